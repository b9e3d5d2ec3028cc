/** Server data: fetched once, cached, and refreshed by server events. */

import {
  infiniteQueryOptions,
  keepPreviousData,
  QueryClient,
  type QueryFilters,
  queryOptions,
  skipToken,
  useInfiniteQuery,
  useQuery,
} from "@tanstack/react-query";
import { useEffect } from "react";
import { type DrawingSummary, drawingService, type ImportReportRow } from "../api/drawings";
import { ServiceError } from "../api/errors";
import { openEventStream } from "../api/events";
import {
  type HistoryFilter,
  type Job,
  jobService,
  type LastJobWanted,
  type OrderRow,
  type OrdersFilter,
} from "../api/jobs";
import { type Board, libraryService, type Shelf } from "../api/library";
import { machineService, type Station } from "../api/machines";
import type { Page } from "../api/restApi";
import { type DeliveryState, webhookService } from "../api/webhooks";
import { type DrawnEdges, type Edges, isComplete } from "../geometry/records";
import { buildTimeline } from "../geometry/timeline";
import { hasProgram, isFinal } from "./job/jobs";
import { hasChanged } from "./job/queue";
import { byTitle } from "./naturalOrder";
import { useUiStore } from "./store";

export const queryClient = new QueryClient({
  defaultOptions: {
    queries: {
      retry: 1,
      staleTime: 30_000,
      refetchOnWindowFocus: false,
      refetchInterval: ({ state: { error } }) =>
        error instanceof ServiceError && error.temporary ? 5000 : false,
    },
  },
});

/**
 * Fetch what has changed again.
 *
 * The answer to a first request that is under way may be older than the change, so that is repeated
 * when it has arrived; later requests are replaced.
 */
async function refresh(filters: QueryFilters): Promise<void> {
  const first = queryClient
    .getQueryCache()
    .findAll({ ...filters, fetchStatus: "fetching" })
    .filter(({ state }) => state.data === undefined);
  await queryClient.invalidateQueries(filters);
  const again = first.map(({ queryKey }) =>
    queryClient.invalidateQueries({ queryKey, exact: true }),
  );
  await Promise.all(again);
}

const getNextPageParam = ({ next }: Page<unknown>) => next;

/** Fetch edges; of many, first what a picture needs, which is drawn meanwhile. */
async function fetchEdgesAfterPicture(id: string, signal: AbortSignal): Promise<Edges> {
  const drawn = await drawingService.drawnEdges(id, signal);
  if (isComplete(drawn)) return drawn;
  queryClient.setQueryData(queries.drawnEdges(id).queryKey, drawn);
  return drawingService.edges(id, signal);
}

