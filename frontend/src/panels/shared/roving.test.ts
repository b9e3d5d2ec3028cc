import { expect, test } from "vitest";
import { movedTo } from "./roving";

const BAR = ["undo", "account", "history"];

test("the arrow keys go round the bar, Home and End to its ends", () => {
  expect(movedTo("ArrowRight", BAR, "undo")).toBe("account");
  expect(movedTo("ArrowRight", BAR, "history")).toBe("undo");
  expect(movedTo("ArrowLeft", BAR, "undo")).toBe("history");
  expect(movedTo("Home", BAR, "account")).toBe("undo");
  expect(movedTo("End", BAR, "account")).toBe("history");
});

test("other keys, and keys in what is no control of the bar, move nothing", () => {
  expect(movedTo("Enter", BAR, "undo")).toBeNull();
  expect(movedTo("ArrowRight", BAR, "dialog")).toBeNull();
});
