/** The import report: what was kept, merged and dropped, and which edges or entities each means. */

import type { Drawing, LedgerRow, ReportGroup } from "../api/client";
import { type Box, type Edges, FATES, type Fate, fateOf } from "../geometry/records";
import { rowsOfHandles } from "./rows";

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

/** Where an entity is seen: its edges, those that it lies on, or the box around what it is. */
export type Found =
  | { readonly rows: readonly number[] }
  | { readonly pin: Box; readonly box: Box }
  | null;

/** Of words so much is shown to each side (heights of the letters) … */
const AROUND = 14;
/** … of all else so much of its size … */
const BESIDE = 0.75;
/** … and at least this part of the drawing. */
const LEAST = 0.25;

export function foundOf(edges: Edges, drawing: Drawing, row: LedgerRow): Found {
  const twin = /: the same as (\S+)$/.exec(row.reason)?.[1];
  const own = rowsOfHandles(edges, [row.handle]);
  const rows = own.length > 0 || twin === undefined ? own : rowsOfHandles(edges, [twin]);
  if (rows.length > 0) return { rows };
  const [x, y, height = 0] = row.place ?? [];
  const [x0 = x, y0 = y, x1 = x, y1 = y] = row.box ?? [];
  if (x0 === undefined || y0 === undefined || x1 === undefined || y1 === undefined) return null;
  const side = Math.max(
    AROUND * height,
    BESIDE * Math.max(x1 - x0, y1 - y0),
    LEAST * Math.max(drawing.width, drawing.height),
  );
  const [middleX, middleY] = [(x0 + x1) / 2, (y0 + y1) / 2];
  return {
    pin: [x0, y0, x1, y1],
    box: [middleX - side, middleY - side, middleX + side, middleY + side],
  };
}

/** A report in a few words: entities and edges that are not there as they were drawn. */
export function outcome(report: Report): string {
  const sum = (fate: Fate) =>
    report.groups.reduce((all, one) => (one.fate === fate ? all + one.count : all), 0);
  const told = (["dropped", "merged"] as const)
    .map((fate) => ({ fate, many: sum(fate) }))
    .filter(({ many }) => many > 0)
    .map(({ fate, many }) => `${many.toLocaleString("en")} ${fate}`);
  return told.length > 0 ? told.join(" · ") : "all kept";
}

/** Whether an edge is not made: dropped, or made by another that it lies on. */
export const isGone = (edges: Edges, row: number): boolean => fateOf(edges.fate[row]) === "dropped";
