import { expect, test } from "vitest";
import type { Edges } from "../../geometry/records";
import { addCorner, cornerNear, DEFAULT_CORNERS, setCornerK, setCornerType } from "./corners";

test("a click on a cut means its nearer end, and a crease has no corner", () => {
  const edges = {
    ends: Float64Array.of(0, 0, 100, 0, 0, 50, 100, 50),
    lineType: Uint8Array.of(1, 2),
  } as unknown as Edges;
  expect(cornerNear(edges, 0, { x: 70, y: 3 })).toEqual({ x: 100, y: 0 });
  expect(cornerNear(edges, 0, { x: 20, y: -3 })).toEqual({ x: 0, y: 0 });
  expect(cornerNear(edges, 1, { x: 20, y: 50 })).toBeNull();
});

test("a corner is chosen once, changed and taken back", () => {
  const one = addCorner(DEFAULT_CORNERS, { x: 100, y: 0 });
  expect(one.at).toEqual([{ x: 100, y: 0, type: "C", k: null }]);
  expect(addCorner(one, { x: 100.2, y: 0 })).toBe(one);
  const d = setCornerK(setCornerType(one, 0, "D"), 0, 0.3);
  expect(d.at).toEqual([{ x: 100, y: 0, type: "D", k: 0.3 }]);
  expect(setCornerType(d, 0, null).at).toEqual([]);
});

test("a corner that is clicked differs from the rest", () => {
  const rest = { ...DEFAULT_CORNERS, type: "C" } as const;
  expect(addCorner(rest, { x: 0, y: 0 }).at[0]?.type).toBe("B");
});
