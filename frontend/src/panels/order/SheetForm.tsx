/** The sheet on the table: of unknown size, or cut to size before the job. */

import { NumberInput, Select } from "@mantine/core";
import type { Sheet } from "../../api/jobs";
import { translate } from "../../language/translate";
import { formatSize } from "../../state/format";
import { OUTLINE_SHEET, sheetSize } from "../../state/order/sheet";
import { useUiStore } from "../../state/store";
import { Note } from "../shared/parts";

const CHOICES = [
  { value: "unknown", label: translate("sheetForm.largerThanTheDrawing") },
  { value: "outline", label: translate("sheetForm.cutToTheOutlineOf") },
  { value: "size", label: translate("sheetForm.cutToARectangle") },
];

const choiceOf = (sheet: Sheet | null): string => {
  if (sheet === null) return "unknown";
  return sheetSize(sheet) === null ? "outline" : "size";
};

/** Greatest rounding of the size of a drawing (mm). */
const ROUNDING = 0.005;

const FIELDS = [
  { name: "width", label: translate("sheetForm.widthMm"), min: 1 },
  { name: "height", label: translate("sheetForm.heightMm"), min: 1 },
  { name: "margin", label: translate("sheetForm.marginMm"), min: 0 },
] as const;

/** Choice of the sheet, and its size; `width` and `height` are those of the drawing (mm). */
export function SheetForm({ width, height }: { width: number; height: number }) {
  const sheet = useUiStore((ui) => ui.sheet);
  const set = useUiStore((ui) => ui.set);
  const isSmall = (name: string): boolean =>
    (name === "width" && (sheet?.width ?? width) < width + (sheet?.margin ?? 0) - ROUNDING) ||
    (name === "height" && (sheet?.height ?? height) < height + (sheet?.margin ?? 0) - ROUNDING);
  const choose = (choice: string | null) => {
    if (choice === "outline") set({ sheet: OUTLINE_SHEET });
    else if (choice === "size") set({ sheet: { ...OUTLINE_SHEET, width, height } });
    else set({ sheet: null });
  };
  return (
    <div style={{ display: "grid", gap: 6 }}>
      <Select
        label={translate("sheetForm.sheet")}
        data={CHOICES}
        value={choiceOf(sheet)}
        allowDeselect={false}
        onChange={choose}
        data-testid="sheet-select"
      />
      {sheet !== null && sheetSize(sheet) !== null && (
        <div style={{ display: "grid", gridTemplateColumns: "1fr 1fr 1fr", gap: 8 }}>
          {FIELDS.map(({ name, label, min }) => (
            <NumberInput
              key={name}
              label={label}
              min={min}
              max={10000}
              decimalScale={2}
              value={sheet[name] ?? min}
              error={isSmall(name)}
              onChange={(value) => set({ sheet: { ...sheet, [name]: Number(value) || min } })}
              data-testid={`sheet-${name}`}
            />
          ))}
        </div>
      )}
      {(isSmall("width") || isSmall("height")) && (
        <Note style={{ margin: 0, color: "var(--bad)" }} role="alert" data-testid="sheet-small">
          {translate("sheetForm.theDrawingWithItsMargin", {
            width: formatSize(width + (sheet?.margin ?? 0), height + (sheet?.margin ?? 0)),
          })}
        </Note>
      )}
      {sheet !== null && (
        <Note>
          {sheetSize(sheet) === null
            ? translate("sheetForm.besideTheSheetToolsTurn")
            : translate("sheetForm.besideTheSheetToolsTurn2")}
        </Note>
      )}
    </div>
  );
}
