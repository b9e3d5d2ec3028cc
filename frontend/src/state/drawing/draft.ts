/**
 * Draft of a profile in the editor: its own rules in order, before or after the inherited ones.
 *
 * Drafts are immutable; each edit returns a new one.
 */

import type { Rule } from "../../api/drawings";
import type { Profile, ProfileDraft } from "../../api/library";
import type { LineType } from "../../geometry/records";
import { translate } from "../../language/translate";

export type Draft = Omit<ProfileDraft, "rules" | "version" | "extends"> & {
  readonly extends: string | null;
  readonly rules: readonly DraftRule[];
};

export type Condition = "layer" | "colour" | "linetype" | "entity" | "block";
export const CONDITIONS: readonly Condition[] = ["layer", "colour", "linetype", "entity", "block"];

export interface DraftRule extends Readonly<Record<Condition, readonly (string | number)[]>> {
  /** Identifies a rule on this page when it is moved. */
  readonly key: number;
  readonly type: LineType;
}

let lastKey = 0;

const NOTHING = { layer: [], colour: [], linetype: [], entity: [], block: [] } as const;

export const newRule = (rule: Partial<Omit<DraftRule, "key">>): DraftRule => ({
  ...NOTHING,
  type: "cut",
  ...rule,
  key: ++lastKey,
});

const ruleOf = (rule: Rule): DraftRule =>
  newRule({
    type: rule.type,
    layer: rule.layer,
    colour: rule.colour,
    linetype: rule.linetype,
    entity: rule.entity,
    block: rule.block,
  });

/** Draft of a customer profile; for a built-in profile, of a new profile that extends it. */
export function draftFromProfile(profile: Profile): Draft {
  if (profile.shipped) return { title: "", extends: profile.name, overrules: true, rules: [] };
  return {
    title: profile.title,
    extends: profile.extends ?? null,
    overrules: profile.overrules || !profile.extends,
    rules: profile.rules.filter(({ inherited }) => !inherited).map(ruleOf),
  };
}

/** Request body for the server. */
export const profileRequest = (draft: Draft): ProfileDraft => ({
  title: draft.title.trim() === "" ? translate("draft.newProfile") : draft.title.trim(),
  extends: draft.extends,
  overrules: draft.overrules,
  version: null,
  rules: draft.rules.map(({ key: _, ...rule }) => ({
    type: rule.type,
    layer: rule.layer.map(String),
    colour: [...rule.colour],
    linetype: rule.linetype.map(String),
    entity: rule.entity.map(String),
    block: rule.block.map(String),
  })),
});

/** Insert a rule before the others. */
export const addRule = (draft: Draft, rule: DraftRule): Draft => ({
  ...draft,
  rules: [rule, ...draft.rules],
});

export const removeRule = (draft: Draft, key: number): Draft => ({
  ...draft,
  rules: draft.rules.filter((rule) => rule.key !== key),
});

export const updateRule = (draft: Draft, key: number, part: Partial<DraftRule>): Draft => ({
  ...draft,
  rules: draft.rules.map((rule) => (rule.key === key ? { ...rule, ...part, key } : rule)),
});

/** Move a rule to an index, limited to the length of the list. */
export function moveRule(draft: Draft, key: number, to: number): Draft {
  const from = draft.rules.findIndex((rule) => rule.key === key);
  const moved = draft.rules[from];
  if (moved === undefined) return draft;
  const rules = draft.rules.filter((rule) => rule.key !== key);
  rules.splice(Math.max(0, Math.min(rules.length, to)), 0, moved);
  return { ...draft, rules };
}

/** Parse the text of a field: patterns separated by commas. */
export function parsePatterns(condition: Condition, text: string): (string | number)[] {
  const parts = text
    .split(",")
    .map((part) => part.trim())
    .filter((part) => part !== "");
  if (condition !== "colour") return parts;
  return parts.map((part) => (/^\d{1,3}$/.test(part) ? Number(part) : part.toLowerCase()));
}

export const formatPatterns = (patterns: readonly (string | number)[]): string =>
  patterns.join(", ");

/** Error message for an invalid colour; empty if all are valid. */
export function colourError(patterns: readonly (string | number)[]): string {
  const wrong = patterns.find((part) =>
    typeof part === "number" ? part < 1 || part > 255 : !/^#[0-9a-f]{6}$/.test(part),
  );
  return wrong === undefined ? "" : translate("draft.isNotAColourEnter", { wrong });
}

/** Whether a rule matches every edge because it has no condition. */
export const matchesAll = (rule: DraftRule): boolean =>
  CONDITIONS.every((condition) => rule[condition].length === 0);

/** A valid profile name made from a title. */
export function slugOf(title: string): string {
  const plain = title
    .normalize("NFKD")
    .replace(/\p{M}/gu, "")
    .replace(/ß/g, "ss")
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-+|-+$/g, "");
  return plain.slice(0, 64).replace(/-+$/, "");
}
