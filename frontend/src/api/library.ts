/** Requests about the library: machines, boards, tools and classification profiles as files. */

import type { components } from "./openapi.gen";
import { operatorName } from "./operator";
import { api, byName, dataOf, ifMatch, uncached } from "./restApi";

type Schemas = components["schemas"];
export type Board = Schemas["BoardOut"];
export type Calibration = Schemas["CalibrationOut"];
/** Points measured on a test cut. */
export type CalibrationOrder = Schemas["CalibrationIn"];
export type Definition = Schemas["DefinitionOut"];
export type LibraryEntry = Schemas["EntryOut"];
export type LibraryVersion = Schemas["VersionOut"];
export type Profile = Schemas["ProfileOut"];
export type ProfileDraft = Schemas["ProfileIn"];
export type Shelf = Schemas["Shelf"];

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

export const libraryService = {
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
};
