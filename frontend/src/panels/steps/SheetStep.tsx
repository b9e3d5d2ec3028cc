/** Second step: the machine, the board, the sheet and the number of copies. */

import { Button, NumberInput, Select, Stack } from "@mantine/core";
import { useState } from "react";
import { translate } from "../../language/translate";
import { useDrawing, useMachines } from "../../state/queries";
import { layoutAddress } from "../../state/routes";
import { useUiStore } from "../../state/store";
import { Permitted } from "../accounts/Permitted";
import { InspectorPanel } from "../drawing/InspectorPanel";
import { LayOutButton } from "../layout/LayOutButton";
import { BoardSelect } from "../order/BoardSelect";
import { MarksForm } from "../order/MarksForm";
import { SheetForm } from "../order/SheetForm";
import { Section } from "../shared/Section";

export function SheetStep() {
  const { data: drawing } = useDrawing();
  const { data: machines } = useMachines();
  const machine = useUiStore((ui) => ui.machine);
  const set = useUiStore((ui) => ui.set);
  if (drawing === undefined) return null;
  return (
    <>
      <InspectorPanel />
      <Section title={translate("sheetStep.boardAndMachine")}>
        <Permitted request="POST /api/v1/jobs">
          <Stack gap={10}>
            <BoardSelect drawing={drawing} />
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
          </Stack>
        </Permitted>
      </Section>
      <Section title={translate("sheetStep.sheetAndCopies")}>
        <Permitted request="POST /api/v1/jobs">
          <Stack gap={10}>
            {drawing.is_layout ? (
              <Button component="a" href={layoutAddress(drawing.id)} variant="default">
                {translate("sheetStep.changeTheSheet")}
              </Button>
            ) : (
              <SheetForm
                width={drawing.bounds[2] - drawing.bounds[0]}
                height={drawing.bounds[3] - drawing.bounds[1]}
              />
            )}
            {!drawing.is_layout && <MarksForm />}
            <Copies />
            {!drawing.is_layout && <LayOutButton drawing={drawing} />}
          </Stack>
        </Permitted>
      </Section>
    </>
  );
}

function Copies() {
  const copies = useUiStore((ui) => ui.copies);
  const set = useUiStore((ui) => ui.set);
  // The field while it is typed in, also when it is empty; null: nothing is typed.
  const [typed, setTyped] = useState<number | string | null>(null);
  return (
    <NumberInput
      w={120}
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
  );
}
