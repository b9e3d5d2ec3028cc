/** What the user does, from the page to the service and back into what is shown. */

import {
  type Drawing,
  type JobCommand,
  type Profile,
  ServiceError,
  service,
  type Unit,
} from "../api/client";
import type { LineType } from "../geometry/records";
import { useEditing } from "./editing";
import { changedRows, difference, undoable } from "./elsewhere";
import {
  backwards,
  type Change,
  changeOf,
  forwards,
  type Keeping,
  readBy,
  reversed,
  type Said,
  saidOf,
} from "./history";
import { heardJob, keys, queries } from "./queries";
import { report, useReports } from "./reports";
import { usePage } from "./store";

let last: Promise<void> = Promise.resolve();
let waiting = 0;

/** Run one thing after the other, in the order in which they were asked; what fails is told. */
export function inTurn(act: () => Promise<void>): Promise<void> {
  waiting++;
  usePage.getState().set({ busy: true });
  last = last
    .then(act)
    .catch(failed)
    .catch(report)
    .finally(() => {
      waiting--;
      if (waiting === 0) usePage.getState().set({ busy: false });
    });
  return last;
}

export function uploadFiles(files: readonly File[]): Promise<void> {
  return inTurn(async () => {
    try {
      for (const file of files) {
        usePage.getState().set({ upload: { name: file.name, fraction: 0 } });
        try {
          const drawing = await service.upload(file, (fraction) =>
            usePage.getState().set({ upload: { name: file.name, fraction } }),
          );
          queries.setQueryData(keys.drawing(drawing.id).queryKey, drawing);
          usePage.getState().open(drawing.id);
        } catch (cause) {
          // One that cannot be read does not keep the others out.
          report(cause);
        }
      }
    } finally {
      usePage.getState().set({ upload: null });
      await queries.invalidateQueries({ queryKey: keys.drawings().queryKey });
    }
  });
}

/** Take a drawing as the service answered it, and ask again for what belongs to it. */
async function changed(drawing: Drawing): Promise<void> {
  queries.setQueryData(keys.drawing(drawing.id).queryKey, drawing);
  // A job's path belongs to the drawing as it was: it is no longer that of this one.
  usePage.getState().openJob(null);
  usePage.getState().set({ asked: [], proposed: [] });
  const old = [
    keys.edges(drawing.id).queryKey,
    keys.ledgers(drawing.id),
    keys.learned(drawing.id).queryKey,
    keys.drawings().queryKey,
  ];
  // A first answer that is still on its way would count as new, though it was asked for before.
  await Promise.all(old.map((queryKey) => queries.cancelQueries({ queryKey })));
  await Promise.all(old.map((queryKey) => queries.invalidateQueries({ queryKey })));
}

const known = (id: string): Drawing | undefined => queries.getQueryData(keys.drawing(id).queryKey);

/** The revision that is shown: that of the picture, or of the panels where they are older. */
function shownRevision(id: string): number | null {
  const edges = queries.getQueryData(keys.edges(id).queryKey);
  const shown = [known(id)?.revision, edges?.revision].filter((one) => one !== undefined);
  return shown.length === 0 ? null : Math.min(...shown);
}

/** Tell why something was not done; where the drawing has changed elsewhere, show how. */
async function failed(cause: unknown): Promise<void> {
  const { drawing } = usePage.getState();
  const stale = cause instanceof ServiceError && cause.stale;
  if (!stale || drawing === null || !(await catchUp(drawing, true))) report(cause);
}

/**
 * Show the open drawing as it is now, and tell what others changed; false where it is the same.
 *
 * `refused` says that something of our own was not done because of it.
 */
