/** Shapes of the drawings on a sheet, fetched once each. */

import { useQueries } from "@tanstack/react-query";
import { useMemo } from "react";
import { drawingService } from "../../api/drawings";
import { layoutService, type Placed } from "../../api/layouts";
import { LINE_TYPES, type Segments } from "../../geometry/records";
import { type DrawingShape, type TurnedShape, turnShape } from "./shapes";

const IGNORED = LINE_TYPES.indexOf("ignored");

/** The edges that are made: ignored ones are not placed. */
function madeEdges({ ends, bulge, lineType }: Segments & { lineType: Uint8Array }): Segments {
  const rows = [...bulge.keys()].filter((row) => lineType[row] !== IGNORED);
  return {
    ends: Float64Array.from(rows.flatMap((row) => [...ends.subarray(4 * row, 4 * row + 4)])),
    bulge: Float64Array.from(rows, (row) => bulge[row] ?? 0),
  };
}

async function fetchShape(id: string, signal: AbortSignal): Promise<DrawingShape> {
  const [drawing, edges, { area, blanks }] = await Promise.all([
    drawingService.drawing(id, signal),
    drawingService.edges(id, signal),
    layoutService.blanks(id, signal),
  ]);
  const outlines = blanks.map(({ outline }) => outline.flat());
  const holes = blanks.flatMap((blank) => blank.holes.map((hole) => hole.flat()));
  return { name: drawing.name, edges: madeEdges(edges), outlines, holes, area };
}

export interface Shapes {
  readonly drawings: ReadonlyMap<string, DrawingShape>;
  readonly shapeOf: (placed: Placed) => TurnedShape | undefined;
  readonly error: Error | null;
}

/** Shapes of drawings by their ids; those that are being fetched are missing. */
export function useShapes(ids: readonly string[]): Shapes {
  const found = useQueries({
    queries: ids.map((id) => ({
      queryKey: ["layout shape", id],
      queryFn: ({ signal }: { signal: AbortSignal }) => fetchShape(id, signal),
      structuralSharing: false as const,
    })),
    combine: (results) => ({
      data: results.map(({ data }) => data),
      error: results.find(({ error }) => error !== null)?.error ?? null,
    }),
  });
  return useMemo(() => {
    const drawings = new Map<string, DrawingShape>();
    for (const [index, id] of ids.entries()) {
      const shape = found.data[index];
      if (shape !== undefined) drawings.set(id, shape);
    }
    const turned = new Map<string, TurnedShape>();
    const shapeOf = ({ drawing, turn, mirror }: Placed): TurnedShape | undefined => {
      const shape = drawings.get(drawing);
      if (shape === undefined) return undefined;
      const key = `${drawing} ${turn} ${mirror}`;
      const known = turned.get(key) ?? turnShape(shape, { turn, mirror });
      turned.set(key, known);
      return known;
    };
    return { drawings, shapeOf, error: found.error };
  }, [ids, found]);
}
