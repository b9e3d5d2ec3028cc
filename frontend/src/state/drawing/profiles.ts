/** Saving, learning, importing and deleting of line-type profiles. */

import type { Proposal } from "../../api/drawings";
import { libraryService, type Profile } from "../../api/library";
import { saveProfile } from "../actions";
import { queries, queryClient } from "../queries";
import { useUiStore } from "../store";
import { addRule, type Draft, draftFromProfile, newRule, profileRequest, slugOf } from "./draft";
import { enqueue } from "./drawingSync";
import { profileRefOf } from "./history";

/** A name for a new profile that is not taken. */
export function unusedName(title: string, taken: readonly string[]): string {
  const name = slugOf(title) || "customer";
  for (let number = 1; ; number++) {
    const tried = number === 1 ? name : `${name.slice(0, 60)}-${number}`;
    if (!taken.includes(tried)) return tried;
  }
}

/** Save a draft under a name and apply it to the drawing; can be undone. */
export function saveDraft(name: string, draft: Draft): Promise<boolean> {
  return saveAndApply(name, async () => {
    const kept = cachedProfiles().some((profile) => profile.name === name && !profile.shipped);
    const before = kept ? await libraryService.profileText(name) : null;
    const version = kept ? (await libraryService.profile(name)).version : null;
    await libraryService.putProfile(name, profileRequest(draft), version);
    return before;
  });
}

/** Save the text of a file as a profile named like the file; its name, or null if that failed. */
export async function importProfile(file: File): Promise<string | null> {
  const called = slugOf(file.name.replace(/\.toml$/i, "")) || "customer";
  const shipped = cachedProfiles().some((profile) => profile.name === called && profile.shipped);
  const name = shipped
    ? unusedName(
        called,
        cachedProfiles().map((profile) => profile.name),
      )
    : called;
  const done = await saveAndApply(name, async () => {
    const text = await file.text();
    const kept = cachedProfiles().some((profile) => profile.name === name && !profile.shipped);
    const before = kept ? await libraryService.profileText(name) : null;
    const version = kept ? (await libraryService.profile(name)).version : null;
    await libraryService.putProfile(name, text, version);
    return before;
  });
  return done ? name : null;
}

/** Show the saved profile in the editor, unless the user has left the editor meanwhile. */
export function showSaved(saved: string, edited: string): void {
  const { editedProfile, set } = useUiStore.getState();
  if (editedProfile === edited) set({ editedProfile: saved });
}

const cachedProfiles = (): readonly Profile[] =>
  queryClient.getQueryData(queries.profiles().queryKey) ?? [];

/** Save a profile with `write`, which returns its previous text, and apply it to the drawing. */
async function saveAndApply(name: string, write: () => Promise<string | null>): Promise<boolean> {
  let done = false;
  await enqueue(async () => {
    const { drawing } = useUiStore.getState();
    const now =
      drawing === null ? undefined : queryClient.getQueryData(queries.drawing(drawing).queryKey);
    const before = await write();
    const after = await libraryService.profileText(name);
    if (now === undefined) {
      await queryClient.invalidateQueries({ queryKey: queries.profiles().queryKey });
    } else {
      const change = {
        kind: "profile",
        name,
        before,
        after,
        profileBefore: profileRefOf(now),
        profileAfter: { profile: name },
      } as const;
      await saveProfile(now.id, change, true);
      useUiStore.getState().recordChange(change);
    }
    done = true;
  });
  return done;
}

/** Add a learned rule to the customer profile, or to a new profile with this title. */
export async function saveLearnedRule(proposal: Proposal, profile: Profile, title: string) {
  const draft = addRule(draftFromProfile(profile), newRule(ruleOf(proposal)));
  if (!profile.shipped) return saveDraft(profile.name, draft);
  const taken = cachedProfiles().map(({ name }) => name);
  return saveDraft(unusedName(title, taken), { ...draft, title });
}

const ruleOf = ({ rule }: Proposal) => ({
  type: rule.type,
  layer: rule.layer,
  colour: rule.colour,
  linetype: rule.linetype,
  entity: rule.entity,
  block: rule.block,
});

/** Delete a customer profile; drawings that use it keep its rules until another is applied. */
export function deleteProfile(profile: Profile): Promise<void> {
  return enqueue(async () => {
    const { drawing } = useUiStore.getState();
    const now =
      drawing === null ? undefined : queryClient.getQueryData(queries.drawing(drawing).queryKey);
    if (now === undefined || now.profile !== profile.name) {
      await libraryService.deleteProfile(profile.name, profile.version);
      await queryClient.invalidateQueries({ queryKey: queries.profiles().queryKey });
      return;
    }
    const change = {
      kind: "profile",
      name: profile.name,
      before: await libraryService.profileText(profile.name),
      after: null,
      profileBefore: profileRefOf(now),
      profileAfter: { profile: profile.extends ?? "default" },
    } as const;
    await saveProfile(now.id, change);
    useUiStore.getState().recordChange(change);
  });
}
