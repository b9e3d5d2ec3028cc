/** The list of edges: which edges it contains, and in which order. */

import { create } from "zustand";
import { type Edges, type LineType, lineTypeOf, outcomeOf } from "../../geometry/records";
import { naturalOrder } from "../naturalOrder";
import { isSetByHand } from "./history";

interface EdgeList {
  /** Whether the list is shown instead of the other panels of the step. */
  readonly open: boolean;
  show(open: boolean): void;
  toggle(): void;
}

export const useEdgeList = create<EdgeList>()((set) => ({
  open: false,
  show: (open) => set({ open }),
  toggle: () => set(({ open }) => ({ open: !open })),
}));

/** How an edge came to its line type, or what the import made of it. */
export const EDGE_STATES = ["undecided", "byHand", "merged", "dropped", "kept"] as const;
export type EdgeState = (typeof EDGE_STATES)[number];

export function edgeState(edges: Edges, row: number): EdgeState {
  const outcome = outcomeOf(edges.outcome[row]);
  if (outcome === "dropped") return "dropped";
  if (lineTypeOf(edges.lineType[row]) === "unclassified") return "undecided";
  if (isSetByHand(edges, row)) return "byHand";
  return outcome;
}

export interface ListFilter {
  /** Part of the name of a layer, or the number of an edge. */
  readonly text: string;
  readonly type: LineType | null;
  readonly state: EdgeState | null;
}

export const NO_LIST_FILTER: ListFilter = { text: "", type: null, state: null };

export const LIST_COLUMNS = ["row", "type", "layer", "length", "state"] as const;
export type ListColumn = (typeof LIST_COLUMNS)[number];

export interface ListSort {
  readonly column: ListColumn;
  readonly down: boolean;
}

/** The rows that meet the filter, sorted; equal ones in the order of the drawing. */
export function listedRows(edges: Edges, filter: ListFilter, sort: ListSort): number[] {
  const rows = [...edges.bulge.keys()].filter(accepts(edges, filter));
  const rank = ranks(edges, sort.column);
  const sign = sort.down ? -1 : 1;
  return rows.sort((a, b) => sign * ((rank[a] ?? 0) - (rank[b] ?? 0)) || a - b);
}

function accepts(edges: Edges, { text, type, state }: ListFilter): (row: number) => boolean {
  const wanted = text.trim().toLowerCase();
  const layers = edges.layers.map((name) => name.toLowerCase().includes(wanted));
  return (row) =>
    (type === null || lineTypeOf(edges.lineType[row]) === type) &&
    (state === null || edgeState(edges, row) === state) &&
    (wanted === "" || layers[edges.layer[row] ?? -1] === true || String(row) === wanted);
}

/** A number for each row by which a column is sorted. */
function ranks(edges: Edges, column: ListColumn): ArrayLike<number> {
  if (column === "length") return edges.length;
  if (column === "type") return edges.lineType;
  if (column === "layer") {
    // The place of each layer in the order of their names.
    const order = [...edges.layers].sort(naturalOrder);
    const places = edges.layers.map((name) => order.indexOf(name));
    return Float64Array.from(edges.layer, (layer) => places[layer] ?? -1);
  }
  if (column === "state")
    return Float64Array.from(edges.bulge, (_, row) => EDGE_STATES.indexOf(edgeState(edges, row)));
  return Float64Array.from(edges.bulge, (_, row) => row);
}

/** The rows from one place of the list to another one, both included. */
export const rangeOf = (listed: readonly number[], from: number, to: number): readonly number[] =>
  listed.slice(Math.min(from, to), Math.max(from, to) + 1);
