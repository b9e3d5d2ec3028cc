/**
 * Records sent by the server, as typed-array views of their columns.
 *
 * Coordinates are float64 mm; only the viewer converts them to float32, relative to an origin.
 */

import type { Similarity } from "./similarity";

/** n lines and arcs. */
export interface Segments {
  /** (n, 2, 2) mm */
  readonly ends: Float64Array;
  /** (n,) tan(sweep / 4): 0 a line, > 0 an arc to the left */
  readonly bulge: Float64Array;
}

/** Line types; the index is the code in the column. */
export const LINE_TYPES = [
  "unclassified",
  "cut",
  "crease",
  "v-groove",
  "perforation",
  "half-cut",
  "ignored",
  "combi",
] as const;
export type LineType = (typeof LINE_TYPES)[number];

export const lineTypeOf = (code: number | undefined): LineType =>
  LINE_TYPES[code ?? 0] ?? "unclassified";

/** The columns of edges that are drawn. For large drawings they arrive before the others. */
export interface DrawnEdges extends Segments {
  /** (n,) index into LINE_TYPES */
  readonly lineType: Uint8Array;
  /** (n,) index into OUTCOMES */
  readonly outcome: Uint8Array;
}

/** The edges of a drawing, in drawing order. */
export interface Edges extends DrawnEdges {
  /** (n,) index into `layers` */
  readonly layer: Int32Array;
  /** (n,) AutoCAD colour index */
  readonly colour: Int32Array;
  /** (n,) index into `rules` */
  readonly rule: Int32Array;
  /** (n,) index into `linetypes` */
  readonly linetype: Int32Array;
  /** (n,) width with which the file draws the edge (1/100 mm), −1 if it states none */
  readonly lineWidth: Int32Array;
  /** (n,) confidence in the line type, 0 … 1 */
  readonly confidence: Float64Array;
  /** (n,) mm */
  readonly length: Float64Array;
  /** (n,) handle of the entity that the edge came from */
  readonly handles: readonly string[];
  readonly layers: readonly string[];
  readonly rules: readonly string[];
  /** Message codes of `rules`. */
  readonly ruleCodes: readonly string[];
  readonly linetypes: readonly string[];
  /** Other possible line types by rule, most likely first. */
  readonly alternatives: readonly (readonly LineType[])[];
  /** (n,) index into `reasons` */
  readonly reason: Int32Array;
  readonly reasons: readonly string[];
  /** Revision of the drawing, if known. */
  readonly revision?: number;
}

export const isComplete = (edges: DrawnEdges | Edges): edges is Edges => "layer" in edges;

/** Import outcomes; the index is the code in the column. */
export const OUTCOMES = ["kept", "merged", "dropped"] as const;
export type ImportOutcome = (typeof OUTCOMES)[number];

export const outcomeOf = (code: number | undefined): ImportOutcome => OUTCOMES[code ?? 0] ?? "kept";

/** Areas that no tool reaches: q loops of lines and arcs. */
export interface Areas extends Segments {
  /** (q + 1,) row offsets of the loops */
  readonly first: Int32Array;
  /** (q,) mm² */
  readonly size: Float64Array;
}

/** Deviations measured at points along the edges. */
export interface Samples {
  /** (m,) row of the edge, ascending */
  readonly edge: Int32Array;
  /** (m,) position as a fraction of the edge's length, ascending on each edge */
  readonly place: Float64Array;
  /** (m,) deviation to the left of the edge (mm) */
  readonly deviation: Float64Array;
}

/** Columns of a verdict. */
export interface VerdictColumns {
  readonly areas: Areas;
  readonly samples: Samples;
}

/** Kinds of moves; the index is the code in the column. */
export const MOTIONS = [
  "rapid",
  "plunge",
  "lead-in",
  "feed",
  "swivel",
  "lead-out",
  "lift",
] as const;
export type Motion = (typeof MOTIONS)[number];

/** n moves between n + 1 poses of the head, in sheet coordinates. */
export interface Toolpath {
  /** (n + 1, 4) x y z in mm, c in degrees */
  readonly pose: Float64Array;
  /** (n,) */
  readonly bulge: Float64Array;
  /** (n,) index into MOTIONS */
  readonly motion: Uint8Array;
  /** (n,) mm/min; degrees/min for a swivel; 0 for an air move */
  readonly feed: Float64Array;
  /** (n,) row of the edge that the move makes; -1 between edges */
  readonly source: Int32Array;
  /** (n,) station number */
  readonly tool: Uint8Array;
  /** (n,) last program line of the move, counted from 1; -1 if it has none */
  readonly line: Int32Array;
  /** (n,) first program line of the move; jobs of older versions have none */
  readonly firstLine?: Int32Array;
  /** (n,) machine time of the move (s); jobs of older versions have none */
  readonly seconds?: Float64Array;
  /**
   * How a printed sheet lies by its marks; null if it has none. The poses are then those on the
   * drawing, as if the sheet were neither turned nor scaled; placement is 0.
   */
  readonly similarity?: Similarity | null;
  /** Sheet coordinates = drawing coordinates + placement. */
  readonly placement: readonly [number, number];
}

export interface Point {
  readonly x: number;
  readonly y: number;
}

/** Position of the head: its axis at X, Y, the tip at Z, C in degrees. */
export interface Pose extends Point {
  readonly z: number;
  readonly c: number;
}

/** x min, y min, x max, y max (mm) */
export type Box = readonly [number, number, number, number];
