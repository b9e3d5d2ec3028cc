/** User actions: send requests to the server and update the cached data. */

import {
  type Drawing,
  type JobCommand,
  type Profile,
  pageProblem,
  ServiceError,
  service,
  type Unit,
} from "../api/client";
import type { LineType } from "../geometry/records";
import {
  type Change,
  inverseOf,
  overridesToApply,
  overridesToUndo,
  type ProfileChange,
  profileRefOf,
  type ReadingSettings,
  retypeChange,
  settingsOf,
} from "./history";
import { notifyError, useNotifications } from "./notifications";
import { useProfileDraft } from "./profileDraft";
import { queries, queryClient, upsertJob } from "./queries";
import { changedRows, describeDifference, undoableChanges } from "./remoteChanges";
import { useUiStore } from "./store";

let queue: Promise<void> = Promise.resolve();
let pending = 0;

/** Run actions one after another, in the order of the calls; report errors. */
export function enqueue(act: () => Promise<void>): Promise<void> {
  pending++;
  useUiStore.getState().set({ busy: true });
  queue = queue
    .then(act)
    .catch(handleFailure)
    .catch(notifyError)
    .finally(() => {
      pending--;
      if (pending === 0) useUiStore.getState().set({ busy: false });
    });
  return queue;
}

export function uploadFiles(files: readonly File[]): Promise<void> {
  return enqueue(async () => {
    try {
      for (const file of files) {
        useUiStore.getState().set({ upload: { name: file.name, fraction: 0 } });
        try {
          const drawing = await service.upload(file, (fraction) =>
            useUiStore.getState().set({ upload: { name: file.name, fraction } }),
          );
          queryClient.setQueryData(queries.drawing(drawing.id).queryKey, drawing);
          useUiStore.getState().open(drawing.id);
        } catch (cause) {
          // A file that cannot be read does not stop the others.
          notifyError(cause);
        }
      }
    } finally {
      useUiStore.getState().set({ upload: null });
      await queryClient.invalidateQueries({ queryKey: queries.drawings().queryKey });
    }
  });
}

/** Cache a changed drawing and refetch what depends on it. */
async function applyDrawing(drawing: Drawing): Promise<void> {
  queryClient.setQueryData(queries.drawing(drawing.id).queryKey, drawing);
  // The job's tool path belongs to the previous revision of the drawing.
  useUiStore.getState().openJob(null);
  useUiStore.getState().set({ compileQuestions: [], retypePreviews: [] });
  const stale = [
    queries.edges(drawing.id).queryKey,
    queries.importReports(drawing.id),
    queries.learned(drawing.id).queryKey,
    queries.drawings().queryKey,
  ];
  // Cancel requests in flight: their answers may be of the previous revision.
  await Promise.all(stale.map((queryKey) => queryClient.cancelQueries({ queryKey })));
  await Promise.all(stale.map((queryKey) => queryClient.invalidateQueries({ queryKey })));
}

const cachedDrawing = (id: string): Drawing | undefined =>
  queryClient.getQueryData(queries.drawing(id).queryKey);

/** The revision on display: the older of those of canvas and panels. */
function displayedRevision(id: string): number | null {
  const edges = queryClient.getQueryData(queries.edges(id).queryKey);
  const shown = [cachedDrawing(id)?.revision, edges?.revision].filter((one) => one !== undefined);
  return shown.length === 0 ? null : Math.min(...shown);
}

/** Report an error; after a conflict of revisions, show the changed drawing. */
async function handleFailure(cause: unknown): Promise<void> {
  const { drawing } = useUiStore.getState();
  const stale = cause instanceof ServiceError && cause.stale;
  if (!stale || drawing === null || !(await applyRemoteChange(drawing, true))) notifyError(cause);
}

/**
 * Fetch the open drawing, and notify the user of what others changed; false if nothing changed.
 *
 * `refused`: an action of this user was rejected because of the change.
 */
