/** The import report: what was kept, merged and dropped, and which edges or entities each means. */

import type { Drawing, LedgerRow, ReportGroup } from "../api/client";
import { type Edges, FATES, type Fate, fateOf } from "../geometry/records";

/** The order in which they are read: what is not there first. */
export const FATES_SHOWN: readonly Fate[] = ["dropped", "merged", "kept"];

export interface Share {
  readonly fate: Fate;
  /** mm */
  readonly length: number;
  /** of all that was drawn: 0 … 1 */
  readonly share: number;
}

type Report = NonNullable<Drawing["report"]>;

/** How the drawn length is shared out; together it is all of it. */
export function shares(report: Report): Share[] {
  return FATES.map((fate) => {
    const length = report[fate];
    return { fate, length, share: report.drawn > 0 ? length / report.drawn : 0 };
  });
}

/** The groups of some fate, or all; what is simply kept needs no reason, and comes last. */
export const groupsOf = (report: Report, fate: Fate | null): ReportGroup[] =>
  report.groups.filter((group) => fate === null || group.fate === fate);

/**
 * The edges of a group; none for entities that are no lines.
 *
 * They are found by the reason: of an edge that is kept a part may be merged, for that reason too.
 */
export function rowsOfGroup(edges: Edges, group: ReportGroup): number[] {
  if (group.what !== "edges") return [];
  const rows: number[] = [];
  for (let row = 0; row < edges.bulge.length; row++) {
    const reason = edges.reasons[edges.reason[row] ?? 0] ?? "";
    if (reason === group.reason) rows.push(row);
  }
  return rows;
}

/** The entities of a group as the ledger lists them. */
export const entitiesOf = (ledger: readonly LedgerRow[], group: ReportGroup): LedgerRow[] =>
  group.what === "edges"
    ? []
    : ledger.filter((row) => row.fate === group.fate && (row.theme || row.reason) === group.reason);

/** Whether an edge is not made: dropped, or made by another that it lies on. */
export const isGone = (edges: Edges, row: number): boolean => fateOf(edges.fate[row]) === "dropped";
