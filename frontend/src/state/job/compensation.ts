/** Where the head runs farthest from the line that its tool makes: the compensation at its clearest. */

import { MOTIONS, type Point, type Toolpath } from "../../geometry/records";
import type { Timeline } from "../../geometry/timeline";
import { NO_OFFSET, type TipOffset, tipOf } from "../../geometry/tip";

const FEED = MOTIONS.indexOf("feed");

export interface Showing {
  /** Row of the edge that the move makes, -1 for none. */
  readonly edge: number;
  /** Tip and head in the coordinates of the drawing (mm). */
  readonly tip: Point;
  readonly head: Point;
  /** Program time at which the move begins (s). */
  readonly from: number;
  /** Program time at which the move ends (s). */
  readonly to: number;
}

/** Least distance of head and tip that can be seen (mm). */
const VISIBLE = 0.05;

/** The cutting move whose head is farthest from its tip; null if all tools run on their lines. */
export function largestOffset(
  timeline: Timeline,
  offsets: ReadonlyMap<number, TipOffset>,
): Showing | null {
  const { motion, tool, source } = timeline.toolpath;
  let best: Showing | null = null;
  let longest = VISIBLE;
  for (let row = 0; row < motion.length; row++) {
    if (motion[row] !== FEED) continue;
    const offset = offsets.get(tool[row] ?? 0) ?? NO_OFFSET;
    const apart = Math.hypot(offset.left, offset.behind);
    // The first of the moves that are equally far apart.
    if (apart <= longest + 1e-9) continue;
    longest = apart;
    const { head, tip } = endOf(timeline.toolpath, row, offset);
    best = {
      edge: source[row] ?? -1,
      head,
      tip,
      from: timeline.clock[row] ?? 0,
      to: timeline.clock[row + 1] ?? 0,
    };
  }
  return best;
}

/** Head and tip at the end of a move, in the coordinates of the drawing. */
function endOf({ pose, placement }: Toolpath, row: number, offset: TipOffset) {
  const at = row * 4 + 4;
  const head = {
    x: (pose[at] ?? 0) - placement[0],
    y: (pose[at + 1] ?? 0) - placement[1],
    z: 0,
    c: pose[at + 3] ?? 0,
  };
  return { head: { x: head.x, y: head.y }, tip: tipOf(head, offset) };
}
