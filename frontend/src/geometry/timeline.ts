/**
 * Nominal time of each move of a tool path.
 *
 * A machine reports its position a few times a second. Between two reports the head marker has to
 * follow the path. So a reported position is converted to a time, and the marker moves in time.
 */

import { arcLength, nearestOnArc, pointAt } from "./arc";
import type { Pose, Toolpath } from "./records";
import { pointOnDrawing } from "./similarity";

/** Assumed feed of air moves (mm/min). */
const RAPID_FEED = 90_000;
/** Assumed speed of C turns above the board (degrees/min). */
const TURN_FEED = 216_000;
/** A reported position is searched from this many program lines before the reported line … */
const LINES_BEFORE = 3;
/** … to this many lines after it: a controller reads further ahead than it reports. */
const LINES_AFTER = 24;

export interface Timeline {
  /** (n + 1,) seconds at each pose */
  readonly clock: Float64Array;
  readonly toolpath: Toolpath;
}

/** The times of a tool path: those of the server, or for older jobs lengths over feeds. */
export function buildTimeline(toolpath: Toolpath): Timeline {
  const { pose, bulge, feed, seconds } = toolpath;
  const clock = new Float64Array(bulge.length + 1);
  if (seconds !== undefined) {
    for (let row = 0; row < bulge.length; row++)
      clock[row + 1] = (clock[row] as number) + (seconds[row] as number);
    return { clock, toolpath };
  }
  for (let row = 0; row < bulge.length; row++) {
    const a = row * 4;
    const distance = Math.hypot(
      arcLength(
        pose[a] as number,
        pose[a + 1] as number,
        pose[a + 4] as number,
        pose[a + 5] as number,
        bulge[row] as number,
      ),
      (pose[a + 6] as number) - (pose[a + 2] as number),
    );
    const turnAngle = Math.abs((pose[a + 7] as number) - (pose[a + 3] as number));
    const speed = feed[row] as number;
    let minutes = distance / (speed > 0 ? speed : RAPID_FEED);
    if (distance < 1e-9) minutes = turnAngle / TURN_FEED;
    else if (speed <= 0) minutes = Math.max(minutes, turnAngle / TURN_FEED);
    clock[row + 1] = (clock[row] as number) + minutes * 60;
  }
  return { clock, toolpath };
}

export const totalSeconds = (line: Timeline): number => line.clock[line.clock.length - 1] ?? 0;

/** Row of the move that is in progress at a time (s). */
export function rowAt(line: Timeline, seconds: number): number {
  let low = 0;
  let high = line.toolpath.bulge.length;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if ((line.clock[middle] as number) <= seconds) low = middle;
    else high = middle - 1;
  }
  return Math.min(low, line.toolpath.bulge.length - 1);
}

/** Position of the head at a time (s); null for an empty tool path. */
export function poseAt(line: Timeline, seconds: number): Pose | null {
  const { pose, bulge } = line.toolpath;
  const row = rowAt(line, seconds);
  if (row < 0) return null;
  const start = line.clock[row] as number;
  const span = (line.clock[row + 1] as number) - start;
  const fraction = span > 0 ? Math.min(1, Math.max(0, (seconds - start) / span)) : 1;
  const a = row * 4;
  const [x, y] = pointAt(
    pose[a] as number,
    pose[a + 1] as number,
    pose[a + 4] as number,
    pose[a + 5] as number,
    bulge[row] as number,
    fraction,
  );
  const between = (from: number, to: number) => from + (to - from) * fraction;
  return {
    x,
    y,
    z: between(pose[a + 2] as number, pose[a + 6] as number),
    c: between(pose[a + 3] as number, pose[a + 7] as number),
  };
}

/**
 * Time (s) at which the head passes a reported position near a reported program line.
 *
 * Without a position, the time at which the moves of the program line end.
 */
export function timeOf(
  line: Timeline,
  programLine: number,
  position: readonly [number, number, number, number] | null,
  /** False if the head follows the path above the board. */
  atHeight = true,
): number {
  const { pose, bulge, line: lines, similarity } = line.toolpath;
  // Poses of a measured sheet are those on the drawing.
  const at = position === null ? null : { x: position[0], y: position[1] };
  const drawn = at === null || similarity == null ? at : pointOnDrawing(at, similarity);
  let first = 0;
  while (first < bulge.length && (lines[first] as number) < programLine - LINES_BEFORE) first++;
  let best = line.clock[Math.min(first, bulge.length)] ?? 0;
  let least = Number.POSITIVE_INFINITY;
  for (let row = first; row < bulge.length; row++) {
    if ((lines[row] as number) > programLine + LINES_AFTER) break;
    if (position === null || drawn === null) {
      if ((lines[row] as number) <= programLine) best = line.clock[row + 1] as number;
      continue;
    }
    const a = row * 4;
    const { distance, fraction } = nearestOnArc(
      drawn.x,
      drawn.y,
      pose[a] as number,
      pose[a + 1] as number,
      pose[a + 4] as number,
      pose[a + 5] as number,
      bulge[row] as number,
    );
    const rise =
      (pose[a + 2] as number) + ((pose[a + 6] as number) - (pose[a + 2] as number)) * fraction;
    // The height tells a cutting pass from the return above the board.
    const miss = distance + (atHeight ? Math.abs(rise - position[2]) : 0);
    if (miss < least - 1e-6) {
      least = miss;
      const start = line.clock[row] as number;
      best = start + ((line.clock[row + 1] as number) - start) * fraction;
    }
  }
  return best;
}
