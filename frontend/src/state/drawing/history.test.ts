import { QueryObserver } from "@tanstack/react-query";
import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { type Drawing, drawingService, type Proposal } from "../../api/drawings";
import { libraryService, type Profile } from "../../api/library";
import { type Edges, LINE_TYPES } from "../../geometry/records";
import { patchDrawing, redo, retype, undo } from "../actions";
import { useNotifications } from "../notifications";
import { queries, queryClient } from "../queries";
import { useUiStore } from "../store";
import {
  inverseOf,
  overridesToApply,
  overridesToUndo,
  type ProfileChange,
  retypeChange,
} from "./history";

/** Edge 0 is a cut by rule, edge 1 a crease by hand, edge 2 a V-groove by hand. */
const EDGES: Edges = {
  ends: new Float64Array(12),
  bulge: new Float64Array(3),
  lineType: Uint8Array.of(1, 2, 3),
  layer: new Int32Array(3),
  colour: new Int32Array(3),
  linetype: new Int32Array(3),
  lineWidth: Int32Array.of(50, 18, -1),
  rule: Int32Array.of(0, 1, 1),
  confidence: new Float64Array(3),
  length: new Float64Array(3),
  handles: ["A", "B", "C"],
  layers: ["0"],
  rules: ['profile default: layer "OVERRIDE"', "the user set the line type of the edge"],
  ruleCodes: ["classification.rule", "classification.override"],
  linetypes: ["Continuous"],
  alternatives: [],
  outcome: new Uint8Array(3),
  reason: new Int32Array(3),
  reasons: [""],
};

describe("a change", () => {
  const change = retypeChange(EDGES, [{ rows: [0, 1, 2], type: "half-cut" }]);

  test("is one override for all its edges", () => {
    expect(overridesToApply(change)).toEqual([{ type: "half-cut", edges: [0, 1, 2] }]);
  });

  test("is one override for each line type that it gives", () => {
    const accepted = retypeChange(EDGES, [
      { rows: [0, 2], type: "crease" },
      { rows: [1], type: "cut" },
    ]);
    expect(overridesToApply(accepted)).toEqual([
      { type: "crease", edges: [0, 2] },
      { type: "cut", edges: [1] },
    ]);
  });

  test("is taken back by what each edge had before; a rule decides again where one did", () => {
    expect(overridesToUndo(change)).toEqual([
      { type: null, edges: [0] },
      { type: "crease", edges: [1] },
      { type: "v-groove", edges: [2] },
    ]);
  });
});

describe("undo and redo", () => {
  const override = vi.spyOn(drawingService, "override");

  beforeEach(() => {
    override.mockReset().mockResolvedValue({ id: "d1" } as Drawing);
    queryClient.clear();
    queryClient.setQueryData(queries.edges("d1").queryKey, EDGES);
    useUiStore.getState().open(null);
    useUiStore.getState().open("d1", "j1");
    for (const { id } of useNotifications.getState().list) useNotifications.getState().dismiss(id);
  });
  afterEach(() => queryClient.clear());

  const sent = () => override.mock.calls.map(([, overrides]) => overrides);

  test("ask again for what was on its way for the first time", async () => {
    const answers: ((lessons: Proposal[]) => void)[] = [];
    const asked = vi
      .spyOn(drawingService, "learned")
      .mockImplementation(() => new Promise((answer) => answers.push(answer)));
    const watched = new QueryObserver(queryClient, queries.learned("d1"));
    const leave = watched.subscribe(() => undefined);
    const answered = retype([0], "crease");
    await vi.waitFor(() => expect(answers).toHaveLength(2));
    const lessons = [{ changes: [] } as unknown as Proposal];
    answers[0]?.([]);
    answers[1]?.(lessons);
    await answered;
    expect(watched.getCurrentResult().data).toEqual(lessons);
    leave();
    asked.mockRestore();
  });

  test("go to the service and back", async () => {
    await retype([0], "crease");
    expect(useUiStore.getState().past).toHaveLength(1);
    await undo();
    expect(useUiStore.getState().past).toHaveLength(0);
    expect(useUiStore.getState().future).toHaveLength(1);
    await redo();
    expect(useUiStore.getState().past).toHaveLength(1);
    expect(sent()).toEqual([
      [{ type: "crease", edges: [0] }],
      [{ type: null, edges: [0] }],
      [{ type: "crease", edges: [0] }],
    ]);
  });

  test("keys that are pressed fast are done one after the other", async () => {
    await Promise.all([retype([0], "crease"), undo(), redo(), undo()]);
    expect(override).toHaveBeenCalledTimes(4);
    expect(useUiStore.getState().future).toHaveLength(1);
    expect(useUiStore.getState().busy).toBe(false);
  });

  test("a new change forgets what was undone", async () => {
    await retype([0], "crease");
    await undo();
    await retype([0], "perforation");
    expect(useUiStore.getState().future).toHaveLength(0);
  });

  test("a refused change is reported and not recorded", async () => {
    override.mockRejectedValue(new Error("no"));
    await retype([0], "crease");
    expect(useUiStore.getState().past).toHaveLength(0);
    expect(useNotifications.getState().list.map(({ detail }) => detail)).toEqual(["no"]);
    expect(useUiStore.getState().busy).toBe(false);
  });

  test("a changed drawing is no longer that of its job", async () => {
    await retype([0], "crease");
    expect(useUiStore.getState().job).toBeNull();
  });

  test("with nothing to undo nothing is asked of the service", async () => {
    await undo();
    await redo();
    expect(override).not.toHaveBeenCalled();
  });

  test("another drawing has a history of its own", async () => {
    await retype([0], "crease");
    useUiStore.getState().open("d2");
    expect(useUiStore.getState().past).toHaveLength(0);
  });
});

