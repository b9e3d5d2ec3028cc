/** Kinds and dimensions of tools in words. */

import type { Machine } from "../api/client";

const DIMENSIONS: Readonly<Record<string, string>> = {
  back: "tip offset beside head axis",
  blade_angle: "blade angle",
  blade_width: "blade width",
  half_width: "tip offset behind head axis",
  least_radius: "least radius of a bend",
  radius: "tool radius",
  tilt: "blade tilt",
  trail: "tip offset behind head axis",
  width: "tool width",
};
const ANGLES = new Set(["tilt", "blade_angle"]);

/** Kind of a tool as a title. */
export const kindText = (kind: string): string =>
  kind.charAt(0).toUpperCase() + (kind === "v-cutter" ? kind : kind.replaceAll("-", " ")).slice(1);

export const dimensionText = ({ dimensions }: Machine["stations"][number]["tool"]): string =>
  Object.entries(dimensions)
    .filter(([name, value]) => name in DIMENSIONS && typeof value === "number" && value !== 0)
    .map(([name, value]) => `${DIMENSIONS[name]} ${value}${ANGLES.has(name) ? "°" : "\u202fmm"}`)
    .join(" · ");
