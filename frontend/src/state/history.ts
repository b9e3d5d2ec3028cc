/**
 * What somebody decided, so that it can be taken back.
 *
 * The service keeps overrides, the later on top; undo is one more of them. An edge that had none
 * before gets its override taken back, so that the profile decides again and says by which rule.
 * A unit, or the choice of a profile, is said again as it was; a profile is kept again as it was.
 */

import type { Drawing, Override, Unit } from "../api/client";
import { type Edges, type LineType, lineTypeOf } from "../geometry/records";

/** What the service gives as the rule of an edge that somebody decided. */
export const BY_HAND = "override";

/** Edges got a line type. */
export interface Retyping {
  readonly kind: "types";
  readonly rows: readonly number[];
  readonly to: LineType | null;
  /** For each row: the type that an override gave it before; null where a rule decided. */
  readonly before: readonly (LineType | null)[];
}

/** What is said of a drawing as a whole. */
export interface Said {
  readonly unit: Unit | "file";
  readonly profile: string;
  /** The customer's profile as it was when the drawing was read by it; empty for a shipped one. */
  readonly rules: string;
}

/** A drawing got a unit or a profile. */
export interface Settling {
  readonly kind: "settled";
  readonly before: Said;
  readonly after: Said;
}

/** A customer's profile was kept; null where there was none. */
export interface Keeping {
  readonly kind: "kept";
  readonly name: string;
  readonly before: string | null;
  readonly after: string | null;
  /** By which profile the drawing was classified before and after, and by which text of it. */
  readonly readBefore: ReadBy;
  readonly readAfter: ReadBy;
}

/** A profile, as it is now where no rules are told. */
export interface ReadBy {
  readonly profile: string;
  readonly rules?: string;
}

export type Change = Retyping | Settling | Keeping;

export const isByHand = (edges: Edges, row: number): boolean =>
  edges.rules[edges.rule[row] ?? -1] === BY_HAND;

/** The change that gives these rows a type (null: lets the rules decide again). */
export function changeOf(edges: Edges, rows: readonly number[], to: LineType | null): Retyping {
  return {
    kind: "types",
    rows: [...rows],
    to,
    before: rows.map((row) => (isByHand(edges, row) ? lineTypeOf(edges.lineType[row]) : null)),
  };
}

/** The overrides that make a change. */
export const forwards = (change: Retyping): Override[] => [
  { type: change.to, edges: [...change.rows] },
];

/** The overrides that take it back: one to each type that there was before. */
export function backwards(change: Retyping): Override[] {
  const byType = new Map<LineType | null, number[]>();
  change.rows.forEach((row, at) => {
    const type = change.before[at] ?? null;
    const rows = byType.get(type);
    if (rows === undefined) byType.set(type, [row]);
    else rows.push(row);
  });
  return [...byType].map(([type, edges]) => ({ type, edges }));
}

/** What is said of a drawing now. */
export const saidOf = (drawing: Drawing): Said => ({
  unit: drawing.unit_given ?? "file",
  profile: drawing.profile,
  rules: drawing.rules,
});

/** By which profile a drawing is read, and by which text of it. */
export const readBy = ({ profile, rules }: Pick<Said, "profile" | "rules">): ReadBy => ({
  profile,
  rules,
});

/** The same change the other way round. */
export function reversed<C extends Settling | Keeping>(change: C): C {
  const turned = { ...change, before: change.after, after: change.before };
  if (turned.kind !== "kept") return turned;
  const { readBefore, readAfter } = turned;
  return { ...turned, readBefore: readAfter, readAfter: readBefore };
}
