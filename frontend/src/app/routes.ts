/**
 * Route in the hash of the address: the open drawing and job.
 *
 *     #/                              no drawing
 *     #/drawings/ID                   a drawing
 *     #/drawings/ID/jobs/ID           a drawing and a job of it
 */

import { useUiStore } from "../state/store";

export interface Route {
  readonly drawing: string | null;
  readonly job: string | null;
}

export function routeOf(hash: string): Route {
  const found = /^#\/drawings\/([^/]+)(?:\/jobs\/([^/]+))?$/.exec(hash);
  const [, drawing, job] = found ?? [];
  try {
    return {
      drawing: drawing === undefined ? null : decodeURIComponent(drawing),
      job: job === undefined ? null : decodeURIComponent(job),
    };
  } catch {
    // Invalid percent-encoding in a typed address.
    return { drawing: null, job: null };
  }
}

export function hashOf({ drawing, job }: Route): string {
  if (drawing === null) return "#/";
  const page = `#/drawings/${encodeURIComponent(drawing)}`;
  return job === null ? page : `${page}/jobs/${encodeURIComponent(job)}`;
}

/** Keep address and store equal until the returned function is called. */
export function syncWithAddress(): () => void {
  const read = () => {
    const { drawing, job } = routeOf(window.location.hash);
    const page = useUiStore.getState();
    if (page.drawing !== drawing || page.job !== job) page.open(drawing, job);
  };
  read();
  window.addEventListener("hashchange", read);
  const stop = useUiStore.subscribe((page, before) => {
    if (page.drawing === before.drawing && page.job === before.job) return;
    const hash = hashOf(page);
    if (window.location.hash === hash) return;
    // Opening a drawing adds an entry to the browser history; opening a job replaces it.
    if (page.drawing === before.drawing) window.history.replaceState(null, "", hash);
    else window.history.pushState(null, "", hash);
  });
  return () => {
    stop();
    window.removeEventListener("hashchange", read);
  };
}
