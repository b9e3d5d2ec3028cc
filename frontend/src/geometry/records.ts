/**
 * The records that the service sends, as typed-array views of its columns.
 *
 * Coordinates are mm and stay float64 here; only the viewer makes them float32, about an origin.
 */

/** n lines and arcs, each with its own two ends. */
export interface Segments {
  /** (n, 2, 2) mm */
  readonly ends: Float64Array;
  /** (n,) tan(sweep / 4): 0 a line, > 0 an arc to the left */
  readonly bulge: Float64Array;
}

/** What is to be done along an edge: the index is the code in the column. */
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

/** The edges of a drawing, in drawing order. */
export interface Edges extends Segments {
  /** (n,) index into LINE_TYPES */
  readonly lineType: Uint8Array;
  /** (n,) index into `layers` */
  readonly layer: Int32Array;
  /** (n,) AutoCAD colour index */
  readonly colour: Int32Array;
  /** (n,) index into `rules` */
  readonly rule: Int32Array;
  /** (n,) index into `linetypes` */
  readonly linetype: Int32Array;
  /** (n,) 0 … 1 */
  readonly confidence: Float64Array;
  /** (n,) mm */
  readonly length: Float64Array;
  /** (n,) of the entity that the edge came from */
  readonly handles: readonly string[];
  readonly layers: readonly string[];
  readonly rules: readonly string[];
  readonly linetypes: readonly string[];
  /** What else an edge could be that a rule decided, by rule, the likeliest first. */
  readonly alternatives: readonly (readonly LineType[])[];
  /** (n,) index into FATES */
  readonly fate: Uint8Array;
  /** (n,) index into `reasons` */
  readonly reason: Int32Array;
  readonly reasons: readonly string[];
  /** Of the drawing, where the service told it. */
  readonly revision?: number;
}

/** What became of an edge when the drawing was cleaned: the index is the code in the column. */
export const FATES = ["kept", "merged", "dropped"] as const;
export type Fate = (typeof FATES)[number];

export const fateOf = (code: number | undefined): Fate => FATES[code ?? 0] ?? "kept";

/** Areas that no cutter gets to: q loops of lines and arcs. */
export interface Areas extends Segments {
  /** (q + 1,) where each loop begins, and the last one ends */
  readonly first: Int32Array;
  /** (q,) mm² */
  readonly size: Float64Array;
}

/** Where the work was found along the edges, and how far beside them. */
export interface Samples {
  /** (m,) row of the edge, ascending */
  readonly edge: Int32Array;
  /** (m,) share of its length, ascending on each edge */
  readonly place: Float64Array;
  /** (m,) mm to the left */
  readonly deviation: Float64Array;
}

/** What a verdict says along the lines. */
export interface VerdictColumns {
  readonly areas: Areas;
  readonly samples: Samples;
}

/** What a move is for: the index is the code in the column. */
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
  /** (n,) mm/min; degrees/min for a swivel; 0 for a rapid */
  readonly feed: Float64Array;
  /** (n,) row of the edge, -1 between edges */
  readonly source: Int32Array;
  /** (n,) station number */
  readonly tool: Uint8Array;
  /** (n,) last line of the program that the move became, 1-based; -1 where there is none */
  readonly line: Int32Array;
  /** Sheet coordinates = drawing coordinates + placement. */
  readonly placement: readonly [number, number];
}

export interface Point {
  readonly x: number;
  readonly y: number;
}

/** A head axis at X, Y with the tip at Z, turned to C degrees. */
export interface Pose extends Point {
  readonly z: number;
  readonly c: number;
}

/** x min, y min, x max, y max (mm) */
export type Box = readonly [number, number, number, number];
