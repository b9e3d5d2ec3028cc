/** Where two straight lines cross. */

import type { Point } from "./records";

export type Line = readonly [x0: number, y0: number, x1: number, y1: number];

/** Where two lines cross between their ends; null if they do not. */
export function crossing(line: Line, other: Line): Point | null {
  const [x0, y0, x1, y1] = line;
  const [u0, v0, u1, v1] = other;
  const cross = (x1 - x0) * (v1 - v0) - (y1 - y0) * (u1 - u0);
  if (Math.abs(cross) < 1e-9) return null;
  const along = ((u0 - x0) * (v1 - v0) - (v0 - y0) * (u1 - u0)) / cross;
  const across = ((u0 - x0) * (y1 - y0) - (v0 - y0) * (x1 - x0)) / cross;
  if (Math.min(along, across) < -1e-9 || Math.max(along, across) > 1 + 1e-9) return null;
  return { x: x0 + along * (x1 - x0), y: y0 + along * (y1 - y0) };
}
