/** Actions of the user: each sends requests to the server and updates the cached data. */

import { type Drawing, drawingService, type Edit, type Unit } from "../api/drawings";
import { pageProblem, ServiceError } from "../api/errors";
import {
  type Exceptions,
  jobService,
  type Neighbours,
  type RestChoice,
  type WaitingChange,
} from "../api/jobs";
import { libraryService, type Profile } from "../api/library";
import { machineService } from "../api/machines";
import type { LineType } from "../geometry/records";
import { translate } from "../language/translate";
import { upsertJob } from "./cacheUpdates";
import {
  applyDrawing,
  cachedDrawing,
  clearQuestions,
  displayedRevision,
  enqueue,
} from "./drawing/drawingSync";
import {
  type Change,
  inverseOf,
  overridesToApply,
  overridesToUndo,
  type ProfileChange,
  profileRefOf,
  type ReadingSettings,
  type Retyping,
  retypeChange,
  settingsOf,
} from "./drawing/history";
import { type Look, lookOf } from "./drawing/learnedLooks";
import { useProfileDraft } from "./drawing/profileDraft";
import type { OfficeCommand } from "./job/jobs";
import { notifyError } from "./notifications";
import { hasLeastLift } from "./order/sheet";
import { queries, queryClient } from "./queries";
import { showDrawing } from "./routes";
import { useUiStore } from "./store";

export function uploadFiles(files: readonly File[]): Promise<void> {
  return enqueue(async () => {
    try {
      for (const file of files) {
        useUiStore.getState().set({ upload: { name: file.name, fraction: 0 } });
        try {
          const drawing = await drawingService.upload(file, (fraction) =>
            useUiStore.getState().set({ upload: { name: file.name, fraction } }),
          );
          queryClient.setQueryData(queries.drawing(drawing.id).queryKey, drawing);
          showDrawing(drawing.id);
        } catch (cause) {
          // A file that cannot be read does not stop the others.
          notifyError(cause);
        }
      }
    } finally {
      useUiStore.getState().set({ upload: null });
      await queryClient.invalidateQueries({ queryKey: ["orders"] });
    }
  });
}

/** Read another page of the file of a drawing, and open it. */
export function choosePage({ id, name }: Pick<Drawing, "id" | "name">, page: number) {
  return enqueue(async () => {
    useUiStore
      .getState()
      .set({ upload: { name: translate("actions.page", { name, page }), fraction: 1 } });
    try {
      const drawing = await drawingService.choosePage(id, page);
      queryClient.setQueryData(queries.drawing(drawing.id).queryKey, drawing);
      showDrawing(drawing.id);
    } finally {
      useUiStore.getState().set({ upload: null });
      await queryClient.invalidateQueries({ queryKey: ["orders"] });
    }
  });
}

/** Delete a drawing of which no job was made. */
export function deleteDrawing(id: string): Promise<void> {
  return enqueue(async () => {
    await drawingService.deleteDrawing(id);
    const page = useUiStore.getState();
    if (page.drawing === id) page.open(null);
    await queryClient.invalidateQueries({ queryKey: ["orders"] });
  });
}

/** Set the unit or the profile of the open drawing. */
export function patchDrawing(part: { unit?: Unit | "file"; profile?: string }): Promise<void> {
  return enqueue(async () => {
    const { drawing } = useUiStore.getState();
    const before = drawing === null ? undefined : cachedDrawing(drawing);
    if (drawing === null || before === undefined) return;
    const after = await drawingService.patchDrawing(drawing, part, displayedRevision(drawing));
    await applyDrawing(after);
    useUiStore
      .getState()
      .recordChange({ kind: "settings", before: settingsOf(before), after: settingsOf(after) });
  });
}

