/** Figures of a verdict that can colour the edges, with their limits. */

import type { Verdict } from "../../api/jobs";
import { translate } from "../../language/translate";
import type { ColourMode } from "../store";

/** Titles of the colour modes. */
export const COLOUR_MODE_TITLES: Readonly<Record<ColourMode, string>> = {
  types: translate("verdictMap.lineType"),
  deviation: translate("verdictMap.deviationFromDrawing"),
  overcut: translate("verdictMap.overcutLength"),
};

export interface VerdictMap {
  readonly title: string;
  /** (n,) mm */
  readonly figure: readonly number[];
  /** mm */
  readonly limit: number;
  /** (n,) mm */
  readonly uncut: readonly number[];
  /** (n,) mm */
  readonly setback: readonly number[];
}

/** Overcut visible on every board (mm): the end of the colour scale. */
const OVERCUT = 3;

/** The figure for a colour mode; null for line types, or if the verdict is of other edges. */
export function verdictMapOf(
  mode: ColourMode,
  verdict: Verdict | undefined,
  edges: number,
): VerdictMap | null {
  if (mode === "types" || verdict === undefined) return null;
  if (verdict.edge_deviation.length !== edges) return null;
  const common = {
    title: COLOUR_MODE_TITLES[mode],
    uncut: verdict.edge_uncut,
    setback: verdict.edge_setback,
  };
  return mode === "deviation"
    ? { ...common, figure: verdict.edge_deviation, limit: verdict.tolerance }
    : { ...common, figure: verdict.edge_overcut, limit: OVERCUT };
}
