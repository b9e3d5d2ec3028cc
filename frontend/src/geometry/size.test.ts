import { expect, test } from "vitest";
import { sizeOf } from "./size";

/** A line of 5 mm, the two halves of a circle of radius 2 about (10, 0), and another arc. */
const SEGMENTS = {
  ends: Float64Array.of(0, 0, 3, 4, 8, 0, 12, 0, 12, 0, 8, 0, 0, 0, 2, 0),
  bulge: Float64Array.of(0, 1, 1, 1),
};

test("one line has a length", () => {
  expect(sizeOf(SEGMENTS, [0])).toEqual({
    kind: "line",
    from: { x: 0, y: 0 },
    to: { x: 3, y: 4 },
    length: 5,
  });
});

test("the arcs of one circle have its radius", () => {
  expect(sizeOf(SEGMENTS, [1])).toMatchObject({ kind: "arc", radius: 2, at: { y: -2 } });
  expect(sizeOf(SEGMENTS, [1, 2])).toMatchObject({ kind: "arc", centre: { x: 10, y: 0 } });
});

test("other edges have a box", () => {
  expect(sizeOf(SEGMENTS, [0, 1])).toEqual({ kind: "box", box: [0, -2, 12, 4] });
  expect(sizeOf(SEGMENTS, [1, 3])?.kind).toBe("box");
  expect(sizeOf(SEGMENTS, [])).toBeNull();
});
