/**
 * The REST API as functions, except those for webhooks and accounts.
 */

import type { DrawnEdges, Edges, Toolpath, VerdictColumns } from "../geometry/records";
import { drawnEdgesOf, edgesOf, toolpathOf, verdictColumnsOf } from "./columns";
import type { components, paths } from "./openapi.gen";
import { operatorName } from "./operator";
import type { EDGE_OPTIONS, OPTIONS } from "./options.gen";
import { api, byId, dataOf, type Page, pageOf, revalidated, uncached } from "./restApi";
import { fetchOnce, upload } from "./transport";

export { type Problem, pageProblem, ServiceError } from "./errors";

type Schemas = components["schemas"];
type StationPaths = paths["/api/v1/machines/{name}/station"];
export type Board = Schemas["BoardOut"];
export type Calibration = Schemas["CalibrationOut"];
/** Points measured on a test cut. */
export type CalibrationOrder = Schemas["CalibrationIn"];
export type CornerAt = Schemas["CornerAt"];
export type Corners = Schemas["Corners"];
export type Definition = Schemas["DefinitionOut"];
/** What the operator checks at the machine before a job or its next copy starts. */
export type Confirmation = Schemas["ConfirmationOut"];
/** What the operator has checked, as it is sent with the confirmation. */
export type CheckedTable = Omit<Schemas["ConfirmIn"], "by">;
export type Drawing = Schemas["DrawingOut"];
export type DrawingSummary = Schemas["DrawingSummary"];
export type Format = Schemas["FormatOut"];
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
export type ImportReportRow = Schemas["ImportReportRow"];
export type LibraryEntry = Schemas["EntryOut"];
export type LibraryVersion = Schemas["VersionOut"];
export type Lift = Job["lift"];
/** Marks of a printed sheet. */
export type Registration = NonNullable<Job["registration"]>;
/** Measured marks of a printed sheet, with their fit. */
export type MarkFit = Schemas["RegistrationOut"];
export type MeasuredMarks = Omit<Schemas["MeasuredMarksIn"], "by">;
export type Machine = Schemas["MachineOut"];
/** State of a machine for the person at it. */
export type Station = StationPaths["get"]["responses"]["200"]["content"]["application/json"];
export type Operation = Schemas["OperationOut"];
/** What a machine does above the board for a person, while a job waits. */
export type Activity = Schemas["ActivityOut"];
/** What a person at a machine requests between two jobs. */
export type OperationRequest = Omit<Schemas["OperationIn"], "hands_clear">;
export type Override = Schemas["Override"];
/** A change of the geometry of a drawing. */
export type Edit = NonNullable<Schemas["DrawingPatch"]["edits"]>[number];
export type PageOfFile = Schemas["PageOut"];
export type Profile = Schemas["ProfileOut"];
export type ProfileDraft = Schemas["ProfileIn"];
export type Preview = Schemas["PreviewOut"];
export type Proposal = Schemas["ProposalOut"];
export type ReportGroup = Schemas["ReportGroup"];
export type RestChoice = Schemas["RestIn"];
export type Retyped = Schemas["ChangeOut"];
export type Rule = Schemas["RuleOut"];
export type Queue = Schemas["QueueOut"];
export type QueueEntry = Schemas["QueueEntry"];
export type Question = Schemas["QuestionOut"];
export type FollowingEdges = Schemas["FollowingEdgesOut"];
export type LearnedLook = Drawing["learned"][number];
export type TaughtLook = Schemas["TaughtLookOut"];
export type LookUse = Schemas["LookPatch"];
export type Sheet = Schemas["Sheet"];
export type Shelf = Schemas["Shelf"];
export type ServiceStatus = Schemas["ServiceOut"];
export type Statistics = Schemas["StatisticsOut"];
export type ToolUse = Schemas["ToolUseOut"];
export type Track = Schemas["TrackOut"];
export type Unit = NonNullable<Drawing["unit"]>;
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

/** Time (s) after which a request of a person at a machine is given up: it must not arrive late. */
const PATIENCE = 3;
/** Time (s) after which a machine's state counts as not answered. */
const SILENCE = 2;

/** Options of a request that must arrive now or never. */
const nowOrNever = () => ({ fetch: fetchOnce, signal: AbortSignal.timeout(PATIENCE * 1000) });

