import { expect, test } from "vitest";
import { footprint, vCutter } from "./footprint.fixture";
import { tipOf, tipOffset } from "./tip";

const V_CUTTER = tipOffset(vCutter(4, 1.5));

test("going due east the V-cutter's head is 4 to the right and 1.5 ahead of its tip", () => {
  const tip = tipOf({ x: 1.5, y: -4, z: 0, c: 0 }, V_CUTTER);
  expect(tip.x).toBeCloseTo(0, 12);
  expect(tip.y).toBeCloseTo(0, 12);
});

test("going due north it is 4 to the east and 1.5 to the north", () => {
  const tip = tipOf({ x: 4, y: 1.5, z: 0, c: 90 }, V_CUTTER);
  expect(tip.x).toBeCloseTo(0, 12);
  expect(tip.y).toBeCloseTo(0, 12);
});

test("the tip of a drag knife trails its head, that of a wheel is under it", () => {
  const trailing = tipOf({ x: 10, y: 0, z: 0, c: 0 }, tipOffset(footprint({ behind: 3 })));
  expect([trailing.x, trailing.y]).toEqual([7, 0]);
  const wheel = tipOf(
    { x: 10, y: 5, z: 0, c: 30 },
    tipOffset(footprint({ shape: "wheel", radius: 15 })),
  );
  expect([wheel.x, wheel.y]).toEqual([10, 5]);
});
