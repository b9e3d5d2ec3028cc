import { expect, test } from "vitest";
import { type Hinge, IDENTITY, type Matrix, panelTransforms, turnAbout } from "./fold";

const moved = (matrix: Matrix, point: readonly number[]) =>
  [0, 1, 2].map((row) =>
    [...point, 1].reduce((sum, value, k) => sum + value * (matrix[4 * row + k] ?? 0), 0),
  );

const near = (found: readonly number[], expected: readonly number[]) =>
  expected.forEach((value, k) => {
    expect(found[k]).toBeCloseTo(value, 9);
  });

test("what lies on the left of an axis rises", () => {
  const turn = turnAbout([0, 0, 0], [10, 0, 0], 90);
  near(moved(turn, [5, 20, 0]), [5, 0, 20]);
  near(moved(turn, [3, 0, 0]), [3, 0, 0]);
  near(moved(turnAbout([0, 0, 1], [10, 0, 1], -90), [5, 20, 1]), [5, 0, -19]);
});

test("a chain of two panels turns by the sum of its angles", () => {
  // Panel 1 ends at y = 0; panels 2 and 3 follow, each 10 mm long, upwards in the drawing.
  const fold = (number: number, y: number): Hinge => ({
    number,
    parent: number,
    child: number + 1,
    axis: [
      [0, y, 0],
      [10, y, 0],
    ],
  });
  const [root, wall, lid] = panelTransforms(3, [fold(1, 0), fold(2, 10)], [1, 2], () => 90);
  expect(root).toEqual(IDENTITY);
  near(moved(wall ?? [], [0, 10, 0]), [0, 0, 10]);
  near(moved(lid ?? [], [4, 20, 0]), [4, -10, 10]);
});

test("panels of no fold stay in place", () => {
  expect(panelTransforms(2, [], [], () => 90)).toEqual([IDENTITY, IDENTITY]);
});
