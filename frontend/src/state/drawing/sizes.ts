/** Units of drawings, and sizes in inches. */

import type { Drawing, Unit } from "../../api/drawings";
import { formatFixed } from "../../language/numbers";
import { translate } from "../../language/translate";

const THIN = "\u202f";

export const UNITS: Readonly<Record<Unit, { title: string; mm: number }>> = {
  mm: { title: translate("sizes.millimetres"), mm: 1 },
  cm: { title: translate("sizes.centimetres"), mm: 10 },
  m: { title: translate("sizes.metres"), mm: 1000 },
  in: { title: translate("sizes.inches"), mm: 25.4 },
  ft: { title: translate("sizes.feet"), mm: 304.8 },
  pt: { title: translate("sizes.points172Inch"), mm: 25.4 / 72 },
  px: { title: translate("sizes.pixels196Inch"), mm: 25.4 / 96 },
  "px-90": { title: translate("sizes.pixels190InchOld"), mm: 25.4 / 90 },
};

export const isUnit = (word: string): word is Unit => word in UNITS;

/** Width and height in inches, or in feet from ten of those up. */
export function formatInches(width: number, height: number): string {
  const [unit, mm] =
    Math.max(width, height) < 3048 ? (["in", 25.4] as const) : (["ft", 304.8] as const);
  const digits = Math.max(width, height) / mm < 100 ? 2 : 1;
  return `${formatFixed(width / mm, digits)} × ${formatFixed(height / mm, digits)}${THIN}${unit}`;
}

/** Width and height (mm) of a drawing if its file were in this unit. */
export function sizeIn(drawing: Drawing, unit: Unit): readonly [number, number] {
  const factor = UNITS[unit].mm / (drawing.unit === null ? 1 : UNITS[drawing.unit].mm);
  return [drawing.width * factor, drawing.height * factor];
}

/** Units to offer: the usual ones, and others that have strong evidence. */
export function offeredUnits(drawing: Drawing): Unit[] {
  const finding = drawing.unit_finding;
  const usual: readonly Unit[] = ["mm", "cm", "m", "in", "ft"];
  const ranked = finding?.ranking ?? usual;
  const supported = new Set(
    (finding?.evidence ?? []).filter(({ weight }) => weight > 1).map(({ unit }) => unit),
  );
  return ranked.filter(
    (unit) =>
      usual.includes(unit) || unit === drawing.unit || (supported.has(unit) && ranked[0] === unit),
  );
}
