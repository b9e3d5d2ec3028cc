/** Theme of the component library. */

import { createTheme, type MantineColorsTuple } from "@mantine/core";
import { decimalSeparator } from "../language/numbers";
import { translate } from "../language/translate";

const dark: MantineColorsTuple = [
  "#eef2f7",
  "#ccd4de",
  "#98a4b3",
  "#6c7887",
  "#3b4553",
  "#2b333f",
  "#222932",
  "#191e26",
  "#12161c",
  "#0e1116",
];

const blue: MantineColorsTuple = [
  "#e8f3ff",
  "#cfe4ff",
  "#9fc8ff",
  "#6cabff",
  "#4693ff",
  "#2f84fb",
  "#2277f0",
  "#1866d6",
  "#0f58bd",
  "#0848a0",
];

/** Dark enough for white text. */
const green: MantineColorsTuple = [
  "#e6f9f0",
  "#c9f0dd",
  "#9be3c1",
  "#6bd6a5",
  "#35d08f",
  "#1fae74",
  "#10925d",
  "#0b7d4e",
  "#096a42",
  "#065234",
];

/** Dark enough for white text. */
const red: MantineColorsTuple = [
  "#fff5f5",
  "#ffe3e3",
  "#ffc9c9",
  "#ffa8a8",
  "#ff8787",
  "#fa5252",
  "#e03131",
  "#c92a2a",
  "#b02525",
  "#971f1f",
];

/** Colours of text, which follow the colour scheme: "ink.0" for headings to "ink.3" for notes. */
const INKS = [0, 1, 2, 3, 3, 3, 3, 3, 3, 3].map((ink) => `var(--ink-${ink})`);
const ink = INKS as unknown as MantineColorsTuple;

export const theme = createTheme({
  fontFamily: '"Inter Variable", system-ui, sans-serif',
  fontFamilyMonospace: 'ui-monospace, "SF Mono", Menlo, Consolas, monospace',
  colors: { dark, blue, green, red, ink },
  primaryColor: "blue",
  primaryShade: 7,
  defaultRadius: 8,
  // Those of the style sheets: phones, tablets upright and tablets across.
  breakpoints: { xs: "37.5em", sm: "56.25em", md: "68.75em", lg: "80em", xl: "90em" },
  cursorType: "pointer",
  focusRing: "auto",
  components: {
    Tooltip: { defaultProps: { openDelay: 350, withArrow: false, fz: 12, color: "dark.6" } },
    Select: {
      defaultProps: { size: "sm", checkIconPosition: "right", comboboxProps: { shadow: "lg" } },
    },
    Input: { defaultProps: { size: "sm" } },
    InputWrapper: {
      styles: { label: { color: "var(--ink-2)", fontSize: 12, fontWeight: 500, marginBottom: 4 } },
    },
    // A comma and a point are both typed as the separator of decimals.
    NumberInput: { defaultProps: { decimalSeparator, allowedDecimalSeparators: [".", ","] } },
    Button: { defaultProps: { fw: 600 } },
    Text: { defaultProps: { inherit: true } },
    Title: { defaultProps: { c: "ink.0", fw: 650 } },
    Anchor: { defaultProps: { c: "var(--accent-ink)", inherit: true, underline: "always" } },
    Badge: { defaultProps: { variant: "light", tt: "none", fw: 600, lts: 0 } },
    Paper: { defaultProps: { withBorder: true } },
    Fieldset: {
      defaultProps: { miw: 0 },
      styles: { legend: { paddingInline: 4, fontSize: "inherit", fontWeight: 500 } },
    },
    Progress: { defaultProps: { radius: "sm" } },
    // A menu that is longer than the space beside its button scrolls inside the window.
    Menu: {
      defaultProps: {
        middlewares: {
          flip: { fallbackStrategy: "bestFit" },
          shift: true,
          size: { padding: 8 },
        },
      },
      styles: { dropdown: { overflowY: "auto" } },
    },
    Modal: {
      defaultProps: {
        closeButtonProps: { "aria-label": translate("theme.close") },
        // Its header is an HTML header, and the page has a banner already.
        attributes: { header: { role: "presentation" } },
      },
    },
  },
});
