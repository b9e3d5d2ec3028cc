import { QueryObserver } from "@tanstack/react-query";
import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { type Drawing, drawingService } from "../../api/drawings";
import { ServiceError } from "../../api/errors";
import { type Job, jobService } from "../../api/jobs";
import type { Edges } from "../../geometry/records";
import { compile, retype } from "../actions";
import { useNotifications } from "../notifications";
import { queries, queryClient } from "../queries";
import { useUiStore } from "../store";
import { syncDrawing } from "./drawingSync";
import type { Change, RetypeChange } from "./history";
import { changedRows, describeDifference, undoableChanges } from "./remoteChanges";

/** Three edges of these types, all by one rule. */
const edgesOf = (types: readonly number[], revision: number): Edges => ({
  ends: new Float64Array(types.length * 4),
  bulge: new Float64Array(types.length),
  lineType: Uint8Array.from(types),
  layer: new Int32Array(types.length),
  colour: new Int32Array(types.length),
  linetype: new Int32Array(types.length),
  lineWidth: new Int32Array(types.length).fill(-1),
  rule: new Int32Array(types.length),
  confidence: new Float64Array(types.length),
  length: new Float64Array(types.length),
  handles: types.map((_, row) => `H${row}`),
  layers: ["0"],
  ruleCodes: [""],
  rules: ["layer CUT"],
  linetypes: ["Continuous"],
  alternatives: [],
  outcome: new Uint8Array(types.length),
  reason: new Int32Array(types.length),
  reasons: [""],
  revision,
});

const drawingOf = (revision: number, more: Partial<Drawing> = {}): Drawing =>
  ({
    id: "d1",
    revision,
    name: "tray.dxf",
    unit: "mm",
    profile: "default",
    profile_state: "current",
    rules: "",
    ...more,
  }) as Drawing;

const retyping = (rows: number[]): RetypeChange => ({
  kind: "types",
  rows,
  after: rows.map(() => "cut" as const),
  before: rows.map(() => null),
});

const SETTLED = { kind: "settings" } as Change;

describe("what differs", () => {
  test("is listed by row while the edges are the same", () => {
    expect(changedRows(edgesOf([1, 2, 1], 1), edgesOf([1, 4, 1], 2))).toEqual([1]);
    expect(changedRows(edgesOf([1, 2], 1), edgesOf([1, 2], 2))).toEqual([]);
    expect(changedRows(edgesOf([1, 2], 1), edgesOf([1, 2, 1], 2))).toBeNull();
    const ruled = { ...edgesOf([1, 2], 2), rules: ["override"] };
    expect(changedRows(edgesOf([1, 2], 1), ruled)).toEqual([0, 1]);
    const renamed = { ...edgesOf([1, 2], 2), handles: ["H1", "H0"] };
    expect(changedRows(edgesOf([1, 2], 1), renamed)).toBeNull();
  });

  test("is described", () => {
    expect(describeDifference(drawingOf(1), drawingOf(2), [4])).toBe(
      "1 edge now has another line type",
    );
    expect(describeDifference(drawingOf(1), drawingOf(2), [])).toBe(
      "line types, unit and profile are as before",
    );
    const after = drawingOf(2, { unit: "in", profile: "acme" });
    expect(describeDifference(drawingOf(1), after, null)).toBe(
      "its unit is now in, its profile is now acme, its edges were read again from the file",
    );
  });
});

test("only steps that overwrite nothing of others can be undone", () => {
  const past = [retyping([0]), retyping([1, 2]), retyping([3])];
  expect(undoableChanges(past, [2])).toEqual(past.slice(2));
  expect(undoableChanges(past, [9])).toEqual(past);
  expect(undoableChanges(past, [3])).toEqual([]);
  expect(undoableChanges(past, [])).toEqual(past);
  expect(undoableChanges(past, null)).toEqual([]);
  expect(undoableChanges([past[0] as Change, SETTLED, past[2] as Change], [9])).toEqual([past[2]]);
});

