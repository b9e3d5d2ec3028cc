import { expect, test } from "vitest";
import { changedSelection, clickMode } from "./selection";

test.each([
  ["replace", [2, 3]],
  ["add", [1, 2, 3]],
  ["remove", [1]],
  ["toggle", [1, 3]],
] as const)("%s", (mode, after) => {
  expect([...changedSelection(new Set([1, 2]), [2, 3], mode)]).toEqual(after);
});

test("a click with Shift or Ctrl adds or removes", () => {
  const keys = { shiftKey: false, ctrlKey: false, metaKey: false };
  expect(clickMode(keys)).toBe("replace");
  expect(clickMode({ ...keys, shiftKey: true })).toBe("toggle");
  expect(clickMode({ ...keys, metaKey: true })).toBe("toggle");
});
