import { expect, test } from "vitest";
import { measure } from "./measure";

test("a measurement has distance, parts along the axes and angle", () => {
  expect(measure({ x: 1, y: 1 }, { x: -2, y: 5 })).toMatchObject({ distance: 5, dx: -3, dy: 4 });
  expect(measure({ x: 0, y: 0 }, { x: 0, y: -2 }).angle).toBe(-90);
});
