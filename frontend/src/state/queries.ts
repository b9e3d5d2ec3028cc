/** What the service knows, asked for once, kept, and refreshed by its events. */

import {
  infiniteQueryOptions,
  QueryClient,
  queryOptions,
  useInfiniteQuery,
  useQuery,
} from "@tanstack/react-query";
import {
  type DrawingSummary,
  FIRST,
  type Job,
  type LedgerRow,
  type Page,
  service,
} from "../api/client";
import { listen } from "../api/events";
import { timeline } from "../geometry/timeline";
import { hasProgram } from "./jobs";
import { usePage } from "./store";

export const queries = new QueryClient({
  defaultOptions: { queries: { retry: 1, staleTime: 30_000, refetchOnWindowFocus: false } },
});

const getNextPageParam = ({ next }: Page<unknown>) => next;

const ask = {
  drawings: () =>
    infiniteQueryOptions({
      queryKey: ["drawings"],
      queryFn: ({ signal, pageParam }) => service.drawings(signal, pageParam),
      initialPageParam: FIRST.drawings as string,
      getNextPageParam,
    }),
  drawing: (id: string) =>
    queryOptions({
      queryKey: ["drawing", id],
      queryFn: ({ signal }) => service.drawing(id, signal),
    }),
  edges: (id: string) =>
    queryOptions({
      queryKey: ["edges", id],
      queryFn: ({ signal }) => service.edges(id, signal),
      structuralSharing: false,
    }),
  ledgers: (id: string) => ["ledger", id] as const,
  ledger: (id: string, fate: LedgerRow["fate"]) =>
    queryOptions({
      queryKey: ["ledger", id, fate],
      queryFn: ({ signal }) => service.ledger(id, fate, signal),
    }),
  learned: (id: string) =>
    queryOptions({
      queryKey: ["learned", id],
      queryFn: ({ signal }) => service.learned(id, signal),
    }),
  jobs: () =>
    infiniteQueryOptions({
      queryKey: ["jobs"],
      queryFn: ({ signal, pageParam }) => service.jobs(signal, pageParam),
      initialPageParam: FIRST.jobs as string,
      getNextPageParam,
    }),
  job: (id: string) =>
    queryOptions({ queryKey: ["job", id], queryFn: ({ signal }) => service.job(id, signal) }),
  verdict: (id: string) =>
    queryOptions({
      queryKey: ["verdict", id],
      queryFn: ({ signal }) => service.verdict(id, signal),
      staleTime: Number.POSITIVE_INFINITY,
    }),
  verdictColumns: (id: string) =>
    queryOptions({
      queryKey: ["verdict columns", id],
      queryFn: ({ signal }) => service.verdictColumns(id, signal),
      staleTime: Number.POSITIVE_INFINITY,
      structuralSharing: false,
      // A verdict of an older service has none, and will not get any.
      retry: false,
    }),
  toolpath: (id: string) =>
    queryOptions({
      queryKey: ["toolpath", id],
      queryFn: ({ signal }) => service.toolpath(id, signal),
      staleTime: Number.POSITIVE_INFINITY,
      structuralSharing: false,
    }),
  machines: () =>
    queryOptions({
      queryKey: ["machines"],
      queryFn: ({ signal }) => service.machines(signal),
      refetchInterval: 4000,
    }),
  formats: () =>
    queryOptions({ queryKey: ["formats"], queryFn: ({ signal }) => service.formats(signal) }),
  boards: () =>
    queryOptions({ queryKey: ["boards"], queryFn: ({ signal }) => service.boards(signal) }),
  profiles: () =>
    queryOptions({ queryKey: ["profiles"], queryFn: ({ signal }) => service.profiles(signal) }),
};

export const keys = ask;

const rowsOf = <T>({ pages }: { pages: Page<T>[] }): T[] => pages.flatMap(({ rows }) => rows);

/** The lists, as far as they were asked for: `fetchNextPage` brings more where `hasNextPage`. */
export const useDrawings = () =>
  useInfiniteQuery({ ...ask.drawings(), select: rowsOf<DrawingSummary> });
export const useJobs = () => useInfiniteQuery({ ...ask.jobs(), select: rowsOf<Job> });
export const useMachines = () => useQuery(ask.machines());
export const useFormats = () => useQuery(ask.formats());
export const useBoards = () => useQuery(ask.boards());
export const useProfiles = () => useQuery(ask.profiles());

