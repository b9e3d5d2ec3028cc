import { expect, test } from "vitest";
import { posesOnDrawing, similarityOf } from "./similarity";

test("a pose on a turned sheet is one on the drawing", () => {
  // A quarter turn with scale 2: (1, 0) comes to (10, 22).
  const [x, y, z, c] = posesOnDrawing(new Float64Array([10, 22, 3, 100]), [0, 2, 10, 20]);
  expect([x, y, z, c]).toEqual([1, 0, 3, 10]);
});

test("other metadata is no similarity", () => {
  expect([similarityOf(null), similarityOf([1, 2]), similarityOf([1, 0, 5, 6])]).toEqual([
    null,
    null,
    [1, 0, 5, 6],
  ]);
});
