/** The part of each edge along which the tip moves. */

import { nearestOnArc } from "./arc";
import { type Edges, MOTIONS, type Toolpath } from "./records";
import { NO_OFFSET, type TipOffset, tipOf } from "./tip";

const FEED = MOTIONS.indexOf("feed");
/** Setbacks shorter than this are ignored, because they are invisible or rounding (mm). */
const SHORTEST = 0.05;

/**
 * First and last point of each edge that the tool tip reaches, (n, 2), as fractions of its length.
 *
 * Only edges with a setback are examined; the span of all others is (0, 1).
 */
export function workedSpans(
  edges: Edges,
  { pose, motion, source, tool, placement }: Toolpath,
  offsets: ReadonlyMap<number, TipOffset>,
  setback: readonly number[],
): Float64Array {
  const count = edges.bulge.length;
  const spans = new Float64Array(count * 2);
  const reached = new Uint8Array(count);
  for (let edge = 0; edge < count; edge++) {
    if ((setback[edge] ?? 0) < SHORTEST) spans[edge * 2 + 1] = 1;
    else spans[edge * 2] = 1;
  }
  for (let row = 0; row < motion.length; row++) {
    const edge = source[row] as number;
    if (motion[row] !== FEED || edge < 0 || edge >= count || !((setback[edge] ?? 0) >= SHORTEST))
      continue;
    const offset = offsets.get(tool[row] ?? 0) ?? NO_OFFSET;
    for (const at of [row * 4, row * 4 + 4]) {
      const tip = tipOf(
        {
          x: (pose[at] as number) - placement[0],
          y: (pose[at + 1] as number) - placement[1],
          z: 0,
          c: pose[at + 3] as number,
        },
        offset,
      );
      const { ends, bulge } = edges;
      const e = edge * 4;
      const { fraction } = nearestOnArc(
        tip.x,
        tip.y,
        ends[e] as number,
        ends[e + 1] as number,
        ends[e + 2] as number,
        ends[e + 3] as number,
        bulge[edge] as number,
      );
      spans[edge * 2] = Math.min(spans[edge * 2] as number, fraction);
      spans[edge * 2 + 1] = Math.max(spans[edge * 2 + 1] as number, fraction);
      reached[edge] = 1;
    }
  }
  // Without a feed, one plunge may have pressed the edge: the span is then the whole edge.
  for (let edge = 0; edge < count; edge++) {
    if (reached[edge] === 0) spans.set([0, 1], edge * 2);
  }
  return spans;
}