describe("a drawing that is changed elsewhere", () => {
  const drawing = vi.spyOn(drawingService, "drawing");
  const edges = vi.spyOn(drawingService, "edges");
  const override = vi.spyOn(drawingService, "override");
  const order = vi.spyOn(jobService, "compile");

  beforeEach(() => {
    queryClient.clear();
    queryClient.setQueryData(queries.drawing("d1").queryKey, drawingOf(1));
    queryClient.setQueryData(queries.edges("d1").queryKey, edgesOf([1, 2, 1], 1));
    drawing.mockReset().mockResolvedValue(drawingOf(2));
    edges.mockReset().mockResolvedValue(edgesOf([1, 4, 1], 2));
    override.mockReset();
    order.mockReset();
    useUiStore.getState().open(null);
    useUiStore.getState().open("d1", "j1");
    for (const { id } of useNotifications.getState().list) useNotifications.getState().dismiss(id);
  });
  afterEach(() => queryClient.clear());

  const shown = () => queryClient.getQueryData(queries.edges("d1").queryKey)?.lineType;
  const notifications = () => useNotifications.getState().list;
  const stale = () =>
    new ServiceError({
      type: "urn:knifetip:problem:stale-revision",
      title: "",
      status: 412,
      code: "stored.text",
      arguments: {},
      detail: "Drawing d1 was changed since it was read.",
      text: "Drawing d1 was changed since it was read.",
      hint: "",
      source: [],
      edges: [],
      questions: [],
      revision: 2,
    });

  test("is shown in its new state, with a notification", async () => {
    useUiStore.getState().recordChange(retyping([0]));
    useUiStore.getState().recordChange(retyping([1]));
    await syncDrawing({ id: "d1", revision: 2 });
    expect(shown()).toEqual(Uint8Array.of(1, 4, 1));
    expect(queryClient.getQueryData(queries.drawing("d1").queryKey)?.revision).toBe(2);
    expect(notifications()).toMatchObject([
      { title: "The drawing was changed elsewhere", notice: true },
    ]);
    expect(notifications()[0]?.detail).toContain("1 edge now has another line type");
    expect(notifications()[0]?.hint).toContain("undone");
    expect(useUiStore.getState().past).toEqual([]);
    expect(useUiStore.getState().job).toBeNull();
  });

  test("leaves a job in view that is on a table", async () => {
    queryClient.setQueryData(queries.job("j1").queryKey, { id: "j1", state: "held" } as Job);
    await syncDrawing({ id: "d1", revision: 2 });
    expect(useUiStore.getState().job).toBe("j1");
  });

  test("is not asked for again because of a change of our own, or of another drawing", async () => {
    override.mockImplementation(async () => {
      // The event is heard before the answer.
      void syncDrawing({ id: "d1", revision: 2 });
      return drawingOf(2);
    });
    const leave = new QueryObserver(queryClient, queries.edges("d1")).subscribe(() => undefined);
    await retype([1], "perforation");
    await syncDrawing({ id: "d2", revision: 9 });
    await syncDrawing({ id: "d1", revision: 2 });
    expect(drawing).not.toHaveBeenCalled();
    expect(notifications()).toEqual([]);
    expect(useUiStore.getState().past).toHaveLength(1);
    leave();
  });

  test("is compared after the line was broken", async () => {
    await syncDrawing(null);
    expect(notifications()).toHaveLength(1);
    await syncDrawing(null);
    expect(drawing).toHaveBeenCalledTimes(2);
    expect(notifications()).toHaveLength(1);
  });

  test("is changed and ordered only as it is shown", async () => {
    override.mockRejectedValue(stale());
    await retype([0], "crease");
    expect(override).toHaveBeenCalledWith("d1", [{ type: "crease", edges: [0] }], 1);
    expect(notifications()).toMatchObject([
      { title: "Your change was not saved: the drawing was changed elsewhere" },
    ]);
    expect(notifications()[0]?.detail).toContain("1 edge now has another line type");
    expect(shown()).toEqual(Uint8Array.of(1, 4, 1));
    expect(useUiStore.getState().past).toEqual([]);

    drawing.mockResolvedValue(drawingOf(3));
    edges.mockResolvedValue(edgesOf([1, 1, 1], 3));
    order.mockRejectedValue(stale());
    await compile("demo-table", "e-flute");
    expect(order.mock.calls[0]?.[0]).toMatchObject({ drawing: "d1", revision: 2 });
    expect(shown()).toEqual(Uint8Array.of(1, 1, 1));
    expect(notifications()).toHaveLength(1);
  });

  test("with a picture older than the panels is ordered as the picture shows it", async () => {
    queryClient.setQueryData(queries.drawing("d1").queryKey, drawingOf(2));
    order.mockRejectedValue(stale());
    await compile("demo-table", "e-flute");
    expect(order.mock.calls[0]?.[0]).toMatchObject({ revision: 1 });
    expect(shown()).toEqual(Uint8Array.of(1, 4, 1));
  });
});
