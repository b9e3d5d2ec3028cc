/** The colour scheme: that of the system or the one that the user has chosen, and its colours. */

import { useComputedColorScheme } from "@mantine/core";
import { useLayoutEffect } from "react";
import { COLOURS, propertyOf, type Scheme } from "../../state/drawing/palette";

/** The colour scheme on display. */
export const useScheme = (): Scheme =>
  useComputedColorScheme("dark", { getInitialValueInEffect: false });

/** Set the colours of drawings, which style sheets use, to those of the scheme. */
export function useSchemeColours(): void {
  const scheme = useScheme();
  useLayoutEffect(() => {
    const { style } = document.documentElement;
    for (const [name, colour] of Object.entries(COLOURS[scheme]))
      style.setProperty(propertyOf(name as keyof (typeof COLOURS)[Scheme]), colour);
  }, [scheme]);
}
