/** Requests about orders and jobs: from the order to the verdict, the run and the history. */

import type { Toolpath, VerdictColumns } from "../geometry/records";
import { toolpathOf, verdictColumnsOf } from "./columns";
import type { ExportFormat } from "./drawings";
import type { components, paths } from "./openapi.gen";
import { operatorName } from "./operator";
import type { EDGE_OPTIONS, OPTIONS } from "./options.gen";
import { api, binary, byId, dataOf, nowOrNever, type Page, pageOf, uncached } from "./restApi";

type Schemas = components["schemas"];
export type CornerAt = Schemas["CornerAt"];
export type Corners = Schemas["Corners"];
/** What the operator checks at the machine before a job or its next copy starts. */
export type Confirmation = Schemas["ConfirmationOut"];
/** What the operator has checked, as it is sent with the confirmation. */
export type CheckedTable = Omit<Schemas["ConfirmIn"], "by">;
/** The section of the board across an edge, as a program makes it. */
export type EdgeSection = Schemas["EdgeSectionOut"];
export type ToolSection = Schemas["ToolSectionOut"];
export type Finding = Schemas["FindingOut"];
export type Job = Schemas["JobOut"];
/** What an ERP system or a user attaches to an order. */
export type OrderDetails = Pick<Job, "external_id" | "customer" | "due" | "notes" | "metadata">;

export type JobOrder = Pick<Schemas["JobIn"], "drawing" | "machine" | "board"> & {
  /** Revision of the drawing on display; null if unknown. */
  revision: number | null;
  copies: number;
} & Pick<
    Job,
    | "corners"
    | "sheet"
    | "registration"
    | "lift"
    | ListOption
    | keyof typeof OPTIONS
    | keyof typeof EDGE_OPTIONS
  > &
  OrderDetails;

/** The options of a job that are lists and have a form of their own. */
export type ListOption = "work_order" | "bridges";
export type JobState = Job["state"];
/** A drawing with its newest job. */
export type OrderRow = Schemas["OrderRow"];
export type Lift = Job["lift"];
/** Marks of a printed sheet. */
export type Registration = NonNullable<Job["registration"]>;
/** Measured marks of a printed sheet, with their fit. */
export type MarkFit = Schemas["RegistrationOut"];
export type MeasuredMarks = Omit<Schemas["MeasuredMarksIn"], "by">;
export type RestChoice = Schemas["RestIn"];
export type Sheet = Schemas["Sheet"];
export type Track = Schemas["TrackOut"];
/** Values of a waiting job that an operator may change. */
export type WaitingChange = Omit<Schemas["WaitingChangeIn"], "by">;

/** Neighbours in a queue; empty at its ends. */
export interface Neighbours {
  readonly previous: string;
  readonly next: string;
}

export type Verdict = Schemas["VerdictOut"];
export type VerdictSummary = Schemas["VerdictSummary"];
/** Actions without further data, each a route of its own. */
export type JobCommand = Exclude<Schemas["OperatorAction"], "accept" | "confirm" | "rest">;
/** Actions of the person at the machine only, on the page of its station. */
export type StationCommand = "resume" | "end";
export type Exceptions = Schemas["ExceptionsIn"];
export type EarlierExceptions = Schemas["EarlierExceptions"];

/** Conditions on jobs of which the newest is wanted. */
export interface LastJobWanted {
  readonly drawing?: string;
  readonly customer?: string;
  readonly machine?: string;
  readonly board?: string;
}

/** Conditions on drawings and their newest jobs, and the order of the list. */
export type OrdersFilter = Omit<
  NonNullable<paths["/api/v1/orders"]["get"]["parameters"]["query"]>,
  "cursor" | "limit"
>;

/** Conditions on ended jobs; a condition that is missing or empty is met by all. */
export interface HistoryFilter {
  readonly machine?: string;
  readonly board?: string;
  readonly drawing?: string;
  readonly external_id?: string;
  readonly customer?: string;
  readonly state?: EndedState | undefined;
  /** Earliest end (seconds since 1970). */
  readonly since?: number | undefined;
}

export type EndedState = NonNullable<
  NonNullable<paths["/api/v1/history"]["get"]["parameters"]["query"]>["state"]
