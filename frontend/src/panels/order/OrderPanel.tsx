/** Machine, board and number of copies, and the button that compiles. */

import { Button, Checkbox, NumberInput, Select } from "@mantine/core";
import { IconBolt } from "@tabler/icons-react";
import { useEffect, useState } from "react";
import { translate } from "../../language/translate";
import { compile } from "../../state/actions";
import { isCompiling } from "../../state/job/jobs";
import { proposedMachine } from "../../state/job/machines";
import { DEFAULT_CORNERS } from "../../state/order/corners";
import { optionsOf } from "../../state/order/options";
import { detailsOf } from "../../state/order/orderDetails";
import { hasLeastLift } from "../../state/order/sheet";
import { useDrawing, useJob, useMachines } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { Permitted } from "../accounts/Permitted";
import { Note } from "../shared/parts";
import { Section } from "../shared/Section";
import { BoardSelect } from "./BoardSelect";
import { CornersForm } from "./CornersForm";
import { EdgeChoiceList } from "./EdgeOptions";
import { OptionFields } from "./OptionFields";
import { OrderDetailsForm } from "./OrderDetailsForm";
import { SheetForm } from "./SheetForm";

export function OrderPanel() {
  const { data: drawing } = useDrawing();
  const { data: machines } = useMachines();
  const { data: job } = useJob();
  const machine = useUiStore((ui) => ui.machine);
  const board = useUiStore((ui) => ui.board);
  const copies = useUiStore((ui) => ui.copies);
  const lift = useUiStore((ui) => ui.lift);
  const busy = useUiStore((ui) => ui.busy);
  // The field of copies while it is typed in, also when it is empty; null: nothing is typed.
  const [typed, setTyped] = useState<number | string | null>(null);
  const set = useUiStore((ui) => ui.set);

  useEffect(() => {
    const proposed = proposedMachine(machines ?? []);
    if (machine === null && proposed !== null) set({ machine: proposed });
  }, [machines, machine, set]);

  // Opening a job takes over its settings, so that it can be compiled again.
  // biome-ignore lint/correctness/useExhaustiveDependencies: once per job, not on each update
  useEffect(() => {
    if (job !== undefined) {
      set({
        machine: job.machine,
        board: job.board,
        corners: job.corners ?? DEFAULT_CORNERS,
        sheet: job.sheet ?? null,
        lift: job.lift,
        options: optionsOf(job),
        details: detailsOf(job),
      });
    }
  }, [job?.id, set]);

  if (drawing === undefined) return null;
  const chosen = machines?.find(({ name }) => name === machine);
  const open = drawing.questions.length;
  const missing =
    open > 0
      ? translate("orderPanel.answerOtherFirst", { open })
      : board === null
        ? translate("orderPanel.chooseTheBoard")
        : machine === null
          ? translate("orderPanel.chooseAMachine")
          : null;
  return (
    <Section title={translate("orderPanel.newJob")}>
      <Permitted request="POST /api/v1/jobs">
        <div style={{ display: "grid", gap: 10 }} data-can-prepare={open === 0 || undefined}>
          <Select
            label={translate("orderPanel.machine")}
            placeholder={translate("orderPanel.chooseAMachine2")}
            data={(machines ?? []).map(({ name, title }) => ({
              value: name,
              label: title || name,
            }))}
            value={machine}
            allowDeselect={false}
            onChange={(value) => set({ machine: value })}
            data-testid="machine-select"
          />
          {chosen?.offset_cuts === true && <CornersForm />}
          <BoardSelect drawing={drawing} />
          <SheetForm
            width={drawing.bounds[2] - drawing.bounds[0]}
            height={drawing.bounds[3] - drawing.bounds[1]}
          />
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
          <EdgeChoiceList />
          <OrderDetailsForm />
          <div
            style={{ display: "grid", gridTemplateColumns: "72px 1fr", gap: 8, alignItems: "end" }}
          >
            <NumberInput
              label={translate("orderPanel.copies")}
              min={1}
              max={1000}
              allowDecimal={false}
              clampBehavior="strict"
              value={typed ?? copies}
              onChange={(value) => {
                setTyped(value);
                set({ copies: Math.max(1, Number(value) || 1) });
              }}
              onBlur={() => setTyped(null)}
              data-testid="copies"
            />
            <Button
              leftSection={<IconBolt size={17} aria-hidden />}
              px="sm"
              disabled={missing !== null}
              loading={(busy && missing === null) || (job !== undefined && isCompiling(job))}
              onClick={() => {
                if (machine !== null && board !== null) void compile(machine, board);
              }}
              variant={job === undefined || job.state === "refused" ? "filled" : "default"}
              data-testid="compile"
            >
              {job === undefined
                ? translate("orderPanel.prepareProgram")
                : translate("orderPanel.prepareAgain")}
            </Button>
          </div>
          {missing !== null && <Note>{missing}</Note>}
        </div>
      </Permitted>
    </Section>
  );
}
