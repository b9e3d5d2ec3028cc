import { expect, test } from "vitest";
import type { Areas } from "../geometry/records";
import { areaShapes } from "./areas";

/** What triangles cover (mm²). */
function covered(corners: Float32Array): number {
  let twice = 0;
  for (let at = 0; at < corners.length; at += 6) {
    const [x0 = 0, y0 = 0, x1 = 0, y1 = 0, x2 = 0, y2 = 0] = corners.subarray(at, at + 6);
    twice += Math.abs((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0));
  }
  return twice / 2;
}

const shapes = (areas: Areas) =>
  areaShapes(areas, { x: 100, y: 100 }, [255, 0, 0, 100], [255, 0, 0, 255]);

/** What a disc of 3 mm leaves in a corner at (100, 100): down, along, and back on the disc. */
const CORNER: Areas = {
  ends: Float64Array.of(100, 103, 100, 100, 100, 100, 103, 100, 103, 100, 100, 103),
  bulge: Float64Array.of(0, 0, -Math.tan(Math.PI / 8)),
  first: Int32Array.of(0, 3),
  size: Float64Array.of(9 * (1 - Math.PI / 4)),
};

test("the corner that a disc leaves is filled, and no more", () => {
  const { bands, rims } = shapes(CORNER);
  expect(covered(bands.corners)).toBeCloseTo(9 * (1 - Math.PI / 4), 1);
  expect(bands.count * 6).toBe(bands.corners.length);
  expect(bands.colour.length).toBe(bands.count * 12);
  // Two sides and the chords of a quarter.
  expect(rims.count).toBeGreaterThan(6);
});

test("a shape that goes in and out again is filled in both its arms", () => {
  const u = [0, 0, 9, 0, 9, 9, 6, 9, 6, 3, 3, 3, 3, 9, 0, 9];
  const ends = u.flatMap((_, at) =>
    at % 2 ? [] : [u[at], u[at + 1], u[(at + 2) % 16], u[(at + 3) % 16]],
  ) as number[];
  const { bands } = shapes({
    ends: Float64Array.from(ends),
    bulge: new Float64Array(8),
    first: Int32Array.of(0, 8),
    size: Float64Array.of(63),
  });
  expect(covered(bands.corners)).toBeCloseTo(63, 4);
});

test("no areas are no bands", () => {
  const none = { ends: new Float64Array(0), bulge: new Float64Array(0), size: new Float64Array(0) };
  const { bands, rims } = shapes({ ...none, first: Int32Array.of(0) });
  expect([bands.count, rims.count]).toEqual([0, 0]);
});
