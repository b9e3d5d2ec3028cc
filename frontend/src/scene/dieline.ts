/** Makes lines for display from the edges of a drawing, in the colours of their line types. */

import { arcLength, flattenArc, partialBulge, pointAt } from "../geometry/arc";
import {
  type Box,
  type DrawnEdges,
  type LineType,
  lineTypeOf,
  type Point,
  type Segments,
} from "../geometry/records";
import { type Millimetre, mm } from "../geometry/units";
import { DASHES, type Dash, LineBuilder, type Lines, type Rgba } from "./lines";

/** Maximum distance of a chord from its arc (mm). */
export const CHORD_TOLERANCE = mm(0.01);

/** The tolerance is at most this part of the diagonal of a drawing: a tenth of a pixel. */
const COARSE_PART = 1 / 16_000;

/** Maximum distance of a chord from its arc (mm) while a drawing is shown as a whole. */
export const coarseTolerance = ([left, bottom, right, top]: Box): Millimetre =>
  mm(Math.max(CHORD_TOLERANCE, Math.hypot(right - left, top - bottom) * COARSE_PART));

/** Colour and dash of each line type. */
export type Palette = Readonly<Record<LineType, { colour: Rgba; dash: Dash }>>;

/** Opacity of the part of an edge that is not machined. */
const UNWORKED_OPACITY = 0.3;

/** Colour of dropped edges. */
const DROPPED: Rgba = [139, 151, 166, 130];

/** Colours along the edges: edge i has the stretches first[i] to first[i + 1] - 1. */
export interface EdgeStretches {
  /** (n + 1,) */
  readonly first: Int32Array;
  /** (m,) start of each stretch, as a fraction of the edge's length */
  readonly place: Float64Array;
  /** (m, 4) */
  readonly colour: Uint8Array;
}

export interface DielineStyle {
  /** Maximum distance of a chord from its arc (mm); default: `CHORD_TOLERANCE`. */
  readonly tolerance?: Millimetre;
  /** Which edges are drawn; default: all. */
  readonly shown?: (row: number) => boolean;
  /** (n, 4) colours instead of those of the line types */
  readonly colours?: Uint8Array | null;
  /** (n, 2) the machined part of each edge, as fractions of its length */
  readonly worked?: Float64Array | null;
  /** Which edges were dropped by the cleaning; they are drawn faint. */
  readonly dropped?: (row: number) => boolean;
  /** Colours that change along the edges; they override `colours` */
  readonly along?: EdgeStretches | null;
}

/** Lines of the drawing, coloured by line type or by `colours`. */
export function dielineLines(
  edges: DrawnEdges,
  origin: Point,
  palette: Palette,
  {
    tolerance = CHORD_TOLERANCE,
    shown = () => true,
    colours = null,
    worked = null,
    along = null,
    dropped = () => false,
  }: DielineStyle = {},
): Lines {
  // Most drawings have few arcs.
  const lines = new LineBuilder(origin, edges.bulge.length);
  for (let row = 0; row < edges.bulge.length; row++) {
    if (!shown(row)) continue;
    if (dropped(row)) {
      addEdge(lines, edges, row, DROPPED, DASHES.indexOf("dotted"), tolerance);
      continue;
    }
    const look = palette[lineTypeOf(edges.lineType[row])];
    const colour = colours === null ? look.colour : rgbaAt(colours, row);
    // A dash gap would hide the colour.
    const dash = colours === null ? DASHES.indexOf(look.dash) : 0;
    const from = worked?.[row * 2] ?? 0;
    const to = worked?.[row * 2 + 1] ?? 1;
    if (from === 0 && to === 1 && along === null) {
      addEdge(lines, edges, row, colour, dash, tolerance);
      continue;
    }
    const faint: Rgba = [colour[0], colour[1], colour[2], Math.round(colour[3] * UNWORKED_OPACITY)];
    if (from > 0) addEdge(lines, edges, row, faint, dash, tolerance, 0, from);
    if (to > from && !addStretches(lines, edges, row, along, from, to)) {
      addEdge(lines, edges, row, colour, dash, tolerance, from, to);
    }
    if (to < 1) addEdge(lines, edges, row, faint, dash, tolerance, to, 1);
  }
  return lines.build();
}

/** Add an edge stretch by stretch; false if it has no stretches. */
function addStretches(
  lines: LineBuilder,
  edges: Segments,
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
    // The last stretch extends to the end.
    const next = at + 1 === end ? to : Math.min(to, along.place[at + 1] ?? to);
    if (next <= before) continue;
    addEdge(lines, edges, row, rgbaAt(along.colour, at), 0, CHORD_TOLERANCE, before, next);
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

/** Edges or moves in one colour, as a highlight. */
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
  return lines.build();
}

/** Edges in the colours of the line types that they would get. */
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
  return lines.build();
}

function addEdge(
  lines: LineBuilder,
  { ends, bulge }: Segments,
  row: number,
  colour: Rgba,
  dash: number,
  tolerance = CHORD_TOLERANCE,
  from = 0,
  to = 1,
) {
  const at = row * 4;
  if (bulge[row] === 0 && from === 0 && to === 1) {
    const [x0, y0] = [ends[at] as number, ends[at + 1] as number];
    const [x1, y1] = [ends[at + 2] as number, ends[at + 3] as number];
    lines.add(x0, y0, x1, y1, colour, { dash, row });
    return;
  }
  const whole = [
    ends[at] as number,
    ends[at + 1] as number,
    ends[at + 2] as number,
    ends[at + 3] as number,
    bulge[row] as number,
  ] as const;
  const run = arcLength(...whole);
  let [x, y] = from > 0 ? pointAt(...whole, from) : [whole[0], whole[1]];
  const [x1, y1] = to < 1 ? pointAt(...whole, to) : [whole[2], whole[3]];
  const bend = partialBulge(whole[4], to - from);
  let before = run * from;
  flattenArc(x, y, x1, y1, bend, tolerance, (nextX, nextY, fraction) => {
    lines.add(x, y, nextX, nextY, colour, { along: before, dash, row });
    before = run * (from + (to - from) * fraction);
    x = nextX;
    y = nextY;
  });
}
