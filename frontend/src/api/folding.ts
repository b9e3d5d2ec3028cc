/** Requests about drawings that are folded in space. */

import type { components, paths } from "./openapi.gen";
import { api, byId, dataOf, uncached } from "./restApi";

type Schemas = components["schemas"];
export type Folding = Schemas["FoldingOut"];
export type FoldedPanel = Schemas["FoldedPanel"];
export type Fold = Schemas["FoldOut"];
export type FoldFinding = Schemas["FoldFindingOut"];
/** How a drawing is folded. */
export type FoldingWanted = paths["/api/v1/drawings/{id}/folding"]["get"]["parameters"]["query"];

export const foldingService = {
  folding: (id: string, wanted: FoldingWanted, signal?: AbortSignal): Promise<Folding> =>
    dataOf(
      api.GET("/api/v1/drawings/{id}/folding", {
        params: { ...byId(id), query: wanted },
        ...uncached(signal),
      }),
    ),
  /** The folded drawing as a binary glTF file. */
  file: async (id: string, wanted: FoldingWanted): Promise<Blob> =>
    (
      await api.GET("/api/v1/drawings/{id}/folding.glb", {
        params: { ...byId(id), query: wanted },
        parseAs: "blob",
      })
    ).data as unknown as Blob,
};
