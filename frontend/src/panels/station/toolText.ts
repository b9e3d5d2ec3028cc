/** Kinds and dimensions of tools in words. */

import type { Machine } from "../../api/machines";
import { formatNumber } from "../../language/numbers";
import { translate } from "../../language/translate";

const DIMENSIONS: Readonly<Record<string, string>> = {
  back: translate("toolText.tipOffsetBesideHeadAxis"),
  blade_angle: translate("toolText.bladeAngle"),
  blade_width: translate("toolText.bladeWidth"),
  half_width: translate("toolText.tipOffsetBehindHeadAxis"),
  least_radius: translate("toolText.leastRadiusOfABend"),
  radius: translate("toolText.toolRadius"),
  tilt: translate("toolText.bladeTilt"),
  trail: translate("toolText.tipOffsetBehindHeadAxis"),
  width: translate("toolText.toolWidth"),
};
const ANGLES = new Set(["tilt", "blade_angle"]);

const KINDS: Readonly<Record<string, string>> = {
  knife: translate("toolText.knife"),
  "crease-wheel": translate("toolText.creaseWheel"),
  "v-cutter": translate("toolText.vCutter"),
  cutter: translate("toolText.cutter"),
  laser: translate("toolText.laser"),
};

/** Kind of a tool as a title. */
export const kindText = (kind: string): string => KINDS[kind] ?? kind;

export const dimensionText = ({ dimensions }: Machine["stations"][number]["tool"]): string =>
  Object.entries(dimensions)
    .filter(([name, value]) => name in DIMENSIONS && typeof value === "number" && value !== 0)
    .map(
      ([name, value]) =>
        `${DIMENSIONS[name]} ${formatNumber(Number(value))}${ANGLES.has(name) ? "°" : "\u202fmm"}`,
    )
    .join(" · ");
