import { expect, test } from "vitest";
import { cornersOnDrawing, posesOnDrawing, similarityOf } from "./similarity";

test("a pose on a turned sheet is one on the drawing", () => {
  // A quarter turn with scale 2: (1, 0) comes to (10, 22).
  const [x, y, z, c] = posesOnDrawing(new Float64Array([10, 22, 3, 100]), [0, 2, 10, 20]);
  expect([x, y, z, c]).toEqual([1, 0, 3, 10]);
});

test("a table lies turned about a sheet that lies turned on it", () => {
  // The sheet is turned by 30° and shifted, so the table is turned by −30° about it.
  const [a, b] = [Math.cos(Math.PI / 6), Math.sin(Math.PI / 6)];
  const corners = cornersOnDrawing([0, 0, 200, 100], [a, b, 30, 40]);
  const back = corners.map(({ x, y }) => [a * x - b * y + 30, b * x + a * y + 40]);
  for (const [at, corner] of [
    [0, 0],
    [200, 0],
    [200, 100],
    [0, 100],
  ].entries())
    for (const axis of [0, 1]) expect(back[at]?.[axis]).toBeCloseTo(corner[axis] as number, 9);
  const side = {
    x: (corners[1]?.x ?? 0) - (corners[0]?.x ?? 0),
    y: (corners[1]?.y ?? 0) - (corners[0]?.y ?? 0),
  };
  expect((Math.atan2(side.y, side.x) * 180) / Math.PI).toBeCloseTo(-30, 9);
});

test("other metadata is no similarity", () => {
  expect([similarityOf(null), similarityOf([1, 2]), similarityOf([1, 0, 5, 6])]).toEqual([
    null,
    null,
    [1, 0, 5, 6],
  ]);
});
