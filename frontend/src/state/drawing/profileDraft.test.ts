import { beforeEach, expect, test } from "vitest";
import type { Profile } from "../../api/library";
import { addRule, newRule } from "./draft";
import { useProfileDraft } from "./profileDraft";

const PROFILE = {
  name: "acme",
  title: "Acme",
  shipped: false,
  version: 1,
  rules: [],
} as unknown as Profile;
const steps = () => useProfileDraft.getState();
const titled = (title: string) => {
  const { draft, edit } = steps();
  if (draft !== null) edit({ ...draft, title }, "title");
};

beforeEach(() => {
  steps().discard();
  steps().begin(PROFILE);
});

test("each step is taken back and made again", () => {
  const { draft } = steps();
  if (draft === null) throw new Error("nothing is edited");
  steps().edit(addRule(draft, newRule({ type: "crease" })));
  titled("Acme Ltd");
  steps().undo();
  expect(steps().draft).toMatchObject({ title: "Acme", rules: [{ type: "crease" }] });
  steps().undo();
  expect(steps().draft).toBe(draft);
  steps().undo();
  expect(steps().draft).toBe(draft);
  steps().redo();
  steps().redo();
  expect(steps().draft).toMatchObject({ title: "Acme Ltd", rules: [{ type: "crease" }] });
});

test("letters typed into one field are one step", () => {
  for (const title of ["A", "Ac", "Acm"]) titled(title);
  expect(steps().past).toHaveLength(1);
  steps().undo();
  expect(steps().draft?.title).toBe("Acme");
});

test("a new step forgets what was taken back", () => {
  titled("A");
  steps().undo();
  titled("B");
  steps().redo();
  expect(steps().draft?.title).toBe("B");
});

test("what was not kept is there again for the same version only", () => {
  titled("B");
  steps().begin(PROFILE);
  expect(steps().draft?.title).toBe("B");
  steps().begin({ ...PROFILE, version: 2 });
  expect(steps().draft?.title).toBe("Acme");
  expect(steps().past).toEqual([]);
});
