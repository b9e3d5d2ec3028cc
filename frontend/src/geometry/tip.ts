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
  /** to the left of C */
  readonly left: number;
  /** behind, along C */
  readonly behind: number;
  /** The blade's edge from the tip forward along C: only a V-cutter has one to draw. */
  readonly blade: number;
}

export const NO_OFFSET: TipOffset = { left: 0, behind: 0, blade: 0 };

/** The offset of a tool's tip. */
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
