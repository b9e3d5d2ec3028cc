/** Rows of edges by line type, layer or handle. */

import { type Edges, type LineType, lineTypeOf } from "../../geometry/records";

const filterRows = (edges: Edges, accepts: (row: number) => boolean): number[] => {
  const rows: number[] = [];
  for (let row = 0; row < edges.bulge.length; row++) if (accepts(row)) rows.push(row);
  return rows;
};

export const rowsOfType = (edges: Edges, type: LineType): number[] =>
  filterRows(edges, (row) => lineTypeOf(edges.lineType[row]) === type);

export const rowsOfLayer = (edges: Edges, layer: string, colour: number): number[] =>
  filterRows(edges, (row) => layerOf(edges, row) === layer && edges.colour[row] === colour);

const cache = new WeakMap<readonly string[], ReadonlyMap<string, readonly number[]>>();

/** Rows by handle, built once per drawing. */
function byHandle(handles: readonly string[]): ReadonlyMap<string, readonly number[]> {
  const known = cache.get(handles);
  if (known !== undefined) return known;
  const rows = new Map<string, number[]>();
  handles.forEach((handle, row) => {
    const those = rows.get(handle);
    if (those === undefined) rows.set(handle, [row]);
    else those.push(row);
  });
  cache.set(handles, rows);
  return rows;
}

export function rowsOfHandles(edges: Edges, handles: Iterable<string>): number[] {
  const rows = byHandle(edges.handles);
  return [...new Set(handles)].flatMap((handle) => rows.get(handle) ?? []).sort((a, b) => a - b);
}

/** What an error or a refused job concerns: rows of edges and handles of their entities. */
export interface Concerned {
  readonly edges: readonly number[];
  readonly source: readonly string[];
}

/**
 * Rows of the edges that an error or a refused job concerns. Only older servers name no rows: then
 * they are all edges of the entities, of which some may not be concerned.
 */
export const concernedRows = (edges: Edges, { edges: rows, source }: Concerned): number[] =>
  rows.length === 0
    ? rowsOfHandles(edges, source)
    : rows.filter((row) => row >= 0 && row < edges.bulge.length);

export const layerOf = (edges: Edges, row: number): string =>
  edges.layers[edges.layer[row] ?? -1] ?? "";

/** Key of a layer and colour that can be hidden. */
export const layerKey = (layer: string, colour: number): string => `${colour}\u0000${layer}`;
