/** Texts and links of panels: parts of the component library with the looks of the page. */

import { Anchor, Group, Text, ThemeIcon } from "@mantine/core";

/** A remark below a control, or in place of an empty list. */
export const Note = Text.withProps({ fz: 12, lh: 1.5, c: "ink.3" });

/** What to do about a report. */
export const Hint = Text.withProps({ component: "div", fz: 12, lh: 1.5, mt: 6, c: "ink.2" });

/** A figure at the end of a row. */
export const Figure = Text.withProps({
  span: true,
  fz: 12,
  c: "ink.3",
  style: { whiteSpace: "nowrap", fontVariantNumeric: "tabular-nums" },
});

/** A name that is cut off where the row ends. */
export const Name = Text.withProps({ span: true, flex: 1, miw: 0, truncate: "end" });

/** The number of a station. */
export const StationNumber = ThemeIcon.withProps({
  variant: "default",
  size: 20,
  radius: 5,
  fz: 11,
  fw: 600,
});

/** A command in a text. */
export const LinkButton = Anchor.withProps({
  component: "button",
  type: "button",
  fz: 12,
  underline: "hover",
});

/** Figures below a bar, from side to side. */
export const Figures = Group.withProps({ justify: "space-between", gap: 8, fz: 12, c: "ink.2" });

/** Colours of badges by the tone of what they state. */
export const BADGE_COLOURS = {
  grey: "gray",
  blue: "blue",
  green: "green",
  amber: "yellow",
  red: "red",
} as const;
