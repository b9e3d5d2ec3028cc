/**
 * Changes of line types that can be taken back.
 *
 * The service keeps overrides, the later on top; undo is one more of them. An edge that had none
 * before gets its override taken back, so that the profile decides again and says by which rule.
 */

import type { Override } from "../api/client";
import { type Edges, type LineType, lineTypeOf } from "../geometry/records";

/** What the service gives as the rule of an edge that somebody decided. */
const BY_HAND = "override";

export interface Change {
  readonly rows: readonly number[];
  readonly to: LineType | null;
  /** For each row: the type that an override gave it before; null where a rule decided. */
  readonly before: readonly (LineType | null)[];
}

export const isByHand = (edges: Edges, row: number): boolean =>
  edges.rules[edges.rule[row] ?? -1] === BY_HAND;

/** The change that gives these rows a type (null: lets the rules decide again). */
export function changeOf(edges: Edges, rows: readonly number[], to: LineType | null): Change {
  return {
    rows: [...rows],
    to,
    before: rows.map((row) => (isByHand(edges, row) ? lineTypeOf(edges.lineType[row]) : null)),
  };
}

/** The overrides that make a change. */
export const forwards = (change: Change): Override[] => [
  { type: change.to, edges: [...change.rows] },
];

/** The overrides that take it back: one to each type that there was before. */
export function backwards(change: Change): Override[] {
  const byType = new Map<LineType | null, number[]>();
  change.rows.forEach((row, at) => {
    const type = change.before[at] ?? null;
    const rows = byType.get(type);
    if (rows === undefined) byType.set(type, [row]);
    else rows.push(row);
  });
  return [...byType].map(([type, edges]) => ({ type, edges }));
}