async function catchUp(id: string, refused = false): Promise<boolean> {
  const before = known(id);
  const shown = shownRevision(id);
  if (before === undefined) return false;
  const seen = queries.getQueryData(keys.edges(id).queryKey);
  const [after, edges] = await Promise.all([service.drawing(id), service.edges(id)]);
  if (after.revision === shown && after.profile_state === before.profile_state) return false;
  const rows = seen === undefined ? null : changedRows(seen, edges);
  await Promise.all(
    [keys.drawing(id).queryKey, keys.edges(id).queryKey].map((queryKey) =>
      queries.cancelQueries({ queryKey }),
    ),
  );
  queries.setQueryData(keys.drawing(id).queryKey, after);
  queries.setQueryData(keys.edges(id).queryKey, edges);
  if (after.revision === shown) return false;
  const page = usePage.getState();
  const { length } = page.past;
  const left = undoable(page.past, rows);
  page.rebase(left);
  page.set({ asked: [], proposed: [] });
  closeOldJob();
  useReports.getState().add({
    title: refused ? "Not done: changed elsewhere" : "Changed elsewhere",
    detail: `${after.name} was changed elsewhere: ${difference(before, after, rows)}.`,
    hint: [
      refused ? "Look at it, and repeat what you wanted if it still holds." : "",
      left.length < length ? "What you did before that can no longer be undone." : "",
    ]
      .join(" ")
      .trim(),
    source: [],
    notice: !refused,
  });
  const old = [keys.ledgers(id), keys.learned(id).queryKey];
  await Promise.all(old.map((queryKey) => queries.invalidateQueries({ queryKey })));
  return true;
}

/** A job that waits or is over is of the drawing as it was; one on a table stays in view. */
function closeOldJob(): void {
  const { job, openJob } = usePage.getState();
  const state = job === null ? undefined : queries.getQueryData(keys.job(job).queryKey)?.state;
  if (state !== "running" && state !== "held" && state !== "interrupted") openJob(null);
}

/** A drawing was changed, by this page or elsewhere; null where any may have been. */
export function heardDrawing(heard: Pick<Drawing, "id" | "revision"> | null): Promise<void> {
  const { drawing } = usePage.getState();
  if (drawing === null || (heard !== null && heard.id !== drawing)) return Promise.resolve();
  // After what is under way: the answer to a change of our own brings its revision.
  return inTurn(async () => {
    if (usePage.getState().drawing !== drawing) return;
    if (known(drawing) === undefined) {
      // What is on its way may be from before the change.
      await Promise.all(
        [keys.drawing(drawing).queryKey, keys.edges(drawing).queryKey].map((queryKey) =>
          queries.invalidateQueries({ queryKey }),
        ),
      );
      return;
    }
    if (heard === null || heard.revision > (shownRevision(drawing) ?? heard.revision))
      await catchUp(drawing);
  });
}

/** Say the unit of the drawing, or by which profile it is read. */
export function settle(part: { unit?: Unit | "file"; profile?: string }): Promise<void> {
  return inTurn(async () => {
    const { drawing } = usePage.getState();
    const before = drawing === null ? undefined : known(drawing);
    if (drawing === null || before === undefined) return;
    const after = await service.settle(drawing, part, shownRevision(drawing));
    await changed(after);
    usePage.getState().made({ kind: "settled", before: saidOf(before), after: saidOf(after) });
  });
}

/** Give these edges a line type; null lets the profile decide again. */
export function retype(rows: readonly number[], to: LineType | null): Promise<void> {
  return inTurn(async () => {
    const { drawing } = usePage.getState();
    if (drawing === null || rows.length === 0) return;
    const edges = queries.getQueryData(keys.edges(drawing).queryKey);
    if (edges === undefined) return;
    const change = changeOf(edges, rows, to);
    await changed(await service.override(drawing, forwards(change), shownRevision(drawing)));
    usePage.getState().made(change);
  });
}