>[number];

/** Part of the list of ended jobs; its cursor is a text. */
export interface HistoryPart {
  readonly rows: readonly Job[];
  readonly next: string | null;
}

async function fetchHistory(
  { state, since, ...filter }: HistoryFilter,
  cursor: string | null,
  signal?: AbortSignal,
): Promise<HistoryPart> {
  const query = {
    ...filter,
    ...(state === undefined ? {} : { state: [state] }),
    ...(since === undefined ? {} : { since: new Date(since * 1000).toISOString() }),
    ...(cursor === null ? {} : { cursor }),
  };
  const { data, response } = await api.GET("/api/v1/history", {
    params: { query },
    ...uncached(signal),
  });
  const [, address] = /<([^>]*)>/.exec(response.headers.get("Link") ?? "") ?? [];
  const next =
    address === undefined ? null : new URL(address, "http://localhost").searchParams.get("cursor");
  return { rows: (data ?? []) as Job[], next };
}

export const jobService = {
  jobs: (signal?: AbortSignal, cursor: number | null = null): Promise<Page<Job>> =>
    pageOf(api.GET("/api/v1/jobs", { params: { query: { cursor } }, ...uncached(signal) })),
  /** Drawings with their newest jobs. */
  orders: (
    wanted: OrdersFilter,
    signal?: AbortSignal,
    cursor: number | null = null,
  ): Promise<Page<OrderRow>> =>
    pageOf(
      api.GET("/api/v1/orders", { params: { query: { ...wanted, cursor } }, ...uncached(signal) }),
    ),
  /** The jobs of a drawing, newest first: at most 30. */
  jobsOf: (drawing: string, signal?: AbortSignal): Promise<Job[]> =>
    dataOf(
      api.GET("/api/v1/jobs", { params: { query: { drawing, limit: 30 } }, ...uncached(signal) }),
    ),
  /** The newest job that meets all conditions; null if there is none. */
  lastJob: async (wanted: LastJobWanted, signal?: AbortSignal): Promise<Job | null> => {
    const query = { ...wanted, limit: 1 };
    const jobs: Job[] = await dataOf(
      api.GET("/api/v1/jobs", { params: { query }, ...uncached(signal) }),
    );
    return jobs[0] ?? null;
  },
  job: (id: string, signal?: AbortSignal): Promise<Job> =>
    dataOf(api.GET("/api/v1/jobs/{id}", { params: byId(id), ...uncached(signal) })),
  compile: (order: JobOrder): Promise<Job> =>
    dataOf(
      api.POST("/api/v1/jobs", { body: { ...order, priority: 0, overrides: [], release: false } }),
    ),
  /** Move a job between others, if the queue still has this ETag. */
  moveJob: (id: string, place: Neighbours, tag: string | null): Promise<Job> =>
    dataOf(
      api.POST("/api/v1/jobs/{id}/move", {
        params: { ...byId(id), header: tag === null ? {} : { "If-Match": tag } },
        body: { ...place, by: operatorName() },
      }),
    ),
  changeJob: (id: string, change: WaitingChange): Promise<Job> =>
    dataOf(
      api.PATCH("/api/v1/jobs/{id}", { params: byId(id), body: { ...change, by: operatorName() } }),
    ),
  transferJob: (id: string, machine: string): Promise<Job> =>
    dataOf(
      api.POST("/api/v1/jobs/{id}/transfer", {
        params: byId(id),
        body: { machine, by: operatorName() },
      }),
    ),
  history: fetchHistory,
  command: (id: string, command: Exclude<JobCommand, StationCommand>): Promise<Job> =>
    dataOf(api.POST(`/api/v1/jobs/{id}/${command}`, { params: byId(id) })),
  confirmation: (id: string, signal?: AbortSignal): Promise<Confirmation> =>
    dataOf(api.GET("/api/v1/jobs/{id}/confirmation", { params: byId(id), ...uncached(signal) })),
  registration: (id: string, signal?: AbortSignal): Promise<MarkFit> =>
    dataOf(api.GET("/api/v1/jobs/{id}/registration", { params: byId(id), ...uncached(signal) })),
  fitMarks: (id: string, measured: MeasuredMarks): Promise<MarkFit> =>
    dataOf(
      api.POST("/api/v1/jobs/{id}/registration/fit", {
        params: byId(id),
        body: { by: operatorName(), ...measured },
        ...nowOrNever(),
      }),
    ),
  /** Compile a job again for its measured sheet: it is sent once, and never late. */
  registerNow: (id: string, measured: MeasuredMarks): Promise<Job> =>
    dataOf(
      api.POST("/api/v1/jobs/{id}/registration", {
        params: byId(id),
        body: { by: operatorName(), ...measured },
        ...nowOrNever(),
      }),
    ),
  /** Confirm what the operator has checked: it is sent once, and never late. */
  confirmNow: (id: string, checked: CheckedTable): Promise<Job> =>
    dataOf(
      api.POST("/api/v1/jobs/{id}/confirm", {
        params: byId(id),
        body: { by: operatorName(), ...checked },
        ...nowOrNever(),
      }),
    ),
  /** Go on in the phase of the run that the user has seen: it is sent once, and never late. */
  goOnNow: (id: string, command: StationCommand, phase: number | null): Promise<Job> =>
    dataOf(
      api.POST(`/api/v1/jobs/{id}/${command}`, {
        params: byId(id),
        body: { phase },
        ...nowOrNever(),
      }),
    ),
  tracks: (id: string, signal?: AbortSignal): Promise<readonly Track[]> =>
    dataOf(api.GET("/api/v1/jobs/{id}/tracks", { params: byId(id), ...uncached(signal) })),
  continueJob: (id: string, choice: RestChoice): Promise<Job> =>
    dataOf(api.POST("/api/v1/jobs/{id}/rest", { params: byId(id), body: choice })),
  accept: (id: string, exceptions: Exceptions): Promise<Job> =>
    dataOf(api.POST("/api/v1/jobs/{id}/exceptions", { params: byId(id), body: exceptions })),
  earlierExceptions: (id: string, signal?: AbortSignal): Promise<EarlierExceptions | null> =>
    dataOf(
      api.GET("/api/v1/jobs/{id}/earlier-exceptions", { params: byId(id), ...uncached(signal) }),
    ),
  verdict: async (id: string, signal?: AbortSignal): Promise<Verdict> => {
    const params = { ...byId(id), query: { format: "json" as const } };
    const { data } = await api.GET("/api/v1/jobs/{id}/verdict", { params, ...uncached(signal) });
    return data as Verdict;
  },
  verdictColumns: async (id: string, signal?: AbortSignal): Promise<VerdictColumns> => {
    const params = { ...byId(id), query: { format: "columns" as const } };
    const { data } = await api.GET("/api/v1/jobs/{id}/verdict", { params, ...binary(signal) });
    return verdictColumnsOf(data as ArrayBuffer);
  },
  toolpath: async (id: string, signal?: AbortSignal): Promise<Toolpath> => {
    const init = { params: byId(id), ...binary(signal) };
    return toolpathOf((await api.GET("/api/v1/jobs/{id}/toolpath", init)).data as ArrayBuffer);
  },
  /** Some lines of a program, counted from 1; without those after its last one. */
  programLines: async (
    id: string,
    first: number,
    count: number,
    signal: AbortSignal,
  ): Promise<string[]> => {
    const { data } = await api.GET("/api/v1/jobs/{id}/program", {
      params: { ...byId(id), query: { first_line: first, lines: count } },
      parseAs: "text",
      signal,
    });
    return (data ?? "").split("\n").slice(0, -1);
  },
  section: (id: string, edge: number, signal: AbortSignal): Promise<EdgeSection> =>
    dataOf(
      api.GET("/api/v1/jobs/{id}/section", {
        params: { ...byId(id), query: { edge } },
        ...uncached(signal),
      }),
    ),
  programUrl: (id: string) => `/api/v1/jobs/${encodeURIComponent(id)}/program`,
  ticketUrl: (id: string, language: string) =>
    `/api/v1/jobs/${encodeURIComponent(id)}/ticket.pdf?language=${language}`,
  pathExportUrl: (id: string, format: ExportFormat) =>
    `/api/v1/jobs/${encodeURIComponent(id)}/toolpath/export?format=${format}`,
};
