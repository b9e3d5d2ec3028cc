import { describe, expect, test } from "vitest";
import type { Drawing, ImportReportRow, ReportGroup } from "../../api/drawings";
import type { Edges } from "../../geometry/records";
import type { Code } from "../../messages/catalogue";
import {
  entitiesOf,
  groupsOf,
  isDropped,
  lengthShares,
  locateEntity,
  rowsOfGroup,
  summarizeReport,
} from "./importReport";
import { summarizeEdges } from "./inspect";

type Report = NonNullable<Drawing["report"]>;

const message = (code: Code, args: Record<string, unknown> = {}) => ({
  code,
  arguments: args,
  text: "",
  hint: "",
});

const group = (part: Partial<ReportGroup>): ReportGroup => ({
  outcome: "kept",
  reason: message("cleaning.as-drawn"),
  what: "edges",
  kinds: [],
  count: 1,
  length: 0,
  ...part,
});

const SPECKS = group({
  outcome: "dropped",
  reason: { ...message("cleaning.speck"), text: "a speck" },
});
const TEXTS = group({ outcome: "dropped", reason: message("import.text"), what: "entities" });
const REPORT: Report = {
  drawn: 200,
  kept: 150,
  merged: 40,
  dropped: 10,
  groups: [SPECKS, TEXTS, group({})],
};

/** Edges 0 and 2 are kept, 1 is dropped as a speck; 2 is a crease by shape. */
const EDGES: Edges = {
  ends: new Float64Array(12),
  bulge: new Float64Array(3),
  lineType: Uint8Array.of(1, 1, 2),
  layer: Int32Array.of(0, 0, 1),
  colour: Int32Array.of(1, 1, 5),
  linetype: new Int32Array(3),
  lineWidth: Int32Array.of(50, 18, -1),
  rule: Int32Array.of(0, 0, 1),
  confidence: Float64Array.of(0.95, 0.9, 0.6),
  length: Float64Array.of(100, 0.01, 50),
  handles: ["A", "B", "C"],
  layers: ["CUT", "0"],
  rules: ['layer "CUT"', "shape: it divides two panels"],
  ruleCodes: ["classification.rule", "classification.shape"],
  linetypes: ["Continuous"],
  alternatives: [["half-cut"], ["cut", "crease", "perforation"]],
  outcome: Uint8Array.of(0, 2, 0),
  reason: Int32Array.of(0, 1, 0),
  reasons: ["", "a speck"],
};

describe("the import report", () => {
  test("gives the share of each outcome", () => {
    expect(lengthShares(REPORT).map(({ share }) => share)).toEqual([0.75, 0.2, 0.05]);
    expect(lengthShares({ ...REPORT, drawn: 0 }).every(({ share }) => share === 0)).toBe(true);
  });

  test("is filtered by what became of things", () => {
    expect(groupsOf(REPORT, "dropped")).toEqual([SPECKS, TEXTS]);
    expect(groupsOf(REPORT, "merged")).toEqual([]);
    expect(groupsOf(REPORT, null)).toHaveLength(3);
  });

  test("leads to the edges of a reason, and to entities that are no lines", () => {
    expect(rowsOfGroup(EDGES, SPECKS)).toEqual([1]);
    expect(rowsOfGroup(EDGES, group({}))).toEqual([0, 2]);
    expect(rowsOfGroup(EDGES, TEXTS)).toEqual([]);
    const row = { outcome: "dropped", reason: message("import.text") };
    expect(entitiesOf([row as ImportReportRow], TEXTS)).toHaveLength(1);
    expect(entitiesOf([row as ImportReportRow], SPECKS)).toHaveLength(0);
    expect([0, 1, 2].map((edge) => isDropped(EDGES, edge))).toEqual([false, true, false]);
  });
});

describe("edges that are looked at", () => {
  test("one has its rule, confidence and alternatives", () => {
    const found = summarizeEdges(EDGES, [2]);
    expect(found.reasons).toEqual([
      { type: "crease", rule: "shape: it divides two panels", confidence: 0.6, rows: [2] },
    ]);
    expect(found.alternatives).toEqual(["cut", "perforation"]);
    expect(found.outcome).toBe("");
  });

  test("several have the lowest confidence and the common alternatives", () => {
    const found = summarizeEdges(EDGES, [0, 1, 2]);
    expect(found.reasons.map(({ confidence, rows }) => [confidence, rows.length])).toEqual([
      [0.9, 2],
      [0.6, 1],
    ]);
    expect(found.alternatives).toEqual([]);
    expect(found.lineWidths).toEqual([50, 18]);
    expect(found.length).toBeCloseTo(150.01);
    expect(summarizeEdges(EDGES, [1]).outcome).toBe("dropped: a speck");
  });
});

const DRAWING = { width: 100, height: 40 } as Drawing;
const entity = (part: Partial<ImportReportRow>): ImportReportRow => ({
  handle: "1",
  kind: "TEXT",
  layer: "NOTES",
  outcome: "dropped",
  reason: message("import.text"),
  length: 0,
  text: "",
  ...part,
});

describe("an entity of the report", () => {
  test("is found by its edges, or by the one that it lies on", () => {
    expect(locateEntity(EDGES, DRAWING, entity({ handle: "C" }))).toEqual({ rows: [2] });
    const twice = entity({ handle: "D", reason: message("import.drawn-twice", { same: ["A"] }) });
    expect(locateEntity(EDGES, DRAWING, twice)).toEqual({ rows: [0] });
  });

  test("is found by the place of its words, with a quarter of the drawing about it", () => {
    expect(locateEntity(EDGES, DRAWING, entity({ place: [50, 20, 1] }))).toEqual({
      pin: [50, 20, 50, 20],
      box: [25, -5, 75, 45],
    });
  });

  test("is found by the box around it, which is seen whole", () => {
    const hatch = entity({ kind: "HATCH", box: [20, 0, 80, 10] });
    expect(locateEntity(EDGES, DRAWING, hatch)).toEqual({
      pin: [20, 0, 80, 10],
      box: [5, -40, 95, 50],
    });
  });

  test("without a position has no location", () => {
    expect(locateEntity(EDGES, DRAWING, entity({ kind: "HATCH" }))).toBeNull();
  });
});

test("a report in a few words counts what is not there as it was drawn", () => {
  expect(summarizeReport(REPORT)).toBe("2 dropped");
  expect(summarizeReport({ ...REPORT, groups: [group({ count: 7 })] })).toBe("all objects kept");
});
