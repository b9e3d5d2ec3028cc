/** Cartons of standard styles in the REST API. */

import type { Drawing } from "./drawings";
import type { components } from "./openapi.gen";
import { api, dataOf, uncached } from "./restApi";

export type CartonStyle = components["schemas"]["CartonStyleOut"];
type DrawnCarton = components["schemas"]["CartonDrawingIn"];
/** Dimensions and options by name. */
export type CartonFields = Readonly<Record<string, unknown>>;

const DIMENSIONS = ["length", "width", "depth"] as const;

/** Query of the picture of a carton; dimensions are parameters of their own. */
function pictureQuery(fields: CartonFields, board: string) {
  const sides = Object.fromEntries(
    DIMENSIONS.flatMap((name) => (fields[name] === undefined ? [] : [[name, fields[name]]])),
  );
  const options = Object.fromEntries(
    Object.entries(fields).filter(
      ([name, value]) => !DIMENSIONS.some((one) => one === name) && value !== undefined,
    ),
  );
  return { ...sides, board, options: JSON.stringify(options) };
}

export const cartonService = {
  styles: (signal?: AbortSignal): Promise<CartonStyle[]> =>
    dataOf(api.GET("/api/v1/cartons", uncached(signal))),

  /** The picture of a carton as SVG. */
  picture: (
    code: string,
    fields: CartonFields,
    board: string,
    signal?: AbortSignal,
  ): Promise<string> =>
    dataOf<string>(
      api.GET("/api/v1/cartons/{code}/picture", {
        params: { path: { code }, query: pictureQuery(fields, board) },
        parseAs: "text",
        ...uncached(signal),
      }),
    ),

  /** Store the drawing of a carton. */
  draw: (code: string, fields: CartonFields, board: string): Promise<Drawing> =>
    dataOf(
      api.POST("/api/v1/cartons", {
        body: { carton: { ...fields, code } as DrawnCarton["carton"], board } as DrawnCarton,
      }),
    ),
};
