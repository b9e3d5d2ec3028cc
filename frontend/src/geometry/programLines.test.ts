import { describe, expect, test } from "vitest";
import { linesAt, timeOfLine } from "./programLines";
import type { Toolpath } from "./records";
import { buildTimeline, poseAt, rowAt } from "./timeline";

/** Four moves: line 10, no line, lines 12 to 15 of a curve in chords, and line 17. */
const PATH: Toolpath = {
  pose: Float64Array.of(
    ...[0, 0, 12, 0],
    ...[0, 0, 0, 0],
    ...[0, 0, 0, 0],
    ...[100, 0, 0, 0],
    ...[100, 0, 12, 0],
  ),
  bulge: new Float64Array(4),
  motion: Uint8Array.of(1, 4, 3, 6),
  feed: Float64Array.of(720, 600, 600, 720),
  source: Int32Array.of(-1, -1, 1, -1),
  tool: Uint8Array.of(1, 1, 1, 1),
  line: Int32Array.of(10, -1, 15, 17),
  firstLine: Int32Array.of(10, -1, 12, 17),
  seconds: Float64Array.of(1, 0.5, 8, 2),
  placement: [0, 0],
};
const LINE = buildTimeline(PATH);

describe("lines of a program", () => {
  test("the clock is that of the machine", () => {
    expect([...LINE.clock]).toEqual([0, 1, 1.5, 9.5, 11.5]);
  });

  test("a time is in the lines of its move, and in one of its chords", () => {
    expect(linesAt(LINE, 0.5)).toEqual({ first: 10, last: 10, current: 10 });
    // A move without a line belongs to the line before.
    expect(linesAt(LINE, 1.2)).toEqual({ first: 10, last: 10, current: 10 });
    expect(linesAt(LINE, 1.6)).toEqual({ first: 12, last: 15, current: 12 });
    expect(linesAt(LINE, 5.6)).toEqual({ first: 12, last: 15, current: 14 });
    expect(linesAt(LINE, 99)?.current).toBe(17);
  });

  test("each line that moves has a time in it, at the end of its move", () => {
    for (const line of [10, 12, 13, 14, 15, 17])
      expect(linesAt(LINE, timeOfLine(LINE, line))?.current).toBe(line);
    expect(poseAt(LINE, timeOfLine(LINE, 13))?.x).toBeCloseTo(50, 3);
    expect(rowAt(LINE, timeOfLine(LINE, 15))).toBe(2);
  });

  test("a line without a move shows where the next move begins", () => {
    expect(timeOfLine(LINE, 1)).toBe(0);
    expect(timeOfLine(LINE, 11)).toBe(1.5);
    expect(timeOfLine(LINE, 16)).toBe(9.5);
    expect(timeOfLine(LINE, 400)).toBe(11.5);
  });

  test("the job of an older version knows the last line of each move", () => {
    const { firstLine: _, seconds: __, ...older } = PATH;
    const line = buildTimeline(older);
    expect(linesAt(line, timeOfLine(line, 15))).toEqual({ first: 15, last: 15, current: 15 });
    expect(timeOfLine(line, 12)).toBe(line.clock[2]);
  });
});
