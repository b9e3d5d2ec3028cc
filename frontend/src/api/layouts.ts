/** Requests about layouts, the shapes of drawings on them, and nestings. */

import type { components } from "./openapi.gen";
import { api, byId, dataOf, uncached } from "./restApi";

type Schemas = components["schemas"];
/** A sheet with placed drawings, and what the server finds wrong with it. */
export type Layout = Schemas["LayoutOut"];
export type LayoutSheet = Required<Schemas["LayoutSheet"]>;
/** A drawing on a sheet: one copy, or rows and columns of copies. */
export type Placed = Required<Schemas["PlacedDrawing"]>;
export type Blanks = Schemas["BlanksOut"];
/** A search for the places of drawings, with the best arrangement so far. */
export type Nesting = Schemas["NestingOut"];
export type NewNesting = Schemas["NestingIn"];

/** Sheets in stock of one board and one size. */
export type StockSheet = Schemas["StockSheetOut"];

export interface LayoutBody {
  readonly sheet: Schemas["LayoutSheet"];
  readonly placed: readonly Placed[];
}

const bodyOf = ({ sheet, placed }: LayoutBody) => ({ sheet, placed: [...placed] });

export const layoutService = {
  get: (id: string, signal?: AbortSignal): Promise<Layout> =>
    dataOf(api.GET("/api/v1/layouts/{id}", { params: byId(id), ...uncached(signal) })),
  add: (name: string, body: LayoutBody): Promise<Layout> =>
    dataOf(api.POST("/api/v1/layouts", { body: { name, ...bodyOf(body) } as Schemas["LayoutIn"] })),
  /** Replace a revision of a layout; the server refuses it if there is a later one. */
  replace: (id: string, revision: number, body: LayoutBody): Promise<Layout> =>
    dataOf(
      api.PUT("/api/v1/layouts/{id}", {
        params: { ...byId(id), header: { "If-Match": `"${revision}"` } },
        body: bodyOf(body),
      }),
    ),
  blanks: (drawing: string, signal?: AbortSignal): Promise<Blanks> =>
    dataOf(
      api.GET("/api/v1/drawings/{id}/blanks", { params: byId(drawing), signal: signal ?? null }),
    ),
  beginNesting: (nesting: NewNesting): Promise<Nesting> =>
    dataOf(api.POST("/api/v1/nestings", { body: nesting })),
  nesting: (id: string, signal?: AbortSignal): Promise<Nesting> =>
    dataOf(api.GET("/api/v1/nestings/{id}", { params: byId(id), ...uncached(signal) })),
  stopNesting: (id: string): Promise<Nesting> =>
    dataOf(api.POST("/api/v1/nestings/{id}/stop", { params: byId(id) })),
  stock: (board: string, signal?: AbortSignal): Promise<StockSheet[]> =>
    dataOf(
      api.GET("/api/v1/stock-sheets", {
        params: { query: { board, limit: 1000 } },
        ...uncached(signal),
      }),
    ),
  addToStock: (sheets: Schemas["StockSheetIn"]): Promise<StockSheet> =>
    dataOf(api.POST("/api/v1/stock-sheets", { body: sheets })),
  /** Take one sheet out of the stock. */
  removeFromStock: async ({ id, count }: StockSheet): Promise<void> => {
    if (count != null && count > 1)
      await dataOf(
        api.PATCH("/api/v1/stock-sheets/{id}", { params: byId(id), body: { count: count - 1 } }),
      );
    else await dataOf(api.DELETE("/api/v1/stock-sheets/{id}", { params: byId(id) }));
  },
};