/** Key and fetch function of each query. */
export const queries = {
  drawing: (id: string) =>
    queryOptions({
      queryKey: ["drawing", id],
      queryFn: ({ signal }) => drawingService.drawing(id, signal),
    }),
  /** The pages of a file never change. */
  pages: (id: string) =>
    queryOptions({
      queryKey: ["pages", id],
      queryFn: ({ signal }) => drawingService.pages(id, signal),
      staleTime: Number.POSITIVE_INFINITY,
    }),
  edges: (id: string) =>
    queryOptions({
      queryKey: ["edges", id],
      queryFn: ({ signal }) =>
        queryClient.getQueryData(["edges", id]) === undefined
          ? fetchEdgesAfterPicture(id, signal)
          : drawingService.edges(id, signal),
      structuralSharing: false,
    }),
  /** What a picture of many edges needs, until all of them are there; set by `edges`. */
  drawnEdges: (id: string) =>
    queryOptions<DrawnEdges | null>({
      queryKey: ["drawn edges", id],
      queryFn: skipToken,
      structuralSharing: false,
    }),
  importReports: (id: string) => ["importReport", id] as const,
  importReport: (id: string, outcome: ImportReportRow["outcome"]) =>
    queryOptions({
      queryKey: ["importReport", id, outcome],
      queryFn: ({ signal }) => drawingService.importReport(id, outcome, signal),
    }),
  customerAnswers: (id: string) =>
    queryOptions({
      queryKey: ["customer-answers", id],
      queryFn: ({ signal }) => drawingService.customerAnswers(id, signal),
    }),
  learned: (id: string) =>
    queryOptions({
      queryKey: ["learned", id],
      queryFn: ({ signal }) => drawingService.learned(id, signal),
    }),
  orders: (wanted: OrdersFilter) =>
    infiniteQueryOptions({
      queryKey: ["orders", wanted],
      queryFn: ({ signal, pageParam }) => jobService.orders(wanted, signal, pageParam),
      initialPageParam: null as number | null,
      getNextPageParam,
    }),
  jobsOf: (drawing: string) =>
    queryOptions({
      queryKey: ["jobsOf", drawing],
      queryFn: ({ signal }) => jobService.jobsOf(drawing, signal),
    }),
  jobs: () =>
    infiniteQueryOptions({
      queryKey: ["jobs"],
      queryFn: ({ signal, pageParam }) => jobService.jobs(signal, pageParam),
      initialPageParam: null as number | null,
      getNextPageParam,
    }),
  lastJob: (wanted: LastJobWanted) =>
    queryOptions({
      queryKey: ["lastJob", wanted],
      queryFn: ({ signal }) => jobService.lastJob(wanted, signal),
      staleTime: 0,
    }),
  job: (id: string) =>
    queryOptions({ queryKey: ["job", id], queryFn: ({ signal }) => jobService.job(id, signal) }),
  verdict: (id: string) =>
    queryOptions({
      queryKey: ["verdict", id],
      queryFn: ({ signal }) => jobService.verdict(id, signal),
      staleTime: Number.POSITIVE_INFINITY,
    }),
  earlierExceptions: (id: string) =>
    queryOptions({
      queryKey: ["earlier exceptions", id],
      queryFn: ({ signal }) => jobService.earlierExceptions(id, signal),
    }),
  verdictColumns: (id: string) =>
    queryOptions({
      queryKey: ["verdict columns", id],
      queryFn: ({ signal }) => jobService.verdictColumns(id, signal),
      staleTime: Number.POSITIVE_INFINITY,
      structuralSharing: false,
      // Verdicts of older versions have no columns; a retry would not help.
      retry: false,
    }),
  toolpath: (id: string) =>
    queryOptions({
      queryKey: ["toolpath", id],
      queryFn: ({ signal }) => jobService.toolpath(id, signal),
      staleTime: Number.POSITIVE_INFINITY,
      structuralSharing: false,
    }),
  /** Lines of a program; a program never changes. */
  programLines: (id: string, first: number, count: number) =>
    queryOptions({
      queryKey: ["programLines", id, first, count],
      queryFn: ({ signal }) => jobService.programLines(id, first, count, signal),
      staleTime: Number.POSITIVE_INFINITY,
    }),
  section: (id: string, edge: number) =>
    queryOptions({
      queryKey: ["section", id, edge],
      queryFn: ({ signal }) => jobService.section(id, edge, signal),
      staleTime: Number.POSITIVE_INFINITY,
    }),
  /** Tracks and their states; the states belong to the last executed line of the job. */
  tracks: (id: string, line: number) =>
    queryOptions({
      queryKey: ["tracks", id, line],
      queryFn: ({ signal }) => jobService.tracks(id, signal),
      staleTime: Number.POSITIVE_INFINITY,
      // Programs of older versions have no tracks; a retry would not help.
      retry: false,
    }),
  status: () =>
    queryOptions({
      queryKey: ["service"],
      queryFn: ({ signal }) => machineService.status(signal),
      // Once the server is prepared it remains so until it is started again.
      refetchInterval: ({ state }) => (state.data?.preparing === false ? false : 1000),
    }),
  queue: (machine: string) =>
    queryOptions({
      queryKey: ["queue", machine],
      queryFn: ({ signal }) => machineService.queue(machine, signal),
      // The estimates of start times change although no job does.
      refetchInterval: 4000,
    }),
  history: (filter: HistoryFilter) =>
    infiniteQueryOptions({
      queryKey: ["history", filter],
      queryFn: ({ signal, pageParam }) => jobService.history(filter, pageParam, signal),
      initialPageParam: null as string | null,
      getNextPageParam: ({ next }) => next,
    }),
  statistics: (wanted: Parameters<typeof machineService.statistics>[0]) =>
    queryOptions({
      queryKey: ["statistics", wanted],
      queryFn: ({ signal }) => machineService.statistics(wanted, signal),
    }),
  tools: (machine: string) =>
    queryOptions({
      queryKey: ["tools", machine],
      queryFn: ({ signal }) => machineService.tools(machine, signal),
      refetchInterval: 4000,
    }),
  machines: () =>
    queryOptions({
      queryKey: ["machines"],
      queryFn: ({ signal }) => machineService.machines(signal),
      refetchInterval: 4000,
    }),
  /** `copy` tells the confirmations of the copies of a job apart. */
  confirmation: (id: string, copy: string) =>
    queryOptions({
      queryKey: ["confirmation", id, copy],
      queryFn: ({ signal }) => jobService.confirmation(id, signal),
      // A tool may reach the end of its life, or be changed, while the job waits.
      refetchInterval: 4000,
    }),
  station: (name: string) =>
    queryOptions({
      queryKey: ["station", name],
      queryFn: ({ signal }) => machineService.station(name, signal),
      // Each answer proves that the server can be reached, and keeps the gateway reporting often.
      refetchInterval: 1000,
      networkMode: "always",
      retry: false,
      staleTime: 0,
    }),
  formats: () =>
    queryOptions({
      queryKey: ["formats"],
      queryFn: ({ signal }) => drawingService.formats(signal),
    }),
  webhooks: () =>
    queryOptions({
      queryKey: ["webhooks"],
      queryFn: ({ signal }) => webhookService.list(signal),
      // Deliveries send no event to the page.
      refetchInterval: 3000,
    }),
  deliveries: (webhook: string, state: DeliveryState | null) =>
    infiniteQueryOptions({
      queryKey: ["deliveries", webhook, state],
      queryFn: ({ signal, pageParam }) =>
        webhookService.deliveries(webhook, state, signal, pageParam),
      initialPageParam: null as number | null,
      getNextPageParam,
      refetchInterval: 3000,
    }),
  delivery: (webhook: string, delivery: string) =>
    queryOptions({
      queryKey: ["delivery", webhook, delivery],
      queryFn: ({ signal }) => webhookService.delivery(webhook, delivery, signal),
      refetchInterval: ({ state }) => (state.data?.state === "pending" ? 1000 : false),
      staleTime: 0,
    }),
  library: () =>
    queryOptions({
      queryKey: ["library"],
      queryFn: ({ signal }) => libraryService.library(signal),
    }),
  librarySchema: (shelf: Shelf) =>
    queryOptions({
      queryKey: ["librarySchema", shelf],
      queryFn: ({ signal }) => libraryService.librarySchema(shelf, signal),
      staleTime: Number.POSITIVE_INFINITY,
    }),
  definition: (shelf: Shelf, name: string, version: number | null = null) =>
    queryOptions({
      queryKey: ["definition", shelf, name, version],
      queryFn: ({ signal }) => libraryService.definition(shelf, name, version, signal),
    }),
  definitionVersions: (shelf: Shelf, name: string) =>
    queryOptions({
      queryKey: ["definitionVersions", shelf, name],
      queryFn: ({ signal }) => libraryService.definitionVersions(shelf, name, signal),
    }),
  boards: () =>
    queryOptions({ queryKey: ["boards"], queryFn: ({ signal }) => libraryService.boards(signal) }),
  profiles: () =>
    queryOptions({
      queryKey: ["profiles"],
      queryFn: ({ signal }) => libraryService.profiles(signal),
    }),
};

