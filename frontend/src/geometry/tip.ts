/**
 * Position of the tip for a pose of the head.
 *
 *     tip = head - left · (sin C, -cos C) - behind · (cos C, sin C)
 */

import type { Footprint } from "./footprint";
import type { Point, Pose } from "./records";
import { degree, radians } from "./units";

/** How far the tip lies from the head's axis (mm). */
export interface TipOffset {
  /** distance to the left of C (mm) */
  readonly left: number;
  /** distance behind the head's axis, along C (mm) */
  readonly behind: number;
  /** Length of the blade's cutting edge, from the tip forward along C; 0 if none is drawn. */
  readonly blade: number;
}

export const NO_OFFSET: TipOffset = { left: 0, behind: 0, blade: 0 };

/** Offset of the tip of a tool from the head's axis. */
export const tipOffset = ({ left, behind, blade }: Footprint): TipOffset => ({
  left,
  behind,
  blade,
});

export function tipOf(pose: Pose, offset: TipOffset): Point {
  const c = radians(degree(pose.c));
  const sin = Math.sin(c);
  const cos = Math.cos(c);
  return {
    x: pose.x - offset.left * sin - offset.behind * cos,
    y: pose.y + offset.left * cos - offset.behind * sin,
  };
}
