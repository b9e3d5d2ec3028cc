/** Runs of edges that are connected end to end. */

import Flatbush from "flatbush";
import type { Segments } from "./records";

/** Ends nearer than this are connected (mm). */
const CONNECTED = 0.05;

/**
 * The rows of the runs through some rows, ascending.
 *
 * A run goes on where exactly one other row for which `accepts` is true has an end, and stops
 * where several have one.
 */
export function chainOf(
  { ends, bulge }: Segments,
  starts: Iterable<number>,
  accepts: (row: number) => boolean,
): number[] {
  const rows = [...bulge.keys()].filter(accepts);
  if (rows.length === 0) return [];
  const tree = new Flatbush(rows.length * 2);
  for (const row of rows)
    for (const at of [row * 4, row * 4 + 2]) {
      const [x = 0, y = 0] = ends.subarray(at, at + 2);
      tree.add(x, y, x, y);
    }
  tree.finish();

  /** Ends near the end in column `at` of other rows, as columns. */
  const connected = (at: number): number[] => {
    const [x = 0, y = 0] = ends.subarray(at, at + 2);
    return tree
      .search(x - CONNECTED, y - CONNECTED, x + CONNECTED, y + CONNECTED)
      .map((item) => (rows[item >> 1] as number) * 4 + (item & 1) * 2)
      .filter((other) => other >> 2 !== at >> 2);
  };

  const found = new Set<number>();
  for (const start of starts) {
    if (!accepts(start) || found.has(start)) continue;
    found.add(start);
    for (const first of [start * 4, start * 4 + 2]) {
      let at = first;
      for (;;) {
        const [next, ...others] = connected(at);
        if (next === undefined || others.length > 0 || found.has(next >> 2)) break;
        found.add(next >> 2);
        at = next ^ 2;
      }
    }
  }
  return [...found].sort((a, b) => a - b);
}
