/** The tracks of the program as a list in working order: dragged, or moved with buttons and keys. */

import { ActionIcon, Button, Flex, Group, Stack, Text } from "@mantine/core";
import { IconArrowDown, IconArrowUp, IconRoute } from "@tabler/icons-react";
import { useState } from "react";
import { translate } from "../../language/translate";
import { LINE_STYLES } from "../../state/drawing/palette";
import { useWorkOrder } from "../../state/order/useWorkOrder";
import {
  type BrokenRule,
  brokenRule,
  movedItem,
  orderOf,
  type WorkItem,
} from "../../state/order/workOrder";
import { useUiStore } from "../../state/store";
import panels from "../shared/panels.module.css";
import { Note } from "../shared/parts";
import { Grip, SortableRows, useSortableRow } from "../shared/Sortable";
import { Swatch } from "../shared/Swatch";
import { WorkPicture } from "./WorkPicture";
import css from "./workOrder.module.css";

/** Most tracks in the list. A longer list would be slow and too long to sort by hand. */
const MOST = 400;

const nameOf = ({ edge, edges, type }: WorkItem): string =>
  translate("workOrder.track", { type: LINE_STYLES[type].title, edge, n: edges.length });

const RULES = {
  types: translate("workOrder.creasesFirst"),
  tools: translate("workOrder.oneToolAfterTheOther"),
  enclosed: translate("workOrder.insideFirst"),
} as const;

const reasonOf = ({ rule, first, second }: BrokenRule): string =>
  translate("workOrder.comesBefore", {
    first: nameOf(first),
    second: nameOf(second),
    why: RULES[rule],
  });

export function WorkOrderList() {
  const work = useWorkOrder();
  const order = useUiStore((ui) => ui.options.work_order);
  if (work === null)
    return (
      <Stack gap={8}>
        <Note data-testid="no-work-order">{translate("workOrder.noProgramYet")}</Note>
        {order.length > 0 && <Shortest />}
      </Stack>
    );
  return (
    <Stack gap={8} data-testid="work-order">
      <Note>
        {order.length === 0 ? translate("workOrder.shortest") : translate("workOrder.byHand")}
      </Note>
      {work.items.length > MOST ? (
        <Note>{translate("workOrder.tooMany", { n: work.items.length, most: MOST })}</Note>
      ) : (
        <Sorted items={work.items} />
      )}
      {order.length > 0 && <Shortest />}
    </Stack>
  );
}

/** Return to the order that the program finds. */
function Shortest() {
  const options = useUiStore((ui) => ui.options);
  const set = useUiStore((ui) => ui.set);
  return (
    <Button
      size="xs"
      variant="default"
      leftSection={<IconRoute size={15} aria-hidden />}
      onClick={() => set({ options: { ...options, work_order: [] } })}
      data-testid="shortest-order"
    >
      {translate("workOrder.byTheShortestWay")}
    </Button>
  );
}

function Sorted({ items }: { items: readonly WorkItem[] }) {
  const options = useUiStore((ui) => ui.options);
  const set = useUiStore((ui) => ui.set);
  const [refused, setRefused] = useState<BrokenRule | null>(null);
  const ids = orderOf(items);
  const move = (from: number, to: number) => {
    if (from < 0 || to < 0 || to >= items.length || from === to) return;
    const broken = brokenRule(items, from, to);
    setRefused(broken);
    if (broken === null)
      set({ options: { ...options, work_order: orderOf(movedItem(items, from, to)) } });
  };
  return (
    <>
      <SortableRows
        ids={ids}
        howTo={translate("workOrder.howToMove")}
        nameOf={(id) => nameOf(items[ids.indexOf(id)] as WorkItem)}
        onMove={move}
      >
        <ol className={css.list} data-testid="work-items">
          {items.map((item, place) => (
            <Row
              key={item.edge}
              item={item}
              place={place}
              last={place === items.length - 1}
              move={move}
            />
          ))}
        </ol>
      </SortableRows>
      <div role="status" data-testid="order-refused">
        {refused !== null && (
          <div className={panels.callout} data-tone="amber">
            {reasonOf(refused)}
          </div>
        )}
      </div>
    </>
  );
}

interface RowProps {
  item: WorkItem;
  place: number;
  last: boolean;
  move: (from: number, to: number) => void;
}

function Row({ item, place, last, move }: RowProps) {
  const { row, grip } = useSortableRow({ id: item.edge });
  const selectEdges = useUiStore((ui) => ui.selectEdges);
  const selected = useUiStore((ui) => ui.selection.has(item.edge));
  const name = nameOf(item);
  return (
    <li {...row} className={css.item} data-edge={item.edge}>
      <Grip
        grip={grip}
        label={translate("workOrder.drag", { name, place: place + 1 })}
        testId="drag-track"
      />
      <button
        type="button"
        className={`${panels.pick} ${css.name}`}
        aria-pressed={selected}
        onClick={() => selectEdges(item.edges)}
      >
        <Text span w={24} ta="end" c="ink.0" fw={650} className={css.number}>
          {place + 1}
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
      <ActionIcon
        variant="subtle"
        color="gray"
        size={28}
        disabled={place === 0}
        aria-label={translate("workOrder.moveUp", { name })}
        onClick={() => move(place, place - 1)}
        data-testid="track-up"
      >
        <IconArrowUp size={15} aria-hidden />
      </ActionIcon>
      <ActionIcon
        variant="subtle"
        color="gray"
        size={28}
        disabled={last}
        aria-label={translate("workOrder.moveDown", { name })}
        onClick={() => move(place, place + 1)}
        data-testid="track-down"
      >
        <IconArrowDown size={15} aria-hidden />
      </ActionIcon>
    </li>
  );
}