/** A profile as the last change left it; somebody else's words are not overwritten. */
async function asItWas(name: string, text: string): Promise<Profile> {
  const now = await service.profile(name);
  if ((await service.profileText(name)) === text) return now;
  throw new ServiceError({
    type: "about:blank",
    title: "The profile has changed",
    status: 412,
    code: "stored.text",
    arguments: {},
    detail: `Somebody else changed the profile ${now.title} since.`,
    text: `Somebody else changed the profile ${now.title} since.`,
    hint: "Look at its rules; nothing was taken back.",
    source: [],
    questions: [],
    revision: null,
  });
}

/**
 * Keep a profile as a text, or keep none of its name, and read the drawing by another.
 *
 * `written` says that the service has the text already.
 */
export async function keepAs(drawing: string, change: Keeping, written = false): Promise<void> {
  const { name, before, after, readAfter } = change;
  if (after === null) {
    const now = await asItWas(name, before ?? "");
    // A drawing that was read by it is read by another first: it would say that it is gone.
    const answer = await service.settle(drawing, readAfter, shownRevision(drawing));
    await service.deleteProfile(name, now.version);
    await changed(answer);
  } else {
    if (!written) {
      const version = before === null ? null : (await asItWas(name, before)).version;
      await service.keepProfile(name, after, version);
    }
    await changed(await service.settle(drawing, readAfter, shownRevision(drawing)));
  }
  await queries.invalidateQueries({ queryKey: keys.profiles().queryKey });
}

async function again(drawing: string, change: Change, back: boolean): Promise<void> {
  if (change.kind === "types") {
    const overrides = back ? backwards(change) : forwards(change);
    await changed(await service.override(drawing, overrides, shownRevision(drawing)));
  } else if (change.kind === "settled") {
    const { before, after } = back ? reversed(change) : change;
    const part = differing(before, after);
    await changed(await service.settle(drawing, part, shownRevision(drawing)));
  } else await keepAs(drawing, back ? reversed(change) : change);
}

/** What of `after` is not as it was: the profile is read anew only where it says something else. */
function differing(before: Said, after: Said): Partial<Said> {
  const same = before.profile === after.profile && before.rules === after.rules;
  return {
    ...(before.unit === after.unit ? {} : { unit: after.unit }),
    ...(same ? {} : readBy(after)),
  };
}

/** Take the last step back: of the profile that is being edited, or else of the drawing. */
export function undo(): Promise<void> {
  if (usePage.getState().editing !== null && useEditing.getState().past.length > 0) {
    useEditing.getState().back();
    return Promise.resolve();
  }
  return inTurn(async () => {
    const { drawing, past } = usePage.getState();
    const change = past.at(-1);
    if (drawing === null || change === undefined) return;
    await again(drawing, change, true);
    usePage.getState().undone();
  });
}

export function redo(): Promise<void> {
  if (usePage.getState().editing !== null && useEditing.getState().future.length > 0) {
    useEditing.getState().forward();
    return Promise.resolve();
  }
  return inTurn(async () => {
    const { drawing, future } = usePage.getState();
    const change = future.at(-1);
    if (drawing === null || change === undefined) return;
    await again(drawing, change, false);
    usePage.getState().redone();
  });
}

export function compile(machine: string, board: string): Promise<void> {
  return inTurn(async () => {
    const { drawing, copies } = usePage.getState();
    if (drawing === null) return;
    usePage.getState().set({ picking: false });
    const machines = queries.getQueryData(keys.machines().queryKey);
    const milled = machines?.find(({ name }) => name === machine)?.offset_cuts === true;
    const corners = milled ? usePage.getState().corners : null;
    try {
      const revision = shownRevision(drawing);
      const job = await service.compile({ drawing, revision, machine, board, copies, corners });
      heardJob(job);
      usePage.getState().openJob(job.id);
    } catch (cause) {
      if (cause instanceof ServiceError) usePage.getState().set({ asked: cause.problem.questions });
      throw cause;
    }
  });
}

export function command(job: string, word: JobCommand): Promise<void> {
  return inTurn(async () => heardJob(await service.command(job, word)));
}
