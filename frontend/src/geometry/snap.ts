/** Snapping: the point of the drawing that a user means by a place near it. */

import Flatbush from "flatbush";
import { circleOf, nearestOnArc, pointAt } from "./arc";
import { crossing, type Line } from "./crossing";
import { buildPickIndex } from "./pick";
import type { Point, Segments } from "./records";

/** Kinds of points; one of an earlier kind is preferred. */
const KINDS: readonly Snapped["kind"][] = ["end", "crossing", "middle", "centre"];
/** Most lines near a place that are compared for crossings. */
const MOST_LINES = 40;

export interface Snapped extends Point {
  /** What the point is: "edge" for another point of an edge, "free" if no edge is near. */
  readonly kind: "end" | "crossing" | "middle" | "centre" | "edge" | "free";
}

/** The point within `reach` mm of a place; the place itself if there is none. */
export type Snap = (place: Point, reach: number) => Snapped;

/**
 * Index the points of the rows for which `accepts` is true.
 *
 * `kinds` are the kinds of points that are found; one of an earlier kind is preferred.
 */
export function buildSnap(
  segments: Segments,
  accepts: (row: number) => boolean = () => true,
  kinds: readonly Snapped["kind"][] = KINDS,
): Snap {
  const edges = buildPickIndex(segments);
  const points = [...segments.bulge.keys()]
    .filter(accepts)
    .flatMap((row) => pointsOf(segments, row))
    .filter(({ kind }) => kinds.includes(kind));
  const tree = points.length === 0 ? null : new Flatbush(points.length);
  for (const { x, y } of points) tree?.add(x, y, x, y);
  tree?.finish();

  const crossingsNear = ({ x, y }: Point, reach: number): Snapped[] => {
    if (!kinds.includes("crossing")) return [];
    const lines = edges
      .near(x, y, reach, reach, accepts)
      .filter((row) => segments.bulge[row] === 0)
      .slice(0, MOST_LINES)
      .map((row): Line => {
        const [x0, y0, x1, y1] = edgeOf(segments, row);
        return [x0, y0, x1, y1];
      });
    return lines.flatMap((line, at) =>
      lines.slice(at + 1).flatMap((other): Snapped[] => {
        const point = crossing(line, other);
        return point === null ? [] : [{ ...point, kind: "crossing" }];
      }),
    );
  };

  const nearestPoint = ({ x, y }: Point, reach: number): Snapped | null => {
    let found: Snapped | null = null;
    let least = Number.POSITIVE_INFINITY;
    const indexed = tree?.search(x - reach, y - reach, x + reach, y + reach) ?? [];
    for (const point of [
      ...indexed.map((at) => points[at] as Snapped),
      ...crossingsNear({ x, y }, reach),
    ]) {
      const distance = Math.hypot(point.x - x, point.y - y);
      const rank = kinds.indexOf(point.kind) * reach + distance;
      if (distance > reach || rank >= least) continue;
      least = rank;
      found = point;
    }
    return found;
  };

  return (place, reach) => {
    const point = nearestPoint(place, reach);
    if (point !== null) return point;
    const row = edges.at(place.x, place.y, reach, accepts);
    if (row === null) return { ...place, kind: "free" };
    const edge = edgeOf(segments, row);
    const [x, y] = pointAt(...edge, nearestOnArc(place.x, place.y, ...edge).fraction);
    return { x, y, kind: "edge" };
  };
}

type Edge = [x0: number, y0: number, x1: number, y1: number, bulge: number];

function edgeOf({ ends, bulge }: Segments, row: number): Edge {
  const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = ends.subarray(row * 4, row * 4 + 4);
  return [x0, y0, x1, y1, bulge[row] ?? 0];
}

function pointsOf(segments: Segments, row: number): Snapped[] {
  const edge = edgeOf(segments, row);
  const [x, y] = pointAt(...edge, 0.5);
  const round = circleOf(...edge);
  return [
    { x: edge[0], y: edge[1], kind: "end" },
    { x: edge[2], y: edge[3], kind: "end" },
    { x, y, kind: "middle" },
    ...(round === null ? [] : [{ x: round.x, y: round.y, kind: "centre" } as const]),
  ];
}
