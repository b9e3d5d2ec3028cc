/** Interface of the viewer: colours, events and visible layers. */

import type { Point } from "../geometry/records";
import type { SelectMode } from "../geometry/selection";
import type { Palette } from "../scene/dieline";
import type { Rgba } from "../scene/lines";
import type { Marked } from "../scene/marks";
import type { PathColours } from "../scene/pathLines";
import type { SweptColours } from "../scene/swept";

export interface ViewerColours extends PathColours {
  readonly palette: Palette;
  readonly swept: SweptColours;
  readonly marks: Readonly<Record<Marked, Rgba>>;
  readonly backdrop: string;
  readonly table: string;
  /** Colour towards which faint lines are mixed. */
  readonly ground: Rgba;
  readonly tableEdge: Rgba;
  /** Colour of the edge of a sheet that was cut to size. */
  readonly sheetEdge: Rgba;
  /** Colour of keep-out zones. */
  readonly zone: Rgba;
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
  /** Colour of the ring around a corner with a type of its own. */
  readonly corner: Rgba;
  /** Colour of a pin. */
  readonly pin: Rgba;
}

export interface ViewerEvents {
  /** Edge and moves under the cursor; both may be empty. */
  onHover(row: number | null, moves: readonly number[], at: Point): void;
  /** Edges selected by a click at `at`, or by an area (`at` null). */
  onSelect(rows: readonly number[], mode: SelectMode, at: Point | null): void;
  onCursor(at: Point | null): void;
  onView(pixelsPerMm: number): void;
  /** Corners of the area that is being drawn (pixels); null when it is finished. */
  onArea(corners: readonly Point[] | null): void;
}

/** Which layers are visible. */
export interface VisibleLayers {
  readonly nominal: boolean;
  readonly head: boolean;
  readonly tip: boolean;
  readonly rapids: boolean;
  readonly swept: boolean;
  readonly moves: boolean;
  readonly uncut: boolean;
}
