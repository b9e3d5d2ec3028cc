/** Selections of edges that start from the edges selected now; hidden edges are left out. */

import type { Edges } from "../../geometry/records";
import { queries, queryClient } from "../queries";
import { useUiStore } from "../store";
import { type Accepts, connectedRows, rowsAlike, shownEdges, similarRows } from "./selecting";

/** Replace the selection by the edges that `choose` finds; nothing without a drawing. */
function select(
  choose: (edges: Edges, selection: ReadonlySet<number>, shown: Accepts) => number[],
): void {
  const { drawing, selection, hiddenTypes, hiddenLayers, selectEdges } = useUiStore.getState();
  if (drawing === null) return;
  const edges = queryClient.getQueryData(queries.edges(drawing).queryKey);
  if (edges !== undefined)
    selectEdges(choose(edges, selection, shownEdges(edges, hiddenTypes, hiddenLayers)));
}

export const selectAll = (): void =>
  select((edges, _, shown) => [...edges.bulge.keys()].filter(shown));

export const selectSimilar = (): void => select(similarRows);

export const selectConnected = (): void => select(connectedRows);

/** Select the edges with the line type or the layer of a selected edge. */
export const selectAlike = (column: "lineType" | "layer"): void =>
  select((edges, selection, shown) => rowsAlike(edges, selection, column, shown));
