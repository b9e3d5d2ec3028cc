/** The pages of a file with several pages: pictures from which the user chooses the drawing. */

import { Box, Flex, SimpleGrid, Text } from "@mantine/core";
import { IconCheck } from "@tabler/icons-react";
import type { Drawing, PageOfFile } from "../../api/drawings";
import { translate } from "../../language/translate";
import { messageText } from "../../messages/translateMessage";
import { useRefusal } from "../../state/accounts/accounts";
import { choosePage } from "../../state/actions";
import { pageRead } from "../../state/drawing/pages";
import { formatSize } from "../../state/format";
import { useDrawing, usePages } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { Refusal } from "../accounts/Permitted";
import panels from "../shared/panels.module.css";
import { Figure, Note } from "../shared/parts";
import { Section } from "../shared/Section";

const PAGE = { flexDirection: "column", alignItems: "flex-start", width: "100%", gap: 3 } as const;
const PICTURE = { width: "100%", height: 84, objectFit: "contain" } as const;

export function PagesPanel() {
  const { data: drawing } = useDrawing();
  const page = drawing === undefined ? null : pageRead(drawing);
  if (drawing === undefined || page === null) return null;
  return (
    <Section
      title={translate("pagesPanel.pagesOfTheFile")}
      aside={<Figure>{translate("pagesPanel.pageIsRead", { page })}</Figure>}
    >
      <Pages drawing={drawing} read={page} />
    </Section>
  );
}

function Pages({ drawing, read }: { drawing: Drawing; read: number }) {
  const { data: pages, isError } = usePages(drawing.id);
  const refusal = useRefusal("POST /api/v1/drawings/{id}/pages/{page}");
  const busy = useUiStore((ui) => ui.upload !== null);
  if (isError) return <Note>{translate("pagesPanel.thePagesCannotBeShown")}</Note>;
  if (pages === undefined) return <Note>{translate("pagesPanel.thePagesAreBeingRead")}</Note>;
  return (
    <>
      <Note>{translate("pagesPanel.chooseAPageToOpen")}</Note>
      <SimpleGrid cols={2} spacing={8} mt={8} data-testid="pages">
        {pages.map((page) => (
          <div key={page.page}>
            <button
              type="button"
              className={panels.choice}
              style={PAGE}
              aria-current={page.page === read}
              disabled={page.page === read || page.edges === 0 || refusal !== null || busy}
              title={page.problem === null ? undefined : messageText(page.problem)}
              onClick={() => void choosePage(drawing, page.page)}
            >
              <Miniature page={page} />
              <Flex component="span" align="center" gap={4}>
                {translate("pagesPanel.page", { page: page.page })}
                {page.page === read && (
                  <IconCheck size={13} aria-label={translate("pagesPanel.thePageThatIsRead")} />
                )}
              </Flex>
              {page.edges === 0 ? (
                <Text span fz={11.5} c="ink.2">
                  {translate("pagesPanel.noDrawing")}
                </Text>
              ) : (
                <>
                  <Text span fz={11.5} c="ink.2">
                    {formatSize(page.width, page.height)}
                  </Text>
                  <Text span fz={11.5} c="ink.2">
                    {translate("pagesPanel.edges", { edges: page.edges })}
                  </Text>
                </>
              )}
            </button>
          </div>
        ))}
      </SimpleGrid>
      <Refusal reason={refusal} />
    </>
  );
}

function Miniature({ page }: { page: PageOfFile }) {
  if (page.picture === "") return <Box component="span" h={84} />;
  const source = `data:image/svg+xml,${encodeURIComponent(page.picture)}`;
  return <img style={PICTURE} src={source} alt="" draggable={false} />;
}
