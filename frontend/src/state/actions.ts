/** What the user does, from the page to the service and back into what is shown. */

import { type JobCommand, ServiceError, service, type Unit } from "../api/client";
import type { LineType } from "../geometry/records";
import { mills } from "./corners";
import { backwards, changeOf, forwards } from "./history";
import { heardJob, keys, queries } from "./queries";
import { report } from "./reports";
import { usePage } from "./store";

let last: Promise<void> = Promise.resolve();
let waiting = 0;

/** Run one thing after the other, in the order in which they were asked; what fails is told. */
function inTurn(act: () => Promise<void>): Promise<void> {
  waiting++;
  usePage.getState().set({ busy: true });
  last = last
    .then(act)
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
        const drawing = await service.upload(file, (fraction) =>
          usePage.getState().set({ upload: { name: file.name, fraction } }),
        );
        queries.setQueryData(keys.drawing(drawing.id).queryKey, drawing);
        usePage.getState().open(drawing.id);
      }
    } finally {
      usePage.getState().set({ upload: null });
      await queries.invalidateQueries({ queryKey: keys.drawings().queryKey });
    }
  });
}

/** Ask again for what belongs to a drawing. */
const refresh = (drawing: string) =>
  Promise.all([
    queries.invalidateQueries({ queryKey: keys.edges(drawing).queryKey }),
    queries.invalidateQueries({ queryKey: keys.ledger(drawing).queryKey }),
    queries.invalidateQueries({ queryKey: keys.drawings().queryKey }),
  ]);

export function settle(change: { unit?: Unit; profile?: string }): Promise<void> {
  return inTurn(async () => {
    const { drawing } = usePage.getState();
    if (drawing === null) return;
    const answer = await service.settle(drawing, change);
    queries.setQueryData(keys.drawing(drawing).queryKey, answer);
    usePage.getState().openJob(null);
    usePage.getState().set({ asked: [] });
    await refresh(drawing);
  });
}

async function apply(drawing: string, overrides: ReturnType<typeof forwards>): Promise<void> {
  const answer = await service.override(drawing, overrides);
  queries.setQueryData(keys.drawing(drawing).queryKey, answer);
  // A job's path belongs to the drawing as it was: it is no longer that of this one.
  usePage.getState().openJob(null);
  usePage.getState().set({ asked: [] });
  await refresh(drawing);
}

/** Give these edges a line type; null lets the profile decide again. */
export function retype(rows: readonly number[], to: LineType | null): Promise<void> {
  return inTurn(async () => {
    const { drawing } = usePage.getState();
    if (drawing === null || rows.length === 0) return;
    const edges = queries.getQueryData(keys.edges(drawing).queryKey);
    if (edges === undefined) return;
    const change = changeOf(edges, rows, to);
    await apply(drawing, forwards(change));
    usePage.getState().made(change);
  });
}

export function undo(): Promise<void> {
  return inTurn(async () => {
    const { drawing, past } = usePage.getState();
    const change = past.at(-1);
    if (drawing === null || change === undefined) return;
    await apply(drawing, backwards(change));
    usePage.getState().undone();
  });
}

export function redo(): Promise<void> {
  return inTurn(async () => {
    const { drawing, future } = usePage.getState();
    const change = future.at(-1);
    if (drawing === null || change === undefined) return;
    await apply(drawing, forwards(change));
    usePage.getState().redone();
  });
}

export function compile(machine: string, board: string): Promise<void> {
  return inTurn(async () => {
    const { drawing, copies } = usePage.getState();
    if (drawing === null) return;
    usePage.getState().set({ picking: false });
    const machines = queries.getQueryData(keys.machines().queryKey);
    const milled = mills(machines?.find(({ name }) => name === machine));
    const corners = milled ? usePage.getState().corners : null;
    try {
      const job = await service.compile({ drawing, machine, board, copies, corners });
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
