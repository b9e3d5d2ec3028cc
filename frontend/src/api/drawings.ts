/** Requests about drawings, their edges and what is learned from them. */

import type { DrawnEdges, Edges } from "../geometry/records";
import { drawnEdgesOf, edgesOf } from "./columns";
import type { ProfileDraft } from "./library";
import type { components } from "./openapi.gen";
import { api, binary, byId, dataOf, ifMatch, revisionOf, uncached } from "./restApi";
import { upload } from "./transport";

type Schemas = components["schemas"];
export type Drawing = Schemas["DrawingOut"];
export type DrawingSummary = Schemas["DrawingSummary"];
export type Format = Schemas["FormatOut"];
export type ImportReportRow = Schemas["ImportReportRow"];
export type Override = Schemas["Override"];
/** A change of the geometry of a drawing. */
export type Edit = NonNullable<Schemas["DrawingPatch"]["edits"]>[number];
export type PageOfFile = Schemas["PageOut"];
export type Preview = Schemas["PreviewOut"];
export type Proposal = Schemas["ProposalOut"];
export type ReportGroup = Schemas["ReportGroup"];
export type Retyped = Schemas["ChangeOut"];
export type Rule = Schemas["RuleOut"];
export type Question = Schemas["QuestionOut"];
export type FollowingEdges = Schemas["FollowingEdgesOut"];
export type LearnedLook = Drawing["learned"][number];
export type TaughtLook = Schemas["TaughtLookOut"];
export type LookUse = Schemas["LookPatch"];
export type Unit = NonNullable<Drawing["unit"]>;

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

/** Formats of exported files. */
export const EXPORT_FORMATS = ["pdf", "svg", "dxf", "png"] as const;

export type ExportFormat = (typeof EXPORT_FORMATS)[number];

export const drawingService = {
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
  deleteDrawing: async (id: string): Promise<void> => {
    await api.DELETE("/api/v1/drawings/{id}", { params: byId(id) });
  },
  /** Address of the picture of a drawing. */
  pictureUrl: (id: string): string => `/api/v1/drawings/${encodeURIComponent(id)}/picture`,
  drawingExportUrl: (id: string, format: ExportFormat) =>
    `/api/v1/drawings/${encodeURIComponent(id)}/export?format=${format}`,
  formats: (signal?: AbortSignal): Promise<Format[]> =>
    dataOf(api.GET("/api/v1/formats", uncached(signal))),
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
