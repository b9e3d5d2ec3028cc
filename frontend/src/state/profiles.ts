/** Profiles: keep them, learn from corrections, take them in and give them out as files. */

import { type Profile, type Proposal, service } from "../api/client";
import { inTurn, keepAs } from "./actions";
import { type Draft, draftOf, draftRule, nameOf, sentOf, withRule } from "./draft";
import { readBy } from "./history";
import { keys, queries } from "./queries";
import { usePage } from "./store";

/** What a profile is called that stands beside those that are there. */
export function freeName(title: string, taken: readonly string[]): string {
  const name = nameOf(title) || "customer";
  for (let number = 1; ; number++) {
    const tried = number === 1 ? name : `${name.slice(0, 60)}-${number}`;
    if (!taken.includes(tried)) return tried;
  }
}

/** Keep a draft under a name, read the drawing by it, and remember how to take that back. */
export function keepDraft(name: string, draft: Draft): Promise<boolean> {
  return keep(name, async () => {
    const kept = list().some((profile) => profile.name === name && !profile.shipped);
    const before = kept ? await service.profileText(name) : null;
    const version = kept ? (await service.profile(name)).version : null;
    await service.keepProfile(name, sentOf(draft), version);
    return before;
  });
}

/** Keep the text of a file as a profile, named as the file is; its name, or null where that failed. */
export async function importProfile(file: File): Promise<string | null> {
  const called = nameOf(file.name.replace(/\.toml$/i, "")) || "customer";
  const shipped = list().some((profile) => profile.name === called && profile.shipped);
  const name = shipped
    ? freeName(
        called,
        list().map((profile) => profile.name),
      )
    : called;
  const done = await keep(name, async () => {
    const text = await file.text();
    const kept = list().some((profile) => profile.name === name && !profile.shipped);
    const before = kept ? await service.profileText(name) : null;
    const version = kept ? (await service.profile(name)).version : null;
    await service.keepProfile(name, text, version);
    return before;
  });
  return done ? name : null;
}

const list = (): readonly Profile[] => queries.getQueryData(keys.profiles().queryKey) ?? [];

/** Let `write` change the service's profile and answer what it was; then read the drawing by it. */
async function keep(name: string, write: () => Promise<string | null>): Promise<boolean> {
  let done = false;
  await inTurn(async () => {
    const { drawing } = usePage.getState();
    const now = drawing === null ? undefined : queries.getQueryData(keys.drawing(drawing).queryKey);
    const before = await write();
    const after = await service.profileText(name);
    if (now === undefined) {
      await queries.invalidateQueries({ queryKey: keys.profiles().queryKey });
    } else {
      const change = {
        kind: "kept",
        name,
        before,
        after,
        readBefore: readBy(now),
        readAfter: { profile: name },
      } as const;
      await keepAs(now.id, change, true);
      usePage.getState().made(change);
    }
    done = true;
  });
  return done;
}

/** Keep a rule that was learned: in the customer's profile, or in a new one of this title. */
export async function keepLearned(proposal: Proposal, profile: Profile, title: string) {
  const draft = withRule(draftOf(profile), draftRule(ruleOf(proposal)));
  if (!profile.shipped) return keepDraft(profile.name, draft);
  const taken = list().map(({ name }) => name);
  return keepDraft(freeName(title, taken), { ...draft, title });
}

const ruleOf = ({ rule }: Proposal) => ({
  type: rule.type,
  layer: rule.layer,
  colour: rule.colour,
  linetype: rule.linetype,
  entity: rule.entity,
  block: rule.block,
});

/** Forget a customer's profile; drawings that it read keep its rules until they get another. */
export function forgetProfile(profile: Profile): Promise<void> {
  return inTurn(async () => {
    const { drawing } = usePage.getState();
    const now = drawing === null ? undefined : queries.getQueryData(keys.drawing(drawing).queryKey);
    if (now === undefined || now.profile !== profile.name) {
      await service.deleteProfile(profile.name, profile.version);
      await queries.invalidateQueries({ queryKey: keys.profiles().queryKey });
      return;
    }
    const change = {
      kind: "kept",
      name: profile.name,
      before: await service.profileText(profile.name),
      after: null,
      readBefore: readBy(now),
      readAfter: { profile: profile.extends ?? "default" },
    } as const;
    await keepAs(now.id, change);
    usePage.getState().made(change);
  });
}