export function useDrawing() {
  const id = usePage((page) => page.drawing);
  return useQuery({ ...ask.drawing(id ?? ""), enabled: id !== null });
}

export function useEdges() {
  const id = usePage((page) => page.drawing);
  return useQuery({ ...ask.edges(id ?? ""), enabled: id !== null });
}

/** The entities of one fate of the drawing that is open, once they are `wanted`. */
export function useLedger(fate: LedgerRow["fate"], wanted: boolean) {
  const id = usePage((page) => page.drawing);
  return useQuery({ ...ask.ledger(id ?? "", fate), enabled: id !== null && wanted });
}

/** Rules that would have said what somebody corrected in the drawing that is open. */
export function useLearned(wanted: boolean) {
  const id = usePage((page) => page.drawing);
  return useQuery({ ...ask.learned(id ?? ""), enabled: id !== null && wanted });
}

/** The job that is looked at. */
export function useJob() {
  const id = usePage((page) => page.job);
  return useQuery({ ...ask.job(id ?? ""), enabled: id !== null });
}

export function useVerdict() {
  const { data: job } = useJob();
  return useQuery({
    ...ask.verdict(job?.id ?? ""),
    enabled: job !== undefined && job.verdict !== null,
  });
}

/** What the verdict of the job says along the lines, and where no cutter gets to. */
export function useVerdictColumns() {
  const { data: job } = useJob();
  return useQuery({
    ...ask.verdictColumns(job?.id ?? ""),
    enabled: job !== undefined && job.verdict !== null,
  });
}

export function useToolpath() {
  const { data: job } = useJob();
  return useQuery({
    ...ask.toolpath(job?.id ?? ""),
    enabled: job !== undefined && hasProgram(job),
  });
}

/** The toolpath of the job laid out in time. */
export function useTimeline() {
  const { data: job } = useJob();
  return useQuery({
    ...ask.toolpath(job?.id ?? ""),
    enabled: job !== undefined && hasProgram(job),
    select: timeline,
  });
}

/** Take a job as the service just told it, wherever it is shown. */
export function heardJob(job: Job): void {
  const known = queries.getQueryData(ask.job(job.id).queryKey);
  if (known !== undefined && known.updated > job.updated) return;
  queries.setQueryData(ask.job(job.id).queryKey, job);
  // A job that begins or ends makes a table busy or free.
  if (known?.state !== job.state) {
    void queries.invalidateQueries({ queryKey: ask.machines().queryKey });
  }
  queries.setQueryData(ask.jobs().queryKey, (list) => {
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

const isDrawing = (data: unknown): data is DrawingSummary =>
  typeof data === "object" && data !== null && "id" in data && "revision" in data;

/** Of what belongs to a drawing, forget what is not shown: it is asked for again when it is. */
function forget(id: string): void {
  for (const queryKey of [ask.drawing(id).queryKey, ask.edges(id).queryKey, ask.ledgers(id)])
    queries.removeQueries({ queryKey, type: "inactive" });
}

/**
 * Follow the service's events until the returned function is called.
 *
 * `onDrawing` hears which drawing has changed, or null where anything may have.
 */
export function follow(
  onDrawing: (drawing: Pick<DrawingSummary, "id" | "revision"> | null) => void,
): () => void {
  let broken = false;
  return listen("/api/events", ["job", "drawing", "deleted"], {
    onEvent: (name, data) => {
      if (name === "job" && isJob(data)) heardJob(data);
      else {
        // Another page, or an order by REST, brought a drawing, changed it or took it away.
        void queries.invalidateQueries({ queryKey: ask.drawings().queryKey });
        if (name === "drawing" && isDrawing(data)) {
          forget(data.id);
          onDrawing(data);
        }
      }
    },
    onLine: (line) => {
      usePage.getState().set({ line });
      if (line === "broken") broken = true;
      else if (line === "open" && broken) {
        broken = false;
        // What happened while nobody listened; the drawing that is open is compared first.
        void queries.invalidateQueries({
          predicate: ({ queryKey }) => queryKey[0] !== "drawing" && queryKey[0] !== "edges",
        });
        onDrawing(null);
      }
    },
  });
}
