import { describe, expect, test } from "vitest";
import type { Machine } from "../../api/machines";
import { type Edges, lineTypeOf } from "../../geometry/records";
import {
  arrowAlong,
  chosenPlaces,
  chosenValues,
  edgeFields,
  stationsForEdges,
  withoutTarget,
  withValue,
} from "./edgeOptions";

const FIELDS = edgeFields("contour_starts");

/** Two edges: from (0, 0) to (10, 0), and from there upwards to (10, 20). */
const EDGES = {
  ends: new Float64Array([0, 0, 10, 0, 10, 0, 10, 20]),
  bulge: new Float64Array([0, 0]),
} as Edges;

describe("the choices for edges", () => {
  test("of edges with equal values are one choice", () => {
    const both = withValue(FIELDS, [], [3, 4], "direction", "reverse");
    expect(both).toEqual([{ at: null, direction: "reverse", edges: [3, 4] }]);
    const one = withValue(FIELDS, both, [4], "at", 0.25);
    expect(one).toEqual([
      { at: null, direction: "reverse", edges: [3] },
      { at: 0.25, direction: "reverse", edges: [4] },
    ]);
    expect(chosenValues(FIELDS, one, 4)).toEqual({ at: 0.25, direction: "reverse" });
    expect(chosenValues(FIELDS, one, 5)).toEqual({ at: null, direction: "free" });
  });

  test("end when every field has its default", () => {
    const chosen = withValue(FIELDS, [], [3], "at", 0);
    expect(chosen).toHaveLength(1);
    expect(withValue(FIELDS, chosen, [3], "at", null)).toEqual([]);
  });

  test("for a line type are kept apart from those for edges", () => {
    const choices = withValue(FIELDS, [{ edges: [1], at: 0.5 }], "cut", "direction", "forward");
    expect(choices).toEqual([
      { edges: [1], at: 0.5 },
      { at: null, direction: "forward", line_type: "cut" },
    ]);
    expect(withoutTarget(choices, [1])).toEqual([choices[1]]);
    expect(withoutTarget(choices, "cut")).toEqual([choices[0]]);
  });

  test("have marks at the chosen places", () => {
    const choices = [{ edges: [0, 1], at: 0.25, direction: "free" as const }];
    expect(
      chosenPlaces(
        {
          contour_starts: choices,
          cut_depths: [],
          crease_depths: [],
          edge_tools: [],
          edge_corners: [],
          contour_leads: [],
          edge_feeds: [],
        },
        EDGES,
      ),
    ).toEqual([
      { x: 2.5, y: 0 },
      { x: 10, y: 5 },
    ]);
  });
});

test("an arrow shows the direction in which an edge is drawn", () => {
  expect(arrowAlong(EDGES, 0)).toBe("→");
  expect(arrowAlong(EDGES, 1)).toBe("↑");
  expect(arrowAlong(EDGES, 1, true)).toBe("↓");
});

test("the tools for edges are those that make all their line types", () => {
  const machine = {
    stations: [
      { number: 1, line_types: ["cut", "half-cut", "combi"] },
      { number: 2, line_types: ["crease", "combi"] },
      { number: 3, line_types: ["cut"] },
    ],
  } as unknown as Machine;
  const edges = { lineType: new Uint8Array([1, 5]) } as unknown as Edges;
  const numbers = (rows: number[]): number[] =>
    stationsForEdges(machine, edges, rows).map(({ number }) => number);
  expect([lineTypeOf(1), lineTypeOf(5)]).toEqual(["cut", "half-cut"]);
  expect(numbers([0])).toEqual([1, 3]);
  expect(numbers([0, 1])).toEqual([1]);
  expect(stationsForEdges(undefined, edges, [0])).toEqual([]);
});