async function applyRemoteChange(id: string, refused = false): Promise<boolean> {
  const before = cachedDrawing(id);
  const shown = displayedRevision(id);
  if (before === undefined) return false;
  const shownEdges = queryClient.getQueryData(queries.edges(id).queryKey);
  const [after, edges] = await Promise.all([service.drawing(id), service.edges(id)]);
  if (after.revision === shown && after.profile_state === before.profile_state) return false;
  const rows = shownEdges === undefined ? null : changedRows(shownEdges, edges);
  await Promise.all(
    [queries.drawing(id).queryKey, queries.edges(id).queryKey].map((queryKey) =>
      queryClient.cancelQueries({ queryKey }),
    ),
  );
  queryClient.setQueryData(queries.drawing(id).queryKey, after);
  queryClient.setQueryData(queries.edges(id).queryKey, edges);
  if (after.revision === shown) return false;
  const page = useUiStore.getState();
  const { length } = page.past;
  const remaining = undoableChanges(page.past, rows);
  page.replaceHistory(remaining);
  page.set({ compileQuestions: [], retypePreviews: [] });
  closeOutdatedJob();
  useNotifications.getState().add({
    title: refused
      ? "Your change was not saved: the drawing was changed elsewhere"
      : "The drawing was changed elsewhere",
    detail: `${after.name} was changed by another user or in another window: ${describeDifference(before, after, rows)}.`,
    hint: [
      refused ? "Check the drawing, then repeat your change if it is still needed." : "",
      remaining.length < length ? "Your earlier changes can no longer be undone." : "",
    ]
      .join(" ")
      .trim(),
    source: [],
    notice: !refused,
  });
  const stale = [queries.importReports(id), queries.learned(id).queryKey];
  await Promise.all(stale.map((queryKey) => queryClient.invalidateQueries({ queryKey })));
  return true;
}

/** Close the open job unless it is on a table: it belongs to the previous revision. */
function closeOutdatedJob(): void {
  const { job, openJob } = useUiStore.getState();
  const state =
    job === null ? undefined : queryClient.getQueryData(queries.job(job).queryKey)?.state;
  if (state !== "running" && state !== "held" && state !== "interrupted") openJob(null);
}

/** Handle the event that a drawing changed; null if any drawing may have changed. */
export function syncDrawing(heard: Pick<Drawing, "id" | "revision"> | null): Promise<void> {
  const { drawing } = useUiStore.getState();
  if (drawing === null || (heard !== null && heard.id !== drawing)) return Promise.resolve();
  // Queued behind pending actions: the answer to our own change contains its revision.
  return enqueue(async () => {
    if (useUiStore.getState().drawing !== drawing) return;
    if (cachedDrawing(drawing) === undefined) {
      // Requests in flight may return the previous revision.
      await Promise.all(
        [queries.drawing(drawing).queryKey, queries.edges(drawing).queryKey].map((queryKey) =>
          queryClient.invalidateQueries({ queryKey }),
        ),
      );
      return;
    }
    if (heard === null || heard.revision > (displayedRevision(drawing) ?? heard.revision))
      await applyRemoteChange(drawing);
  });
}

/** Set the unit or the profile of the open drawing. */
export function patchDrawing(part: { unit?: Unit | "file"; profile?: string }): Promise<void> {
  return enqueue(async () => {
    const { drawing } = useUiStore.getState();
    const before = drawing === null ? undefined : cachedDrawing(drawing);
    if (drawing === null || before === undefined) return;
    const after = await service.patchDrawing(drawing, part, displayedRevision(drawing));
    await applyDrawing(after);
    useUiStore
      .getState()
      .recordChange({ kind: "settings", before: settingsOf(before), after: settingsOf(after) });
  });
}

/** Set the line type of edges; null resets them to the profile. */
export function retype(rows: readonly number[], to: LineType | null): Promise<void> {
  return enqueue(async () => {
    const { drawing } = useUiStore.getState();
    if (drawing === null || rows.length === 0) return;
    const edges = queryClient.getQueryData(queries.edges(drawing).queryKey);
    if (edges === undefined) return;
    const change = retypeChange(edges, rows, to);
    await applyDrawing(
      await service.override(drawing, overridesToApply(change), displayedRevision(drawing)),
    );
    useUiStore.getState().recordChange(change);
  });
}