/** Change the geometry of the open drawing; one undo takes all of the edits back. */
export function addEdits(added: readonly Edit[]): Promise<void> {
  return enqueue(async () => {
    const { drawing } = useUiStore.getState();
    const before = drawing === null ? undefined : cachedDrawing(drawing);
    if (drawing === null || before === undefined || added.length === 0) return;
    const edits = [...before.edits, ...added];
    await applyDrawing(
      await drawingService.patchDrawing(drawing, { edits }, displayedRevision(drawing)),
    );
    useUiStore.getState().recordChange({ kind: "edits", before: before.edits, after: edits });
  });
}

/** Let all designers change the open drawing, or its owner and operators only. */
export function shareDrawing(shared: boolean): Promise<void> {
  return enqueue(async () => {
    const { drawing } = useUiStore.getState();
    if (drawing === null) return;
    await applyDrawing(
      await drawingService.patchDrawing(drawing, { shared }, displayedRevision(drawing)),
    );
  });
}

/** Set the customer of the open drawing, whose earlier drawings answer its questions. */
export function setCustomer(customer: string): Promise<void> {
  return enqueue(async () => {
    const { drawing } = useUiStore.getState();
    if (drawing === null) return;
    const part = { customer };
    await applyDrawing(
      await drawingService.patchDrawing(drawing, part, displayedRevision(drawing)),
    );
  });
}

/** Set whether earlier drawings of the customer decide edges of a look. */
export function setLookUsed(look: Look, used: boolean): Promise<void> {
  return enqueue(async () => {
    const { drawing } = useUiStore.getState();
    if (drawing === null) return;
    const revision = displayedRevision(drawing);
    await applyDrawing(
      await drawingService.setCustomerAnswer(drawing, { ...lookOf(look), used }, revision),
    );
  });
}

/** Set the line type of edges; null resets them to the profile. */
export const retype = (rows: readonly number[], type: LineType | null): Promise<void> =>
  retypeEach([{ rows, type }]);

/** Set line types of several groups of edges; one undo takes all of them back. */
export function retypeEach(retypings: readonly Retyping[]): Promise<void> {
  return enqueue(async () => {
    const { drawing } = useUiStore.getState();
    if (drawing === null || retypings.every(({ rows }) => rows.length === 0)) return;
    const edges = queryClient.getQueryData(queries.edges(drawing).queryKey);
    if (edges === undefined) return;
    const change = retypeChange(edges, retypings);
    await applyDrawing(
      await drawingService.override(drawing, overridesToApply(change), displayedRevision(drawing)),
    );
    useUiStore.getState().recordChange(change);
  });
}

/** Return a profile if its text is still `text`; raise if another user has changed it. */
async function assertUnchanged(name: string, text: string): Promise<Profile> {
  const now = await libraryService.profile(name);
  if ((await libraryService.profileText(name)) === text) return now;
  throw pageProblem(
    412,
    translate("actions.theProfileWasChangedElsewhere"),
    translate("actions.anotherUserHasChangedThe", { title: now.title }),
    translate("actions.nothingWasUndoneOrRedone"),
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
    const answer = await drawingService.patchDrawing(
      drawing,
      profileAfter,
      displayedRevision(drawing),
    );
    await libraryService.deleteProfile(name, now.version);
    await applyDrawing(answer);
  } else {
    if (!written) {
      const version = before === null ? null : (await assertUnchanged(name, before)).version;
      await libraryService.putProfile(name, after, version);
    }
    await applyDrawing(
      await drawingService.patchDrawing(drawing, profileAfter, displayedRevision(drawing)),
    );
  }
  await queryClient.invalidateQueries({ queryKey: queries.profiles().queryKey });
}