const flattenPages = <T>({ pages }: { pages: Page<T>[] }): T[] => pages.flatMap(({ rows }) => rows);

/** Drawings with their newest jobs, page by page. */
export const useOrders = (wanted: OrdersFilter) =>
  useInfiniteQuery({
    ...queries.orders(wanted),
    select: flattenPages<OrderRow>,
    placeholderData: keepPreviousData,
  });
export const useJobsOf = (drawing: string) => useQuery(queries.jobsOf(drawing));
export const usePages = (id: string) => useQuery(queries.pages(id));
export const useJobs = () => useInfiniteQuery({ ...queries.jobs(), select: flattenPages<Job> });
export const useQueue = (machine: string) => useQuery(queries.queue(machine));
export const useHistory = (filter: HistoryFilter) =>
  useInfiniteQuery({
    ...queries.history(filter),
    select: ({ pages }) => pages.flatMap(({ rows }) => rows),
    placeholderData: keepPreviousData,
  });
export const useDeliveries = (webhook: string, state: DeliveryState | null) =>
  useInfiniteQuery({
    ...queries.deliveries(webhook, state),
    select: ({ pages }) => pages.flatMap(({ rows }) => rows),
    placeholderData: keepPreviousData,
  });
export const useStatistics = (wanted: Parameters<typeof machineService.statistics>[0]) =>
  useQuery({ ...queries.statistics(wanted), placeholderData: keepPreviousData });
export const useTools = (machine: string) => useQuery(queries.tools(machine));
export const useMachines = () => useQuery(queries.machines());
/** State of a machine for the person at it. */
export const useStation = (machine: string) => useQuery(queries.station(machine));
/** State of a machine if the page follows it; the machine then reports more often. */
export const useKnownStation = (machine: string): Station | undefined =>
  useQuery({ ...queries.station(machine), enabled: false }).data;
