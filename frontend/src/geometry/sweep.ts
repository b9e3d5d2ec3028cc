/** Area of the board that a tool removes or presses around its tip at a depth h. */

import type { Footprint } from "./footprint";

export type Sweep =
  /** A disc of radius r. A beam has it at any height, a cutter only below the board's top face. */
  | { readonly kind: "disc"; readonly radius: number; readonly anyHeight: boolean }
  /** A strip h · slope wide to the right of travel, along the blade. */
  | { readonly kind: "groove"; readonly slope: number; readonly blade: number }
  /** The rim of a wheel of radius R, √(h (2R - h)) long before and behind the tip. */
  | { readonly kind: "wheel"; readonly radius: number; readonly width: number };

/** The swept area of a tool; null if it is not wider than the line of the tip. */
export function sweepOf(footprint: Footprint): Sweep | null {
  const { shape, radius, width, slope, blade } = footprint;
  if (shape === "disc") return { kind: shape, radius, anyHeight: footprint.any_height };
  if (shape === "wheel") return { kind: shape, radius, width };
  if (shape === "groove") return { kind: shape, slope, blade };
  return null;
}

/** Half the length over which a wheel touches the board (mm). */
export const halfContactLength = (radius: number, depth: number): number =>
  Math.sqrt(Math.max(0, depth * (2 * radius - depth)));
