import { expect, test } from "vitest";
import type { Edges } from "../../geometry/records";
import { followedEdges } from "./followed";

/** Lines with rules of the given codes and types. */
const edges = (ruleCodes: readonly string[], rule: number[], types: number[]): Edges =>
  ({ ruleCodes, rule: Int32Array.from(rule), lineType: Uint8Array.from(types) }) as Edges;

test("edges that follow from answers are listed by line type", () => {
  const codes = ["classification.override", "classification.follows"];
  expect(followedEdges(edges(codes, [0, 1, 1, 1], [2, 2, 6, 2]))).toEqual([
    { type: "crease", rows: [1, 3] },
    { type: "ignored", rows: [2] },
  ]);
});

test("without such edges there are none, also where edges have no rule", () => {
  expect(followedEdges(edges(["classification.override"], [0, -1], [2, 0]))).toEqual([]);
});
