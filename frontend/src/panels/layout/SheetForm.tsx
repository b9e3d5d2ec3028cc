/** The sheet of a layout: size, board, grain, and the distances that placing and nesting keep. */

import { NumberInput, Select } from "@mantine/core";
import type { LayoutSheet } from "../../api/layouts";
import { translate } from "../../language/translate";
import { useBoards } from "../../state/queries";
import css from "./layout.module.css";

interface Props {
  readonly sheet: LayoutSheet;
  readonly onChange: (fields: Partial<LayoutSheet>) => void;
}

const NUMBERS = [
  { field: "width", label: translate("layoutEditor.widthMm"), min: 1, max: 10_000 },
  { field: "height", label: translate("layoutEditor.heightMm"), min: 1, max: 10_000 },
  { field: "gap", label: translate("layoutEditor.gapMm"), min: 0, max: 1000 },
  { field: "margin", label: translate("layoutEditor.marginMm"), min: 0, max: 1000 },
] as const;
const GRAINS = [
  { value: "", label: translate("layoutEditor.noGrain") },
  { value: "x", label: translate("layoutEditor.grainAlongX") },
  { value: "y", label: translate("layoutEditor.grainAlongY") },
];

export function SheetForm({ sheet, onChange }: Props) {
  const { data: boards } = useBoards();
  const number = ({ field, label, min, max }: (typeof NUMBERS)[number]) => (
    <NumberInput
      hideControls
      key={field}
      label={label}
      size="xs"
      min={min}
      max={max}
      value={sheet[field]}
      onChange={(value) =>
        typeof value === "number" && value >= min && value <= max && onChange({ [field]: value })
      }
      data-testid={`layout-${field}`}
    />
  );
  return (
    <div className={css.two}>
      {NUMBERS.map(number)}
      <Select
        label={translate("layoutEditor.board")}
        size="xs"
        searchable
        clearable
        data={(boards ?? []).map(({ name, title }) => ({ value: name, label: title || name }))}
        value={sheet.board || null}
        onChange={(name) => onChange({ board: name ?? "" })}
        data-testid="layout-board"
      />
      <Select
        label={translate("layoutEditor.grain")}
        size="xs"
        data={GRAINS}
        value={sheet.grain ?? ""}
        allowDeselect={false}
        onChange={(value) => onChange({ grain: value === "x" || value === "y" ? value : null })}
      />
    </div>
  );
}
