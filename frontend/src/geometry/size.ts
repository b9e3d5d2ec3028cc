/** The size of some edges: of a line, of an arc, or of all of them together. */

import { arcLength, circleOf, pointAt } from "./arc";
import { boundsOf } from "./bounds";
import type { Box, Point, Segments } from "./records";

/** Arcs whose centres and radii differ by less than this lie on one circle (mm). */
const SAME_CIRCLE = 1e-3;

export type Size =
  | { readonly kind: "line"; readonly from: Point; readonly to: Point; readonly length: number }
  | {
      readonly kind: "arc";
      readonly centre: Point;
      readonly radius: number;
      /** the middle of the arc */
      readonly at: Point;
    }
  | { readonly kind: "box"; readonly box: Box };

/** Length of one line, radius of arcs of one circle, else the box of all rows; null for none. */
export function sizeOf(segments: Segments, rows: readonly number[]): Size | null {
  const [row] = rows;
  if (row === undefined) return null;
  const edge = edgeOf(segments, row);
  const round = circleOf(...edge);
  if (round === null && rows.length === 1) {
    const [x0, y0, x1, y1] = edge;
    const length = arcLength(...edge);
    return { kind: "line", from: { x: x0, y: y0 }, to: { x: x1, y: y1 }, length };
  }
  if (round !== null && rows.every((other) => isOnCircle(segments, other, round))) {
    const [x, y] = pointAt(...edge, 0.5);
    return { kind: "arc", centre: { x: round.x, y: round.y }, radius: round.radius, at: { x, y } };
  }
  const box = boundsOf(segments, rows);
  return box === null ? null : { kind: "box", box };
}

function edgeOf({ ends, bulge }: Segments, row: number) {
  const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = ends.subarray(row * 4, row * 4 + 4);
  return [x0, y0, x1, y1, bulge[row] ?? 0] as const;
}

function isOnCircle(
  segments: Segments,
  row: number,
  { x, y, radius }: Point & { readonly radius: number },
): boolean {
  const other = circleOf(...edgeOf(segments, row));
  return (
    other !== null &&
    Math.hypot(other.x - x, other.y - y) < SAME_CIRCLE &&
    Math.abs(other.radius - radius) < SAME_CIRCLE
  );
}