/** Return a profile if its text is still `text`; raise if another user has changed it. */
async function assertUnchanged(name: string, text: string): Promise<Profile> {
  const now = await service.profile(name);
  if ((await service.profileText(name)) === text) return now;
  throw pageProblem(
    412,
    "The profile was changed elsewhere",
    `Another user has changed the profile ${now.title} since your change.`,
    "Check the rules of the profile. Nothing was undone or repeated.",
  );
}

/**
 * Save or delete a profile and apply a profile to the drawing.
 *
 * `written`: the server has the text already.
 */
export async function saveProfile(
  drawing: string,
  change: ProfileChange,
  written = false,
): Promise<void> {
  const { name, before, after, profileAfter } = change;
  if (after === null) {
    const now = await assertUnchanged(name, before ?? "");
    // Apply the other profile first, so that the drawing never refers to a deleted one.
    const answer = await service.patchDrawing(drawing, profileAfter, displayedRevision(drawing));
    await service.deleteProfile(name, now.version);
    await applyDrawing(answer);
  } else {
    if (!written) {
      const version = before === null ? null : (await assertUnchanged(name, before)).version;
      await service.putProfile(name, after, version);
    }
    await applyDrawing(
      await service.patchDrawing(drawing, profileAfter, displayedRevision(drawing)),
    );
  }
  await queryClient.invalidateQueries({ queryKey: queries.profiles().queryKey });
}

async function applyChange(drawing: string, change: Change, back: boolean): Promise<void> {
  if (change.kind === "types") {
    const overrides = back ? overridesToUndo(change) : overridesToApply(change);
    await applyDrawing(await service.override(drawing, overrides, displayedRevision(drawing)));
  } else if (change.kind === "settings") {
    const { before, after } = back ? inverseOf(change) : change;
    const part = changedSettings(before, after);
    await applyDrawing(await service.patchDrawing(drawing, part, displayedRevision(drawing)));
  } else await saveProfile(drawing, back ? inverseOf(change) : change);
}

/** The settings of `after` that differ from `before`; an unchanged profile is not applied again. */
function changedSettings(
  before: ReadingSettings,
  after: ReadingSettings,
): Partial<ReadingSettings> {
  const same = before.profile === after.profile && before.rules === after.rules;
  return {
    ...(before.unit === after.unit ? {} : { unit: after.unit }),
    ...(same ? {} : profileRefOf(after)),
  };
}

/** Undo the last step in the profile editor if it has one, else the last change of the drawing. */
export function undo(): Promise<void> {
  if (useUiStore.getState().editedProfile !== null && useProfileDraft.getState().past.length > 0) {
    useProfileDraft.getState().undo();
    return Promise.resolve();
  }
  return enqueue(async () => {
    const { drawing, past } = useUiStore.getState();
    const change = past.at(-1);
    if (drawing === null || change === undefined) return;
    await applyChange(drawing, change, true);
    useUiStore.getState().recordUndo();
  });
}

export function redo(): Promise<void> {
  if (
    useUiStore.getState().editedProfile !== null &&
    useProfileDraft.getState().future.length > 0
  ) {
    useProfileDraft.getState().redo();
    return Promise.resolve();
  }
  return enqueue(async () => {
    const { drawing, future } = useUiStore.getState();
    const change = future.at(-1);
    if (drawing === null || change === undefined) return;
    await applyChange(drawing, change, false);
    useUiStore.getState().recordRedo();
  });
}

export function compile(machine: string, board: string): Promise<void> {
  return enqueue(async () => {
    const { drawing, copies } = useUiStore.getState();
    if (drawing === null) return;
    useUiStore.getState().set({ pickingCorners: false });
    const machines = queryClient.getQueryData(queries.machines().queryKey);
    const milled = machines?.find(({ name }) => name === machine)?.offset_cuts === true;
    const corners = milled ? useUiStore.getState().corners : null;
    try {
      const revision = displayedRevision(drawing);
      const job = await service.compile({ drawing, revision, machine, board, copies, corners });
      upsertJob(job);
      useUiStore.getState().openJob(job.id);
    } catch (cause) {
      if (cause instanceof ServiceError)
        useUiStore.getState().set({ compileQuestions: cause.problem.questions });
      throw cause;
    }
  });
}

export function command(job: string, word: JobCommand): Promise<void> {
  return enqueue(async () => upsertJob(await service.command(job, word)));
}
