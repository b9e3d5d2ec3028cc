/** Edges to select: those like others, those connected to others, and those that meet conditions. */

import { chainOf } from "../../geometry/chain";
import {
  type DrawnEdges,
  type Edges,
  isComplete,
  type LineType,
  lineTypeOf,
} from "../../geometry/records";
import { isDropped } from "./importReport";
import { layerKey, layerOf } from "./rows";

/** Lengths that differ by at most this share, or by `SAME_LENGTH` mm, are about the same. */
const SAME_SHARE = 0.01;
const SAME_LENGTH = 0.2;

export type Accepts = (row: number) => boolean;

/**
 * Which edges are shown while some line types and layers are hidden.
 *
 * Edges whose layers are not known yet are shown by line type.
 */
export function shownEdges(
  edges: DrawnEdges | Edges,
  hiddenTypes: ReadonlySet<string>,
  hiddenLayers: ReadonlySet<string>,
): Accepts {
  const isShown: Accepts = (row) => !hiddenTypes.has(lineTypeOf(edges.lineType[row]));
  if (hiddenLayers.size === 0 || !isComplete(edges))
    return hiddenTypes.size === 0 ? () => true : isShown;
  return (row) =>
    isShown(row) && !hiddenLayers.has(layerKey(layerOf(edges, row), edges.colour[row] ?? 0));
}

const rowsWhere = (edges: Edges, accepts: Accepts): number[] =>
  [...edges.bulge.keys()].filter(accepts);

/** Edges with the line type, the layer and about the length of one of `rows`. */
export function similarRows(edges: Edges, rows: Iterable<number>, shown: Accepts): number[] {
  const kind = (row: number) => `${edges.lineType[row]} ${edges.layer[row]}`;
  const lengths = new Map<string, number[]>();
  for (const row of rows) {
    const known = lengths.get(kind(row));
    const length = edges.length[row] ?? 0;
    if (known === undefined) lengths.set(kind(row), [length]);
    else known.push(length);
  }
  // Of many lengths, those that differ: each edge is compared with few.
  const ranges = new Map(
    [...lengths].map(([key, listed]) => [key, joinedRanges(listed.map(aboutLength))]),
  );
  return rowsWhere(edges, (row) => {
    const length = edges.length[row] ?? 0;
    const within = ranges.get(kind(row))?.some(([low, high]) => length >= low && length <= high);
    return within === true && shown(row);
  });
}

type Range = readonly [low: number, high: number];

const aboutLength = (length: number): Range => {
  const slack = Math.max(SAME_LENGTH, length * SAME_SHARE);
  return [length - slack, length + slack];
};

/** Ranges that cover the same numbers and do not overlap. */
function joinedRanges(ranges: readonly Range[]): Range[] {
  const joined: Range[] = [];
  for (const range of [...ranges].sort((a, b) => a[0] - b[0])) {
    const last = joined.at(-1);
    if (last === undefined || range[0] > last[1]) joined.push(range);
    else joined[joined.length - 1] = [last[0], Math.max(last[1], range[1])];
  }
  return joined;
}

/** The runs of connected edges of one line type through `rows`. */
export function connectedRows(edges: Edges, rows: Iterable<number>, shown: Accepts): number[] {
  const byType = new Map<number, number[]>();
  for (const row of rows) {
    const type = edges.lineType[row] ?? 0;
    byType.set(type, [...(byType.get(type) ?? []), row]);
  }
  return [...byType].flatMap(([type, starts]) =>
    chainOf(
      edges,
      starts,
      (row) => edges.lineType[row] === type && !isDropped(edges, row) && shown(row),
    ),
  );
}

/** Edges with a line type or layer of one of `rows`. */
export function rowsAlike(
  edges: Edges,
  rows: Iterable<number>,
  column: "lineType" | "layer",
  shown: Accepts,
): number[] {
  const values = new Set([...rows].map((row) => edges[column][row]));
  return rowsWhere(edges, (row) => values.has(edges[column][row]) && shown(row));
}

/** Conditions on edges; null: any. */
export interface Conditions {
  readonly type: LineType | null;
  readonly layer: string | null;
  /** mm */
  readonly shortest: number | null;
  readonly longest: number | null;
}

export const ANY: Conditions = { type: null, layer: null, shortest: null, longest: null };

/** Edges that meet all conditions. */
export const rowsThatMeet = (edges: Edges, wanted: Conditions, shown: Accepts): number[] =>
  rowsWhere(edges, (row) => {
    const length = edges.length[row] ?? 0;
    return (
      (wanted.type === null || lineTypeOf(edges.lineType[row]) === wanted.type) &&
      (wanted.layer === null || layerOf(edges, row) === wanted.layer) &&
      length >= (wanted.shortest ?? 0) &&
      length <= (wanted.longest ?? Number.POSITIVE_INFINITY) &&
      shown(row)
    );
  });
