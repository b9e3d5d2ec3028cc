import { describe, expect, test } from "vitest";
import type { Toolpath } from "./records";
import { buildTimeline, poseAt, timeOf, totalSeconds } from "./timeline";

/** Down 12 mm in 1 s, 100 mm east in 10 s, half a circle of radius 10 to the left in π s, up. */
const PATH: Toolpath = {
  pose: Float64Array.of(
    ...[0, 0, 12, 0],
    ...[0, 0, 0, 0],
    ...[100, 0, 0, 0],
    ...[100, 20, 0, 180],
    ...[100, 20, 12, 180],
  ),
  bulge: Float64Array.of(0, 0, 1, 0),
  motion: Uint8Array.of(1, 3, 3, 6),
  feed: Float64Array.of(720, 600, 600, 720),
  source: Int32Array.of(-1, 0, 1, -1),
  tool: Uint8Array.of(1, 1, 1, 1),
  line: Int32Array.of(10, 11, 12, 13),
  placement: [0, 0],
};
const LINE = buildTimeline(PATH);

describe("timeline", () => {
  test("lasts as long as its lengths over its feeds", () => {
    expect(totalSeconds(LINE)).toBeCloseTo(1 + 10 + Math.PI + 1, 9);
  });

  test("the head is half way along the line after half its time", () => {
    expect(poseAt(LINE, 6)).toEqual({ x: 50, y: 0, z: 0, c: 0 });
  });

  test("half way round the arc it is on the arc, half turned", () => {
    const pose = poseAt(LINE, 11 + Math.PI / 2);
    expect(pose?.x).toBeCloseTo(110, 9);
    expect(pose?.y).toBeCloseTo(10, 9);
    expect(pose?.c).toBeCloseTo(90, 9);
  });

  test("before the start and after the end it stays there", () => {
    expect(poseAt(LINE, -5)?.z).toBe(12);
    expect(poseAt(LINE, 1e6)).toEqual({ x: 100, y: 20, z: 12, c: 180 });
  });

  test("an empty toolpath has no place for a head", () => {
    const empty = buildTimeline({
      ...PATH,
      pose: new Float64Array(4),
      bulge: new Float64Array(),
    });
    expect(poseAt(empty, 0)).toBeNull();
  });
});

describe("a reported position", () => {
  test("becomes the time at which the head passes it", () => {
    expect(timeOf(LINE, 11, [50, 0, 0, 0])).toBeCloseTo(6, 9);
    expect(timeOf(LINE, 12, [110, 10, 0, 90])).toBeCloseTo(11 + Math.PI / 2, 9);
  });

  test("a position on a sheet that lies turned is found on the drawing", () => {
    // A quarter turn, then 300 to the right: (50, 0) comes to (300, 50).
    const turned = buildTimeline({ ...PATH, similarity: [0, 1, 300, 0] });
    expect(timeOf(turned, 11, [300, 50, 0, 90])).toBeCloseTo(6, 9);
  });

  test("beside the path still becomes the nearest time", () => {
    expect(timeOf(LINE, 11, [50, 0.4, 0, 0])).toBeCloseTo(6, 9);
  });

  test("is looked for near its program line, where a path passes a place twice", () => {
    const moves = 100;
    const there = Array.from({ length: moves + 1 }, (_, at) => [(at % 2) * 100, 0, 0, 0]);
    const twice: Toolpath = {
      ...PATH,
      pose: Float64Array.from(there.flat()),
      bulge: new Float64Array(moves),
      motion: new Uint8Array(moves).fill(3),
      feed: new Float64Array(moves).fill(600),
      line: Int32Array.from({ length: moves }, (_, at) => at + 1),
    };
    // Move 61 (row 60) begins after 600 s.
    const found = timeOf(buildTimeline(twice), 63, [50, 0, 0, 0]);
    expect(found).toBeCloseTo(605 - 10, 6);
  });

  test("without a position it is the end of the line", () => {
    expect(timeOf(LINE, 11, null)).toBeCloseTo(11, 9);
  });
});
