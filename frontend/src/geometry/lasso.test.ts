import { expect, test } from "vitest";
import { isInside, rowsInside } from "./lasso";

const place = (x: number, y: number) => ({ x, y });
/** A U of 10 by 10 mm with a notch from above. */
const NOTCHED = [
  place(0, 0),
  place(10, 0),
  place(10, 10),
  place(7, 10),
  place(7, 3),
  place(3, 3),
  place(3, 10),
  place(0, 10),
];

test("a place in the notch is outside", () => {
  expect(isInside(NOTCHED, 5, 1)).toBe(true);
  expect(isInside(NOTCHED, 5, 8)).toBe(false);
  expect(isInside(NOTCHED, 11, 1)).toBe(false);
  expect(isInside([], 0, 0)).toBe(false);
});

test("an edge that leaves the polygon is not inside, although both ends are", () => {
  const lines = {
    ends: Float64Array.of(1, 8, 9, 8, 1, 1, 9, 1, 1, 1, 20, 1),
    bulge: Float64Array.of(0, 0, 0),
  };
  expect(rowsInside(lines, [0, 1, 2], NOTCHED)).toEqual([1]);
});

test("an arc that bulges out of the polygon is not inside", () => {
  const arcs = {
    ends: Float64Array.of(1, 1, 9, 1, 1, 1, 9, 1),
    // A half circle below y = 0, and a shallow arc.
    bulge: Float64Array.of(1, 0.01),
  };
  expect(rowsInside(arcs, [0, 1], NOTCHED)).toEqual([1]);
});
