/** What the picture is given to draw with, and what it tells of the user. */

import type { Point } from "../geometry/records";
import type { Palette } from "../scene/dieline";
import type { Rgba } from "../scene/lines";
import type { Marked } from "../scene/marks";
import type { SweptColours } from "../scene/swept";
import type { TravelColours } from "../scene/travel";

export interface ViewerColours extends TravelColours {
  readonly palette: Palette;
  readonly swept: SweptColours;
  readonly marks: Readonly<Record<Marked, Rgba>>;
  readonly backdrop: string;
  readonly table: string;
  /** What a line that steps back comes near to. */
  readonly ground: Rgba;
  readonly tableEdge: Rgba;
  readonly gridMinor: Rgba;
  readonly gridMajor: Rgba;
  readonly axisX: Rgba;
  readonly axisY: Rgba;
  readonly hover: Rgba;
  readonly chosen: Rgba;
  readonly done: Rgba;
  readonly mark: Rgba;
  readonly blade: Rgba;
  readonly uncut: Rgba;
  readonly uncutRim: Rgba;
  /** Of the ring about a corner that was chosen. */
  readonly corner: Rgba;
  /** Of the mark about a place that is meant. */
  readonly pin: Rgba;
}

export interface ViewerEvents {
  /** An edge, and the moves of the head that are there: both may be none. */
  onHover(row: number | null, moves: readonly number[], at: Point): void;
  /** Edges, and where in the drawing it was clicked; nowhere for a box. */
  onChoose(rows: readonly number[], add: boolean, at: Point | null): void;
  onCursor(at: Point | null): void;
  onView(pixelsPerMm: number): void;
  onBox(box: { from: Point; to: Point } | null): void;
}

/** Which of it all is drawn. */
export interface Shown {
  readonly nominal: boolean;
  readonly head: boolean;
  readonly tip: boolean;
  readonly rapids: boolean;
  readonly swept: boolean;
  readonly moves: boolean;
  readonly uncut: boolean;
}
