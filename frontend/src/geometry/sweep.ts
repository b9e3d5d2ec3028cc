/** What a tool takes of the board, or presses, about its tip at a depth h. */

import type { Footprint } from "./footprint";

export type Sweep =
  /** A disc of radius r: of a beam at any height, of a cutter below the board's top face. */
  | { readonly kind: "disc"; readonly radius: number; readonly anyHeight: boolean }
  /** h · slope to the right of travel, along the blade. */
  | { readonly kind: "groove"; readonly slope: number; readonly blade: number }
  /** A rim, over √(h (2R - h)) before and behind. */
  | { readonly kind: "wheel"; readonly radius: number; readonly width: number };

/** What a tool sweeps; null where that is no wider than its line. */
export function sweepOf(footprint: Footprint): Sweep | null {
  const { shape, radius, width, slope, blade } = footprint;
  if (shape === "disc") return { kind: shape, radius, anyHeight: footprint.any_height };
  if (shape === "wheel") return { kind: shape, radius, width };
  if (shape === "groove") return { kind: shape, slope, blade };
  return null;
}

/** Half the length over which a wheel touches the board (mm). */
export const contactOf = (radius: number, depth: number): number =>
  Math.sqrt(Math.max(0, depth * (2 * radius - depth)));
