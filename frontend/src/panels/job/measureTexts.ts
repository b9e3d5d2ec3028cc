/** Names and values of the measures of a section. */

import type { ToolSection } from "../../api/jobs";
import { formatFixed, formatNumber } from "../../language/numbers";
import { translate } from "../../language/translate";
import type { Measure, MeasureName } from "../../state/job/section";

const TITLES: Readonly<Record<Exclude<MeasureName, "base" | "topWidth">, string>> = {
  caliper: translate("sectionPanel.caliper"),
  depth: translate("sectionPanel.depth"),
  beyond: translate("sectionPanel.beyond"),
  foldAngle: translate("sectionPanel.foldAngle"),
  requiredFold: translate("sectionPanel.requiredFold"),
  flankAngle: translate("sectionPanel.flankAngle"),
  passes: translate("sectionPanel.passes"),
  rimWidth: translate("sectionPanel.rimWidth"),
  wheelRadius: translate("sectionPanel.wheelRadius"),
  contactLength: translate("sectionPanel.contactLength"),
  bladeWidth: translate("sectionPanel.bladeWidth"),
  bladeAngle: translate("sectionPanel.bladeAngle"),
  bladeLead: translate("sectionPanel.bladeLead"),
};

/** What remains below the tool, and what is open in the top face, by the shape of the tool's mark. */
const BASES: Readonly<Record<ToolSection["shape"], string>> = {
  groove: translate("sectionPanel.web"),
  wheel: translate("sectionPanel.base"),
  line: translate("sectionPanel.left"),
  disc: translate("sectionPanel.left"),
};
const WIDTHS: Readonly<Record<ToolSection["shape"], string>> = {
  groove: translate("sectionPanel.topWidth"),
  wheel: translate("sectionPanel.rimWidth"),
  line: translate("sectionPanel.slotWidth"),
  disc: translate("sectionPanel.slotWidth"),
};

export function measureTitle({ name }: Measure, { shape }: ToolSection): string {
  if (name === "base") return BASES[shape];
  return name === "topWidth" ? WIDTHS[shape] : TITLES[name];
}

const THIN = "\u202f";

export function measureText({ value, unit }: Pick<Measure, "value" | "unit">): string {
  if (unit === "°") return `${formatFixed(value, 1)}°`;
  return unit === "" ? formatNumber(value) : `${formatFixed(value, 2)}${THIN}mm`;
}
