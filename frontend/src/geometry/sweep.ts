/**
 * What a tool takes of the board, or presses, about its tip at a depth h.
 *
 *     cutter         a disc of radius r
 *     V-cutter       h tan θ to the right of travel, along the blade's 2 · half width
 *     crease wheel   its rim, over s = √(h (2R - h)) before and behind
 */

import { degree, radians } from "./units";

export type Sweep =
  | { readonly kind: "disc"; readonly radius: number }
  | { readonly kind: "groove"; readonly slope: number; readonly blade: number }
  | { readonly kind: "wheel"; readonly radius: number; readonly width: number };

/** What a tool sweeps, by the library's description; null where that is no wider than its line. */
export function sweepOf(
  kind: string,
  dimensions: Readonly<Record<string, number | boolean>>,
): Sweep | null {
  const size = (name: string): number => {
    const value = dimensions[name];
    return typeof value === "number" ? value : 0;
  };
  if (kind === "cutter") return { kind: "disc", radius: size("radius") };
  if (kind === "crease-wheel")
    return { kind: "wheel", radius: size("radius"), width: size("width") };
  if (kind === "v-cutter") {
    const slope = Math.tan(radians(degree(size("tilt"))));
    return { kind: "groove", slope, blade: 2 * size("half_width") };
  }
  return null;
}

/** Half the length over which a wheel touches the board (mm). */
export const contactOf = (radius: number, depth: number): number =>
  Math.sqrt(Math.max(0, depth * (2 * radius - depth)));
