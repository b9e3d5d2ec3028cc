/**
 * Where the tip is when the head stands at a pose.
 *
 *     tip = head - back · (sin C, -cos C) - half width · (cos C, sin C)      V-cutter
 *     tip = head - trail · (cos C, sin C)                                    drag knife
 *     tip = head                                                             all others
 */

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

export const UNDER_THE_HEAD: TipOffset = { left: 0, behind: 0, blade: 0 };

/** The offset of a tool as the library describes it. */
export function tipOffset(kind: string, dimensions: Record<string, number | boolean>): TipOffset {
  const size = (name: string): number => {
    const value = dimensions[name];
    return typeof value === "number" ? value : 0;
  };
  if (kind === "v-cutter") {
    const half = size("half_width");
    return { left: size("back"), behind: half, blade: 2 * half };
  }
  if (kind === "knife") return { left: 0, behind: size("trail"), blade: 0 };
  return UNDER_THE_HEAD;
}

export function tipOf(pose: Pose, offset: TipOffset): Point {
  const c = radians(degree(pose.c));
  const sin = Math.sin(c);
  const cos = Math.cos(c);
  return {
    x: pose.x - offset.left * sin - offset.behind * cos,
    y: pose.y + offset.left * cos - offset.behind * sin,
  };
}
