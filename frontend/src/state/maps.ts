/** The verdict as maps: which figure colours the edges, and up to what. */

import type { Verdict } from "../api/client";
import type { ColourMode } from "./store";

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

/** As far as a blade may run past an end before it is seen on any board (mm). */
const OVERCUT = 3;

/** The map of a verdict; null where the line types are to be seen, or it is of other edges. */
export function mapOf(
  mode: ColourMode,
  verdict: Verdict | undefined,
  edges: number,
): VerdictMap | null {
  if (mode === "types" || verdict === undefined) return null;
  if (verdict.edge_deviation.length !== edges) return null;
  const left = { uncut: verdict.edge_uncut, setback: verdict.edge_setback };
  return mode === "deviation"
    ? { title: "Deviation", figure: verdict.edge_deviation, limit: verdict.tolerance, ...left }
    : { title: "Overcut", figure: verdict.edge_overcut, limit: OVERCUT, ...left };
}
