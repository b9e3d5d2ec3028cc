/** Bounding boxes of lines and arcs. */

import { circleOf } from "./arc";
import type { Box, Segments } from "./records";

const EMPTY: Box = [
  Number.POSITIVE_INFINITY,
  Number.POSITIVE_INFINITY,
  Number.NEGATIVE_INFINITY,
  Number.NEGATIVE_INFINITY,
];

/** Bounding box of a line or arc. */
export function boxOf(x0: number, y0: number, x1: number, y1: number, bulge: number): Box {
  let low = Math.min(x0, x1);
  let bottom = Math.min(y0, y1);
  let high = Math.max(x0, x1);
  let top = Math.max(y0, y1);
  const round = circleOf(x0, y0, x1, y1, bulge);
  if (round !== null) {
    const turn = 2 * Math.PI;
    for (let quarter = 0; quarter < 4; quarter++) {
      const axis = (quarter * Math.PI) / 2;
      const angle = round.sweep > 0 ? axis - round.first : round.first - axis;
      const travelled = ((angle % turn) + turn) % turn;
      if (travelled < Math.abs(round.sweep)) {
        low = Math.min(low, round.x + round.radius * Math.cos(axis));
        high = Math.max(high, round.x + round.radius * Math.cos(axis));
        bottom = Math.min(bottom, round.y + round.radius * Math.sin(axis));
        top = Math.max(top, round.y + round.radius * Math.sin(axis));
      }
    }
  }
  return [low, bottom, high, top];
}

export const unionBox = (a: Box, b: Box): Box => [
  Math.min(a[0], b[0]),
  Math.min(a[1], b[1]),
  Math.max(a[2], b[2]),
  Math.max(a[3], b[3]),
];

/** Bounding box of the line or arc in one row. */
export function boxOfRow(segments: Segments, row: number): Box {
  const { ends, bulge } = segments;
  const at = row * 4;
  return boxOf(
    ends[at] as number,
    ends[at + 1] as number,
    ends[at + 2] as number,
    ends[at + 3] as number,
    bulge[row] as number,
  );
}

/** Bounding boxes of all lines and arcs: asked for often, and the values never change. */
const known = new WeakMap<Segments, Box | null>();

/** Bounding box of the lines and arcs in some rows, by default in all; null if there are none. */
export function boundsOf(segments: Segments, rows?: Iterable<number>): Box | null {
  if (rows !== undefined) return unionOfRows(segments, rows);
  let box = known.get(segments);
  if (box === undefined) {
    box = unionOfAll(segments);
    known.set(segments, box);
  }
  return box;
}

function unionOfRows(segments: Segments, rows: Iterable<number>): Box | null {
  let box = EMPTY;
  for (const row of rows) {
    if (row >= 0 && row < segments.bulge.length) box = unionBox(box, boxOfRow(segments, row));
  }
  return Number.isFinite(box[0]) ? box : null;
}

function unionOfAll(segments: Segments): Box | null {
  const { ends, bulge } = segments;
  let [left, bottom, right, top] = EMPTY;
  const add = (x: number, y: number) => {
    if (x < left) left = x;
    if (x > right) right = x;
    if (y < bottom) bottom = y;
    if (y > top) top = y;
  };
  for (let row = 0; row < bulge.length; row++) {
    const at = row * 4;
    add(ends[at] as number, ends[at + 1] as number);
    add(ends[at + 2] as number, ends[at + 3] as number);
    if (bulge[row] !== 0) {
      const box = boxOfRow(segments, row);
      add(box[0], box[1]);
      add(box[2], box[3]);
    }
  }
  return Number.isFinite(left) ? [left, bottom, right, top] : null;
}