export const useServiceStatus = () => useQuery(queries.status());
export const useFormats = () => useQuery(queries.formats());
/** The boards, ordered by their titles. */
export const useBoards = () => useQuery({ ...queries.boards(), select: byTitle<Board> });
/** Function that returns the title of a board, or its name while the boards are not known. */
export function useBoardTitles(): (name: string) => string {
  const { data: boards } = useBoards();
  return (name) => boards?.find((board) => board.name === name)?.title || name;
}
export const useBoardTitle = (name: string): string => useBoardTitles()(name);
/** Function that returns the title of a machine, or its name while the machines are not known. */
export function useMachineTitles(): (name: string) => string {
  const { data: machines } = useMachines();
  return (name) => machines?.find((machine) => machine.name === name)?.title || name;
}
/** Caliper of a board (mm); 0 for no board, and while the boards are not known. */
export function useBoardCaliper(name: string | undefined): number {
  const { data: boards } = useBoards();
  return boards?.find((board) => board.name === name)?.caliper ?? 0;
}
/** The newest job that meets all conditions, fetched if `wanted`; null if there is none. */
export const useLastJob = (conditions: LastJobWanted, wanted: boolean) =>
  useQuery({ ...queries.lastJob(conditions), enabled: wanted });
export const useProfiles = () => useQuery(queries.profiles());

export function useDrawing() {
  const id = useUiStore((ui) => ui.drawing);
  return useQuery({ ...queries.drawing(id ?? ""), enabled: id !== null });
}

export function useEdges() {
  const id = useUiStore((ui) => ui.drawing);
  return useQuery({ ...queries.edges(id ?? ""), enabled: id !== null });
}

/** The edges of the open drawing, or what a picture of them needs while the rest is fetched. */
export function useDrawnEdges(): DrawnEdges | Edges | undefined {
  const id = useUiStore((ui) => ui.drawing);
  const { data: edges } = useEdges();
  const { data: drawn } = useQuery(queries.drawnEdges(id ?? ""));
  const outdated = edges !== undefined && drawn != null;
  useEffect(() => {
    if (id !== null && outdated) queryClient.setQueryData(queries.drawnEdges(id).queryKey, null);
  }, [id, outdated]);
  return edges ?? drawn ?? undefined;
}

/** Entities of the open drawing with one import outcome; fetched if `wanted`. */
export function useImportReport(outcome: ImportReportRow["outcome"], wanted: boolean) {
  const id = useUiStore((ui) => ui.drawing);
  return useQuery({ ...queries.importReport(id ?? "", outcome), enabled: id !== null && wanted });
}

/** What other drawings of the customer of the open drawing teach. */
export function useCustomerAnswers(wanted: boolean) {
  const id = useUiStore((ui) => ui.drawing);
  return useQuery({ ...queries.customerAnswers(id ?? ""), enabled: id !== null && wanted });
}

/** Rules that explain the corrections made in the open drawing. */
export function useLearned(wanted: boolean) {
  const id = useUiStore((ui) => ui.drawing);
  return useQuery({ ...queries.learned(id ?? ""), enabled: id !== null && wanted });
}

/** Tracks of the program of a job. */
export const useTracks = (job: Job) => useQuery(queries.tracks(job.id, job.line));

/** Tool path of any job, which need not be open. */
export const useToolpathOf = (id: string) => useQuery(queries.toolpath(id));

/** The open job. */
export function useJob() {
  const id = useUiStore((ui) => ui.job);
  return useQuery({ ...queries.job(id ?? ""), enabled: id !== null });
}

export function useVerdict() {
  const { data: job } = useJob();
  return useQuery({
    ...queries.verdict(job?.id ?? ""),
    enabled: job !== undefined && job.verdict !== null,
  });
}

/** Shortfalls of a refused job that a user accepted for an earlier job; null if there are none. */
export const useEarlierExceptions = (job: string) => useQuery(queries.earlierExceptions(job));

/** Deviations along the edges and unreachable areas, from the verdict of the open job. */
export function useVerdictColumns() {
  const { data: job } = useJob();
  return useQuery({
    ...queries.verdictColumns(job?.id ?? ""),
    enabled: job !== undefined && job.verdict !== null,
  });
}

export function useToolpath() {
  const { data: job } = useJob();
  return useQuery({
    ...queries.toolpath(job?.id ?? ""),
    enabled: job !== undefined && hasProgram(job),
  });
}

/** The tool path of the open job with times. */
export function useTimeline() {
  const { data: job } = useJob();
  return useQuery({
    ...queries.toolpath(job?.id ?? ""),
    enabled: job !== undefined && hasProgram(job),
    select: buildTimeline,
  });
}

/** Phase of the run of a job that the user sees; null if the job is not known. */
export const phaseOf = (job: string): number | null =>
  queryClient.getQueryData(queries.job(job).queryKey)?.phase ?? null;

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
