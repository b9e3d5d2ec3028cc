/**
 * Route in the hash of the address: the open drawing and job, or the station page of a machine.
 *
 *     #/                              no drawing
 *     #/drawings/ID                   a drawing
 *     #/drawings/ID/jobs/ID           a drawing and a job of it
 *     #/station/MACHINE               the page of the person at a machine
 *     #/library                       machines, boards and tools
 *     #/history                       ended jobs, statistics and tools
 *     #/webhooks                      endpoints of other systems
 */

import { useUiStore } from "../state/store";

const HISTORY = "#/history";
const WEBHOOKS = "#/webhooks";

export interface Route {
  readonly drawing: string | null;
  readonly job: string | null;
  /** The drawing and the job follow the machine while its station page is open. */
  readonly station: string | null;
  /** Whether the page of machines, boards and tools is open. */
  readonly library: boolean;
}

const LIBRARY = "#/library";
const ROUTES = /^#\/(?:drawings\/([^/]+)(?:\/jobs\/([^/]+))?|station\/([^/]+))$/;

const decoded = (part: string | undefined): string | null =>
  part === undefined ? null : decodeURIComponent(part);

export function routeOf(hash: string): Route {
  const [, drawing, job, station] = ROUTES.exec(hash) ?? [];
  try {
    return {
      drawing: decoded(drawing),
      job: decoded(job),
      station: decoded(station),
      library: hash === LIBRARY,
    };
  } catch {
    // Invalid percent-encoding in a typed address.
    return { drawing: null, job: null, station: null, library: false };
  }
}

export function hashOf({ drawing, job, station, library }: Route): string {
  if (library) return LIBRARY;
  if (station !== null) return `#/station/${encodeURIComponent(station)}`;
  if (drawing === null) return "#/";
  const page = `#/drawings/${encodeURIComponent(drawing)}`;
  return job === null ? page : `${page}/jobs/${encodeURIComponent(job)}`;
}

/** Keep address and store equal until the returned function is called. */
export function syncWithAddress(): () => void {
  const read = () => {
    const page = useUiStore.getState();
    const history = window.location.hash === HISTORY;
    const webhooks = window.location.hash === WEBHOOKS;
    const { drawing, job, station, library } = routeOf(window.location.hash);
    if (page.history !== history || page.library !== library || page.webhooks !== webhooks) {
      page.set({ history, library, webhooks });
    }
    // The drawing stays open behind these pages.
    if (history || library || webhooks) {
      if (page.station !== null) page.openStation(null);
      return;
    }
    if (page.station !== station) page.openStation(station);
    if (station === null && (page.drawing !== drawing || page.job !== job)) page.open(drawing, job);
  };
  read();
  window.addEventListener("hashchange", read);
  const stop = useUiStore.subscribe((page, before) => {
    const same =
      page.drawing === before.drawing &&
      page.station === before.station &&
      page.library === before.library &&
      page.webhooks === before.webhooks &&
      page.history === before.history;
    if (same && page.job === before.job) return;
    const other = page.webhooks ? WEBHOOKS : null;
    const hash = page.history ? HISTORY : (other ?? hashOf(page));
    if (window.location.hash === hash) return;
    // Opening a drawing adds an entry to the browser history; opening a job replaces it.
    if (same) window.history.replaceState(null, "", hash);
    else window.history.pushState(null, "", hash);
  });
  return () => {
    stop();
    window.removeEventListener("hashchange", read);
  };
}
