import { expect, test } from "vitest";
import { askedOf } from "./questions";

const WHICH =
  '1,246 edges on layer "A: B", colour 1, linetype CONTINUOUS, 389.0 mm long in all, in a box of ' +
  "229.0 × 155.0 mm at (0.0, 345.2): what are they?";

test("a question is taken apart into what is likely and why", () => {
  const text = `${WHICH} Most likely v-groove (55 %): shape: it divides two panels.`;
  expect(askedOf(text)).toEqual({ text: "", share: 55, why: "Shape: it divides two panels." });
});

test("where nothing speaks for anything, the rest of the words stays", () => {
  expect(askedOf(WHICH)).toEqual({ text: "", share: null, why: "" });
  expect(askedOf(`${WHICH} It does not close.`).text).toBe("It does not close.");
});

test("a question of another kind is asked as it is", () => {
  const text = "No tool of this machine makes a V-groove. What then?";
  expect(askedOf(text)).toEqual({ text, share: null, why: "" });
});
