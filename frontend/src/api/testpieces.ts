/** Test pieces in the REST API: pieces that are cut and measured, and what follows. */

import type { components } from "./openapi.gen";
import { api, dataOf, uncached } from "./restApi";

export type TestPiece = components["schemas"]["WizardOut"];
export type Figure = components["schemas"]["FigureOut"];
type FiguresIn = components["schemas"]["FiguresIn"];
type PieceOut = components["schemas"]["PieceOut"];

/** The machine, the station and the board that are measured. */
export interface Bench {
  readonly machine: string;
  readonly station: number;
  readonly board: string;
}

/** What was measured, by the names of the fields; what was not measured is missing. */
export type Measures = Readonly<Record<string, number>>;

export const testPieceService = {
  list: (signal?: AbortSignal): Promise<TestPiece[]> =>
    dataOf(api.GET("/api/v1/testpieces", uncached(signal))),

  /** The picture of a piece as SVG, with what is measured. */
  picture: (code: string, bench: Bench, signal?: AbortSignal): Promise<string> =>
    dataOf<string>(
      api.GET("/api/v1/testpieces/{code}/picture", {
        params: { path: { code }, query: { ...bench } },
        parseAs: "text",
        ...uncached(signal),
      }),
    ),

  /** Store the drawing of a piece. */
  draw: (code: string, bench: Bench): Promise<PieceOut> =>
    dataOf(api.POST("/api/v1/testpieces", { body: { code, ...bench } })),

  figures: (code: string, bench: Bench, measures: Measures): Promise<Figure[]> =>
    dataOf(
      api.POST("/api/v1/testpieces/figures", {
        body: { ...bench, measures: { ...measures, code } as unknown as FiguresIn["measures"] },
      }),
    ),
};
