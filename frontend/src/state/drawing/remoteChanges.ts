/** Changes of the open drawing by others: what differs, and which changes can still be undone. */

import type { Drawing } from "../../api/drawings";
import type { Edges } from "../../geometry/records";
import { translate } from "../../language/translate";
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
  if (before.unit !== after.unit)
    parts.push(
      translate("remoteChanges.itsUnitIsNow", {
        unit: after.unit ?? translate("remoteChanges.unitUnknown"),
      }),
    );
  if (before.profile !== after.profile || before.rules !== after.rules)
    parts.push(translate("remoteChanges.itsProfileIsNow", { profile: after.profile }));
  if (rows === null) parts.push(translate("remoteChanges.itsEdgesWereReadAgain"));
  else if (rows.length > 0)
    parts.push(translate("remoteChanges.edgesNowHaveAnotherLine", { rows: rows.length }));
  return parts.length === 0 ? translate("remoteChanges.lineTypesUnitAndProfile") : parts.join(", ");
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
