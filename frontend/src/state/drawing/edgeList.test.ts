import { expect, test } from "vitest";
import { type Edges, LINE_TYPES } from "../../geometry/records";
import { edgeState, listedRows, NO_LIST_FILTER, rangeOf } from "./edgeList";
import { movedPlace } from "./listKeys";

const type = (name: (typeof LINE_TYPES)[number]) => LINE_TYPES.indexOf(name);

const EDGES = {
  bulge: new Float64Array(5),
  lineType: Uint8Array.of(
    type("crease"),
    type("cut"),
    type("cut"),
    type("unclassified"),
    type("cut"),
  ),
  layer: Int32Array.of(0, 1, 2, 1, 0),
  layers: ["Layer 10", "Layer 9", "Ä"],
  length: Float64Array.of(5, 20, 10, 10, 1),
  rule: Int32Array.of(0, 0, 1, 0, 0),
  ruleCodes: ["classification.rule", "classification.override"],
  outcome: Uint8Array.of(0, 1, 0, 0, 2),
} as unknown as Edges;

const listed = (
  part: Partial<typeof NO_LIST_FILTER>,
  column: "row" | "length" | "layer" | "state" | "type" = "row",
  down = false,
) => listedRows(EDGES, { ...NO_LIST_FILTER, ...part }, { column, down });

test("the state of an edge", () => {
  expect([0, 1, 2, 3, 4].map((row) => edgeState(EDGES, row))).toEqual([
    "kept",
    "merged",
    "byHand",
    "undecided",
    "dropped",
  ]);
});

test("the list is sorted by any column, equal edges in the order of the drawing", () => {
  expect(listed({}, "length")).toEqual([4, 0, 2, 3, 1]);
  expect(listed({}, "length", true)).toEqual([1, 2, 3, 0, 4]);
  expect(listed({}, "layer")).toEqual([2, 1, 3, 0, 4]);
  expect(listed({}, "state")).toEqual([3, 2, 1, 4, 0]);
  expect(listed({}, "row", true)).toEqual([4, 3, 2, 1, 0]);
});

test("the list is filtered by line type, state, layer and number", () => {
  expect(listed({ type: "cut" })).toEqual([1, 2, 4]);
  expect(listed({ state: "merged" })).toEqual([1]);
  expect(listed({ text: " layer 1" })).toEqual([0, 4]);
  expect(listed({ text: "ä" })).toEqual([2]);
  expect(listed({ text: "3" })).toEqual([3]);
  expect(listed({ text: "cut", type: "crease" })).toEqual([]);
});

test("a range has both of its ends", () => {
  expect(rangeOf([7, 8, 9, 10], 2, 1)).toEqual([8, 9]);
  expect(rangeOf([7, 8, 9, 10], 0, 3)).toHaveLength(4);
});

test("keys move within the list", () => {
  expect(movedPlace("ArrowDown", -1, 5, 3)).toBe(0);
  expect(movedPlace("ArrowUp", 0, 5, 3)).toBe(0);
  expect(movedPlace("PageDown", 1, 5, 3)).toBe(4);
  expect(movedPlace("PageDown", 4, 5, 3)).toBe(4);
  expect(movedPlace("Home", 4, 5, 3)).toBe(0);
  expect(movedPlace("End", 0, 5, 3)).toBe(4);
  expect(movedPlace("x", 0, 5, 3)).toBeNull();
  expect(movedPlace("ArrowDown", -1, 0, 3)).toBeNull();
});
