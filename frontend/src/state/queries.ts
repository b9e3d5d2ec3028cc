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
import { drawingService, type ImportReportRow } from "../api/drawings";
import { ServiceError } from "../api/errors";
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
import { hasProgram } from "./job/jobs";
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
export async function refresh(filters: QueryFilters): Promise<void> {
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
