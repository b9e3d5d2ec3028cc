/** Picking of edges: a spatial index of their boxes, then the exact distance. */

import Flatbush from "flatbush";
import { nearestOnArc } from "./arc";
import { boxOfRow } from "./bounds";
import type { Box, Segments } from "./records";

export interface PickIndex {
  /** The row nearest to a point, within `reach` mm, for which `accepts` is true; else null. */
  at(x: number, y: number, reach: number, accepts?: (row: number) => boolean): number | null;
  /** The rows within `reach` mm of a point and at most `slack` mm farther than the nearest row. */
  near(
    x: number,
    y: number,
    reach: number,
    slack: number,
    accepts?: (row: number) => boolean,
  ): number[];
  /** The rows whose bounding boxes lie completely inside a box. */
  inside(box: Box): number[];
}

export function buildPickIndex(segments: Segments): PickIndex {
  const count = segments.bulge.length;
  if (count === 0) return { at: () => null, near: () => [], inside: () => [] };
  const tree = new Flatbush(count);
  for (let row = 0; row < count; row++) tree.add(...boxOfRow(segments, row));
  tree.finish();
  const { ends, bulge } = segments;

  const distanceTo = (x: number, y: number, row: number): number => {
    const at = row * 4;
    return nearestOnArc(
      x,
      y,
      ends[at] as number,
      ends[at + 1] as number,
      ends[at + 2] as number,
      ends[at + 3] as number,
      bulge[row] as number,
    ).distance;
  };

  return {
    at(x, y, reach, accepts = () => true) {
      let found: number | null = null;
      let least = reach;
      for (const row of tree.search(x - reach, y - reach, x + reach, y + reach)) {
        if (!accepts(row)) continue;
        const distance = distanceTo(x, y, row);
        if (distance <= least) {
          least = distance;
          found = row;
        }
      }
      return found;
    },
    near(x, y, reach, slack, accepts = () => true) {
      const around = tree
        .search(x - reach, y - reach, x + reach, y + reach)
        .filter(accepts)
        .map((row) => ({ row, distance: distanceTo(x, y, row) }));
      const least = Math.min(reach, ...around.map(({ distance }) => distance));
      return around
        .filter(({ distance }) => distance <= reach && distance <= least + slack)
        .map(({ row }) => row)
        .sort((a, b) => a - b);
    },
    inside(box) {
      return tree.search(...box).filter((row) => {
        const inner = boxOfRow(segments, row);
        return inner[0] >= box[0] && inner[1] >= box[1] && inner[2] <= box[2] && inner[3] <= box[3];
      });
    },
  };
}
