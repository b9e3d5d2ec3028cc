/** What the user does, from the page to the service and back into what is shown. */

import { type JobCommand, ServiceError, service, type Unit } from "../api/client";
import type { Edges, LineType } from "../geometry/records";
import { backwards, type Change, changeOf, forwards } from "./history";
import { heardJob, keys, queries } from "./queries";
import { report } from "./reports";
import { usePage } from "./store";

/** Run one thing at a time; what fails is told. */
async function alone(act: () => Promise<void>): Promise<void> {
  const page = usePage.getState();
  if (page.busy) return;
  page.set({ busy: true });
  try {
    await act();
  } catch (cause) {
    report(cause);
  } finally {
    usePage.getState().set({ busy: false });
  }
}

export function uploadFiles(files: readonly File[]): Promise<void> {
  return alone(async () => {
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
  const { drawing } = usePage.getState();
  if (drawing === null) return Promise.resolve();
  return alone(async () => {
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
  const { drawing } = usePage.getState();
  const edges: Edges | undefined =
    drawing === null ? undefined : queries.getQueryData(keys.edges(drawing).queryKey);
  if (drawing === null || edges === undefined || rows.length === 0) return Promise.resolve();
  const change: Change = changeOf(edges, rows, to);
  return alone(async () => {
    await apply(drawing, forwards(change));
    usePage.getState().made(change);
  });
}

export function undo(): Promise<void> {
  const { drawing, past } = usePage.getState();
  const last = past.at(-1);
  if (drawing === null || last === undefined) return Promise.resolve();
  return alone(async () => {
    await apply(drawing, backwards(last));
    usePage.getState().undone();
  });
}

export function redo(): Promise<void> {
  const { drawing, future } = usePage.getState();
  const next = future.at(-1);
  if (drawing === null || next === undefined) return Promise.resolve();
  return alone(async () => {
    await apply(drawing, forwards(next));
    usePage.getState().redone();
  });
}

export function compile(machine: string, board: string): Promise<void> {
  const { drawing, copies } = usePage.getState();
  if (drawing === null) return Promise.resolve();
  return alone(async () => {
    try {
      const job = await service.compile({ drawing, machine, board, copies });
      heardJob(job);
      usePage.getState().openJob(job.id);
    } catch (cause) {
      if (cause instanceof ServiceError) usePage.getState().set({ asked: cause.problem.questions });
      throw cause;
    }
  });
}

export function command(job: string, word: JobCommand): Promise<void> {
  return alone(async () => {
    heardJob(await service.command(job, word));
  });
}
