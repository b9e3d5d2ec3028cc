/** The sheet of a job, if it was cut to size, and the height of its turns. */

import type { Sheet } from "../../api/jobs";
import type { Machine } from "../../api/machines";
import type { Box, Point } from "../../geometry/records";
import { translate } from "../../language/translate";

/** A sheet that was cut to the outline of the drawing. */
export const OUTLINE_SHEET: Sheet = { width: null, height: null, margin: 0 };

/** Width and height of a rectangular sheet (mm); null if its shape is not a rectangle. */
export function sheetSize(sheet: Sheet | null): readonly [number, number] | null {
  const { width = null, height = null } = sheet ?? OUTLINE_SHEET;
  return width === null || height === null ? null : [width, height];
}

/** Distance of the drawing from the left and from the lower edge of a sheet (mm). */
const sheetMargins = ({ margin = 0, margin_below = null }: Sheet): readonly [number, number] => [
  margin,
  margin_below ?? margin,
];

/**
 * A rectangular sheet as a box in drawing coordinates; null if its shape is not a rectangle.
 *
 * `corner` is the lower left corner of the drawing.
 */
export function sheetBox(sheet: Sheet | null, corner: Point): Box | null {
  const size = sheetSize(sheet);
  if (sheet === null || size === null) return null;
  const [left, below] = sheetMargins(sheet);
  const [x, y] = [corner.x - left, corner.y - below];
  return [x, y, x + size[0], y + size[1]];
}

/** The sheet in words, for the operator who loads it. */
export function sheetText(sheet: Sheet): string {
  const size = sheetSize(sheet);
  if (size === null) return translate("sheet.cutToTheOutlineOf");
  return translate("sheet.mmDrawingMmFromIts", {
    size: size[0],
    size2: size[1],
    margin: sheet.margin,
  });
}

/** Whether a machine states the distance from the board that the least lift leaves. */
export const hasLeastLift = (machine: Machine | undefined): boolean =>
  machine !== undefined && machine.turn_clearance > 0;
