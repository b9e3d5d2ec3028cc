import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { type Drawing, service } from "../api/client";
import { type Edges, LINE_TYPES } from "../geometry/records";
import { redo, retype, undo } from "./actions";
import { backwards, changeOf, forwards } from "./history";
import { keys, queries } from "./queries";
import { useReports } from "./reports";
import { usePage } from "./store";

/** Edge 0 is a cut by rule, edge 1 a crease by hand, edge 2 a V-groove by hand. */
const EDGES: Edges = {
  ends: new Float64Array(12),
  bulge: new Float64Array(3),
  lineType: Uint8Array.of(1, 2, 3),
  layer: new Int32Array(3),
  colour: new Int32Array(3),
  linetype: new Int32Array(3),
  rule: Int32Array.of(0, 1, 1),
  confidence: new Float64Array(3),
  length: new Float64Array(3),
  handles: ["A", "B", "C"],
  layers: ["0"],
  rules: ['profile default: layer "OVERRIDE"', "override"],
  linetypes: ["Continuous"],
};

describe("a change", () => {
  const change = changeOf(EDGES, [0, 1, 2], "half-cut");

  test("is one override for all its edges", () => {
    expect(forwards(change)).toEqual([{ type: "half-cut", edges: [0, 1, 2] }]);
  });

  test("is taken back by what each edge had before; a rule decides again where one did", () => {
    expect(backwards(change)).toEqual([
      { type: null, edges: [0] },
      { type: "crease", edges: [1] },
      { type: "v-groove", edges: [2] },
    ]);
  });
});

describe("undo and redo", () => {
  const override = vi.spyOn(service, "override");

  beforeEach(() => {
    override.mockReset().mockResolvedValue({ id: "d1" } as Drawing);
    queries.clear();
    queries.setQueryData(keys.edges("d1").queryKey, EDGES);
    usePage.getState().open(null);
    usePage.getState().open("d1", "j1");
    for (const { id } of useReports.getState().list) useReports.getState().dismiss(id);
  });
  afterEach(() => queries.clear());

  const told = () => override.mock.calls.map(([, overrides]) => overrides);

  test("go to the service and back", async () => {
    await retype([0], "crease");
    expect(usePage.getState().past).toHaveLength(1);
    await undo();
    expect(usePage.getState().past).toHaveLength(0);
    expect(usePage.getState().future).toHaveLength(1);
    await redo();
    expect(usePage.getState().past).toHaveLength(1);
    expect(told()).toEqual([
      [{ type: "crease", edges: [0] }],
      [{ type: null, edges: [0] }],
      [{ type: "crease", edges: [0] }],
    ]);
  });

  test("keys that are pressed fast are done one after the other", async () => {
    await Promise.all([retype([0], "crease"), undo(), redo(), undo()]);
    expect(override).toHaveBeenCalledTimes(4);
    expect(usePage.getState().future).toHaveLength(1);
    expect(usePage.getState().busy).toBe(false);
  });

  test("a new change forgets what was undone", async () => {
    await retype([0], "crease");
    await undo();
    await retype([0], "perforation");
    expect(usePage.getState().future).toHaveLength(0);
  });

  test("what the service refuses is told and is not in the history", async () => {
    override.mockRejectedValue(new Error("no"));
    await retype([0], "crease");
    expect(usePage.getState().past).toHaveLength(0);
    expect(useReports.getState().list.map(({ detail }) => detail)).toEqual(["no"]);
    expect(usePage.getState().busy).toBe(false);
  });

  test("a changed drawing is no longer that of its job", async () => {
    await retype([0], "crease");
    expect(usePage.getState().job).toBeNull();
  });

  test("with nothing to undo nothing is asked of the service", async () => {
    await undo();
    await redo();
    expect(override).not.toHaveBeenCalled();
  });

  test("another drawing has a history of its own", async () => {
    await retype([0], "crease");
    usePage.getState().open("d2");
    expect(usePage.getState().past).toHaveLength(0);
  });
});

test("the line types stand in the order of their codes", () => {
  expect(LINE_TYPES[3]).toBe("v-groove");
  expect(LINE_TYPES).toHaveLength(8);
});
