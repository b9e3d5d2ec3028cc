/** Changes of the open drawing by others: what differs, and which changes can still be undone. */

import type { Drawing } from "../api/client";
import type { Edges } from "../geometry/records";
import { pluralize } from "./format";
import type { Change } from "./history";

/** Rows of edges whose type or rule differs; null if the edges themselves were replaced. */
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

/** Describe the differences to the user. */
export function describeDifference(
  before: Drawing,
  after: Drawing,
  rows: readonly number[] | null,
): string {
  const parts: string[] = [];
  if (before.unit !== after.unit) parts.push(`its unit is now ${after.unit ?? "unknown"}`);
  if (before.profile !== after.profile || before.rules !== after.rules)
    parts.push(`its profile is now ${after.profile}`);
  if (rows === null) parts.push("its edges were read again from the file");
  else if (rows.length > 0)
    parts.push(
      `${pluralize(rows.length, "edge")} ${rows.length === 1 ? "now has" : "now have"} another line type`,
    );
  return parts.length === 0 ? "line types, unit and profile are as before" : parts.join(", ");
}

/**
 * The changes that can still be undone: those after the last one that affects the given rows.
 * Undoing that one, or one before it, would overwrite the changes of others.
 */
export function undoableChanges(past: readonly Change[], rows: readonly number[] | null): Change[] {
  if (rows === null) return [];
  const theirs = new Set(rows);
  const last = past.findLastIndex(
    (change) => change.kind !== "types" || change.rows.some((row) => theirs.has(row)),
  );
  return rows.length === 0 ? [...past] : past.slice(last + 1);
}
