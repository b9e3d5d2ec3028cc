/** The order of the work: tracks of the program by blanks and layers, or in one list. */

import { Button, SegmentedControl, Stack } from "@mantine/core";
import { IconRoute } from "@tabler/icons-react";
import { useState } from "react";
import { translate } from "../../language/translate";
import { useWorkOrder, type WorkOrder } from "../../state/order/useWorkOrder";
import { brokenRule, movedItem, orderOf, type WorkItem } from "../../state/order/workOrder";
import { useUiStore } from "../../state/store";
import panels from "../shared/panels.module.css";
import { Note } from "../shared/parts";
import { reasonOf } from "./orderReason";
import { SortedList } from "./SortedList";
import { nameOfTrack, trackRow } from "./WorkTrack";
import { WorkTree } from "./WorkTree";

/** Most tracks in one list. A longer list would be slow and too long to sort by hand. */
const MOST = 400;
/** Greatest length of an order that the server accepts (tracks). */
const MOST_ORDERED = 5000;

type View = "parts" | "tracks";

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
      <Views work={work} />
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

/** By blanks if there are several; a single one may be listed so, too. */
function Views({ work: { items, parts } }: { work: WorkOrder }) {
  const options = useUiStore((ui) => ui.options);
  const set = useUiStore((ui) => ui.set);
  const [chosen, setChosen] = useState<View | null>(null);
  const [refused, setRefused] = useState("");
  const hasParts = parts.length > 0 && parts.length <= MOST && items.length <= MOST_ORDERED;
  const view: View = hasParts ? (chosen ?? (parts.length > 1 ? "parts" : "tracks")) : "tracks";
  const onOrder = (ordered: readonly WorkItem[]) => {
    setRefused("");
    set({ options: { ...options, work_order: orderOf(ordered) } });
  };
  const move = (from: number, to: number) => {
    const broken = brokenRule(items, from, to);
    if (broken === null) onOrder(movedItem(items, from, to));
    else setRefused(reasonOf(broken, nameOfTrack));
  };
  return (
    <>
      {hasParts && (
        <SegmentedControl
          size="xs"
          fullWidth
          aria-label={translate("workOrder.view")}
          data={[
            { value: "parts", label: translate("workOrder.byBlanks") },
            { value: "tracks", label: translate("workOrder.inOneList") },
          ]}
          value={view}
          onChange={(value) => setChosen(value as View)}
          data-testid="work-view"
        />
      )}
      {view === "parts" && (
        <>
          <Note>{translate("workOrder.aboutBlanks")}</Note>
          <WorkTree items={items} parts={parts} onOrder={onOrder} onRefused={setRefused} />
        </>
      )}
      {view === "tracks" && items.length > MOST && (
        <Note>{translate("workOrder.tooMany", { n: items.length, most: MOST })}</Note>
      )}
      {view === "tracks" && items.length <= MOST && (
        <SortedList
          kind="track"
          testId="work-items"
          onMove={move}
          rows={items.map((item, place) => trackRow(item, place + 1))}
        />
      )}
      <div role="status" data-testid="order-refused">
        {refused !== "" && (
          <div className={panels.callout} data-tone="amber">
            {refused}
          </div>
        )}
      </div>
    </>
  );
}
