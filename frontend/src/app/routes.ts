/**
 * Route in the hash of the address: the open drawing and job, or another view.
 *
 *     #/                              no drawing
 *     #/drawings/ID                   a drawing
 *     #/drawings/ID/jobs/ID           a drawing and a job of it
 *     #/station/MACHINE               the page of the person at a machine
 *     #/library                       machines, boards and tools
 *     #/history                       ended jobs, statistics and tools
 *     #/webhooks                      endpoints of other systems
 */

import { type Route, useUiStore } from "../state/store";

const LIBRARY = "#/library";
const HISTORY = "#/history";
const WEBHOOKS = "#/webhooks";
const ROUTES = /^#\/(?:drawings\/([^/]+)(?:\/jobs\/([^/]+))?|station\/([^/]+))$/;

const decoded = (part: string | undefined): string | null =>
  part === undefined ? null : decodeURIComponent(part);

export function routeOf(hash: string): Route {
  const [, drawing, job, station] = ROUTES.exec(hash) ?? [];
  const views = {
    library: hash === LIBRARY,
    webhooks: hash === WEBHOOKS,
    history: hash === HISTORY,
  };
  try {
    return { drawing: decoded(drawing), job: decoded(job), station: decoded(station), ...views };
  } catch {
    // Invalid percent-encoding in a typed address.
    return { drawing: null, job: null, station: null, ...views };
  }
}

export function hashOf({ drawing, job, station, library, webhooks, history }: Route): string {
  if (history) return HISTORY;
  if (webhooks) return WEBHOOKS;
  if (library) return LIBRARY;
  if (station !== null) return `#/station/${encodeURIComponent(station)}`;
  if (drawing === null) return "#/";
  const page = `#/drawings/${encodeURIComponent(drawing)}`;
  return job === null ? page : `${page}/jobs/${encodeURIComponent(job)}`;
}

/** Open what the address names. */
export const openAddress = (): void =>
  useUiStore.getState().openRoute(routeOf(window.location.hash));

/** Keep address and store equal until the returned function is called. */
export function syncWithAddress(): () => void {
  openAddress();
  window.addEventListener("hashchange", openAddress);
  const stop = useUiStore.subscribe((page, before) => {
    const hash = hashOf(page);
    if (hash === hashOf(before) || window.location.hash === hash) return;
    // Opening a drawing or a view adds an entry to the browser history; a job replaces it.
    if (hashOf({ ...page, job: null }) === hashOf({ ...before, job: null }))
      window.history.replaceState(null, "", hash);
    else window.history.pushState(null, "", hash);
  });
  return () => {
    stop();
    window.removeEventListener("hashchange", openAddress);
  };
}
