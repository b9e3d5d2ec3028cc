/** Footprints of tools, for tests. */

import type { Footprint } from "./footprint";

export const footprint = (given: Partial<Footprint>): Footprint => ({
  shape: "line",
  radius: 0,
  width: 0,
  slope: 0,
  blade: 0,
  left: 0,
  behind: 0,
  any_height: false,
  ...given,
});

export const vCutter = (back: number, halfWidth: number, slope = 1): Footprint =>
  footprint({ shape: "groove", slope, blade: 2 * halfWidth, left: back, behind: halfWidth });
