import { expect, test } from "vitest";
import { addedCircle, movedEnds } from "./edits";

/** Two lines that meet at (100, 0). */
const SEGMENTS = {
  ends: Float64Array.of(0, 0, 100, 0, 100, 0, 100, 50),
  bulge: Float64Array.of(0, 0),
};

test("all ends at a point are moved", () => {
  const moved = movedEnds(SEGMENTS, { x: 100, y: 0 }, { x: 90, y: 5 }, new Set());
  expect(moved).toEqual([
    { kind: "move-end", edge: 0, end: "end", before: [100, 0], to: [90, 5] },
    { kind: "move-end", edge: 1, end: "start", before: [100, 0], to: [90, 5] },
  ]);
});

test("of selected edges only the selected ones are moved", () => {
  const moved = movedEnds(SEGMENTS, { x: 100, y: 0 }, { x: 90, y: 5 }, new Set([1]));
  expect(moved.map((edit) => edit.kind === "move-end" && edit.edge)).toEqual([1]);
});

test("a circle is given by its centre and a point", () => {
  expect(addedCircle({ x: 1, y: 2 }, { x: 4, y: 6 }, "cut")).toMatchObject({
    centre: [1, 2],
    radius: 5,
  });
});
