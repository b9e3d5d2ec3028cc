/**
 * The address names what is open, so that it can be kept, sent and loaded again.
 *
 *     #/                              nothing
 *     #/drawings/ID                   a drawing
 *     #/drawings/ID/jobs/ID           a drawing and the job that was made of it
 */

import { usePage } from "../state/store";

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
    // A stray % in an address somebody typed.
    return { drawing: null, job: null };
  }
}

export function hashOf({ drawing, job }: Route): string {
  if (drawing === null) return "#/";
  const page = `#/drawings/${encodeURIComponent(drawing)}`;
  return job === null ? page : `${page}/jobs/${encodeURIComponent(job)}`;
}

/** Keep address and store the same until the returned function is called. */
export function followAddress(): () => void {
  const read = () => {
    const { drawing, job } = routeOf(window.location.hash);
    const page = usePage.getState();
    if (page.drawing !== drawing || page.job !== job) page.open(drawing, job);
  };
  read();
  window.addEventListener("hashchange", read);
  const stop = usePage.subscribe((page, before) => {
    if (page.drawing === before.drawing && page.job === before.job) return;
    const hash = hashOf(page);
    if (window.location.hash === hash) return;
    // Another drawing is a place to come back from; another job of it is not.
    if (page.drawing === before.drawing) window.history.replaceState(null, "", hash);
    else window.history.pushState(null, "", hash);
  });
  return () => {
    stop();
    window.removeEventListener("hashchange", read);
  };
}
