/** What the operator decides about tools at the end of their lives, before a job or copy starts. */

import { useState } from "react";
import type { Confirmation } from "../../api/jobs";

export type ToolToConfirm = Confirmation["tools"][number];

/** Greatest number of characters of a reason. */
export const REASON_LENGTH = 200;

/** The decision as it is sent with the confirmation. */
export interface ToolDecision {
  /** Stations into which new tools were put. */
  readonly changed: number[];
  /** Why the other ones stay in use; empty if all were changed. */
  readonly reason: string;
}

export const NO_DECISION: ToolDecision = { changed: [], reason: "" };

export interface WornToolsState {
  /** Tools of the job at the end of their lives. */
  readonly worn: readonly ToolToConfirm[];
  readonly changed: ReadonlySet<number>;
  readonly reason: string;
  toggle(station: number): void;
  explain(reason: string): void;
  /** null: it is not decided yet, and the job must not start. */
  readonly decision: ToolDecision | null;
}

export const wornToolsOf = (asked: Confirmation): readonly ToolToConfirm[] =>
  asked.tools.filter(({ warning }) => warning === "over");

/** The decision; null if a tool is neither changed nor kept for a reason. */
export function decisionOf(
  worn: readonly ToolToConfirm[],
  changed: ReadonlySet<number>,
  reason: string,
): ToolDecision | null {
  const stations = worn.map(({ station }) => station).filter((station) => changed.has(station));
  const kept = worn.length - stations.length;
  const text = reason.trim();
  if (kept > 0 && text === "") return null;
  return { changed: stations, reason: kept > 0 ? text : "" };
}

const NONE: ReadonlySet<number> = new Set();

/** `of` names the copy that is confirmed: a decision is void for another one. */
export function useWornTools(asked: Confirmation | undefined, of: string): WornToolsState {
  const [made, setMade] = useState({ of: "", changed: NONE, reason: "" });
  const { changed, reason } = made.of === of ? made : { changed: NONE, reason: "" };
  const worn = asked === undefined ? [] : wornToolsOf(asked);
  return {
    worn,
    changed,
    reason,
    toggle: (station) => {
      const next = new Set(changed);
      if (!next.delete(station)) next.add(station);
      setMade({ of, changed: next, reason });
    },
    explain: (text) => setMade({ of, changed, reason: text }),
    decision: asked === undefined ? null : decisionOf(worn, changed, reason),
  };
}
