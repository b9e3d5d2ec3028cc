/**
 * Copies on a sheet that overlap or extend over its edge.
 *
 * This shows faults while a copy is moved; the server decides when the layout is stored. Outlines
 * overlap if their lines cross, or if one lies within the other, but not in one of its holes. Lines
 * that touch do not cross.
 */

import type { Box } from "../../geometry/records";
import { boxOfCopy, type Copy, type Ring } from "./shapes";

/** Distance by which lines must cross, or a point must lie within, to be an overlap (mm). */
const DEPTH = 0.05;

export interface Sheet {
  readonly width: number;
  readonly height: number;
}

/** Indices of the copies that overlap another one or extend over the edge of the sheet. */
export function collidingCopies(copies: readonly Copy[], sheet: Sheet): Set<number> {
  const found = new Set<number>();
  const boxes = copies.map(boxOfCopy);
  for (const [index, [left, below, right, above]] of boxes.entries())
    if (Math.max(-left, -below, right - sheet.width, above - sheet.height) > DEPTH)
      found.add(index);
  const order = [...boxes.keys()].sort((a, b) => low(boxes[a]) - low(boxes[b]));
  for (const [at, one] of order.entries()) {
    const box = boxes[one] as Box;
    for (const other of order.slice(at + 1)) {
      const next = boxes[other] as Box;
      if (next[0] > box[2] - DEPTH) break;
      if (next[1] > box[3] - DEPTH || box[1] > next[3] - DEPTH) continue;
      if (overlap(copies[one] as Copy, copies[other] as Copy)) found.add(one).add(other);
    }
  }
  return found;
}

const low = (box: Box | undefined): number => box?.[0] ?? 0;

/** Whether two copies overlap. */
export function overlap(one: Copy, other: Copy): boolean {
  const x = other.x - one.x;
  const y = other.y - one.y;
  const moved = (ring: Ring): Ring => ring.map((value, at) => value + (at % 2 === 0 ? x : y));
  const holes = other.shape.holes.map(moved);
  return other.shape.outlines
    .map(moved)
    .some((next) =>
      one.shape.outlines.some(
        (ring) =>
          ringsOverlap(ring, next) &&
          !liesInHole(next, one.shape.holes) &&
          !liesInHole(ring, holes),
      ),
    );
}

const liesInHole = (ring: Ring, holes: readonly Ring[]): boolean =>
  holes.some(
    (hole) => isNoLarger(ring, hole) && !ringsCross(ring, hole) && somePointWithin(ring, hole),
  );

/** Whether a ring extends over the box of another one nowhere. */
const isNoLarger = (ring: Ring, other: Ring): boolean =>
  [0, 1].every((axis) => {
    const [own, around] = [ring, other].map((one) => one.filter((_, index) => index % 2 === axis));
    return (
      Math.min(...(own ?? [])) > Math.min(...(around ?? [])) - DEPTH &&
      Math.max(...(own ?? [])) < Math.max(...(around ?? [])) + DEPTH
    );
  });

function ringsOverlap(ring: Ring, moved: Ring): boolean {
  if (ringsCross(ring, moved)) return true;
  return somePointWithin(ring, moved) || somePointWithin(moved, ring);
}

function ringsCross(ring: Ring, next: Ring): boolean {
  for (let a = 0; a < ring.length; a += 2)
    for (let b = 0; b < next.length; b += 2) if (linesCross(ring, a, next, b)) return true;
  return false;
}

const at = (ring: Ring, index: number): number => ring[index % ring.length] ?? 0;

/** Whether two sides cross, each with both ends at least `DEPTH` beside the other. */
function linesCross(ring: Ring, a: number, next: Ring, b: number): boolean {
  const [px, py, qx, qy] = [at(ring, a), at(ring, a + 1), at(ring, a + 2), at(ring, a + 3)];
  const [rx, ry, sx, sy] = [at(next, b), at(next, b + 1), at(next, b + 2), at(next, b + 3)];
  if (Math.max(px, qx) < Math.min(rx, sx) || Math.max(rx, sx) < Math.min(px, qx)) return false;
  if (Math.max(py, qy) < Math.min(ry, sy) || Math.max(ry, sy) < Math.min(py, qy)) return false;
  return (
    areApart(beside(px, py, qx, qy, rx, ry), beside(px, py, qx, qy, sx, sy)) &&
    areApart(beside(rx, ry, sx, sy, px, py), beside(rx, ry, sx, sy, qx, qy))
  );
}

const areApart = (one: number, other: number): boolean =>
  Math.min(one, other) < -DEPTH && Math.max(one, other) > DEPTH;

/** Distance of a point to the left of a line (mm). */
function beside(px: number, py: number, qx: number, qy: number, x: number, y: number): number {
  const length = Math.hypot(qx - px, qy - py);
  return length === 0 ? 0 : ((qx - px) * (y - py) - (qy - py) * (x - px)) / length;
}

/** Whether a corner of a ring, or a point beside the middle of a side, lies within another ring. */
function somePointWithin(ring: Ring, other: Ring): boolean {
  for (let index = 0; index < ring.length; index += 2) {
    const [px, py] = [at(ring, index), at(ring, index + 1)];
    const [qx, qy] = [at(ring, index + 2), at(ring, index + 3)];
    if (isWithin(px, py, other)) return true;
    const length = Math.hypot(qx - px, qy - py);
    if (length < 4 * DEPTH) continue;
    // Outlines run counter-clockwise, mirrored ones clockwise: the inside is on one of both sides.
    for (const side of [-2 * DEPTH, 2 * DEPTH]) {
      const x = (px + qx) / 2 - (side * (qy - py)) / length;
      const y = (py + qy) / 2 + (side * (qx - px)) / length;
      if (isWithin(x, y, ring) && isWithin(x, y, other)) return true;
    }
  }
  return false;
}

/** Whether a point lies within a ring, at least `DEPTH` from its sides. */
function isWithin(x: number, y: number, ring: Ring): boolean {
  let inside = false;
  for (let index = 0; index < ring.length; index += 2) {
    const [px, py] = [at(ring, index), at(ring, index + 1)];
    const [qx, qy] = [at(ring, index + 2), at(ring, index + 3)];
    if (distance(x, y, px, py, qx, qy) < DEPTH) return false;
    if (py > y !== qy > y && x < ((qx - px) * (y - py)) / (qy - py) + px) inside = !inside;
  }
  return inside;
}

/** Distance of a point from a side (mm). */
function distance(x: number, y: number, px: number, py: number, qx: number, qy: number): number {
  const [dx, dy] = [qx - px, qy - py];
  const square = dx * dx + dy * dy;
  const share =
    square === 0 ? 0 : Math.min(1, Math.max(0, ((x - px) * dx + (y - py) * dy) / square));
  return Math.hypot(x - px - share * dx, y - py - share * dy);
}
