/** Computes a colour per edge from a figure of the verdict, on a scale from 0 to a limit. */

import { type Edges, lineTypeOf, type Samples } from "../geometry/records";
import type { EdgeStretches } from "./dieline";
import type { Rgba } from "./lines";

export interface Scale {
  /** Colours from 0 to the limit at equal steps; at least two. */
  readonly stops: readonly Rgba[];
  readonly beyond: Rgba;
  /** Colour of an edge that is not machined. */
  readonly unworked: Rgba;
}

/** One figure per edge and its limit (mm). */
export interface FigureMap {
  /** (n,) */
  readonly figure: readonly number[];
  readonly limit: number;
  /** (n,) uncut length (mm) */
  readonly uncut: readonly number[];
  /** (n,) length left uncut on purpose (mm) */
  readonly setback: readonly number[];
}

/** Rounding allowed above the limit (mm). */
const ROUNDING = 1e-6;

/** The colour of a figure. */
export function scaleColour(figure: number, limit: number, { stops, beyond }: Scale): Rgba {
  if (!(figure <= limit + ROUNDING)) return beyond;
  const share = limit > 0 ? Math.min(1, Math.max(0, figure / limit)) : 0;
  const place = share * (stops.length - 1);
  const before = Math.min(stops.length - 2, Math.floor(place));
  const [a, b] = [stops[before] ?? beyond, stops[before + 1] ?? beyond];
  const mixed = (at: 0 | 1 | 2 | 3) => Math.round(a[at] + (b[at] - a[at]) * (place - before));
  return [mixed(0), mixed(1), mixed(2), mixed(3)];
}

/** Whether at least a part of an edge was machined. */
export function isWorked(edges: Edges, { uncut, setback }: FigureMap, row: number): boolean {
  const type = lineTypeOf(edges.lineType[row]);
  if (type === "ignored" || type === "unclassified") return false;
  const left = (uncut[row] ?? 0) + (setback[row] ?? 0);
  // A crease shorter than the wheel's contact is pressed by one plunge: its setback is its whole
  // length, although it is machined.
  return (uncut[row] ?? 0) === 0 || left < (edges.length[row] ?? 0) - ROUNDING;
}

/** The colours of all edges, (n, 4). */
export function figureColours(edges: Edges, map: FigureMap, scale: Scale): Uint8Array {
  const count = edges.bulge.length;
  const colours = new Uint8Array(count * 4);
  for (let row = 0; row < count; row++) {
    const colour = isWorked(edges, map, row)
      ? scaleColour(map.figure[row] ?? Number.NaN, map.limit, scale)
      : scale.unworked;
    colours.set(colour, row * 4);
  }
  return colours;
}

/**
 * Colours of the deviations measured along the edges.
 *
 * The figure of an edge includes the rounding of the controller, the samples do not. The
 * difference is added to all samples, so that the worst sample has the colour of the edge.
 */
export function stretchColours(
  edges: Edges,
  map: FigureMap,
  { edge, place, deviation }: Samples,
  scale: Scale,
): EdgeStretches {
  const count = edges.bulge.length;
  const first = new Int32Array(count + 1);
  const worst = new Float64Array(count);
  edge.forEach((row, at) => {
    first[row + 1] = (first[row + 1] ?? 0) + 1;
    worst[row] = Math.max(worst[row] ?? 0, Math.abs(deviation[at] ?? 0));
  });
  for (let row = 0; row < count; row++) first[row + 1] = (first[row + 1] ?? 0) + (first[row] ?? 0);
  const colour = new Uint8Array(edge.length * 4);
  edge.forEach((row, at) => {
    const rounding = Math.max(0, (map.figure[row] ?? 0) - (worst[row] ?? 0));
    // A stretch has the larger deviation of its two ends.
    const next = edge[at + 1] === row ? Math.abs(deviation[at + 1] ?? 0) : 0;
    // Two passes may have samples at the same place.
    const coincident = edge[at - 1] === row && place[at - 1] === place[at];
    const other = coincident ? Math.abs(deviation[at - 1] ?? 0) : 0;
    const figure = Math.max(Math.abs(deviation[at] ?? 0), next, other) + rounding;
    const shown = isWorked(edges, map, row)
      ? scaleColour(figure, map.limit, scale)
      : scale.unworked;
    colour.set(shown, at * 4);
  });
  return { first, place, colour };
}
