/** The import report: what was kept, merged and dropped, and which edges or entities each means. */

import type { Drawing, ImportReportRow, ReportGroup } from "../../api/drawings";
import {
  type Box,
  type Edges,
  type ImportOutcome,
  OUTCOMES,
  outcomeOf,
} from "../../geometry/records";
import { translate } from "../../language/translate";
import { typed } from "../../messages/translateMessage";
import { rowsOfHandles } from "./rows";

/** Filters of the import report, in display order. */
export const OUTCOME_FILTERS: readonly ImportOutcome[] = ["dropped", "merged", "kept"];

export interface Share {
  readonly outcome: ImportOutcome;
  /** mm */
  readonly length: number;
  /** of the drawn length: 0 … 1 */
  readonly share: number;
}

type Report = NonNullable<Drawing["report"]>;

/** Length of each outcome; the sum is the drawn length. */
export function lengthShares(report: Report): Share[] {
  return OUTCOMES.map((outcome) => {
    const length = report[outcome];
    return { outcome, length, share: report.drawn > 0 ? length / report.drawn : 0 };
  });
}

/** Warnings about objects that the import left out; warnings about the unit are shown with it. */
export const importWarnings = ({ warnings = [] }: Pick<Drawing, "warnings">) =>
  warnings.filter(({ code }) => code.startsWith("import."));

/** Groups with some outcome, or all. */
export const groupsOf = (report: Report, outcome: ImportOutcome | null): ReportGroup[] =>
  report.groups.filter((group) => outcome === null || group.outcome === outcome);

/**
 * Rows of the edges of a group; none for entities that are not lines.
 *
 * Edges are found by the reason, because part of a kept edge may have been merged.
 */
export function rowsOfGroup(edges: Edges, group: ReportGroup): number[] {
  if (group.what !== "edges") return [];
  const rows: number[] = [];
  for (let row = 0; row < edges.bulge.length; row++) {
    const reason = edges.reasons[edges.reason[row] ?? 0] ?? "";
    if (reason === group.reason.text) rows.push(row);
  }
  return rows;
}

/** Entities of a group, from the import report. */
export const entitiesOf = (
  rows: readonly ImportReportRow[],
  group: ReportGroup,
): ImportReportRow[] =>
  group.what === "edges"
    ? []
    : rows.filter((row) => row.outcome === group.outcome && row.reason.code === group.reason.code);

/** Location of an entity: its edges, those that it coincides with, or its bounding box. */
export type EntityLocation =
  | { readonly rows: readonly number[] }
  | { readonly pin: Box; readonly box: Box }
  | null;

/** Margin about a text (letter heights) … */
const TEXT_MARGIN = 14;
/** … about other entities (relative to their size) … */
const BOX_MARGIN = 0.75;
/** … and at least (relative to the drawing). */
const MIN_MARGIN = 0.25;

export function locateEntity(edges: Edges, drawing: Drawing, row: ImportReportRow): EntityLocation {
  const reason = typed(row.reason);
  const twin = reason.code === "import.drawn-twice" ? reason.arguments.same[0] : undefined;
  const own = rowsOfHandles(edges, [row.handle]);
  const rows = own.length > 0 || twin === undefined ? own : rowsOfHandles(edges, [twin]);
  if (rows.length > 0) return { rows };
  const [x, y, height = 0] = row.place ?? [];
  const [x0 = x, y0 = y, x1 = x, y1 = y] = row.box ?? [];
  if (x0 === undefined || y0 === undefined || x1 === undefined || y1 === undefined) return null;
  const side = Math.max(
    TEXT_MARGIN * height,
    BOX_MARGIN * Math.max(x1 - x0, y1 - y0),
    MIN_MARGIN * Math.max(drawing.width, drawing.height),
  );
  const [middleX, middleY] = [(x0 + x1) / 2, (y0 + y1) / 2];
  return {
    pin: [x0, y0, x1, y1],
    box: [middleX - side, middleY - side, middleX + side, middleY + side],
  };
}

const COUNTS = { dropped: "importReport.dropped", merged: "importReport.merged" } as const;

/** Short summary of a report: numbers of dropped and merged entities and edges. */
export function summarizeReport(report: Report): string {
  const sum = (outcome: ImportOutcome) =>
    report.groups.reduce((all, one) => (one.outcome === outcome ? all + one.count : all), 0);
  const parts = (["dropped", "merged"] as const)
    .map((outcome) => ({ outcome, many: sum(outcome) }))
    .filter(({ many }) => many > 0)
    .map(({ outcome, many }) => translate(COUNTS[outcome], { many }));
  return parts.length > 0 ? parts.join(", ") : translate("importReport.allObjectsKept");
}

/** Whether an edge was dropped by the cleaning. */
export const isDropped = (edges: Pick<Edges, "outcome">, row: number): boolean =>
  outcomeOf(edges.outcome[row]) === "dropped";
