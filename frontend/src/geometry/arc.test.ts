import { describe, expect, test } from "vitest";
import { arcLength, circleOf, flattenArc, nearestOnArc, pointAt } from "./arc";
import { boxOf } from "./bounds";
import { mm } from "./units";

/** Half a circle about (10, 0) with radius 10, to the left from (20, 0): over the top. */
const HALF = [20, 0, 0, 0, 1] as const;
/** A quarter about (0, 0) with radius 10, from (10, 0) to (0, 10). */
const QUARTER = [10, 0, 0, 10, Math.tan(Math.PI / 8)] as const;

const vertices = (arc: readonly [number, number, number, number, number], tolerance: number) => {
  const found: [number, number][] = [[arc[0], arc[1]]];
  flattenArc(...arc, mm(tolerance), (x, y) => found.push([x, y]));
  return found;
};

describe("arcs to vertices", () => {
  test.each([0.1, 0.01, 0.001])("chords stay within %f mm of the arc", (tolerance) => {
    const found = vertices(HALF, tolerance);
    let worst = 0;
    for (let at = 1; at < found.length; at++) {
      const [a, b] = [found[at - 1], found[at]];
      if (a === undefined || b === undefined) continue;
      const sagitta = 10 - Math.hypot((a[0] + b[0]) / 2 - 10, (a[1] + b[1]) / 2);
      worst = Math.max(worst, sagitta);
    }
    expect(worst).toBeLessThanOrEqual(tolerance);
    // The number of chords is close to the least.
    expect(worst).toBeGreaterThan(tolerance * 0.8);
  });

  test("every vertex lies on the arc and the last is its end", () => {
    const found = vertices(QUARTER, 0.01);
    for (const [x, y] of found) expect(Math.hypot(x, y)).toBeCloseTo(10, 12);
    expect(found.at(-1)).toEqual([0, 10]);
  });

  test("a line has no vertices between its ends", () => {
    expect(vertices([0, 0, 30, 40, 0], 0.01)).toEqual([
      [0, 0],
      [30, 40],
    ]);
  });

  test("a left arc from east to west goes over the top, a right one below", () => {
    expect(pointAt(...HALF, 0.5)[1]).toBeCloseTo(10, 12);
    expect(pointAt(20, 0, 0, 0, -1, 0.5)[1]).toBeCloseTo(-10, 12);
  });

  test("half a circle of radius 10 is 31.4 mm long and has that radius", () => {
    expect(arcLength(...HALF)).toBeCloseTo(10 * Math.PI, 12);
    expect(circleOf(...HALF)?.radius).toBe(10);
    expect(circleOf(0, 0, 30, 40, 0)).toBeNull();
  });
});

describe("boxes", () => {
  test("an arc's box holds its belly", () => {
    const [low, bottom, high, top] = boxOf(...HALF);
    expect([low, bottom, high]).toEqual([0, 0, 20]);
    expect(top).toBeCloseTo(10, 12);
  });

  test("a quarter that ends on the axes has no belly", () => {
    const [low, bottom, high, top] = boxOf(...QUARTER);
    expect(low).toBeCloseTo(0, 12);
    expect(bottom).toBeCloseTo(0, 12);
    expect(high).toBeCloseTo(10, 12);
    expect(top).toBeCloseTo(10, 12);
  });
});

describe("nearest", () => {
  test("from the centre every place of the arc is a radius away", () => {
    expect(nearestOnArc(10, 0, ...HALF).distance).toBeCloseTo(10, 12);
  });

  test("outside the sweep it is the nearer end", () => {
    // Below the half circle: (3, -4) is 5 from (0, 0) and further from (20, 0).
    expect(nearestOnArc(3, -4, ...HALF)).toEqual({ distance: expect.closeTo(5, 12), fraction: 1 });
    expect(nearestOnArc(17, -4, ...HALF)).toEqual({ distance: expect.closeTo(5, 12), fraction: 0 });
  });

  test("beside a line it is the foot of the perpendicular", () => {
    expect(nearestOnArc(30, 7, 0, 0, 100, 0, 0)).toEqual({ distance: 7, fraction: 0.3 });
    expect(nearestOnArc(-3, 4, 0, 0, 100, 0, 0)).toEqual({ distance: 5, fraction: 0 });
  });
});
