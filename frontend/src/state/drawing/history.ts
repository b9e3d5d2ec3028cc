/**
 * Changes made by the user, with what is needed to undo them.
 *
 * The server stores overrides in order, and the last one wins; undo adds another override. An
 * edge without a previous override has it removed, so that the rules of the profile apply again.
 * To undo a change of unit or profile, the previous value is sent.
 */

import type { Drawing, Edit, Override, Unit } from "../../api/drawings";
import { type Edges, type LineType, lineTypeOf } from "../../geometry/records";
import type { Code } from "../../messages/catalogue";

/** Message code of the rule of an edge whose line type the user has set. */
const OVERRIDE_CODE: Code = "classification.override";

/** The line type of edges was changed. */
export interface RetypeChange {
  readonly kind: "types";
  readonly rows: readonly number[];
  /** For each row: its new type; null resets it to the profile. */
  readonly after: readonly (LineType | null)[];
  /** For each row: the type of its previous override; null if a rule decided. */
  readonly before: readonly (LineType | null)[];
}

/** Edges and their new line type; null resets them to the profile. */
export interface Retyping {
  readonly rows: readonly number[];
  readonly type: LineType | null;
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

/** The geometry of the drawing was changed. */
export interface EditsChange {
  readonly kind: "edits";
  readonly before: readonly Edit[];
  readonly after: readonly Edit[];
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

export type Change = RetypeChange | SettingsChange | ProfileChange | EditsChange;

export const isSetByHand = (edges: Edges, row: number): boolean =>
  edges.ruleCodes[edges.rule[row] ?? -1] === OVERRIDE_CODE;

/** The change that sets the types of edges. */
export function retypeChange(edges: Edges, retypings: readonly Retyping[]): RetypeChange {
  const rows = retypings.flatMap((one) => one.rows);
  return {
    kind: "types",
    rows,
    after: retypings.flatMap((one) => one.rows.map(() => one.type)),
    before: rows.map((row) => (isSetByHand(edges, row) ? lineTypeOf(edges.lineType[row]) : null)),
  };
}

/** Overrides that make a change. */
export const overridesToApply = (change: RetypeChange): Override[] =>
  overridesOf(change.rows, change.after);

/** Overrides that undo a change. */
export const overridesToUndo = (change: RetypeChange): Override[] =>
  overridesOf(change.rows, change.before);

/** One override for each type. */
function overridesOf(rows: readonly number[], types: readonly (LineType | null)[]): Override[] {
  const byType = new Map<LineType | null, number[]>();
  rows.forEach((row, at) => {
    const type = types[at] ?? null;
    const same = byType.get(type);
    if (same === undefined) byType.set(type, [row]);
    else same.push(row);
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
