/** Ways to select edges other than a click: like the selected ones, or by conditions. */

import {
  ActionIcon,
  Button,
  Group,
  Kbd,
  NativeSelect,
  NumberInput,
  Popover,
  SegmentedControl,
  SimpleGrid,
  Stack,
  Tooltip,
} from "@mantine/core";
import { IconFilterSearch } from "@tabler/icons-react";
import { useMemo, useState } from "react";
import type { SelectMode } from "../../geometry/selection";
import { translate } from "../../language/translate";
import { COMMANDS } from "../../state/commands/commands";
import { keyTexts } from "../../state/commands/commandTexts";
import { LEGEND, LINE_STYLES } from "../../state/drawing/palette";
import { isLineType } from "../../state/drawing/questions";
import { ANY, type Conditions, rowsThatMeet, shownEdges } from "../../state/drawing/selecting";
import { naturalOrder } from "../../state/naturalOrder";
import { useEdges } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { AREA_MODES } from "../drafting/AreaBar";
import { Note } from "../shared/parts";

const WAYS = COMMANDS.filter(({ group, id }) => group === "select" && id !== "cancel");

export function SelectMenu() {
  const [open, setOpen] = useState(false);
  return (
    <Popover
      opened={open}
      onChange={setOpen}
      position="right-start"
      width={300}
      trapFocus
      shadow="md"
      // On a phone there is no space beside the button.
      middlewares={{ flip: true, shift: { crossAxis: true, padding: 8 } }}
    >
      <Popover.Target>
        <Tooltip label={translate("selectMenu.selectEdgesBy")} position="right" disabled={open}>
          <ActionIcon
            variant={open ? "light" : "subtle"}
            color={open ? "blue" : "gray"}
            aria-label={translate("selectMenu.selectEdgesBy")}
            onClick={() => setOpen(!open)}
            data-testid="select-menu"
          >
            <IconFilterSearch size={16} />
          </ActionIcon>
        </Tooltip>
      </Popover.Target>
      <Popover.Dropdown aria-label={translate("selectMenu.selectEdgesBy")}>
        <Stack gap={14} data-testid="select-by">
          <Ways done={() => setOpen(false)} />
          <ConditionsForm />
        </Stack>
      </Popover.Dropdown>
    </Popover>
  );
}

/** The commands that select edges; those that start from the selection need one. */
function Ways({ done }: { done(): void }) {
  // Whether a command does something depends on the selection.
  useUiStore((ui) => ui.selection);
  return (
    <Stack gap={2}>
      {WAYS.map((one) => (
        <Button
          key={one.id}
          fullWidth
          size="xs"
          variant="subtle"
          color="gray"
          fw={400}
          justify="space-between"
          px={8}
          h="auto"
          mih={30}
          styles={{ label: { whiteSpace: "normal", textAlign: "left" } }}
          rightSection={one.keys.length > 0 && <Kbd size="xs">{keyTexts(one)}</Kbd>}
          disabled={!one.ready()}
          onClick={() => {
            one.run();
            done();
          }}
          data-testid={one.id}
        >
          {one.title}
        </Button>
      ))}
    </Stack>
  );
}

const length = (value: number | string): number | null =>
  typeof value === "number" ? value : null;

function ConditionsForm() {
  const { data: edges } = useEdges();
  const hiddenTypes = useUiStore((ui) => ui.hiddenTypes);
  const hiddenLayers = useUiStore((ui) => ui.hiddenLayers);
  const selectEdges = useUiStore((ui) => ui.selectEdges);
  const [wanted, setWanted] = useState<Conditions>(ANY);
  const [mode, setMode] = useState<SelectMode>("replace");
  const change = (part: Partial<Conditions>) => setWanted((before) => ({ ...before, ...part }));
  const rows = useMemo(
    () =>
      edges === undefined
        ? []
        : rowsThatMeet(edges, wanted, shownEdges(edges, hiddenTypes, hiddenLayers)),
    [edges, wanted, hiddenTypes, hiddenLayers],
  );
  const layers = [...(edges?.layers ?? [])].sort(naturalOrder);
  return (
    <Stack
      component="form"
      gap={10}
      onSubmit={(event) => {
        event.preventDefault();
        selectEdges(rows, mode);
      }}
    >
      <NativeSelect
        size="xs"
        label={translate("selectMenu.lineType")}
        value={wanted.type ?? ""}
        onChange={({ currentTarget: { value } }) =>
          change({ type: value === "unclassified" || isLineType(value) ? value : null })
        }
        data={[
          { value: "", label: translate("selectMenu.any") },
          ...LEGEND.map((type) => ({ value: type, label: LINE_STYLES[type].title })),
        ]}
      />
      <NativeSelect
        size="xs"
        label={translate("inspectorPanel.layerInFile")}
        value={wanted.layer ?? ""}
        onChange={({ currentTarget: { value } }) => change({ layer: value === "" ? null : value })}
        data={[
          { value: "", label: translate("selectMenu.any") },
          ...layers.filter((name) => name !== "").map((name) => ({ value: name, label: name })),
        ]}
      />
      <SimpleGrid cols={2} spacing={8}>
        <NumberInput
          size="xs"
          hideControls
          min={0}
          label={translate("selectMenu.lengthFrom")}
          value={wanted.shortest ?? ""}
          onChange={(value) => change({ shortest: length(value) })}
        />
        <NumberInput
          size="xs"
          hideControls
          min={0}
          label={translate("selectMenu.lengthTo")}
          value={wanted.longest ?? ""}
          onChange={(value) => change({ longest: length(value) })}
        />
      </SimpleGrid>
      <SegmentedControl
        size="xs"
        fullWidth
        aria-label={translate("selectMenu.whatTheyDo")}
        data={[...AREA_MODES]}
        value={mode}
        onChange={(value) => setMode(value as SelectMode)}
      />
      <Group justify="space-between">
        <Note role="status">{translate("selectMenu.edges", { count: rows.length })}</Note>
        <Button
          type="submit"
          size="xs"
          disabled={rows.length === 0}
          data-testid="select-conditions"
        >
          {translate("selectMenu.select")}
        </Button>
      </Group>
    </Stack>
  );
}
