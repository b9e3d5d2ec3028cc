/**
 * Changes made by the user, with what is needed to undo them.
 *
 * The server stores overrides in order, and the last one wins; undo adds another override. An
 * edge without a previous override has it removed, so that the rules of the profile apply again.
 * To undo a change of unit or profile, the previous value is sent.
 */

import type { Drawing, Override, Unit } from "../api/client";
import { type Edges, type LineType, lineTypeOf } from "../geometry/records";
import type { Code } from "../messages/catalogue";

/** Message code of the rule of an edge whose line type the user has set. */
const OVERRIDE_CODE: Code = "classification.override";

/** The line type of edges was changed. */
export interface RetypeChange {
  readonly kind: "types";
  readonly rows: readonly number[];
  readonly to: LineType | null;
  /** For each row: the type of its previous override; null if a rule decided. */
  readonly before: readonly (LineType | null)[];
}

/** Settings by which a drawing is read. */
export interface ReadingSettings {
  readonly unit: Unit | "file";
  readonly profile: string;
  /** Text of the customer profile when it was applied; empty for a built-in profile. */
  readonly rules: string;
}

/** The unit or the profile of the drawing was changed. */
export interface SettingsChange {
  readonly kind: "settings";
  readonly before: ReadingSettings;
  readonly after: ReadingSettings;
}

/** A customer profile was created, changed or deleted; null: it did not exist. */
export interface ProfileChange {
  readonly kind: "profile";
  readonly name: string;
  readonly before: string | null;
  readonly after: string | null;
  /** Profile of the drawing before and after. */
  readonly profileBefore: ProfileRef;
  readonly profileAfter: ProfileRef;
}

/** A profile: the given text of it, or its current one. */
export interface ProfileRef {
  readonly profile: string;
  readonly rules?: string;
}

export type Change = RetypeChange | SettingsChange | ProfileChange;

export const isSetByHand = (edges: Edges, row: number): boolean =>
  edges.ruleCodes[edges.rule[row] ?? -1] === OVERRIDE_CODE;

/** The change that sets the type of rows (null: resets them to the profile). */
export function retypeChange(
  edges: Edges,
  rows: readonly number[],
  to: LineType | null,
): RetypeChange {
  return {
    kind: "types",
    rows: [...rows],
    to,
    before: rows.map((row) => (isSetByHand(edges, row) ? lineTypeOf(edges.lineType[row]) : null)),
  };
}

/** Overrides that make a change. */
export const overridesToApply = (change: RetypeChange): Override[] => [
  { type: change.to, edges: [...change.rows] },
];

/** Overrides that undo a change: one per previous type. */
export function overridesToUndo(change: RetypeChange): Override[] {
  const byType = new Map<LineType | null, number[]>();
  change.rows.forEach((row, at) => {
    const type = change.before[at] ?? null;
    const rows = byType.get(type);
    if (rows === undefined) byType.set(type, [row]);
    else rows.push(row);
  });
  return [...byType].map(([type, edges]) => ({ type, edges }));
}

/** Current settings of a drawing. */
export const settingsOf = (drawing: Drawing): ReadingSettings => ({
  unit: drawing.unit_given ?? "file",
  profile: drawing.profile,
  rules: drawing.rules,
});

/** The profile of some settings. */
export const profileRefOf = ({
  profile,
  rules,
}: Pick<ReadingSettings, "profile" | "rules">): ProfileRef => ({
  profile,
  rules,
});

/** The change that undoes another one. */
export function inverseOf<C extends SettingsChange | ProfileChange>(change: C): C {
  const turned = { ...change, before: change.after, after: change.before };
  if (turned.kind !== "profile") return turned;
  const { profileBefore, profileAfter } = turned;
  return { ...turned, profileBefore: profileAfter, profileAfter: profileBefore };
}
