/** Bridges that are placed by a click on the outline of a part. */

import { create } from "zustand";
import type { Job } from "../../api/jobs";
import { arcLength, nearestOnArc, pointAt } from "../../geometry/arc";
import { type Edges, lineTypeOf, type Point } from "../../geometry/records";

export type Bridge = Job["bridges"][number];

/** Limits of the width (mm), as the server has them. */
export const WIDTH = { min: 0.1, max: 20, step: 0.1 } as const;

interface Picking {
  /** A click on the canvas places a bridge. */
  readonly active: boolean;
  /** Width of the next bridge (mm). */
  readonly width: number;
}

export const useBridgePicking = create<Picking>()(() => ({ active: false, width: 0.5 }));

const lineOf = ({ ends, bulge }: Edges, row: number) => {
  const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = ends.subarray(4 * row, 4 * row + 4);
  return [x0, y0, x1, y1, bulge[row] ?? 0] as const;
};

/**
 * The bridge at the point of an edge that is nearest to a click, moved so far from the ends that it
 * fits on the edge; null if the edge is not cut or too short.
 */
export function bridgeNear(edges: Edges, row: number, to: Point, width: number): Bridge | null {
  if (lineTypeOf(edges.lineType[row]) !== "cut") return null;
  const line = lineOf(edges, row);
  const half = width / 2 / arcLength(...line);
  if (!(half <= 0.5)) return null;
  const { fraction } = nearestOnArc(to.x, to.y, ...line);
  const at = Math.min(1 - half, Math.max(half, fraction));
  return { edges: [row], at: Number(at.toFixed(4)), width };
}

export const withoutBridge = (bridges: readonly Bridge[], which: number): Bridge[] =>
  bridges.filter((_, place) => place !== which);

export const withBridgeWidth = (
  bridges: readonly Bridge[],
  which: number,
  width: number,
): Bridge[] => bridges.map((one, place) => (place === which ? { ...one, width } : one));

/** The middles of all bridges, for marks in the drawing. */
export function bridgePlaces(bridges: readonly Bridge[], edges: Edges | null): Point[] {
  if (edges === null) return [];
  return bridges.flatMap(({ edges: rows, at }) =>
    rows
      .filter((row) => row < edges.bulge.length)
      .map((row) => {
        const [x, y] = pointAt(...lineOf(edges, row), at);
        return { x, y };
      }),
  );
}

/** Distance of the middle of a bridge from the start of its edge (mm). */
export const distanceAlong = ({ edges: [row = 0], at }: Bridge, edges: Edges): number =>
  at * arcLength(...lineOf(edges, row));
