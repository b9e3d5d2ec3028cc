/**
 * A profile while it is being edited: its own rules in order, above or below those it extends.
 *
 * Nothing here asks the service: a draft is a value, and each edit makes another.
 */

import type { Profile, ProfileDraft, Rule } from "../api/client";
import type { LineType } from "../geometry/records";

export type Draft = Omit<ProfileDraft, "rules" | "version" | "extends"> & {
  readonly extends: string | null;
  readonly rules: readonly DraftRule[];
};

export type Condition = "layer" | "colour" | "linetype" | "entity" | "block";
export const CONDITIONS: readonly Condition[] = ["layer", "colour", "linetype", "entity", "block"];

export interface DraftRule extends Readonly<Record<Condition, readonly (string | number)[]>> {
  /** Of the page alone, so that a rule is known again where it has moved. */
  readonly key: number;
  readonly type: LineType;
}

let lastKey = 0;

const NOTHING = { layer: [], colour: [], linetype: [], entity: [], block: [] } as const;

export const draftRule = (rule: Partial<Omit<DraftRule, "key">>): DraftRule => ({
  ...NOTHING,
  type: "cut",
  ...rule,
  key: ++lastKey,
});

const ruleOf = (rule: Rule): DraftRule =>
  draftRule({
    type: rule.type,
    layer: rule.layer,
    colour: rule.colour,
    linetype: rule.linetype,
    entity: rule.entity,
    block: rule.block,
  });

/** What is edited of a profile; of one that is shipped, nothing: a new one extends it. */
export function draftOf(profile: Profile): Draft {
  if (profile.shipped) return { title: "", extends: profile.name, overrules: true, rules: [] };
  return {
    title: profile.title,
    extends: profile.extends ?? null,
    overrules: profile.overrules || !profile.extends,
    rules: profile.rules.filter(({ inherited }) => !inherited).map(ruleOf),
  };
}

/** What the service is sent. */
export const sentOf = (draft: Draft): ProfileDraft => ({
  title: draft.title.trim() === "" ? "Untitled" : draft.title.trim(),
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

/** The draft with another rule on top of its own: the newest is asked first. */
export const withRule = (draft: Draft, rule: DraftRule): Draft => ({
  ...draft,
  rules: [rule, ...draft.rules],
});

export const withoutRule = (draft: Draft, key: number): Draft => ({
  ...draft,
  rules: draft.rules.filter((rule) => rule.key !== key),
});

export const withChanged = (draft: Draft, key: number, part: Partial<DraftRule>): Draft => ({
  ...draft,
  rules: draft.rules.map((rule) => (rule.key === key ? { ...rule, ...part, key } : rule)),
});

/** The draft with a rule moved to a place; where the list ends, it ends. */
export function withMoved(draft: Draft, key: number, to: number): Draft {
  const from = draft.rules.findIndex((rule) => rule.key === key);
  const moved = draft.rules[from];
  if (moved === undefined) return draft;
  const rules = draft.rules.filter((rule) => rule.key !== key);
  rules.splice(Math.max(0, Math.min(rules.length, to)), 0, moved);
  return { ...draft, rules };
}

/** What somebody wrote into a field, as a condition: parts between commas. */
export function patternsOf(condition: Condition, text: string): (string | number)[] {
  const parts = text
    .split(",")
    .map((part) => part.trim())
    .filter((part) => part !== "");
  if (condition !== "colour") return parts;
  return parts.map((part) => (/^\d{1,3}$/.test(part) ? Number(part) : part.toLowerCase()));
}

export const textOf = (patterns: readonly (string | number)[]): string => patterns.join(", ");

/** Why a colour that was written is none; empty where all are. */
export function colourFault(patterns: readonly (string | number)[]): string {
  const wrong = patterns.find((part) =>
    typeof part === "number" ? part < 1 || part > 255 : !/^#[0-9a-f]{6}$/.test(part),
  );
  return wrong === undefined ? "" : `${wrong} is neither 1 … 255 nor #rrggbb`;
}

/** Whether a rule meets everything: it has no condition. */
export const meetsAll = (rule: DraftRule): boolean =>
  CONDITIONS.every((condition) => rule[condition].length === 0);

/** A name that the service takes, made of what people call it. */
export function nameOf(title: string): string {
  const plain = title
    .normalize("NFKD")
    .replace(/\p{M}/gu, "")
    .replace(/ß/g, "ss")
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-+|-+$/g, "");
  return plain.slice(0, 64).replace(/-+$/, "");
}
