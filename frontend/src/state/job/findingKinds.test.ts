import { expect, test } from "vitest";
import type { Finding } from "../../api/jobs";
import { acceptancesOf, deviationOfOthers, edgesOf, kindsOf } from "./findingKinds";

const FINDING: Finding = {
  kind: "unreached",
  severity: "shortfall",
  refuses: true,
  acceptance: null,
  measure: 1,
  edge: 4,
  edges: [4, 5],
  handle: "2F",
  line: -1,
  code: "verify.unreached",
  text: "",
  hint: "",
  arguments: {},
};
const note = (code: string, edge: number): Finding => ({
  ...FINDING,
  kind: "planned",
  severity: "note",
  code,
  edge,
  edges: [],
});

test("shortfalls are grouped by kind, notes by what they state, and faults stand alone", () => {
  const groups = kindsOf([
    { ...FINDING, severity: "fault" },
    FINDING,
    { ...FINDING, code: "verify.slot", edge: 9 },
    { ...FINDING, kind: "kerf" },
    note("a", 1),
    note("b", 2),
    note("a", 3),
    // A note about the program has no place.
    note("a", -1),
  ]);
  expect(
    groups.map(({ kind, severity, findings }) => [kind, severity, findings.map((one) => one.edge)]),
  ).toEqual([
    ["unreached", "shortfall", [4, 9]],
    ["kerf", "shortfall", [4]],
    ["planned", "note", [1, 3]],
    ["planned", "note", [2]],
  ]);
});

test("a finding is about its edge, or all edges that are made as one", () => {
  expect(edgesOf(FINDING)).toEqual([4, 5]);
  expect(edgesOf(note("a", 7))).toEqual([7]);
});

test("each acceptance is stated once", () => {
  const by = (by: string, reason: string) => ({
    ...FINDING,
    acceptance: { by, reason, at: "2026-01-01T00:00:00Z" },
  });
  expect(acceptancesOf([by("Ada", "x"), FINDING, by("Ada", "x"), by("Ada", "y")])).toEqual([
    { by: "Ada", reason: "x" },
    { by: "Ada", reason: "y" },
  ]);
});

test("the deviation of the others leaves out the edges with a shortfall", () => {
  const deviations = [0.001, 0.004, 0, 0, 0.3, 0.2];
  expect(deviationOfOthers(deviations, [FINDING, note("a", 1)])).toBe(0.004);
  expect(deviationOfOthers(deviations, [])).toBe(0.3);
});