const binary = (signal?: AbortSignal) =>
  ({ parseAs: "arrayBuffer", signal: signal ?? null }) as const;

const byName = (name: string) => ({ path: { name } });

/** Header that applies a change to this revision only. */
const ifMatch = (revision: number | null) => ({
  header: revision === null ? {} : { "If-Match": `"${revision}"` },
});

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

/** The revision in an ETag; null if there is none. */
export function revisionOf(etag: string | null): number | null {
  const [, digits] = /^(?:W\/)?"(\d+)/.exec(etag ?? "") ?? [];
  return digits === undefined ? null : Number.parseInt(digits, 10);
}

/** The edges, with the revision of their drawing. */
async function fetchEdges<T extends DrawnEdges>(
  id: string,
  format: "columns" | "drawn",
  decode: (bytes: ArrayBuffer) => T,
  signal?: AbortSignal,
): Promise<T> {
  const { data, response } = await api.GET("/api/v1/drawings/{id}/edges", {
    params: { ...byId(id), query: { format } },
    ...binary(signal),
  });
  const edges = decode(data as ArrayBuffer);
  const revision = revisionOf(response.headers.get("ETag"));
  return revision === null ? edges : { ...edges, revision };
}

/** Save a profile as TOML text or as data; `version` is the one that was edited. */
const putProfile = (
  name: string,
  body: string | ProfileDraft,
  version: number | null,
): Promise<Profile> =>
  dataOf(
    api.PUT("/api/v1/profiles/{name}", {
      params: { ...byName(name), ...ifMatch(version) },
      body,
      bodySerializer: (profile) =>
        typeof profile === "string" ? profile : JSON.stringify(profile),
      headers: {
        "Content-Type": typeof body === "string" ? "application/toml" : "application/json",
      },
    }),
  );

/** Save a machine, board or tool as TOML text or as data; `version` is the one that was edited. */
const putDefinition = (
  { shelf, name }: Pick<LibraryEntry, "shelf" | "name">,
  body: string | Record<string, unknown>,
  { version, note }: { version: number | null; note: string },
): Promise<Definition> =>
  dataOf(
    api.PUT(`/api/v1/${shelf}/{name}`, {
      params: { ...byName(name), ...ifMatch(version), query: { by: operatorName(), note } },
      body: typeof body === "string" ? body : JSON.stringify(body),
      bodySerializer: String,
      headers: {
        "Content-Type": typeof body === "string" ? "application/toml" : "application/json",
      },
    }),
  );

/** Formats of exported files. */
export const EXPORT_FORMATS = ["pdf", "svg", "dxf", "png"] as const;
export type ExportFormat = (typeof EXPORT_FORMATS)[number];

