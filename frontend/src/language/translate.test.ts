import { IntlMessageFormat } from "intl-messageformat";
import { describe, expect, expectTypeOf, test } from "vitest";
import type { ArgumentsOf, TagsOf } from "./arguments";
import { de } from "./de";
import { en } from "./en";
import { chooseLanguage, chooseLocale } from "./language";
import { formatFixed, formatNumber } from "./numbers";
import { type TextId, translate } from "./translate";

/** Identifiers whose texts have other arguments or tags in another language. */
type Mismatched<Texts extends Record<TextId, string>> = {
  [Id in TextId]: [keyof ArgumentsOf<Texts[Id]>, TagsOf<Texts[Id]>] extends [
    keyof ArgumentsOf<(typeof en)[Id]>,
    TagsOf<(typeof en)[Id]>,
  ]
    ? [keyof ArgumentsOf<(typeof en)[Id]>, TagsOf<(typeof en)[Id]>] extends [
        keyof ArgumentsOf<Texts[Id]>,
        TagsOf<Texts[Id]>,
      ]
      ? never
      : Id
    : Id;
}[TextId];

test("German texts have the arguments of the English ones", () => {
  expectTypeOf<Mismatched<typeof de>>().toEqualTypeOf<never>();
});

test("the compiler knows the arguments of a text, and their types", () => {
  type Found = ArgumentsOf<"{count, plural, one {# line ({name})} other {# lines}} of {size}">;
  expectTypeOf<Found>().toEqualTypeOf<{
    readonly count: number;
    readonly name: string | number;
    readonly size: string | number;
  }>();
  expectTypeOf<keyof ArgumentsOf<"Save">>().toEqualTypeOf<never>();
  expectTypeOf<
    ArgumentsOf<"{shelf, select, a {one word} other {{length, number}}}">
  >().toEqualTypeOf<{
    readonly shelf: string | number;
    readonly length: number;
  }>();
  expectTypeOf<TagsOf<"<b>{a}</b> and <code>b</code>">>().toEqualTypeOf<"b" | "code">();
});

test("a plural and a number follow the language", () => {
  expect(translate("importPanel.edges", { count: 1 })).toBe("1 edge");
  expect(translate("importPanel.edges", { count: 1200 })).toBe("1,200 edges");
  const german = (id: TextId, values: Record<string, string | number>) =>
    String(new IntlMessageFormat(de[id], "de").format(values));
  expect(german("importPanel.edges", { count: 1 })).toBe("1 Kante");
  expect(german("importPanel.edges", { count: 1200 })).toBe("1.200 Kanten");
  expect(german("learnedLooks.lineWidthMm", { lineWidth: 0.25 })).toBe("Strichstärke 0,25 mm");
});

test("a sentence of two counts is whole", () => {
  expect(translate("profileEditor.outcome", { changed: 0, open: 1 })).toBe(
    "These rules change no line type in this drawing; 1 edge matches no rule.",
  );
  expect(translate("profileEditor.outcome", { changed: 12, open: 0 })).toBe(
    "These rules change the line type of 12 edges in this drawing.",
  );
});

test.each([
  ["en", en],
  ["de", de],
])("all texts of %s are valid", (language, texts) => {
  const faults = Object.entries(texts).filter(([, text]) => {
    try {
      new IntlMessageFormat(text, language);
      return text.trim() === "";
    } catch {
      return true;
    }
  });
  expect(faults).toEqual([]);
});

test("German is German: no text is left in English", () => {
  // Names, units and figures are the same in both languages.
  const same = (Object.keys(en) as TextId[]).filter(
    (id) => en[id] === de[id] && /\p{L}{3}/u.test(en[id].replaceAll(/\{[^{}]*\}|<[^<>]*>/g, "")),
  );
  const words = new Set(same.map((id) => en[id]));
  expect([...words].sort()).toEqual(SAME);
});

/** Words that English and German share. */
const SAME: readonly string[] = [
  "Alarm",
  "Esc",
  "Laser",
  "Layer",
  "Layer {layer}",
  "Name",
  "Normal",
  "Perforation",
  "Start",
  "Station",
  "Station {number}",
  "Station {station}",
  "Status {status}",
  "Test",
  "Test: {data}",
  "URL",
  "Version {compared}",
  "Version {version}",
  "Webhooks",
  "cyan",
  "magenta",
  "webhook-id <code>{id}</code>",
];

describe("language", () => {
  test("is the one that was chosen, or else the first of the browser that there is", () => {
    expect(chooseLanguage("de", ["en-US"])).toBe("de");
    expect(chooseLanguage(null, ["fr", "de-AT", "en"])).toBe("de");
    expect(chooseLanguage("fr", ["fr"])).toBe("en");
    expect(chooseLanguage(null, [])).toBe("en");
  });

  test("has the dates of the browser's region", () => {
    expect(chooseLocale("en", ["de-DE", "en-GB"])).toBe("en-GB");
    expect(chooseLocale("de", ["en-GB"])).toBe("de");
  });
});

test("numbers have a fixed count of decimals, or at most three", () => {
  expect(formatFixed(1234.5, 2)).toBe("1234.50");
  expect(formatNumber(1234.5678)).toBe("1,234.568");
});
