/** Updates of the cached data: by events of the server, and by answers to changes. */

import type { DrawingSummary } from "../api/drawings";
import { openEventStream } from "../api/events";
import type { Job } from "../api/jobs";
import type { Station } from "../api/machines";
import { isFinal } from "./job/jobs";
import { hasChanged } from "./job/queue";
import { queries, queryClient, refresh } from "./queries";
import { useUiStore } from "./store";

/** Insert or update a job in the cache, unless the cached one is newer. */
export function upsertJob(job: Job): void {
  const known = queryClient.getQueryData(queries.job(job.id).queryKey);
  if (known !== undefined && known.updated > job.updated) return;
  queryClient.setQueryData(queries.job(job.id).queryKey, job);
  // The table of work shows the newest job of each drawing.
  if (known?.state !== job.state || known?.waiting_for !== job.waiting_for) {
    void refresh({ queryKey: ["orders"] });
    void refresh({ queryKey: queries.jobsOf(job.drawing).queryKey });
  }
  if (hasChanged(known, job)) {
    void refresh({ queryKey: ["queue"] });
    if (known?.state !== job.state && (isFinal(job) || job.state === "interrupted")) {
      for (const key of ["history", "statistics", "tools"]) void refresh({ queryKey: [key] });
    }
  }
  // A job that starts or ends makes its machine busy or free.
  if (known?.state !== job.state) {
    void refresh({ queryKey: queries.machines().queryKey });
  }
  const { queryKey } = queries.jobs();
  // The answer that is under way may not contain this change.
  if (known?.state !== job.state && queryClient.isFetching({ queryKey }) > 0)
    void refresh({ queryKey });
  queryClient.setQueryData(queryKey, (list) => {
    if (list === undefined) return list;
    const known = list.pages.some(({ rows }) => rows.some(({ id }) => id === job.id));
    const pages = list.pages.map((page, at) => {
      const rows = page.rows.map((row) => (row.id === job.id ? job : row));
      return { ...page, rows: known || at > 0 ? rows : [job, ...rows] };
    });
    return { ...list, pages };
  });
}

const isJob = (data: unknown): data is Job =>
  typeof data === "object" && data !== null && "id" in data && "state" in data && "stage" in data;

const isStation = (data: unknown): data is Station =>
  typeof data === "object" && data !== null && "machine" in data && "operations" in data;

const isDrawing = (data: unknown): data is DrawingSummary =>
  typeof data === "object" && data !== null && "id" in data && "revision" in data;

/** Put the reported state of a machine in place of the last one, if the machine is on display. */
function showStation(station: Station): void {
  const { queryKey } = queries.station(station.machine);
  queryClient.setQueryData(queryKey, (shown) => (shown === undefined ? shown : station));
}

/** Drop cached data of a drawing that is not on display. */
function dropInactive(id: string): void {
  for (const queryKey of [
    queries.drawing(id).queryKey,
    queries.edges(id).queryKey,
    queries.importReports(id),
  ])
    queryClient.removeQueries({ queryKey, type: "inactive" });
}

/** Fetch again what the library contains: what can be chosen, not the definition in an editor. */
export async function refreshChoices(): Promise<void> {
  const keys = ["library", "machines", "boards", "profiles"];
  await Promise.all(keys.map((key) => refresh({ queryKey: [key] })));
}

const EVENTS = ["connected", "job", "drawing", "deleted", "station", "library"];

/**
 * Subscribe to server events until the returned function is called.
 *
 * `onDrawing` receives the drawing that changed, or null if any may have changed.
 */
export function subscribeToEvents(
  onDrawing: (drawing: Pick<DrawingSummary, "id" | "revision"> | null) => void,
): () => void {
  let broken = false;
  return openEventStream("/api/v1/events", EVENTS, {
    onEvent: (name, data) => {
      if (name === "connected") {
        // What changed between the first requests, or the last event, and now was not sent.
        void refresh({
          predicate: ({ queryKey }) => queryKey[0] !== "drawing" && queryKey[0] !== "edges",
        });
        // The open drawing is compared before it is replaced.
        if (broken) onDrawing(null);
        broken = false;
      } else if (name === "job" && isJob(data)) upsertJob(data);
      else if (name === "station") {
        if (isStation(data)) showStation(data);
      } else if (name === "library") {
        void refreshChoices();
      } else {
        // A drawing was added, changed or deleted.
        void refresh({ queryKey: ["orders"] });
        if (name === "drawing" && isDrawing(data)) {
          dropInactive(data.id);
          onDrawing(data);
        }
      }
    },
    onConnection: (connection) => {
      useUiStore.getState().set({ connection });
      if (connection !== "broken") return;
      broken = true;
      // The stream of a session that has ended ends too; then this request loads the sign-in page.
      void refresh({ queryKey: ["me"] });
    },
  });
}