export const service = {
  drawing: (id: string, signal?: AbortSignal): Promise<Drawing> =>
    dataOf(api.GET("/api/v1/drawings/{id}", { params: byId(id), ...uncached(signal) })),
  edges: (id: string, signal?: AbortSignal): Promise<Edges> =>
    fetchEdges(id, "columns", edgesOf, signal),
  /** The edges; of many, only what a picture needs. */
  drawnEdges: (id: string, signal?: AbortSignal): Promise<DrawnEdges | Edges> =>
    fetchEdges(id, "drawn", drawnEdgesOf, signal),
  importReport: (
    id: string,
    outcome: ImportReportRow["outcome"],
    signal?: AbortSignal,
  ): Promise<Schemas["ImportReportOut"]> =>
    dataOf(
      api.GET("/api/v1/drawings/{id}/import-report", {
        params: { ...byId(id), query: { outcome } },
        ...uncached(signal),
      }),
    ),
  pages: (id: string, signal?: AbortSignal): Promise<PageOfFile[]> =>
    dataOf(api.GET("/api/v1/drawings/{id}/pages", { params: byId(id), ...uncached(signal) })),
  choosePage: (id: string, page: number): Promise<Drawing> =>
    dataOf(api.POST("/api/v1/drawings/{id}/pages/{page}", { params: { path: { id, page } } })),
  upload: async (file: File, onProgress: (fraction: number) => void): Promise<Drawing> =>
    JSON.parse(await upload(file, onProgress)) as Drawing,
  patchDrawing: (
    id: string,
    {
      rules = "",
      ...change
    }: {
      unit?: Unit | "file";
      profile?: string;
      rules?: string;
      shared?: boolean;
      customer?: string;
      edits?: Edit[];
    },
    revision: number | null,
  ): Promise<Drawing> =>
    dataOf(
      api.PATCH("/api/v1/drawings/{id}", {
        params: { ...byId(id), ...ifMatch(revision) },
        body: { ...change, rules },
      }),
    ),
  override: (id: string, overrides: Override[], revision: number | null): Promise<Drawing> =>
    dataOf(
      api.PATCH("/api/v1/drawings/{id}/edges", {
        params: { ...byId(id), ...ifMatch(revision) },
        body: { overrides },
      }),
    ),

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
  deleteDrawing: async (id: string): Promise<void> => {
    await api.DELETE("/api/v1/drawings/{id}", { params: byId(id) });
  },
  /** Address of the picture of a drawing. */
  pictureUrl: (id: string): string => `/api/v1/drawings/${encodeURIComponent(id)}/picture`,
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
  queue: async (machine: string, signal?: AbortSignal): Promise<Queue & { tag: string | null }> => {
    const { data, response } = await api.GET("/api/v1/machines/{name}/queue", {
      params: byName(machine),
      ...uncached(signal),
    });
    return { ...(data as Queue), tag: response.headers.get("ETag") };
  },
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
  statistics: (
    { machine, step, since }: { machine: string; step: "day" | "week" | "month"; since: number },
    signal?: AbortSignal,
  ): Promise<Statistics[]> => {
    const zone = Intl.DateTimeFormat().resolvedOptions().timeZone;
    const query = { machine, step, since: new Date(since * 1000).toISOString(), zone };
    return dataOf(api.GET("/api/v1/statistics", { params: { query }, ...uncached(signal) }));
  },
  tools: (machine: string, signal?: AbortSignal): Promise<ToolUse[]> =>
    dataOf(
      api.GET("/api/v1/machines/{name}/tools", { params: byName(machine), ...uncached(signal) }),
    ),
  recordToolChange: (machine: string, station: number): Promise<ToolUse[]> =>
    dataOf(
      api.POST("/api/v1/machines/{name}/tools/{station}/changed", {
        params: { path: { name: machine, station } },
        body: { by: operatorName() },
      }),
    ),
  setToolLife: (machine: string, station: number, life: number): Promise<ToolUse[]> =>
    dataOf(
      api.PUT("/api/v1/machines/{name}/tools/{station}/life", {
        params: { path: { name: machine, station } },
        body: { life, by: operatorName() },
      }),
    ),
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
  drawingExportUrl: (id: string, format: ExportFormat) =>
    `/api/v1/drawings/${encodeURIComponent(id)}/export?format=${format}`,

  status: (signal?: AbortSignal): Promise<ServiceStatus> =>
    dataOf(api.GET("/api/v1/service", uncached(signal))),
  machines: (signal?: AbortSignal): Promise<Machine[]> =>
    dataOf(api.GET("/api/v1/machines", revalidated(signal))),
  station: (name: string, signal: AbortSignal): Promise<Station> =>
    dataOf(
      api.GET("/api/v1/machines/{name}/station", {
        params: byName(name),
        cache: "no-store",
        fetch: fetchOnce,
        signal: AbortSignal.any([signal, AbortSignal.timeout(SILENCE * 1000)]),
      }),
    ),
  operate: (name: string, request: OperationRequest): Promise<Operation> =>
    dataOf(
      api.POST("/api/v1/machines/{name}/operations", {
        params: byName(name),
        body: { hands_clear: false, ...request },
        ...nowOrNever(),
      }),
    ),
  stateHandsClear: (name: string): Promise<Schemas["HandsClearOut"]> =>
    dataOf(
      api.POST("/api/v1/machines/{name}/hands-clear", { params: byName(name), ...nowOrNever() }),
    ),
  withdrawHandsClear: async (name: string): Promise<void> => {
    await api.DELETE("/api/v1/machines/{name}/hands-clear", {
      params: byName(name),
      ...nowOrNever(),
    });
  },
  renewJog: (name: string, id: string): Promise<Operation> =>
    dataOf(
      api.POST("/api/v1/machines/{name}/operations/{id}/renew", {
        params: { path: { name, id } },
        ...nowOrNever(),
      }),
    ),
  operation: (name: string, id: string): Promise<Operation> =>
    dataOf(
      api.GET("/api/v1/machines/{name}/operations/{id}", {
        params: { path: { name, id } },
        cache: "no-store",
        ...nowOrNever(),
      }),
    ),
  formats: (signal?: AbortSignal): Promise<Format[]> =>
    dataOf(api.GET("/api/v1/formats", uncached(signal))),
  boards: (signal?: AbortSignal): Promise<Board[]> =>
    dataOf(api.GET("/api/v1/boards", uncached(signal))),
  /** Compute the deflection of a cutter from a measured test cut; nothing is stored. */
  calibrate: (board: string, order: CalibrationOrder): Promise<Calibration> =>
    dataOf(api.POST("/api/v1/boards/{name}/deflection", { params: byName(board), body: order })),
  library: (signal?: AbortSignal): Promise<LibraryEntry[]> =>
    dataOf(api.GET("/api/v1/library", uncached(signal))),
  librarySchema: (kind: Shelf, signal?: AbortSignal): Promise<Record<string, unknown>> =>
    dataOf(api.GET("/api/v1/schemas/{kind}", { params: { path: { kind } }, ...uncached(signal) })),
  definition: (
    shelf: Shelf,
    name: string,
    version: number | null = null,
    signal?: AbortSignal,
  ): Promise<Definition> =>
    dataOf(
      api.GET(`/api/v1/${shelf}/{name}/definition`, {
        params: { ...byName(name), query: { version } },
        ...uncached(signal),
      }),
    ),
  definitionVersions: (
    shelf: Shelf,
    name: string,
    signal?: AbortSignal,
  ): Promise<LibraryVersion[]> =>
    dataOf(
      api.GET(`/api/v1/${shelf}/{name}/versions`, { params: byName(name), ...uncached(signal) }),
    ),
  definitionUrl: (shelf: Shelf, name: string) =>
    `/api/v1/${shelf}/${encodeURIComponent(name)}/toml`,
  putDefinition,
  deleteDefinition: async (shelf: Shelf, name: string, version: number): Promise<void> => {
    await api.DELETE(`/api/v1/${shelf}/{name}`, {
      params: { ...byName(name), ...ifMatch(version) },
    });
  },
  profiles: (signal?: AbortSignal): Promise<Profile[]> =>
    dataOf(api.GET("/api/v1/profiles", uncached(signal))),
  profile: (name: string, signal?: AbortSignal): Promise<Profile> =>
    dataOf(api.GET("/api/v1/profiles/{name}", { params: byName(name), ...uncached(signal) })),
  profileText: (name: string): Promise<string> =>
    dataOf(api.GET("/api/v1/profiles/{name}.toml", { params: byName(name), parseAs: "text" })),
  profileUrl: (name: string) => `/api/v1/profiles/${encodeURIComponent(name)}.toml`,
  putProfile,
  deleteProfile: async (name: string, version: number): Promise<void> => {
    await api.DELETE("/api/v1/profiles/{name}", {
      params: { ...byName(name), ...ifMatch(version) },
    });
  },
  preview: (id: string, profile: ProfileDraft): Promise<Preview> =>
    dataOf(api.POST("/api/v1/drawings/{id}/preview", { params: byId(id), body: profile })),
  /** What other drawings of the customer of a drawing teach. */
  customerAnswers: (id: string, signal?: AbortSignal): Promise<TaughtLook[]> =>
    dataOf(
      api.GET("/api/v1/drawings/{id}/customer-answers", {
        params: byId(id),
        signal: signal ?? null,
      }),
    ),
  setCustomerAnswer: (id: string, look: LookUse, revision: number | null): Promise<Drawing> =>
    dataOf(
      api.PATCH("/api/v1/drawings/{id}/customer-answers", {
        params: { ...byId(id), ...ifMatch(revision) },
        body: look,
      }),
    ),
  learned: (id: string, signal?: AbortSignal): Promise<Proposal[]> =>
    dataOf(api.POST("/api/v1/drawings/{id}/learned", { params: byId(id), signal: signal ?? null })),
};
