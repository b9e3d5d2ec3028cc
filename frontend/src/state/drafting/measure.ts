/** Figures between two points. */

import type { Point } from "../../geometry/records";

export interface Measured {
  /** mm */
  readonly distance: number;
  /** mm, from the first point to the second */
  readonly dx: number;
  readonly dy: number;
  /** degrees from the X axis, counter-clockwise, −180 … 180 */
  readonly angle: number;
}

export function measure(from: Point, to: Point): Measured {
  const dx = to.x - from.x;
  const dy = to.y - from.y;
  return { distance: Math.hypot(dx, dy), dx, dy, angle: (Math.atan2(dy, dx) * 180) / Math.PI };
}
