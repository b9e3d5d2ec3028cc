import { expect, test } from "vitest";
import { matches, shortcut, shortcutText } from "./keys";

const PRESSED = { shiftKey: false, ctrlKey: false, metaKey: false, altKey: false };

test.each([
  ["F", { key: "f" }, true],
  ["F", { key: "F", shiftKey: true }, false],
  ["Shift+F", { key: "F", shiftKey: true }, true],
  ["Ctrl+Z", { key: "z", metaKey: true }, true],
  ["Ctrl+Z", { key: "Z", ctrlKey: true, shiftKey: true }, false],
  ["Ctrl+Shift+Z", { key: "Z", ctrlKey: true, shiftKey: true }, true],
  ["F", { key: "f", altKey: true }, false],
  ["F", { key: "f", ctrlKey: true }, false],
  ["?", { key: "?", shiftKey: true }, true],
  ["+", { key: "+" }, true],
  ["Escape", { key: "Escape" }, true],
])("%s is pressed by %o: %s", (text, keys, yes) => {
  expect(matches(shortcut(text), { ...PRESSED, ...keys })).toBe(yes);
});

test("keys are written as the keyboard names them", () => {
  expect(shortcutText(shortcut("Ctrl+Shift+Z"))).toBe("Ctrl Shift Z");
  expect(shortcutText(shortcut("Escape"))).toBe("Esc");
  expect(shortcutText(shortcut("-"))).toBe("−");
  expect(shortcutText(shortcut("ArrowLeft"))).toBe("←");
});
