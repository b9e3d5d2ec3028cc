/** Marks of a printed sheet, from edges of the drawing. */

import { create } from "zustand";
import type { Registration } from "../../api/jobs";
import { circleOf } from "../../geometry/arc";
import { crossing, type Line } from "../../geometry/crossing";
import type { Point, Segments } from "../../geometry/records";

/** Least distance of two marks (mm), as the server demands it. */
export const LEAST_DISTANCE = 20;
/** Points closer than this are one mark (mm): two arcs of a circle have one centre. */
const SAME = 0.05;
/** Most edges that are compared for crossings. */
const MOST_LINES = 200;

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

export const NO_MARKS: Registration = { marks: [], scale: "fit", limit: 0.5, measured: [] };

/** Most marks of a sheet. */
const MOST = 20;

export type Marks = Registration["marks"];

/** Marks with further points; `close` if a point was left out because it is too near to another. */
export function withMarks(
  marks: Marks,
  points: readonly Point[],
): { readonly marks: Marks; readonly close: boolean } {
  const kept = marks.map(([x, y]) => ({ x, y }));
  const far: Point[] = [];
  for (const point of points)
    if ([...kept, ...far].every((one) => distance(one, point) >= LEAST_DISTANCE)) far.push(point);
  const all = [...kept, ...far].slice(0, MOST);
  return { marks: all.map(({ x, y }) => [x, y]), close: far.length < points.length };
}

interface Picking {
  /** A click on the canvas is a mark. */
  readonly active: boolean;
  /** The point that a click would take; null without a point near the cursor. */
  readonly cursor: Point | null;
  /** Why the last click is no mark. */
  readonly fault: "none" | "close" | null;
}

export const useMarkPicking = create<Picking>()(() => ({
  active: false,
  cursor: null,
  fault: null,
}));

export const stopPicking = (): void =>
  useMarkPicking.setState({ active: false, cursor: null, fault: null });
