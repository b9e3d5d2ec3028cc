/** Colours and dashes, shared by canvas and legends, in the dark and in the light scheme. */

import type { LineType } from "../../geometry/records";
import { translate } from "../../language/translate";

export interface LineStyle {
  readonly title: string;
  /** Colour in style sheets, which follows the scheme. */
  readonly colour: string;
  readonly dash: "solid" | "dashed" | "dotted" | "long";
  /** Keyboard shortcut that sets it. */
  readonly key: string;
}

export type Scheme = "dark" | "light";

const DARK = {
  cut: "#ff6b61",
  crease: "#3ddc97",
  "v-groove": "#b794ff",
  perforation: "#ffc53d",
  "half-cut": "#ff9446",
  combi: "#d3df62",
  ignored: "#7d8794",
  unclassified: "#ff2fd6",
  // The path of the tool: its head, its tip, moves above the board, what is done.
  head: "#5cbcff",
  lead: "#2b7fc4",
  tip: "#e8eef6",
  rapid: "#66717f",
  done: "#f4f8ff",
  // Area that a tool cuts or presses, and area that no tool reaches.
  cutter: "#5cbcff",
  groove: "#b794ff",
  pressed: "#3ddc97",
  uncut: "#ff4fa3",
  // Moves without length in the plane.
  plunge: "#ff9446",
  lift: "#8fe3ff",
  swivel: "#f3e36b",
  // The canvas.
  backdrop: "#0e1116",
  table: "#151a21",
  tableEdge: "#3a4554",
  sheetEdge: "#c9b48a",
  zone: "#e0655c",
  grid: "#ffffff",
  axisX: "#ff6b61",
  axisY: "#3ddc97",
  hover: "#ffffff",
  chosen: "#3b82f6",
  pin: "#6cabff",
  blade: "#ffe27a",
};
type Colour = keyof typeof DARK;

const LIGHT: Readonly<Record<Colour, string>> = {
  cut: "#cf222e",
  crease: "#0a7d4b",
  "v-groove": "#7a3ff2",
  perforation: "#9a6700",
  "half-cut": "#bc4c00",
  combi: "#667300",
  ignored: "#7b8794",
  unclassified: "#c400a0",
  head: "#0b6bcb",
  lead: "#5aa2e0",
  tip: "#17202b",
  rapid: "#8592a2",
  done: "#10161d",
  cutter: "#0b6bcb",
  groove: "#7a3ff2",
  pressed: "#0a7d4b",
  uncut: "#d6006c",
  plunge: "#bc4c00",
  lift: "#0784a8",
  swivel: "#8a7400",
  backdrop: "#e4e8ee",
  table: "#fbfcfd",
  tableEdge: "#98a4b3",
  sheetEdge: "#86672a",
  zone: "#c8372d",
  grid: "#000000",
  axisX: "#cf222e",
  axisY: "#0a7d4b",
  hover: "#000000",
  chosen: "#1f6feb",
  pin: "#0b5fd0",
  blade: "#8a6d00",
};

/** Colours as hexadecimal numbers, for the canvas. */
export const COLOURS: Readonly<Record<Scheme, Readonly<Record<Colour, string>>>> = {
  dark: DARK,
  light: LIGHT,
};

/** The custom property of a colour, which `app/scheme.ts` sets. */
export const propertyOf = (name: Colour): string => `--drawn-${name}`;

const css = (name: Colour): string => `var(${propertyOf(name)})`;

const styleOf = (
  type: LineType,
  title: string,
  dash: LineStyle["dash"],
  key: string,
): LineStyle => ({ title, colour: css(type), dash, key });

export const LINE_STYLES: Readonly<Record<LineType, LineStyle>> = {
  cut: styleOf("cut", translate("palette.cut"), "solid", "1"),
  crease: styleOf("crease", translate("palette.crease"), "dashed", "2"),
  "v-groove": styleOf("v-groove", translate("palette.vGroove"), "solid", "3"),
  perforation: styleOf("perforation", translate("palette.perforation"), "dotted", "4"),
  "half-cut": styleOf("half-cut", translate("palette.halfCut"), "long", "5"),
  combi: styleOf("combi", translate("palette.combiCutCrease"), "long", "6"),
  ignored: styleOf("ignored", translate("palette.ignored"), "solid", "7"),
  unclassified: styleOf("unclassified", translate("palette.undecided"), "solid", ""),
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

/** Colours of the path in style sheets. */
export const TRAVEL = { head: css("head"), tip: css("tip"), rapid: css("rapid") } as const;

/**
 * Colour scale of a figure from 0 to its limit.
 *
 * Neighbouring stops have equal distances in OKLab and increasing lightness, so that equal steps
 * of the figure look equal, also in shades of grey. The light scheme has the same steps, darker.
 */
export const SCALE = {
  dark: {
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
  },
  light: {
    stops: [
      "#1b387b",
      "#054b7b",
      "#0c5d79",
      "#117077",
      "#317f70",
      "#4a8e66",
      "#6b9955",
      "#90a450",
      "#b4af56",
    ],
    beyond: "#e5131c",
    unworked: "#8a94a0",
  },
} as const;

/** Area that a tool cuts or presses, in style sheets. */
export const SWEPT = {
  cutter: css("cutter"),
  groove: css("groove"),
  crease: css("pressed"),
} as const;

/** Area that no tool reaches, in style sheets. */
export const UNCUT = css("uncut");

/** Moves without length in the plane, in style sheets. */
export const MARKS = { plunge: css("plunge"), lift: css("lift"), swivel: css("swivel") } as const;

/** Keep-out zones, in style sheets. */
export const ZONE = css("zone");

/** A colour of a style sheet with this share of opacity (%). */
export const translucent = (colour: string, share: number): string =>
  `color-mix(in srgb, ${colour} ${share}%, transparent)`;
