/** Sends requests one after another and keeps the open drawing equal to that of the server. */

import { type Drawing, drawingService } from "../../api/drawings";
import { ServiceError } from "../../api/errors";
import { translate } from "../../language/translate";
import { notifyError, useNotifications } from "../notifications";
import { queries, queryClient } from "../queries";
import { useUiStore } from "../store";
import { changedRows, describeDifference, undoableChanges } from "./remoteChanges";

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

/** Cache a changed drawing and refetch what depends on it. */
export async function applyDrawing(drawing: Drawing): Promise<void> {
  queryClient.setQueryData(queries.drawing(drawing.id).queryKey, drawing);
  // The job's tool path belongs to the previous revision of the drawing.
  useUiStore.getState().openJob(null);
  clearQuestions();
  const stale = [
    queries.edges(drawing.id).queryKey,
    queries.importReports(drawing.id),
    queries.learned(drawing.id).queryKey,
    queries.customerAnswers(drawing.id).queryKey,
    ["orders"],
  ];
  // Cancel requests in flight: their answers may be of the previous revision.
  await Promise.all(stale.map((queryKey) => queryClient.cancelQueries({ queryKey })));
  await Promise.all(stale.map((queryKey) => queryClient.invalidateQueries({ queryKey })));
}

/** Forget the questions for which a job was refused, their message, and previews of answers. */
export function clearQuestions(): void {
  useUiStore.getState().set({ compileQuestions: [], retypePreviews: [] });
  useNotifications.getState().dismissError("drawing.open-questions");
}

export const cachedDrawing = (id: string): Drawing | undefined =>
  queryClient.getQueryData(queries.drawing(id).queryKey);

/** The revision on display: the older of those of canvas and panels. */
export function displayedRevision(id: string): number | null {
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
  const [after, edges] = await Promise.all([drawingService.drawing(id), drawingService.edges(id)]);
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
  clearQuestions();
  closeOutdatedJob();
  useNotifications.getState().add({
    title: refused
      ? translate("drawingSync.yourChangeWasNotSaved")
      : translate("drawingSync.theDrawingWasChangedElsewhere"),
    detail: translate("drawingSync.wasChangedByAnotherUser", {
      name: after.name,
      before: describeDifference(before, after, rows),
    }),
    hint: [
      refused ? translate("drawingSync.checkTheDrawingThenRepeat") : "",
      remaining.length < length ? translate("drawingSync.yourEarlierChangesCanNo") : "",
    ]
      .join(" ")
      .trim(),
    source: [],
    edges: [],
    notice: !refused,
  });
  const stale = [
    queries.importReports(id),
    queries.learned(id).queryKey,
    queries.customerAnswers(id).queryKey,
  ];
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
