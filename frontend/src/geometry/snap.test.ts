import { expect, test } from "vitest";
import { buildSnap } from "./snap";

/** A line along x = 0 … 100 and half a circle over it, centre (50, 0), radius 50. */
const SEGMENTS = {
  ends: Float64Array.of(0, 0, 100, 0, 100, 0, 0, 0),
  bulge: Float64Array.of(0, 1),
};

test("ends are preferred to nearer middles and centres", () => {
  const snap = buildSnap(SEGMENTS);
  expect(snap({ x: 1, y: 1 }, 3)).toEqual({ x: 0, y: 0, kind: "end" });
  expect(snap({ x: 48, y: 0 }, 60).kind).toBe("end");
});

test("the middle of an arc and the centre of its circle are points", () => {
  const snap = buildSnap(SEGMENTS, (row) => row === 1);
  const top = snap({ x: 51, y: 49 }, 3);
  expect(
    [top.kind, top.x, top.y].map((one) => (typeof one === "number" ? Math.round(one) : one)),
  ).toEqual(["middle", 50, 50]);
  expect(snap({ x: 50, y: 1 }, 3).kind).toBe("centre");
});

test("elsewhere the nearest point of an edge is taken, or the place itself", () => {
  const snap = buildSnap(SEGMENTS);
  expect(snap({ x: 20, y: 2 }, 3)).toEqual({ x: 20, y: 0, kind: "edge" });
  expect(snap({ x: 20, y: 8 }, 3)).toEqual({ x: 20, y: 8, kind: "free" });
});

test("edges that are not shown are no points", () => {
  const snap = buildSnap(SEGMENTS, (row) => row === 1);
  expect(snap({ x: 20, y: 0 }, 3).kind).toBe("free");
});

test("a drawing without edges has no points", () => {
  const snap = buildSnap({ ends: new Float64Array(), bulge: new Float64Array() });
  expect(snap({ x: 1, y: 2 }, 3)).toEqual({ x: 1, y: 2, kind: "free" });
});
