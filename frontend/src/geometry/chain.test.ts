import { expect, test } from "vitest";
import { chainOf } from "./chain";

const all = () => true;
const segments = (...lines: [number, number, number, number][]) => ({
  ends: Float64Array.from(lines.flat()),
  bulge: new Float64Array(lines.length),
});

test("a run goes on in both directions, whichever way its edges are drawn", () => {
  const run = segments([0, 0, 1, 0], [2, 0, 1, 0.01], [2, 0, 3, 0], [5, 0, 6, 0]);
  expect(chainOf(run, [1], all)).toEqual([0, 1, 2]);
  expect(chainOf(run, [3, 0], all)).toEqual([0, 1, 2, 3]);
});

test("a run stops where three edges meet, unless one of them does not count", () => {
  const branch = segments([0, 0, 1, 0], [1, 0, 2, 0], [1, 0, 1, 5]);
  expect(chainOf(branch, [0], all)).toEqual([0]);
  expect(chainOf(branch, [0], (row) => row !== 2)).toEqual([0, 1]);
});

test("a closed run ends where it begins", () => {
  const square = segments([0, 0, 1, 0], [1, 0, 1, 1], [1, 1, 0, 1], [0, 1, 0, 0]);
  expect(chainOf(square, [2], all)).toEqual([0, 1, 2, 3]);
});

test("a row that is not accepted has no run", () => {
  expect(chainOf(segments([0, 0, 1, 0]), [0], () => false)).toEqual([]);
});

test("a long run is followed without recursion", () => {
  const count = 20_000;
  const long = segments(
    ...Array.from({ length: count }, (_, at): [number, number, number, number] => [
      at,
      0,
      at + 1,
      0,
    ]),
  );
  expect(chainOf(long, [count / 2], all)).toHaveLength(count);
});
