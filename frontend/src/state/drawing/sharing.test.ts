import { expect, test } from "vitest";
import { maySetShare } from "./sharing";

const drawing = { owner: "user:anna", shared: false };

test("the owner and operators share a drawing, another designer only while it is shared", () => {
  expect(maySetShare({ account: "user:anna", scopes: ["designer"] }, drawing)).toBe(true);
  expect(maySetShare({ account: "user:carl", scopes: ["designer"] }, drawing)).toBe(false);
  expect(maySetShare({ account: "user:carl", scopes: ["operator"] }, drawing)).toBe(true);
  expect(
    maySetShare({ account: "user:carl", scopes: ["designer"] }, { ...drawing, shared: true }),
  ).toBe(true);
});
