import { beforeEach, expect, test } from "vitest";
import type { Profile } from "../api/client";
import { draftRule, withRule } from "./draft";
import { useEditing } from "./editing";

const PROFILE = {
  name: "acme",
  title: "Acme",
  shipped: false,
  version: 1,
  rules: [],
} as unknown as Profile;
const steps = () => useEditing.getState();
const titled = (title: string) => {
  const { now, edit } = steps();
  if (now !== null) edit({ ...now, title }, "title");
};

beforeEach(() => {
  steps().forget();
  steps().begin(PROFILE);
});

test("each step is taken back and made again", () => {
  const { now } = steps();
  if (now === null) throw new Error("nothing is edited");
  steps().edit(withRule(now, draftRule({ type: "crease" })));
  titled("Acme Ltd");
  steps().back();
  expect(steps().now).toMatchObject({ title: "Acme", rules: [{ type: "crease" }] });
  steps().back();
  expect(steps().now).toBe(now);
  steps().back();
  expect(steps().now).toBe(now);
  steps().forward();
  steps().forward();
  expect(steps().now).toMatchObject({ title: "Acme Ltd", rules: [{ type: "crease" }] });
});

test("letters typed into one field are one step", () => {
  for (const title of ["A", "Ac", "Acm"]) titled(title);
  expect(steps().past).toHaveLength(1);
  steps().back();
  expect(steps().now?.title).toBe("Acme");
});

test("a new step forgets what was taken back", () => {
  titled("A");
  steps().back();
  titled("B");
  steps().forward();
  expect(steps().now?.title).toBe("B");
});

test("what was not kept is there again for the same version only", () => {
  titled("B");
  steps().begin(PROFILE);
  expect(steps().now?.title).toBe("B");
  steps().begin({ ...PROFILE, version: 2 });
  expect(steps().now?.title).toBe("Acme");
  expect(steps().past).toEqual([]);
});
