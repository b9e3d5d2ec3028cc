import { expect, test } from "vitest";
import { marksOf } from "./marks";

test("a circle of two arcs and a cross are one mark each", () => {
  const ends = new Float64Array([
    ...[2, 0, -2, 0, -2, 0, 2, 0],
    ...[95, 50, 105, 50, 100, 45, 100, 55],
    ...[0, 200, 10, 200],
  ]);
  const segments = { ends, bulge: new Float64Array([1, 1, 0, 0, 0]) };
  const marks = marksOf(segments, [0, 1, 2, 3, 4]);
  expect(marks).toHaveLength(2);
  expect(marks[0]?.x).toBeCloseTo(0);
  expect(marks[0]?.y).toBeCloseTo(0);
  expect(marks[1]).toEqual({ x: 100, y: 50 });
  expect(marksOf(segments, [2, 4])).toEqual([]);
});
