import { expect, test } from "vitest";
import {
  type Dimension,
  formatDimensions,
  parseDimensions,
  useDimensions,
  withDimensions,
} from "./dimensions";

const from0 = (x: number, y: number): Dimension => ({ from: { x: 0, y: 0 }, to: { x, y } });

test("a dimension is kept once, and removed", () => {
  const { keep, remove } = useDimensions.getState();
  keep("d", from0(3, 4));
  keep("d", from0(5, 6));
  keep("d", from0(3, 4));
  expect(useDimensions.getState().kept.get("d")).toEqual([from0(5, 6), from0(3, 4)]);
  remove("d", from0(5, 6));
  remove("d", from0(3, 4));
  expect(useDimensions.getState().kept.has("d")).toBe(false);
});

test("a kept dimension is shown", () => {
  useDimensions.getState().toggle();
  expect(useDimensions.getState().shown).toBe(false);
  useDimensions.getState().keep("d", from0(1, 1));
  expect(useDimensions.getState().shown).toBe(true);
});

test("dimensions are stored as a text", () => {
  const kept = new Map([["d", [from0(3, 4)]]]);
  expect(parseDimensions(formatDimensions(kept))).toEqual(kept);
});

test.each([
  "{",
  "7",
  '[["d"]]',
  '[["d", 3]]',
  '[["d", [[1, 2]]]]',
  "[null]",
  '[["d", [[1,2,3,"x"]]]]',
])("a damaged text has no dimensions: %s", (text) => {
  expect([...parseDimensions(text).values()].flat()).toEqual([]);
});

test("of many drawings, those changed last are kept", () => {
  let kept: ReadonlyMap<string, readonly Dimension[]> = new Map();
  for (let at = 0; at < 60; at++) kept = withDimensions(kept, `d${at}`, [from0(at, 0)]);
  expect(kept.size).toBe(50);
  expect(kept.has("d9")).toBe(false);
  expect(kept.has("d59")).toBe(true);
});
