import { beforeEach, expect, test } from "vitest";
import type { Snapped } from "../../geometry/snap";
import { editsOf, useDrafting } from "./drafting";

const at = (x: number, y: number): Snapped => ({ x, y, kind: "end" });
const SEGMENTS = { ends: Float64Array.of(0, 0, 10, 0), bulge: Float64Array.of(0) };
const LINE = { type: "crease", selection: new Set<number>() } as const;

beforeEach(() => useDrafting.getState().choose(null));

test("a measurement stays until the next one begins", () => {
  const { choose, pick } = useDrafting.getState();
  choose("measure");
  expect(pick(at(0, 0))).toBeNull();
  expect(pick(at(3, 4))).toEqual([at(0, 0), at(3, 4)]);
  expect(useDrafting.getState().second).toEqual(at(3, 4));
  pick(at(7, 7));
  expect(useDrafting.getState()).toMatchObject({ first: at(7, 7), second: null });
});

test("a drawn line leaves no point behind", () => {
  const { choose, pick } = useDrafting.getState();
  choose("line");
  pick(at(0, 0));
  pick(at(3, 4));
  expect(useDrafting.getState()).toMatchObject({ tool: "line", first: null, second: null });
});

test("cancel forgets the point first, then leaves the tool", () => {
  const { choose, pick, cancel } = useDrafting.getState();
  choose("circle");
  pick(at(0, 0));
  cancel();
  expect(useDrafting.getState()).toMatchObject({ tool: "circle", first: null });
  cancel();
  expect(useDrafting.getState().tool).toBeNull();
});

test("two points give the edits of the tool", () => {
  const points = [at(0, 0), at(0, 5)] as const;
  expect(editsOf("line", points, SEGMENTS, LINE)).toMatchObject([{ kind: "line", type: "crease" }]);
  expect(editsOf("circle", points, SEGMENTS, LINE)).toMatchObject([{ kind: "circle", radius: 5 }]);
  expect(editsOf("move", points, SEGMENTS, LINE)).toMatchObject([{ edge: 0, end: "start" }]);
  expect(editsOf("measure", points, SEGMENTS, LINE)).toEqual([]);
});

test("two equal points give no edit", () => {
  expect(editsOf("line", [at(1, 1), at(1, 1)], SEGMENTS, LINE)).toEqual([]);
});
