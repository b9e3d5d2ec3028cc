/** Lines and arcs inside a polygon that was drawn by hand. */

import { flattenArc } from "./arc";
import type { Point, Segments } from "./records";
import { mm } from "./units";

/** Maximum distance of a chord from its arc when an arc is compared with the polygon (mm). */
const CHORD_TOLERANCE = mm(0.1);

/** Whether a place is inside a polygon, by the even-odd rule. */
export function isInside(polygon: readonly Point[], x: number, y: number): boolean {
  let inside = false;
  let before = polygon.at(-1);
  for (const now of polygon) {
    if (
      before !== undefined &&
      now.y > y !== before.y > y &&
      x < now.x + ((y - now.y) * (before.x - now.x)) / (before.y - now.y)
    )
      inside = !inside;
    before = now;
  }
  return inside;
}

/** Twice the area of the triangle a, b, (x, y); positive if it is counter-clockwise. */
const turn = (a: Point, b: Point, x: number, y: number): number =>
  (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);

/** Whether the segment between two points crosses a side of the polygon. */
function crosses(polygon: readonly Point[], a: Point, b: Point): boolean {
  let before = polygon.at(-1);
  for (const now of polygon) {
    if (
      before !== undefined &&
      turn(a, b, before.x, before.y) > 0 !== turn(a, b, now.x, now.y) > 0 &&
      turn(before, now, a.x, a.y) > 0 !== turn(before, now, b.x, b.y) > 0
    )
      return true;
    before = now;
  }
  return false;
}

/** Those of `rows` that lie inside the polygon completely. */
export function rowsInside(
  { ends, bulge }: Segments,
  rows: readonly number[],
  polygon: readonly Point[],
): number[] {
  return rows.filter((row) => {
    const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = ends.subarray(row * 4, row * 4 + 4);
    if (!isInside(polygon, x0, y0) || !isInside(polygon, x1, y1)) return false;
    let before: Point = { x: x0, y: y0 };
    let within = true;
    flattenArc(x0, y0, x1, y1, bulge[row] ?? 0, CHORD_TOLERANCE, (x, y) => {
      const now = { x, y };
      within &&= !crosses(polygon, before, now);
      before = now;
    });
    return within;
  });
}
