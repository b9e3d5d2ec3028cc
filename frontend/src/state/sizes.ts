/** Sizes in both of the units that people in this trade think in. */

import type { Drawing, Unit } from "../api/client";

const THIN = "\u202f";

export const UNITS: Readonly<Record<Unit, { title: string; mm: number }>> = {
  mm: { title: "Millimetres", mm: 1 },
  cm: { title: "Centimetres", mm: 10 },
  m: { title: "Metres", mm: 1000 },
  in: { title: "Inches", mm: 25.4 },
  ft: { title: "Feet", mm: 304.8 },
  pt: { title: "Points", mm: 25.4 / 72 },
  px: { title: "Pixels", mm: 25.4 / 96 },
};

export const isUnit = (word: string): word is Unit => word in UNITS;

/** Width and height in inches, or in feet from ten of those up. */
export function inches(width: number, height: number): string {
  const [unit, mm] =
    Math.max(width, height) < 3048 ? (["in", 25.4] as const) : (["ft", 304.8] as const);
  const digits = Math.max(width, height) / mm < 100 ? 2 : 1;
  return `${(width / mm).toFixed(digits)} × ${(height / mm).toFixed(digits)}${THIN}${unit}`;
}

/** How large a drawing would be (mm) if its file were in this unit. */
export function sizeIn(drawing: Drawing, unit: Unit): readonly [number, number] {
  const factor = UNITS[unit].mm / (drawing.unit === null ? 1 : UNITS[drawing.unit].mm);
  return [drawing.width * factor, drawing.height * factor];
}

/** The units worth offering: those people draw in, and others that something speaks for. */
export function unitsOffered(drawing: Drawing): Unit[] {
  const finding = drawing.unit_finding;
  const drawn: readonly Unit[] = ["mm", "cm", "m", "in", "ft"];
  const ranked = finding?.ranking ?? drawn;
  const spoken = new Set(
    (finding?.evidence ?? []).filter(({ weight }) => weight > 1).map(({ unit }) => unit),
  );
  return ranked.filter(
    (unit) =>
      drawn.includes(unit) || unit === drawing.unit || (spoken.has(unit) && ranked[0] === unit),
  );
}
