/** Makes filling triangles and outlines from areas that lines and arcs bound. */

import { flattenArc } from "../geometry/arc";
import type { Areas, Point } from "../geometry/records";
import { CHORD_TOLERANCE } from "./dieline";
import { LineBuilder, type Lines, type Rgba } from "./lines";
import type { Bands } from "./swept";

export interface AreaShapes {
  readonly bands: Bands;
  readonly rims: Lines;
}

type Pair = readonly [number, number];

export function areaShapes(areas: Areas, origin: Point, fill: Rgba, rim: Rgba): AreaShapes {
  const corners: number[] = [];
  const rims = new LineBuilder(origin);
  for (let loop = 0; loop + 1 < areas.first.length; loop++) {
    const outline = flattenLoop(areas, loop);
    outline.forEach(([x, y], at) => {
      const [nextX, nextY] = outline[(at + 1) % outline.length] as Pair;
      rims.add(x, y, nextX, nextY, rim);
    });
    for (const [x, y] of triangulate(outline)) corners.push(x - origin.x, y - origin.y);
  }
  const colour = new Uint8Array(corners.length * 2);
  for (let at = 0; at < colour.length; at += 4) colour.set(fill, at);
  return {
    bands: { count: corners.length / 6, corners: Float32Array.from(corners), colour },
    rims: rims.build(),
  };
}

/** Vertices of a loop, its arcs flattened. */
function flattenLoop({ ends, bulge, first }: Areas, loop: number): Pair[] {
  const outline: Pair[] = [];
  for (let row = first[loop] ?? 0; row < (first[loop + 1] ?? 0); row++) {
    const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = ends.subarray(row * 4, row * 4 + 4);
    flattenArc(x0, y0, x1, y1, bulge[row] ?? 0, CHORD_TOLERANCE, (x, y) => outline.push([x, y]));
  }
  return outline;
}

/**
 * Corners of the triangles that fill a polygon, three per triangle.
 *
 * No vertex lies between two neighbouring vertex heights, so the sides that cross this strip
 * bound trapezoids in pairs.
 */
function triangulate(outline: readonly Pair[]): Pair[] {
  const heights = [...new Set(outline.map(([, y]) => y))].sort((a, b) => a - b);
  const sides = outline.map((a, at) => [a, outline[(at + 1) % outline.length] as Pair] as const);
  const triangles: Pair[] = [];
  for (let at = 0; at + 1 < heights.length; at++) {
    const [low, high] = [heights[at] as number, heights[at + 1] as number];
    const middle = (low + high) / 2;
    const crossing = sides
      .filter(([a, b]) => a[1] > middle !== b[1] > middle)
      .map(([a, b]) => {
        const x = (y: number) => a[0] + ((b[0] - a[0]) * (y - a[1])) / (b[1] - a[1]);
        return { low: x(low), middle: x(middle), high: x(high) };
      })
      .sort((a, b) => a.middle - b.middle);
    for (let pair = 0; pair + 1 < crossing.length; pair += 2) {
      const left = crossing[pair];
      const right = crossing[pair + 1];
      if (left === undefined || right === undefined) continue;
      triangles.push([left.low, low], [right.low, low], [right.high, high]);
      triangles.push([left.low, low], [right.high, high], [left.high, high]);
    }
  }
  return triangles;
}
