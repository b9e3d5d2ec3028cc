import { expect, test } from "vitest";
import { buildPickIndex } from "./pick";

/** A line along x = 0 … 100 and half a circle over it, centre (50, 0), radius 50. */
const SEGMENTS = {
  ends: Float64Array.of(0, 0, 100, 0, 100, 0, 0, 0),
  bulge: Float64Array.of(0, 1),
};

test("the nearest edge within reach is picked", () => {
  const index = buildPickIndex(SEGMENTS);
  expect(index.at(50, 2, 3)).toBe(0);
  expect(index.at(50, 48, 3)).toBe(1);
});

test("moves that lie on each other are pointed at together", () => {
  const index = buildPickIndex({
    ends: Float64Array.of(0, 0, 10, 0, 10, 0, 0, 0, 5, 1, 5, 1, 5, 4, 9, 4),
    bulge: Float64Array.of(0, 0, 0, 0),
  });
  expect(index.near(2, 0.25, 3, 0.5)).toEqual([0, 1]);
  expect(index.near(5, 0.5, 3, 0.5)).toEqual([0, 1, 2]);
  expect(index.near(5, 0.5, 3, 0.5, (row) => row !== 0)).toEqual([1, 2]);
  expect(index.near(50, 50, 3, 0.5)).toEqual([]);
});

test("inside an arc's box but far from the arc nothing is picked", () => {
  expect(buildPickIndex(SEGMENTS).at(50, 25, 3)).toBeNull();
});

test("what is hidden is not picked", () => {
  expect(buildPickIndex(SEGMENTS).at(50, 0, 3, (row) => row !== 0)).toBeNull();
});

test("a box chooses what lies wholly inside it", () => {
  const index = buildPickIndex(SEGMENTS);
  expect(index.inside([-1, -1, 101, 1])).toEqual([0]);
  expect(index.inside([-1, -1, 101, 51]).sort()).toEqual([0, 1]);
});

test("an empty drawing has nothing to pick", () => {
  const index = buildPickIndex({ ends: new Float64Array(), bulge: new Float64Array() });
  expect(index.at(0, 0, 10)).toBeNull();
});
