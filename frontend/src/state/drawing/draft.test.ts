import { describe, expect, test } from "vitest";
import type { Profile } from "../../api/library";
import {
  addRule,
  colourError,
  draftFromProfile,
  moveRule,
  newRule,
  parsePatterns,
  profileRequest,
  removeRule,
  slugOf,
  updateRule,
} from "./draft";

const CONDITIONS = {
  code: "rule.everything",
  arguments: {},
  text: "every edge",
  hint: "",
} as const;
const RULE = {
  type: "cut",
  conditions: CONDITIONS,
  colour: [],
  linetype: [],
  entity: [],
  block: [],
} as const;

const PROFILE = {
  name: "acme",
  title: "Acme",
  shipped: false,
  extends: "default",
  overrules: true,
  version: 3,
  updated: 0,
  fault: "",
  rules: [
    { ...RULE, layer: ["A"], inherited: false },
    { ...RULE, layer: ["B"], inherited: false },
    { ...RULE, layer: ["CUT"], inherited: true },
  ],
} as unknown as Profile;

const layers = (draft: ReturnType<typeof draftFromProfile>) =>
  draft.rules.map(({ layer }) => layer[0]);

describe("a draft", () => {
  test("has the customer's own rules, not those that it extends", () => {
    const draft = draftFromProfile(PROFILE);
    expect(layers(draft)).toEqual(["A", "B"]);
    expect(profileRequest(draft)).toMatchObject({
      title: "Acme",
      extends: "default",
      overrules: true,
    });
    expect(profileRequest(draft).rules[0]).toEqual({
      type: "cut",
      layer: ["A"],
      colour: [],
      linetype: [],
      entity: [],
      block: [],
    });
  });

  test("of a shipped profile is a new one on top of it", () => {
    const draft = draftFromProfile({ ...PROFILE, name: "german", shipped: true });
    expect(draft).toMatchObject({ title: "", extends: "german", overrules: true, rules: [] });
  });

  test("takes a rule on top, moves it and lets it go", () => {
    const added = addRule(draftFromProfile(PROFILE), newRule({ layer: ["C"] }));
    expect(layers(added)).toEqual(["C", "A", "B"]);
    const key = added.rules[0]?.key ?? -1;
    expect(layers(moveRule(added, key, 1))).toEqual(["A", "C", "B"]);
    expect(layers(moveRule(added, key, 99))).toEqual(["A", "B", "C"]);
    expect(layers(moveRule(added, key, -1))).toEqual(["C", "A", "B"]);
    expect(layers(removeRule(added, key))).toEqual(["A", "B"]);
    expect(updateRule(added, key, { type: "crease" }).rules[0]).toMatchObject({
      key,
      type: "crease",
      layer: ["C"],
    });
    expect(moveRule(added, -5, 0)).toBe(added);
  });
});

describe("the text of a field", () => {
  test("is parted at commas; colours are numbers where they can be", () => {
    expect(parsePatterns("layer", " FOLDS, 10 ,,crease*")).toEqual(["FOLDS", "10", "crease*"]);
    expect(parsePatterns("colour", "1, #FF0000, red")).toEqual([1, "#ff0000", "red"]);
  });

  test.each([
    ["1, 255, #00aeef", ""],
    ["0", "0 is"],
    ["256", "256 is"],
    ["red", "red is"],
    ["#12345", "#12345 is"],
  ])("as colours %s", (text, fault) => {
    const error = colourError(parsePatterns("colour", text));
    expect(fault === "" ? error : error.slice(0, fault.length)).toBe(fault);
  });

  test.each([
    ["Müller & Söhne GmbH", "muller-sohne-gmbh"],
    ["Weiß", "weiss"],
    ["../../etc/passwd", "etc-passwd"],
    ["刀线", ""],
    ["x".repeat(100), "x".repeat(64)],
  ])("%s becomes a name", (title, name) => expect(slugOf(title)).toBe(name));
});
