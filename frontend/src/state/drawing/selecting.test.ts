import { expect, test } from "vitest";
import { type Edges, LINE_TYPES } from "../../geometry/records";
import { ANY, connectedRows, rowsAlike, rowsThatMeet, shownEdges, similarRows } from "./selecting";

const CUT = LINE_TYPES.indexOf("cut");
const CREASE = LINE_TYPES.indexOf("crease");
const DROPPED = 2;

/** Four lines end to end along X, one of them drawn twice, and a crease from their first joint. */
const EDGES = {
  ends: Float64Array.of(
    ...[0, 0, 100, 0],
    ...[100, 0, 200.5, 0],
    ...[200.5, 0, 300, 0],
    ...[300, 0, 310, 0],
    ...[100, 0, 100, 100],
    ...[0, 0, 100, 0],
  ),
  bulge: new Float64Array(6),
  length: Float64Array.of(100, 100.5, 99.5, 10, 100, 100),
  lineType: Uint8Array.of(CUT, CUT, CUT, CUT, CREASE, CUT),
  layer: Int32Array.of(0, 0, 1, 0, 0, 0),
  layers: ["A", "B"],
  colour: new Int32Array(6),
  outcome: Uint8Array.of(0, 0, 0, 0, 0, DROPPED),
} as unknown as Edges;

const all = () => true;

test("similar edges have type, layer and about the length of a selected one", () => {
  expect(similarRows(EDGES, [0], all)).toEqual([0, 1, 5]);
  expect(similarRows(EDGES, [3, 2], all)).toEqual([2, 3]);
  expect(similarRows(EDGES, [0, 3, 4], all)).toEqual([0, 1, 3, 4, 5]);
  expect(similarRows(EDGES, [], all)).toEqual([]);
});

test("a connected run has one line type and no edges that are not made", () => {
  expect(connectedRows(EDGES, [1], all)).toEqual([0, 1, 2, 3]);
  expect(connectedRows(EDGES, [4, 0], all)).toEqual([4, 0, 1, 2, 3]);
  expect(connectedRows(EDGES, [0], (row) => row !== 1)).toEqual([0]);
});

test("edges of the same line type or layer", () => {
  expect(rowsAlike(EDGES, [2], "layer", all)).toEqual([2]);
  expect(rowsAlike(EDGES, [2, 4], "lineType", all)).toEqual([0, 1, 2, 3, 4, 5]);
});

test("edges that meet conditions", () => {
  expect(rowsThatMeet(EDGES, { ...ANY, type: "crease" }, all)).toEqual([4]);
  expect(rowsThatMeet(EDGES, { ...ANY, layer: "B" }, all)).toEqual([2]);
  expect(rowsThatMeet(EDGES, { ...ANY, shortest: 100, longest: 100.5 }, all)).toEqual([0, 1, 4, 5]);
});

test("hidden edges are not selected", () => {
  const shown = shownEdges(EDGES, new Set(["crease"]), new Set());
  expect(rowsThatMeet(EDGES, ANY, shown)).toEqual([0, 1, 2, 3, 5]);
  expect(similarRows(EDGES, [4], shown)).toEqual([]);
  expect(rowsThatMeet(EDGES, ANY, shownEdges(EDGES, new Set(), new Set(["0\u0000A"])))).toEqual([
    2,
  ]);
});
