/**
 * Views in the hash of the address, shown by the router.
 *
 *     #/                              no drawing
 *     #/drawings/ID                   a drawing
 *     #/drawings/ID/jobs/ID           a drawing and a job of it
 *     #/station/MACHINE               the page of the person at a machine
 *     #/library                       machines, boards and tools
 *     #/library/SHELF/NAME            one of them, such as #/library/machines/demo-table
 *     #/history                       ended jobs, statistics and tools
 *     #/webhooks                      endpoints of other systems
 *
 * The open drawing and job are state, because they stay open behind the other views.
 */

import { navigate } from "wouter/use-hash-location";
import { type OpenDrawing, useUiStore } from "./store";

export const STATION = "/station/:machine";
export const LIBRARY = "/library/:shelf?/:name?";
export const HISTORY = "/history";
export const WEBHOOKS = "/webhooks";

/** Addresses of the page of drawings and of the history. */
export const DRAWINGS = /^\/(?:history|drawings\/[^/]+(?:\/jobs\/[^/]+)?)?$/;

const OTHER_VIEW = /^#\/(?:library(?:\/[^/]+\/[^/]+)?|history|webhooks|station\/[^/]+)$/;
const DRAWING = /^#\/drawings\/([^/]+)(?:\/jobs\/([^/]+))?$/;

/** What an address opens; null if it names a view behind which the drawing stays open. */
export function drawingOf(hash: string): OpenDrawing | null {
  if (OTHER_VIEW.test(hash)) return null;
  const [, drawing, job] = DRAWING.exec(hash) ?? [];
  try {
    return { drawing: decoded(drawing), job: decoded(job) };
  } catch {
    // Invalid percent-encoding in a typed address.
    return { drawing: null, job: null };
  }
}

const decoded = (part: string | undefined): string | null =>
  part === undefined ? null : decodeURIComponent(part);

/** A part of a path as it was before it was encoded; as it is typed if the encoding is invalid. */
export function decodedPart(part = ""): string {
  try {
    return decodeURIComponent(part);
  } catch {
    return part;
  }
}

/** Path of a drawing and a job of it; "/" without a drawing. */
export function drawingPath({ drawing, job }: OpenDrawing): string {
  if (drawing === null) return "/";
  const path = `/drawings/${encodeURIComponent(drawing)}`;
  return job === null ? path : `${path}/jobs/${encodeURIComponent(job)}`;
}

/** Show the open drawing instead of another view. */
export function returnToDrawing(): void {
  const path = drawingPath(useUiStore.getState());
  if (location.hash !== `#${path}`) navigate(path);
}

/** Open a drawing and a job of it and show them; null shows all drawings. */
export function showDrawing(drawing: string | null, job: string | null = null): void {
  useUiStore.getState().open(drawing, job);
  returnToDrawing();
}

/** Open the drawing that the address names. */
export function openAddress(): void {
  const named = drawingOf(location.hash);
  if (named !== null) useUiStore.getState().open(named.drawing, named.job);
}

/** Keep the address and the open drawing equal until the returned function is called. */
export function syncWithAddress(): () => void {
  openAddress();
  addEventListener("hashchange", openAddress);
  const stop = useUiStore.subscribe((page, before) => {
    const path = drawingPath(page);
    if (path === drawingPath(before) || location.hash === `#${path}`) return;
    if (drawingOf(location.hash) === null) return;
    // Opening a drawing adds an entry to the browser history; a job replaces it.
    navigate(path, { replace: page.drawing === before.drawing });
  });
  return () => {
    stop();
    removeEventListener("hashchange", openAddress);
  };
}
