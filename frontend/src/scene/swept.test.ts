import { describe, expect, test } from "vitest";
import type { Footprint } from "../geometry/footprint";
import { footprint, vCutter } from "../geometry/footprint.fixture";
import { MOTIONS, type Motion, type Toolpath } from "../geometry/records";
import { sweepOf } from "../geometry/sweep";
import { tipOffset } from "../geometry/tip";
import { motionMarks } from "./marks";
import { type Bands, sweptShapes, type Tools } from "./swept";

const INK = [1, 2, 3, 4] as const;
const COLOURS = { cutter: INK, groove: INK, crease: INK, groovesRim: INK, contact: INK };
const ORIGIN = { x: 0, y: 0 };

interface Stop {
  readonly pose: readonly [number, number, number, number];
  readonly motion?: Motion;
  readonly bulge?: number;
}

/** A path from the first stop to the last, all with one tool, on a sheet that begins at (5, 5). */
function path(...stops: readonly Stop[]): Toolpath {
  const moves = stops.slice(1);
  return {
    pose: Float64Array.from(stops.flatMap(({ pose: [x, y, z, c] }) => [x + 5, y + 5, z, c])),
    bulge: Float64Array.from(moves, ({ bulge }) => bulge ?? 0),
    motion: Uint8Array.from(moves, ({ motion }) => MOTIONS.indexOf(motion ?? "feed")),
    feed: new Float64Array(moves.length).fill(6000),
    source: new Int32Array(moves.length),
    tool: new Uint8Array(moves.length).fill(1),
    line: Int32Array.from(moves.keys()),
    placement: [5, 5],
  };
}

function toolOf(of: Footprint, caliper = 2): Tools {
  const sweep = sweepOf(of);
  if (sweep === null) throw new Error(`${of.shape} sweeps nothing`);
  return {
    sweeps: new Map([[1, sweep]]),
    offsets: new Map([[1, tipOffset(of)]]),
    caliper,
  };
}

/** Whether a point lies in one of the triangles. */
function covers({ count, corners }: Bands, x: number, y: number): boolean {
  for (let at = 0; at < count; at++) {
    const [ax = 0, ay = 0, bx = 0, by = 0, cx = 0, cy = 0] = corners.slice(at * 6, at * 6 + 6);
    const sides = [
      (bx - ax) * (y - ay) - (by - ay) * (x - ax),
      (cx - bx) * (y - by) - (cy - by) * (x - bx),
      (ax - cx) * (y - cy) - (ay - cy) * (x - cx),
    ];
    if (sides.every((side) => side >= 0) || sides.every((side) => side <= 0)) return true;
  }
  return false;
}

describe("a cutter of radius 3", () => {
  const cutter = toolOf(footprint({ shape: "disc", radius: 3 }));

  test("removes a disc all along its way, round at both ends", () => {
    const { bands } = sweptShapes(
      path({ pose: [0, 0, -0.3, 0] }, { pose: [100, 0, -0.3, 0] }),
      ORIGIN,
      cutter,
      COLOURS,
    );
    for (const [x, y] of [
      [50, 2.9],
      [50, -2.9],
      [-2.9, 0],
      [102.9, 0],
    ] as const)
      expect(covers(bands, x, y)).toBe(true);
    for (const [x, y] of [
      [50, 3.1],
      [-3.1, 0],
      [102.5, 2.5],
    ] as const)
      expect(covers(bands, x, y)).toBe(false);
  });

  test("removes a ring along an arc of radius 10", () => {
    // Half a turn to the left about (0, 10).
    const { bands } = sweptShapes(
      path({ pose: [0, 0, -0.3, 0] }, { pose: [0, 20, -0.3, 0], bulge: 1 }),
      ORIGIN,
      cutter,
      COLOURS,
    );
    expect(covers(bands, 12.9, 10)).toBe(true);
    expect(covers(bands, 7.1, 10)).toBe(true);
    expect(covers(bands, 13.1, 10)).toBe(false);
    expect(covers(bands, 6.9, 10)).toBe(false);
    expect(covers(bands, -2.9, 0)).toBe(true);
  });

  test("removes nothing above the board, nor in a rapid", () => {
    const above = path({ pose: [0, 0, 2, 0] }, { pose: [9, 0, 2, 0] });
    const rapid = path({ pose: [0, 0, 1, 0] }, { pose: [9, 0, 1, 0], motion: "rapid" });
    for (const toolpath of [above, rapid])
      expect(sweptShapes(toolpath, ORIGIN, cutter, COLOURS).bands.count).toBe(0);
  });

  test("needs no disc where it runs on, and one where it turns", () => {
    const count = (...stops: Stop[]) =>
      sweptShapes(path({ pose: [0, 0, 0, 0] }, ...stops), ORIGIN, cutter, COLOURS).bands.count;
    const one = count({ pose: [10, 0, 0, 0] });
    expect(count({ pose: [10, 0, 0, 0] }, { pose: [20, 0, 0, 0] })).toBe(one + 2);
    expect(count({ pose: [10, 0, 0, 0] }, { pose: [10, 9, 0, 0] })).toBeGreaterThan(one + 20);
  });
});