describe("a unit and a profile", () => {
  const sent = vi.spyOn(drawingService, "patchDrawing");
  const texts = vi.spyOn(libraryService, "putProfile");
  const forgotten = vi.spyOn(libraryService, "deleteProfile");
  const read = vi.spyOn(libraryService, "profile");
  const text = vi.spyOn(libraryService, "profileText");
  const drawing = (part: Partial<Drawing>) =>
    ({ id: "d1", unit: "mm", unit_given: null, profile: "default", ...part }) as Drawing;

  beforeEach(() => {
    sent.mockReset().mockImplementation((_, part) =>
      Promise.resolve(
        drawing({
          unit_given: part.unit === "file" ? null : (part.unit ?? null),
          profile: part.profile ?? "default",
        }),
      ),
    );
    texts.mockReset().mockResolvedValue({ version: 2 } as Profile);
    forgotten.mockReset().mockResolvedValue();
    read.mockReset().mockResolvedValue({ version: 7, title: "Acme" } as Profile);
    text.mockReset().mockResolvedValue('title = "Acme"');
    queryClient.clear();
    queryClient.setQueryData(queries.drawing("d1").queryKey, drawing({}));
    useUiStore.getState().open(null);
    useUiStore.getState().open("d1");
  });

  test("are undone and redone", async () => {
    await patchDrawing({ unit: "in" });
    await undo();
    await redo();
    expect(sent.mock.calls.map(([, part]) => part)).toEqual([
      { unit: "in" },
      { unit: "file" },
      { unit: "in" },
    ]);
  });

  test("a profile that has changed is read anew, and then as it was", async () => {
    const acme = (rules: string) => drawing({ profile: "acme", rules });
    queryClient.setQueryData(queries.drawing("d1").queryKey, acme("old"));
    sent.mockImplementation((_, { rules }) => Promise.resolve(acme(rules || "new")));
    await patchDrawing({ profile: "acme" });
    await undo();
    await redo();
    expect(sent.mock.calls.map(([, part]) => part)).toEqual([
      { profile: "acme" },
      { profile: "acme", rules: "old" },
      { profile: "acme", rules: "new" },
    ]);
  });

  const KEPT: ProfileChange = {
    kind: "profile",
    name: "acme",
    before: null,
    after: 'title = "Acme"',
    profileBefore: { profile: "default", rules: "" },
    profileAfter: { profile: "acme" },
  };

  test("a new profile is forgotten, once the drawing is read by the one before", async () => {
    useUiStore.getState().recordChange(KEPT);
    await undo();
    expect(sent).toHaveBeenCalledWith("d1", { profile: "default", rules: "" }, null);
    expect(forgotten).toHaveBeenCalledWith("acme", 7);
    await redo();
    expect(texts).toHaveBeenCalledWith("acme", 'title = "Acme"', null);
    expect(sent).toHaveBeenLastCalledWith("d1", { profile: "acme" }, null);
  });

  test("a changed profile gets back the text that it had", async () => {
    useUiStore.getState().recordChange({
      ...KEPT,
      before: 'title = "Old"',
      profileBefore: { profile: "acme", rules: 'title = "Old"' },
    });
    await undo();
    expect(texts).toHaveBeenCalledWith("acme", 'title = "Old"', 7);
    expect(forgotten).not.toHaveBeenCalled();
  });

  test("a profile changed by another user is not overwritten, and that is reported", async () => {
    text.mockResolvedValue('title = "Theirs"');
    useUiStore.getState().recordChange({
      ...KEPT,
      before: 'title = "Old"',
      profileBefore: { profile: "acme", rules: 'title = "Old"' },
    });
    await undo();
    expect(texts).not.toHaveBeenCalled();
    expect(useUiStore.getState().past).toHaveLength(1);
    expect(useNotifications.getState().list.at(-1)?.title).toBe(
      "The profile was changed elsewhere",
    );
  });

  test("the way back of the way back is the way", () => {
    expect(inverseOf(inverseOf(KEPT))).toEqual(KEPT);
  });
});

test("the line types stand in the order of their codes", () => {
  expect(LINE_TYPES[3]).toBe("v-groove");
  expect(LINE_TYPES).toHaveLength(8);
});
