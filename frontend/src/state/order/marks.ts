/** Marks of a printed sheet, from edges of the drawing. */

import { circleOf } from "../../geometry/arc";
import type { Point, Segments } from "../../geometry/records";

/** Least distance of two marks (mm), as the server demands it. */
export const LEAST_DISTANCE = 20;
/** Points closer than this are one mark (mm): two arcs of a circle have one centre. */
const SAME = 0.05;
/** Most edges that are compared for crossings. */
const MOST_LINES = 200;

type Line = readonly [x0: number, y0: number, x1: number, y1: number];

/** Centres of the circles, and crossings of the straight lines, among some edges. */
export function marksOf({ ends, bulge }: Segments, rows: Iterable<number>): readonly Point[] {
  const lines: Line[] = [];
  const found: Point[] = [];
  for (const row of rows) {
    const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = ends.subarray(row * 4, row * 4 + 4);
    const circle = circleOf(x0, y0, x1, y1, bulge[row] ?? 0);
    if (circle === null) lines.push([x0, y0, x1, y1]);
    else found.push({ x: circle.x, y: circle.y });
  }
  const few = lines.slice(0, MOST_LINES);
  for (const [at, line] of few.entries())
    for (const other of few.slice(at + 1)) {
      const point = crossing(line, other);
      if (point !== null) found.push(point);
    }
  return found.filter((point, at) =>
    found.slice(0, at).every((one) => distance(one, point) >= SAME),
  );
}

export const distance = (a: Point, b: Point): number => Math.hypot(a.x - b.x, a.y - b.y);

/** Where two lines cross between their ends; null if they do not. */
function crossing(line: Line, other: Line): Point | null {
  const [x0, y0, x1, y1] = line;
  const [u0, v0, u1, v1] = other;
  const cross = (x1 - x0) * (v1 - v0) - (y1 - y0) * (u1 - u0);
  if (Math.abs(cross) < 1e-9) return null;
  const along = ((u0 - x0) * (v1 - v0) - (v0 - y0) * (u1 - u0)) / cross;
  const across = ((u0 - x0) * (y1 - y0) - (v0 - y0) * (x1 - x0)) / cross;
  if (Math.min(along, across) < -1e-9 || Math.max(along, across) > 1 + 1e-9) return null;
  return { x: x0 + along * (x1 - x0), y: y0 + along * (y1 - y0) };
}
