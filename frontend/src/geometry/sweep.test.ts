import { expect, test } from "vitest";
import { deepestZ } from "./depths";
import { footprint, vCutter } from "./footprint.fixture";
import { moveSegments } from "./moves";
import type { Toolpath } from "./records";
import { halfContactLength, sweepOf } from "./sweep";
import { workedSpans } from "./workedSpans";

test("a V-cutter sweeps by its slope, along its blade", () => {
  expect(sweepOf(vCutter(6, 1.5, 0.5))).toEqual({ kind: "groove", blade: 3, slope: 0.5 });
});

test("a knife sweeps no more than its line", () => {
  expect(sweepOf(footprint({ behind: 3 }))).toBeNull();
});

test("a wheel of radius 13 that is 1 deep touches 5 before and behind", () => {
  expect(halfContactLength(13, 1)).toBe(5);
  expect(halfContactLength(13, 0)).toBe(0);
  expect(halfContactLength(13, -1)).toBe(0);
});

/** A crease of 100 mm due east from (10, 20) on the sheet, worked from 5 to 90; then the air. */
const CREASE: Toolpath = {
  pose: Float64Array.of(
    ...[15, 20, 5, 0],
    ...[15, 20, -1, 0],
    ...[100, 20, -1, 0],
    ...[100, 20, 5, 0],
    ...[0, 0, 5, 0],
  ),
  bulge: Float64Array.of(0, 0, 0, 0),
  motion: Uint8Array.of(1, 3, 6, 0),
  feed: Float64Array.of(600, 600, 600, 0),
  source: Int32Array.of(0, 0, 0, -1),
  tool: Uint8Array.of(2, 2, 2, 4),
  line: Int32Array.of(1, 2, 3, 4),
  placement: [10, 20],
};
const EDGES = {
  ends: Float64Array.of(0, 0, 100, 0, 0, 0, 0, 50, 0, 50, 100, 50),
  bulge: Float64Array.of(0, 0, 0),
  lineType: Uint8Array.of(2, 1, 2),
  layer: Int32Array.of(0, 0, 0),
  colour: Int32Array.of(1, 1, 1),
  linetype: Int32Array.of(0, 0, 0),
  lineWidth: Int32Array.of(-1, -1, -1),
  rule: Int32Array.of(0, 0, 0),
  confidence: Float64Array.of(1, 1, 1),
  length: Float64Array.of(100, 50, 100),
  handles: ["A", "B", "C"],
  layers: ["0"],
  rules: [""],
  ruleCodes: [""],
  linetypes: ["Continuous"],
  alternatives: [],
  outcome: new Uint8Array(3),
  reason: new Int32Array(3),
  reasons: [""],
};

test("an edge that is set back is worked as far as its tool goes, all others wholly", () => {
  const spans = workedSpans(EDGES, CREASE, new Map(), [15, 0, 8]);
  // The third was set back, but no move states where: it counts as whole.
  [0.05, 0.9, 0, 1, 0, 1].forEach((at, k) => {
    expect(spans[k]).toBeCloseTo(at, 12);
  });
});

test("moves are those of the drawing, without the placement", () => {
  expect([...moveSegments(CREASE).ends.slice(4, 8)]).toEqual([5, 0, 90, 0]);
});

test("a station is as deep as its deepestZ work, and in the air it has none", () => {
  expect([...deepestZ(CREASE)]).toEqual([[2, -1]]);
});
