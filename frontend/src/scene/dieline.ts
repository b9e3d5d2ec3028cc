/** Edges → lines coloured by what is to be done along them. */

import { length, partialBulge, pointAt, walk } from "../geometry/arc";
import {
  type Edges,
  type LineType,
  lineTypeOf,
  type Point,
  type Segments,
} from "../geometry/records";
import { mm } from "../geometry/units";
import { DASHES, type Dash, LineBuilder, type Lines, type Rgba } from "./lines";

/** Chords keep this near to their arcs: what a knife is held to. */
export const CHORD_TOLERANCE = mm(0.01);

/** How each line type looks. */
export type Palette = Readonly<Record<LineType, { colour: Rgba; dash: Dash }>>;

/** What is not worked is this much fainter. */
const LEFT = 0.3;

/** What is not made at all. */
const GHOST: Rgba = [139, 151, 166, 130];

/** Colours along the edges: the stretches of edge i begin at first[i] and end before first[i + 1]. */
export interface EdgeStretches {
  /** (n + 1,) */
  readonly first: Int32Array;
  /** (m,) where each stretch begins, as a share of the edge's length */
  readonly place: Float64Array;
  /** (m, 4) */
  readonly colour: Uint8Array;
}

export interface DielineStyle {
  /** Which edges are drawn; all, if it is not said. */
  readonly shown?: (row: number) => boolean;
  /** (n, 4) colours that stand for those of the line types */
  readonly colours?: Uint8Array | null;
  /** (n, 2) the part of each edge that is worked, as fractions of its length */
  readonly worked?: Float64Array | null;
  /** Which edges are not made, since the drawing has them twice or by mistake: they stand back. */
  readonly gone?: (row: number) => boolean;
  /** Colours that change along the edges, above `colours` where there are any */
  readonly along?: EdgeStretches | null;
}

/** The nominal lines, coloured by line type or as they are told to be. */
export function dielineLines(
  edges: Edges,
  origin: Point,
  palette: Palette,
  {
    shown = () => true,
    colours = null,
    worked = null,
    along = null,
    gone = () => false,
  }: DielineStyle = {},
): Lines {
  const lines = new LineBuilder(origin);
  for (let row = 0; row < edges.bulge.length; row++) {
    if (!shown(row)) continue;
    if (gone(row)) {
      addEdge(lines, edges, row, GHOST, DASHES.indexOf("dotted"));
      continue;
    }
    const look = palette[lineTypeOf(edges.lineType[row])];
    const colour = colours === null ? look.colour : rgbaAt(colours, row);
    // In a gap of a line there would be nothing to read a colour from.
    const dash = colours === null ? DASHES.indexOf(look.dash) : 0;
    const from = worked?.[row * 2] ?? 0;
    const to = worked?.[row * 2 + 1] ?? 1;
    const faint: Rgba = [colour[0], colour[1], colour[2], Math.round(colour[3] * LEFT)];
    if (from > 0) addEdge(lines, edges, row, faint, dash, 0, from);
    if (to > from && !addStretches(lines, edges, row, along, from, to)) {
      addEdge(lines, edges, row, colour, dash, from, to);
    }
    if (to < 1) addEdge(lines, edges, row, faint, dash, to, 1);
  }
  return lines.done();
}

/** Lay an edge from stretch to stretch; false where none are known of it. */
function addStretches(
  lines: LineBuilder,
  edges: Edges,
  row: number,
  along: EdgeStretches | null,
  from: number,
  to: number,
): boolean {
  const begin = along?.first[row] ?? 0;
  const end = along?.first[row + 1] ?? 0;
  if (along === null || end - begin < 2) return false;
  let before = from;
  for (let at = begin; at < end && before < to; at++) {
    // The last one that is known holds to the end.
    const next = at + 1 === end ? to : Math.min(to, along.place[at + 1] ?? to);
    if (next <= before) continue;
    addEdge(lines, edges, row, rgbaAt(along.colour, at), 0, before, next);
    before = next;
  }
  return true;
}

const rgbaAt = (colours: Uint8Array, row: number): Rgba => [
  colours[row * 4] ?? 0,
  colours[row * 4 + 1] ?? 0,
  colours[row * 4 + 2] ?? 0,
  colours[row * 4 + 3] ?? 0,
];

/** Some edges, or moves, in one colour, to lie under or over the others. */
export function highlightLines(
  edges: Segments,
  origin: Point,
  rows: Iterable<number>,
  colour: Rgba,
): Lines {
  const lines = new LineBuilder(origin);
  for (const row of rows) {
    if (row >= 0 && row < edges.bulge.length) addEdge(lines, edges, row, colour, 0);
  }
  return lines.done();
}

/** Edges in the colours of what they would become, to lie under them. */
export function retypePreviewLines(
  edges: Segments,
  origin: Point,
  retypePreviews: readonly { readonly rows: readonly number[]; readonly type: LineType }[],
  palette: Palette,
): Lines {
  const lines = new LineBuilder(origin);
  for (const { rows, type } of retypePreviews) {
    const [red, green, blue] = palette[type].colour;
    for (const row of rows) {
      if (row < edges.bulge.length) addEdge(lines, edges, row, [red, green, blue, 150], 0);
    }
  }
  return lines.done();
}

function addEdge(
  lines: LineBuilder,
  { ends, bulge }: Segments,
  row: number,
  colour: Rgba,
  dash: number,
  from = 0,
  to = 1,
) {
  const at = row * 4;
  const whole = [
    ends[at] as number,
    ends[at + 1] as number,
    ends[at + 2] as number,
    ends[at + 3] as number,
    bulge[row] as number,
  ] as const;
  const run = length(...whole);
  let [x, y] = from > 0 ? pointAt(...whole, from) : [whole[0], whole[1]];
  const [x1, y1] = to < 1 ? pointAt(...whole, to) : [whole[2], whole[3]];
  const bend = partialBulge(whole[4], to - from);
  let before = run * from;
  walk(x, y, x1, y1, bend, CHORD_TOLERANCE, (nextX, nextY, fraction) => {
    lines.add(x, y, nextX, nextY, colour, { along: before, dash, row });
    before = run * (from + (to - from) * fraction);
    x = nextX;
    y = nextY;
  });
}
