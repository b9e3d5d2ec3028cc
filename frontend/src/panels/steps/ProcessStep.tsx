/** Third step: the tools, how they go round corners and lift, options of edges, and the order. */

import { Checkbox, Stack } from "@mantine/core";
import { translate } from "../../language/translate";
import { hasLeastLift } from "../../state/order/sheet";
import { useMachines } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { Permitted } from "../accounts/Permitted";
import { InspectorPanel } from "../drawing/InspectorPanel";
import { MachineTools } from "../job/MachineTools";
import { BridgesForm } from "../order/BridgesForm";
import { CornersForm } from "../order/CornersForm";
import { EdgeChoiceList } from "../order/EdgeOptions";
import { LastTime } from "../order/LastTime";
import { OptionFields } from "../order/OptionFields";
import { OrderDetailsForm } from "../order/OrderDetailsForm";
import { WorkOrderList } from "../order/WorkOrderList";
import { Note } from "../shared/parts";
import { Section } from "../shared/Section";

export function ProcessStep() {
  const { data: machines } = useMachines();
  const machine = useUiStore((ui) => ui.machine);
  const lift = useUiStore((ui) => ui.lift);
  const set = useUiStore((ui) => ui.set);
  const chosen = machines?.find(({ name }) => name === machine);
  return (
    <>
      <InspectorPanel />
      <Section title={translate("processStep.howItIsMade")}>
        <Permitted request="POST /api/v1/jobs">
          <Stack gap={10}>
            <LastTime />
            {chosen?.offset_cuts === true && <CornersForm />}
            <BridgesForm />
            {hasLeastLift(chosen) && (
              <Checkbox
                label={translate("orderPanel.leastLiftInTurnsMm", {
                  turnClearance: chosen?.turn_clearance ?? 0,
                })}
                description={translate("orderPanel.savesTimeOnlyForBoard")}
                checked={lift === "least"}
                onChange={({ currentTarget }) =>
                  set({ lift: currentTarget.checked ? "least" : "clearance" })
                }
                data-testid="least-lift"
              />
            )}
            <OptionFields />
          </Stack>
        </Permitted>
      </Section>
      <Section title={translate("processStep.singleEdges")}>
        <Permitted request="POST /api/v1/jobs">
          <Stack gap={10}>
            <EdgeChoiceList />
            <Note>{translate("processStep.selectEdgesInTheDrawing")}</Note>
          </Stack>
        </Permitted>
      </Section>
      <Section title={translate("processStep.workOrder")}>
        <Permitted request="POST /api/v1/jobs">
          <WorkOrderList />
        </Permitted>
      </Section>
      <Section title={translate("processStep.order")}>
        <Permitted request="POST /api/v1/jobs">
          <OrderDetailsForm />
        </Permitted>
      </Section>
      {chosen !== undefined && (
        <Section
          title={translate("processStep.toolsOf", { title: chosen.title || chosen.name })}
          flush
        >
          <MachineTools machine={chosen} />
        </Section>
      )}
    </>
  );
}
