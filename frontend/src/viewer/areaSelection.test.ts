import { expect, test } from "vitest";
import { areaOfDrag, extendedArea } from "./areaSelection";

const KEYS = { shiftKey: false, altKey: false, ctrlKey: false, metaKey: false };
const LASSO = { kind: "lasso", mode: "replace" } as const;

test("without a tool, a drag without keys moves the view", () => {
  expect(areaOfDrag(null, KEYS)).toBeNull();
  expect(areaOfDrag(null, { ...KEYS, ctrlKey: true })).toBeNull();
});

test("keys choose the kind of area and what its edges do", () => {
  expect(areaOfDrag(null, { ...KEYS, shiftKey: true })).toEqual({ kind: "box", mode: "add" });
  expect(areaOfDrag(null, { ...KEYS, altKey: true })).toEqual(LASSO);
  expect(areaOfDrag(LASSO, KEYS)).toEqual(LASSO);
  expect(areaOfDrag(LASSO, { ...KEYS, shiftKey: true })).toEqual({ kind: "lasso", mode: "add" });
  expect(areaOfDrag(LASSO, { ...KEYS, ctrlKey: true })?.mode).toBe("remove");
  expect(areaOfDrag({ kind: "box", mode: "remove" }, KEYS)?.mode).toBe("remove");
});

test("a box has four corners, a lasso the points of its line", () => {
  const from = { x: 1, y: 1 };
  expect(extendedArea("box", [from], { x: 4, y: 5 })).toEqual([
    from,
    { x: 4, y: 1 },
    { x: 4, y: 5 },
    { x: 1, y: 5 },
  ]);
  const near = extendedArea("lasso", [from], { x: 2, y: 1 });
  expect(near).toEqual([from]);
  expect(extendedArea("lasso", near, { x: 9, y: 1 })).toHaveLength(2);
});
