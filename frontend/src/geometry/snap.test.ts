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

test("where two lines cross is a point, which is preferred to the middle of a line", () => {
  const cross = {
    ends: Float64Array.of(0, 0, 20, 20, 0, 18, 20, 2),
    bulge: Float64Array.of(0, 0),
  };
  const found = buildSnap(cross)({ x: 10.5, y: 10 }, 2);
  expect([found.kind, found.x, found.y]).toEqual(["crossing", 10, 10]);
});

test("the order of the kinds decides, and other kinds are no points", () => {
  // A circle of radius 2, whose ends are as near as its centre.
  const circle = {
    ends: Float64Array.of(-2, 0, 2, 0, 2, 0, -2, 0),
    bulge: Float64Array.of(1, 1),
  };
  expect(buildSnap(circle)({ x: 0.5, y: 0 }, 4).kind).toBe("end");
  const marks = buildSnap(circle, undefined, ["centre", "crossing", "end"]);
  expect(marks({ x: 0.5, y: 0 }, 4)).toEqual({ x: 0, y: 0, kind: "centre" });
  expect(buildSnap(circle, undefined, ["crossing"])({ x: 0, y: 2.5 }, 1).kind).toBe("edge");
});
