/** A track in a list of the order of the work: a click selects its edges. */

import { Flex, Group, Text } from "@mantine/core";
import { translate } from "../../language/translate";
import { LINE_STYLES } from "../../state/drawing/palette";
import type { WorkItem } from "../../state/order/workOrder";
import { useUiStore } from "../../state/store";
import panels from "../shared/panels.module.css";
import { Swatch } from "../shared/Swatch";
import type { SortedRow } from "./SortedList";
import { WorkPicture } from "./WorkPicture";
import css from "./workOrder.module.css";

export const nameOfTrack = ({ edge, edges, type }: WorkItem): string =>
  translate("workOrder.track", { type: LINE_STYLES[type].title, edge, n: edges.length });

/** Row of a track with its number in the whole program, from 1. */
export const trackRow = (item: WorkItem, number: number): SortedRow => ({
  id: item.edge,
  name: nameOfTrack(item),
  content: <WorkTrack item={item} number={number} />,
});

function WorkTrack({ item, number }: { item: WorkItem; number: number }) {
  const selectEdges = useUiStore((ui) => ui.selectEdges);
  const selected = useUiStore((ui) => ui.selection.has(item.edge));
  return (
    <button
      type="button"
      className={`${panels.pick} ${css.name}`}
      aria-pressed={selected}
      onClick={() => selectEdges(item.edges)}
    >
      <Text span w={24} ta="end" c="ink.0" fw={650} className={css.number}>
        {number}
      </Text>
      <WorkPicture edges={item.edges} box={item.box} colour={LINE_STYLES[item.type].colour} />
      <Flex component="span" direction="column" miw={0} align="flex-start">
        <Group component="span" gap={6} wrap="nowrap">
          <Swatch type={item.type} />
          <Text span fz={13} fw={550} truncate="end">
            {LINE_STYLES[item.type].title}
          </Text>
        </Group>
        <Text span fz={12} c="ink.3">
          {translate("workOrder.edgesAndTool", {
            edge: item.edge,
            n: item.edges.length,
            station: item.station,
          })}
        </Text>
      </Flex>
    </button>
  );
}
