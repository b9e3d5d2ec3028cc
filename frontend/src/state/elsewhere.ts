/** What others made of the drawing that is open: how it differs, and what of it can be undone. */

import type { Drawing } from "../api/client";
import type { Edges } from "../geometry/records";
import type { Change } from "./history";
import { count } from "./words";

/** Rows of edges whose type or rule differs; null where the edges are not the same ones. */
export function changedRows(before: Edges, after: Edges): number[] | null {
  const same =
    before.handles.length === after.handles.length &&
    before.handles.every((handle, row) => handle === after.handles[row]);
  if (!same) return null;
  const rows: number[] = [];
  after.lineType.forEach((type, row) => {
    const ruled = before.rules[before.rule[row] ?? -1] === after.rules[after.rule[row] ?? -1];
    if (type !== before.lineType[row] || !ruled) rows.push(row);
  });
  return rows;
}

/** What differs, in words. */
export function difference(
  before: Drawing,
  after: Drawing,
  rows: readonly number[] | null,
): string {
  const parts: string[] = [];
  if (before.unit !== after.unit) parts.push(`its unit is ${after.unit ?? "open"}`);
  if (before.profile !== after.profile || before.rules !== after.rules)
    parts.push(`it is classified by the profile ${after.profile}`);
  if (rows === null) parts.push("its edges are new");
  else if (rows.length > 0)
    parts.push(`${count(rows.length, "edge")} ${rows.length === 1 ? "has" : "have"} another type`);
  return parts.length === 0 ? "nothing that is shown differs" : parts.join(", ");
}

/**
 * The steps that can still be undone: those after the last one that touches what others changed.
 * To undo that one, or any before it, would overwrite what they did.
 */
export function undoable(past: readonly Change[], rows: readonly number[] | null): Change[] {
  if (rows === null) return [];
  const theirs = new Set(rows);
  const last = past.findLastIndex(
    (change) => change.kind !== "types" || change.rows.some((row) => theirs.has(row)),
  );
  return rows.length === 0 ? [...past] : past.slice(last + 1);
}