describe("a V-cutter at 45 degrees, 1.3 mm deep", () => {
  const cutter = toolOf(vCutter(6, 1.5));
  // Its tip goes from (0, 0) to (100, 0): the head 6 to the right and 1.5 ahead.
  const pass = path({ pose: [1.5, -6, 0.7, 0] }, { pose: [101.5, -6, 0.7, 0] });
  const { bands, rims } = sweptShapes(pass, ORIGIN, cutter, COLOURS);

  test("cuts the flank on the right, as wide as it is deep", () => {
    expect(covers(bands, 50, -1.29)).toBe(true);
    expect(covers(bands, 50, -1.31)).toBe(false);
    expect(covers(bands, 50, 0.01)).toBe(false);
  });

  test("cuts on by the blade's width past the end, and begins at the tip", () => {
    expect(covers(bands, 102.9, -0.5)).toBe(true);
    expect(covers(bands, 103.1, -0.5)).toBe(false);
    expect(covers(bands, -0.1, -0.5)).toBe(false);
  });

  test("has its rim drawn", () => {
    expect([...rims.ends].map((value) => Math.round(value * 1e4) / 1e4)).toEqual([
      0, -1.3, 103, -1.3,
    ]);
  });

  test("makes the other flank on the way back", () => {
    const back = path({ pose: [98.5, 6, 0.7, 180] }, { pose: [-1.5, 6, 0.7, 180] });
    const other = sweptShapes(back, ORIGIN, cutter, COLOURS).bands;
    expect(covers(other, 50, 1.29)).toBe(true);
    expect(covers(other, 50, -0.01)).toBe(false);
  });
});

describe("a wheel of radius 13, 1 mm deep", () => {
  const wheel = toolOf(footprint({ shape: "wheel", radius: 13, width: 0.7 }));

  test("touches 5 mm past where its lowest point stops, marked at both ends", () => {
    const { bands, rims } = sweptShapes(
      path({ pose: [10, 0, 1, 0] }, { pose: [90, 0, 1, 0] }),
      ORIGIN,
      wheel,
      COLOURS,
    );
    expect(covers(bands, 5.1, 0.3)).toBe(true);
    expect(covers(bands, 94.9, -0.3)).toBe(true);
    expect(covers(bands, 4.9, 0)).toBe(false);
    expect(covers(bands, 50, 0.4)).toBe(false);
    expect(rims.count).toBe(2);
    expect([rims.ends[0], rims.ends[4]]).toEqual([5, 95]);
  });

  test("is marked once at each end of a crease of two pieces", () => {
    const two = path({ pose: [10, 0, 1, 0] }, { pose: [50, 0, 1, 0] }, { pose: [90, 0, 1, 0] });
    expect(sweptShapes(two, ORIGIN, wheel, COLOURS).rims.count).toBe(2);
  });

  test("presses a short crease on the spot, along C", () => {
    const { bands, rims } = sweptShapes(
      path(
        { pose: [10, 0, 9, 90] },
        { pose: [10, 0, 1, 90], motion: "plunge" },
        { pose: [10, 0, 9, 90], motion: "lift" },
      ),
      ORIGIN,
      wheel,
      COLOURS,
    );
    expect(rims.count).toBe(2);
    expect(covers(bands, 10, 4.9)).toBe(true);
    expect(covers(bands, 14, 0)).toBe(false);
  });
});

test("plunges, swivels and lifts are dots where the tool is down", () => {
  const toolpath = path(
    { pose: [0, 0, 9, 0] },
    { pose: [1, 0, 0, 0], motion: "plunge" },
    { pose: [10, 0, 0, 0] },
    { pose: [10, 0, 0, 90], motion: "swivel" },
    { pose: [11, 0, 9, 90], motion: "lift" },
  );
  const marks = motionMarks(toolpath, ORIGIN, { plunge: INK, lift: INK, swivel: INK });
  expect([...marks.plunge.ends]).toEqual([1, 0, 1, 0]);
  expect([...marks.swivel.ends]).toEqual([10, 0, 10, 0]);
  expect([...marks.lift.ends]).toEqual([10, 0, 10, 0]);
  expect(marks.lift.row[0]).toBe(3);
});
