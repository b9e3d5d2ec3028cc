/**
 * Lines for display: float32 segments relative to an origin, with colour, dash and time.
 *
 * The origin is the centre of the drawing, so that float32 is precise enough for a drawing far
 * from its zero point.
 */

import type { Point } from "../geometry/records";

/** Dash patterns; the index is passed to the shader. */
export const DASHES = ["solid", "dashed", "dotted", "long"] as const;
export type Dash = (typeof DASHES)[number];

/** Red, green, blue and opacity, 0 … 255. */
export type Rgba = readonly [number, number, number, number];

export interface Lines {
  readonly count: number;
  /** (m, 4) x0 y0 x1 y1, mm about the origin */
  readonly ends: Float32Array;
  /** (m, 4) */
  readonly colour: Uint8Array;
  /** (m,) mm along the edge before the segment, so that dashes continue across chords */
  readonly along: Float32Array;
  /** (m,) index into DASHES */
  readonly dash: Uint8Array;
  /** (m, 2) seconds at either end; NEVER for lines without time */
  readonly time: Float32Array;
  /** (m,) row of the edge or move */
  readonly row: Int32Array;
}

/** Later than the end of every program. */
export const NEVER = 3e38;

/** Growable buffers of segments. */
export class LineBuilder {
  private count = 0;
  private ends: Float32Array;
  private colour: Uint8Array;
  private along: Float32Array;
  private dash: Uint8Array;
  private time: Float32Array;
  private row: Int32Array;

  /** `capacity`: number of segments for which there is room before the buffers grow. */
  constructor(
    private readonly origin: Point,
    private capacity = 256,
  ) {
    this.ends = new Float32Array(capacity * 4);
    this.colour = new Uint8Array(capacity * 4);
    this.along = new Float32Array(capacity);
    this.dash = new Uint8Array(capacity);
    this.time = new Float32Array(capacity * 2);
    this.row = new Int32Array(capacity);
  }

  add(
    x0: number,
    y0: number,
    x1: number,
    y1: number,
    colour: Rgba,
    { along = 0, dash = 0, from = NEVER, to = NEVER, row = -1 } = {},
  ): void {
    if (this.count === this.capacity) this.grow();
    const at = this.count++;
    const { ends, colour: colours } = this;
    const { x, y } = this.origin;
    const first = at * 4;
    // One by one: a typed array's `set` takes many times as long for four values.
    ends[first] = x0 - x;
    ends[first + 1] = y0 - y;
    ends[first + 2] = x1 - x;
    ends[first + 3] = y1 - y;
    colours[first] = colour[0];
    colours[first + 1] = colour[1];
    colours[first + 2] = colour[2];
    colours[first + 3] = colour[3];
    this.along[at] = along;
    this.dash[at] = dash;
    this.time[at * 2] = from;
    this.time[at * 2 + 1] = to;
    this.row[at] = row;
  }

  /** The lines; nothing can be added later, because full buffers are not copied. */
  build(): Lines {
    const { count } = this;
    const used = <T extends Float32Array | Uint8Array | Int32Array>(all: T, each: number): T =>
      all.length === count * each ? all : (all.slice(0, count * each) as T);
    return {
      count,
      ends: used(this.ends, 4),
      colour: used(this.colour, 4),
      along: used(this.along, 1),
      dash: used(this.dash, 1),
      time: used(this.time, 2),
      row: used(this.row, 1),
    };
  }

  private grow(): void {
    this.capacity = Math.max(256, this.capacity * 2);
    const larger = <T extends Float32Array | Uint8Array | Int32Array>(old: T, next: T): T => {
      next.set(old);
      return next;
    };
    this.ends = larger(this.ends, new Float32Array(this.capacity * 4));
    this.colour = larger(this.colour, new Uint8Array(this.capacity * 4));
    this.along = larger(this.along, new Float32Array(this.capacity));
    this.dash = larger(this.dash, new Uint8Array(this.capacity));
    this.time = larger(this.time, new Float32Array(this.capacity * 2));
    this.row = larger(this.row, new Int32Array(this.capacity));
  }
}

/** "#rrggbb" as bytes. */
export function rgba(hex: string, opacity = 1): Rgba {
  const value = Number.parseInt(hex.slice(1), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255, Math.round(opacity * 255)];
}
