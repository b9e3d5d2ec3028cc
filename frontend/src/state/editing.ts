/** The profile that is being edited, step by step: each can be taken back before it is kept. */

import { create } from "zustand";
import type { Profile } from "../api/client";
import { type Draft, draftOf } from "./draft";

interface Steps {
  /** Which version of which profile; another one is another thing to edit. */
  readonly of: string;
  readonly past: readonly Draft[];
  readonly now: Draft | null;
  readonly future: readonly Draft[];
  /** What the last step was about: letters typed into one field are one step. */
  readonly about: string;
}

interface Editing extends Steps {
  /** Edit a profile; what was not kept of the same version is still there. */
  begin(profile: Profile): void;
  edit(draft: Draft, about?: string): void;
  back(): void;
  forward(): void;
  forget(): void;
}

const NOTHING: Steps = { of: "", past: [], now: null, future: [], about: "" };

export const versionOf = ({ name, version }: Profile): string => `${name} ${version}`;

export const useEditing = create<Editing>()((put) => ({
  ...NOTHING,
  begin: (profile) =>
    put(({ of }) =>
      of === versionOf(profile)
        ? {}
        : { ...NOTHING, of: versionOf(profile), now: draftOf(profile) },
    ),
  edit: (draft, about = "") =>
    put(({ past, now, about: last }) => {
      if (now === null) return {};
      const goesOn = about !== "" && about === last;
      return { now: draft, past: goesOn ? past : [...past, now], future: [], about };
    }),
  back: () =>
    put(({ past, now, future }) => {
      const before = past.at(-1);
      if (before === undefined || now === null) return {};
      return { past: past.slice(0, -1), now: before, future: [...future, now], about: "" };
    }),
  forward: () =>
    put(({ past, now, future }) => {
      const next = future.at(-1);
      if (next === undefined || now === null) return {};
      return { past: [...past, now], now: next, future: future.slice(0, -1), about: "" };
    }),
  forget: () => put(NOTHING),
}));