async function applyChange(drawing: string, change: Change, back: boolean): Promise<void> {
  if (change.kind === "types") {
    const overrides = back ? overridesToUndo(change) : overridesToApply(change);
    await applyDrawing(
      await drawingService.override(drawing, overrides, displayedRevision(drawing)),
    );
  } else if (change.kind === "settings") {
    const { before, after } = back ? inverseOf(change) : change;
    const part = changedSettings(before, after);
    await applyDrawing(
      await drawingService.patchDrawing(drawing, part, displayedRevision(drawing)),
    );
  } else if (change.kind === "edits") {
    const edits = [...(back ? change.before : change.after)];
    await applyDrawing(
      await drawingService.patchDrawing(drawing, { edits }, displayedRevision(drawing)),
    );
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
    const { drawing, copies, sheet } = useUiStore.getState();
    if (drawing === null) return;
    useUiStore.getState().set({ pickingCorners: false });
    clearQuestions();
    const machines = queryClient.getQueryData(queries.machines().queryKey);
    const chosen = machines?.find(({ name }) => name === machine);
    const { corners: types, lift: height, options, details } = useUiStore.getState();
    const { registration } = useUiStore.getState();
    const corners = chosen?.offset_cuts === true ? types : null;
    const lift = hasLeastLift(chosen) ? height : "clearance";
    try {
      const revision = displayedRevision(drawing);
      const chosenOptions = { corners, sheet, registration, lift, ...options };
      const order = { drawing, revision, machine, board, copies, ...chosenOptions, ...details };
      const job = await jobService.compile(order);
      upsertJob(job);
      useUiStore.getState().open(drawing, job.id, "check");
    } catch (cause) {
      if (cause instanceof ServiceError)
        useUiStore.getState().set({
          compileQuestions: cause.problem.questions,
          ...(cause.problem.questions.length > 0 ? { step: "lines" as const } : {}),
        });
      throw cause;
    }
  });
}

/** Accept shortfalls in the verdict of a refused job. */
export function acceptShortfalls(job: string, exceptions: Exceptions): Promise<void> {
  return enqueue(async () => {
    upsertJob(await jobService.accept(job, exceptions));
    await Promise.all(
      [queries.verdict, queries.verdictColumns, queries.earlierExceptions].map((query) =>
        queryClient.invalidateQueries({ queryKey: query(job).queryKey }),
      ),
    );
  });
}

/** Order a job that makes the rest of a sheet, or the whole program again, and open it. */
export function continueJob(job: string, choice: RestChoice): Promise<void> {
  return enqueue(async () => {
    const rest = await jobService.continueJob(job, choice);
    upsertJob(rest);
    useUiStore.getState().openJob(rest.id);
  });
}

export function command(job: string, word: OfficeCommand): Promise<void> {
  return enqueue(async () => upsertJob(await jobService.command(job, word)));
}

/** Move a waiting job between two others, if the queue is still as displayed. */
export function moveJob(job: string, machine: string, place: Neighbours): Promise<void> {
  return enqueue(async () => {
    const { queryKey } = queries.queue(machine);
    try {
      const tag = queryClient.getQueryData(queryKey)?.tag ?? null;
      upsertJob(await jobService.moveJob(job, place, tag));
    } finally {
      // After a refusal the present order is displayed.
      await queryClient.invalidateQueries({ queryKey });
    }
  });
}

/** Change priority, copies or hold of a waiting job. */
export function changeJob(job: string, change: WaitingChange): Promise<void> {
  return enqueue(async () => upsertJob(await jobService.changeJob(job, change)));
}

/** Move a waiting job to another machine; its program is compiled again. */
export function transferJob(job: string, machine: string): Promise<void> {
  return enqueue(async () => upsertJob(await jobService.transferJob(job, machine)));
}

/** Record that a new tool was put into a station. */
export function recordToolChange(machine: string, station: number): Promise<void> {
  return enqueue(async () => {
    const tools = await machineService.recordToolChange(machine, station);
    queryClient.setQueryData(queries.tools(machine).queryKey, tools);
  });
}

/** Set the length that the tool of a station may work (m). */
export function setToolLife(machine: string, station: number, life: number): Promise<void> {
  return enqueue(async () => {
    const tools = await machineService.setToolLife(machine, station, life);
    queryClient.setQueryData(queries.tools(machine).queryKey, tools);
  });
}
