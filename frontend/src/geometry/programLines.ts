/** The lines of a program and the times of its tool path, from one to the other. */

import { rowAt, type Timeline } from "./timeline";

/** Lines that make one move, and the one of them that is in progress; all from 1. */
export interface LinesOfMove {
  readonly first: number;
  readonly last: number;
  readonly current: number;
}

/** Ends of moves belong to the next one: a line is shown shortly before its end (s). */
const BEFORE_END = 1e-6;

/** First program line of a move; jobs of older versions know the last one only. */
const firstLineOf = ({ firstLine, line }: Timeline["toolpath"], row: number): number =>
  (firstLine ?? line)[row] ?? -1;

/** The lines of the move that is in progress at a time (s); null before the first one. */
export function linesAt(timeline: Timeline, seconds: number): LinesOfMove | null {
  const { clock, toolpath } = timeline;
  let row = rowAt(timeline, seconds);
  const made = row;
  // Moves without a line belong to the line before.
  while (row >= 0 && (toolpath.line[row] ?? -1) < 0) row--;
  if (row < 0) return null;
  const [first, last] = [firstLineOf(toolpath, row), toolpath.line[row] as number];
  const start = clock[row] as number;
  const span = (clock[row + 1] as number) - start;
  const share = made > row || span <= 0 ? 1 : Math.min(1, Math.max(0, (seconds - start) / span));
  const count = last - first + 1;
  return { first, last, current: Math.min(last, first + Math.floor(share * count)) };
}

/**
 * Time (s) at which a program line has been executed.
 *
 * For a line that moves nothing it is the time at which the next move begins.
 */
export function timeOfLine(timeline: Timeline, line: number): number {
  const { clock, toolpath } = timeline;
  const rows = toolpath.line.length;
  for (let row = 0; row < rows; row++) {
    const last = toolpath.line[row] as number;
    if (last < line) continue;
    const first = firstLineOf(toolpath, row);
    const start = clock[row] as number;
    if (line < first) return start;
    const span = (clock[row + 1] as number) - start;
    const end = start + (span * (line - first + 1)) / (last - first + 1);
    return Math.max(start, end - Math.min(BEFORE_END, span / 2));
  }
  return clock[rows] ?? 0;
}
