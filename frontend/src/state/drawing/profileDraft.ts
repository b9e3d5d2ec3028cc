/** The draft in the profile editor, with its own undo history until it is saved. */

import { create } from "zustand";
import type { Profile } from "../../api/library";
import { type Draft, draftFromProfile } from "./draft";

interface Steps {
  /** Key of the profile and version that is edited. */
  readonly version: string;
  readonly past: readonly Draft[];
  readonly draft: Draft | null;
  readonly future: readonly Draft[];
  /** Successive edits with the same key are one undo step, such as letters typed into a field. */
  readonly mergeKey: string;
}

interface Editing extends Steps {
  /** Start to edit a profile; an unsaved draft of the same version is kept. */
  begin(profile: Profile): void;
  edit(draft: Draft, mergeKey?: string): void;
  undo(): void;
  redo(): void;
  discard(): void;
}

const NOTHING: Steps = { version: "", past: [], draft: null, future: [], mergeKey: "" };

export const versionKey = ({ name, version }: Profile): string => `${name} ${version}`;

export const useProfileDraft = create<Editing>()((set) => ({
  ...NOTHING,
  begin: (profile) =>
    set(({ version }) =>
      version === versionKey(profile)
        ? {}
        : { ...NOTHING, version: versionKey(profile), draft: draftFromProfile(profile) },
    ),
  edit: (next, mergeKey = "") =>
    set(({ past, draft, mergeKey: last }) => {
      if (draft === null) return {};
      const merged = mergeKey !== "" && mergeKey === last;
      return { draft: next, past: merged ? past : [...past, draft], future: [], mergeKey };
    }),
  undo: () =>
    set(({ past, draft, future }) => {
      const before = past.at(-1);
      if (before === undefined || draft === null) return {};
      return { past: past.slice(0, -1), draft: before, future: [...future, draft], mergeKey: "" };
    }),
  redo: () =>
    set(({ past, draft, future }) => {
      const next = future.at(-1);
      if (next === undefined || draft === null) return {};
      return { past: [...past, draft], draft: next, future: future.slice(0, -1), mergeKey: "" };
    }),
  discard: () => set(NOTHING),
}));
