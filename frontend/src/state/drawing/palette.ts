/** Colours and dashes, shared by canvas and legends. */

import type { LineType } from "../../geometry/records";
import { translate } from "../../language/translate";

export interface LineStyle {
  readonly title: string;
  readonly colour: string;
  readonly dash: "solid" | "dashed" | "dotted" | "long";
  /** Keyboard shortcut that sets it. */
  readonly key: string;
}

export const LINE_STYLES: Readonly<Record<LineType, LineStyle>> = {
  cut: { title: translate("palette.cut"), colour: "#ff6b61", dash: "solid", key: "1" },
  crease: { title: translate("palette.crease"), colour: "#3ddc97", dash: "dashed", key: "2" },
  "v-groove": { title: translate("palette.vGroove"), colour: "#b794ff", dash: "solid", key: "3" },
  perforation: {
    title: translate("palette.perforation"),
    colour: "#ffc53d",
    dash: "dotted",
    key: "4",
  },
  "half-cut": { title: translate("palette.halfCut"), colour: "#ff9446", dash: "long", key: "5" },
  combi: { title: translate("palette.combiCutCrease"), colour: "#d3df62", dash: "long", key: "6" },
  ignored: { title: translate("palette.ignored"), colour: "#7d8794", dash: "solid", key: "7" },
  unclassified: {
    title: translate("palette.undecided"),
    colour: "#ff2fd6",
    dash: "solid",
    key: "",
  },
};

/** In the order of the legend. */
export const LEGEND: readonly LineType[] = [
  "unclassified",
  "cut",
  "crease",
  "v-groove",
  "perforation",
  "half-cut",
  "combi",
  "ignored",
];

/** Line types that can be set by hand. */
export const ASSIGNABLE_TYPES: readonly LineType[] = LEGEND.filter(
  (type) => type !== "unclassified",
);

export const TRAVEL = {
  head: "#5cbcff",
  lead: "#2b7fc4",
  tip: "#e8eef6",
  rapid: "#66717f",
  done: "#f4f8ff",
} as const;

/**
 * Colour scale of a figure from 0 to its limit.
 *
 * Neighbouring stops have equal distances in OKLab and increasing lightness, so that equal steps
 * of the figure look equal, also in shades of grey.
 */
export const SCALE = {
  stops: [
    "#3f6dd7",
    "#1e86d2",
    "#209cc7",
    "#19b2bd",
    "#47c4ac",
    "#69d496",
    "#99df76",
    "#cbe865",
    "#faf164",
  ],
  beyond: "#ff4249",
  unworked: "#525c69",
} as const;

/** Area that a tool cuts or presses. */
export const SWEPT = {
  cutter: "#5cbcff",
  groove: "#b794ff",
  crease: "#3ddc97",
} as const;

/** Area that no tool reaches. */
export const UNCUT = "#ff4fa3";

/** Moves without length in the plane. */
export const MARKS = {
  plunge: "#ff9446",
  lift: "#8fe3ff",
  swivel: "#f3e36b",
} as const;

export const CANVAS = {
  backdrop: "#0e1116",
  table: "#151a21",
  tableEdge: "#3a4554",
  sheetEdge: "#c9b48a",
  zone: "#e0655c",
  gridMinor: "#ffffff",
  gridMajor: "#ffffff",
  hover: "#ffffff",
  chosen: "#3b82f6",
  pin: "#6cabff",
  mark: "#ffffff",
  blade: "#ffe27a",
} as const;
