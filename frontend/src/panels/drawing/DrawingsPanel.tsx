/** Upload a drawing, or open one from the list. */

import { Badge, Box, Button, Flex, Skeleton, Text, ThemeIcon } from "@mantine/core";
import { IconFileVector, IconUpload } from "@tabler/icons-react";
import { useRef } from "react";
import type { DrawingSummary } from "../../api/client";
import { translate } from "../../language/translate";
import { errorText } from "../../messages/translateMessage";
import { uploadFiles } from "../../state/actions";
import { formatSize } from "../../state/format";
import { useDrawings, useFormats } from "../../state/queries";
import { showDrawing } from "../../state/routes";
import { useUiStore } from "../../state/store";
import { Permitted } from "../accounts/Permitted";
import css from "../shared/panels.module.css";
import { Figure, Name, Note } from "../shared/parts";
import { Section } from "../shared/Section";
import { ShowMore } from "../shared/ShowMore";

export function DrawingsPanel() {
  const list = useDrawings();
  const { data: drawings, isPending, error } = list;
  const current = useUiStore((ui) => ui.drawing);
  return (
    <Section
      title={translate("drawingsPanel.drawings")}
      flush
      aside={drawings && <Figure>{`${drawings.length}${list.hasNextPage ? "+" : ""}`}</Figure>}
    >
      <Box px={8} pb={10}>
        <Permitted request="POST /api/v1/drawings">
          <ChooseFile />
        </Permitted>
      </Box>
      {isPending && [1, 2, 3].map((row) => <Skeleton key={row} height={44} mb={6} radius={8} />)}
      {error && <Note>{errorText(error)}</Note>}
      {drawings?.length === 0 && (
        <Note px={8}>{translate("drawingsPanel.thereAreNoDrawingsYet")}</Note>
      )}
      {drawings?.map((drawing) => (
        <Row key={drawing.id} drawing={drawing} current={drawing.id === current} />
      ))}
      {list.hasNextPage && (
        <ShowMore busy={list.isFetchingNextPage} act={() => void list.fetchNextPage()} />
      )}
    </Section>
  );
}

function Row({ drawing, current }: { drawing: DrawingSummary; current: boolean }) {
  return (
    <button
      type="button"
      className={css.pick}
      aria-current={current}
      data-testid="drawing-row"
      onClick={() => showDrawing(drawing.id)}
    >
      <ThemeIcon component="span" variant="default" size={34} c="ink.3">
        <IconFileVector size={18} stroke={1.5} aria-hidden />
      </ThemeIcon>
      <Box component="span" flex={1} miw={0}>
        <Flex component="span" align="center" gap={8}>
          <Name fw={550}>{drawing.name}</Name>
          {drawing.questions > 0 && (
            <Badge component="span" color="yellow" flex="none">
              {translate("drawingsPanel.questions", { questions: drawing.questions })}
            </Badge>
          )}
        </Flex>
        <Text span fz={11.5} c="ink.3">
          {translate("drawingsPanel.edges", {
            width:
              drawing.unit === null
                ? translate("drawingsPanel.unitUnknown")
                : formatSize(drawing.width, drawing.height),
            segments: drawing.segments,
          })}
        </Text>
      </Box>
    </button>
  );
}

/** File chooser. */
export function ChooseFile({ large = false }: { large?: boolean }) {
  const input = useRef<HTMLInputElement>(null);
  const upload = useUiStore((ui) => ui.upload);
  const { data: formats } = useFormats();
  return (
    <>
      <input
        ref={input}
        type="file"
        accept={formats
          ?.filter((format) => format.available)
          .flatMap((format) => format.extensions)
          .join(",")}
        multiple
        hidden
        data-testid={large ? "file-input-large" : "file-input"}
        onChange={(event) => {
          void uploadFiles([...(event.currentTarget.files ?? [])]);
          event.currentTarget.value = "";
        }}
      />
      <Button
        fullWidth={!large}
        size={large ? "md" : "sm"}
        variant={large ? "filled" : "default"}
        leftSection={<IconUpload size={16} aria-hidden />}
        loading={upload !== null}
        onClick={() => input.current?.click()}
        data-testid={large ? "choose-file-large" : "choose-file"}
      >
        {translate("drawingsPanel.openDrawingFiles")}
      </Button>
    </>
  );
}
