import { expect, test } from "vitest";
import { OUTLINE_SHEET, sheetBox, sheetText } from "./sheet";

test("a rectangle begins at its margin before the drawing", () => {
  const sheet = { width: 400, height: 300, margin: 10 };
  expect(sheetBox(sheet, { x: 5, y: 7 })).toEqual([-5, -3, 395, 297]);
  expect(sheetBox(OUTLINE_SHEET, { x: 5, y: 7 })).toBeNull();
  expect(sheetBox(null, { x: 5, y: 7 })).toBeNull();
});

test("the operator reads which sheet to load", () => {
  expect(sheetText(OUTLINE_SHEET)).toBe("cut to the outline of the drawing");
  expect(sheetText({ width: 400, height: 300, margin: 10 })).toContain("400 × 300 mm");
});
