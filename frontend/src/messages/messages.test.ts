import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { describe, expect, expectTypeOf, test } from "vitest";
import type { Mismatched } from "./catalogue";
import type { TEXTS } from "./en.gen";
import { messageHint, messageText } from "./translateMessage";

test("templates name only arguments of their codes", () => {
  // The compiler checks it: a mismatch makes this type a union of codes.
  expectTypeOf<Mismatched<typeof TEXTS>>().toEqualTypeOf<never>();
});

describe("rendering", () => {
  test("formats numbers, plurals and units, and renders nested messages", () => {
    const shape = { code: "stored.text", arguments: { text: "divides two panels", hint: "" } };
    const guess = {
      code: "question.guess",
      arguments: { type: "v-groove", percent: 55, reason: shape },
    };
    const line = {
      edges: 1246,
      layer: "A: B",
      colour: "1",
      linetype: "CONTINUOUS",
      length: 1389,
      width: 229,
      height: 155,
      x: 0,
      y: 345.2,
      unit: "mm",
      guess,
    };
    expect(messageText({ code: "question.line-type", arguments: line })).toBe(
      '1,246 edges on layer "A: B" (colour 1, line style CONTINUOUS) have no line type: ' +
        "total length 1,389.0 mm, extent 229.0 × 155.0 mm, lower left corner at X 0.0, Y 345.2. " +
        "Which line type should these edges get? The most likely line type is v-groove (55 %): divides two panels.",
    );
    expect(
      messageText({ code: "question.line-type", arguments: { ...line, edges: 1, guess: null } }),
    ).toContain("1 edge on layer");
  });

  test("joins lists, and leaves out what is absent", () => {
    const size = (unit: string, width: number) => ({
      code: "question.unit-size",
      arguments: { unit, width, height: 76.2 },
    });
    const reason = { code: "question.unit-not-stated", arguments: {} };
    const sizes = [size("in", 101.6), size("m", 4000)];
    expect(
      messageText({ code: "question.unit", arguments: { reason, sizes, evidence: null } }),
    ).toBe(
      "The file does not state the unit of the drawing. In which unit is the drawing? " +
        "Its possible sizes are: 101.6 × 76.2 mm if the unit is inches, 4,000 × 76.2 mm if the unit is metres.",
    );
  });

  test("quotes, joins alternatives and rounds to significant digits as the server does", () => {
    const known = { code: "library.unknown", arguments: { shelf: "board", name: "x", known: [] } };
    expect(messageText(known)).toContain("'x'");
    const { code, arguments: given } = {
      code: "bridges.no-room",
      arguments: { edge: 3, length: 12.5, fewest: 2, gap: 0.4, spacing: 100 },
    };
    expect(messageText({ code, arguments: given })).toContain("12.5");
  });

  test("of a code that only a newer server has takes the text of the server", () => {
    const newer = { code: "newer.code", arguments: {}, text: "New.", hint: "Reload." };
    expect(messageText(newer)).toBe("New.");
    expect(messageHint(newer)).toBe("Reload.");
  });

  test("with arguments that only another version has takes the text of the server", () => {
    const other = { code: "question.line-type", arguments: {}, text: "Which?", hint: "Choose." };
    expect(messageText(other)).toBe("Which?");
  });

  test("of a stored text is that text", () => {
    const stored = { code: "stored.text", arguments: { text: "Old.", hint: "Retry." } };
    expect([messageText(stored), messageHint(stored)]).toEqual(["Old.", "Retry."]);
  });
});

describe("sentences", () => {
  const SRC = join(dirname(fileURLToPath(import.meta.url)), "..");
  const sources = readdirSync(SRC, { recursive: true, encoding: "utf8" })
    .filter((name) => /\.tsx?$/.test(name) && !/\.(test|gen)\.tsx?$/.test(name))
    .map((name) => ({ name, source: readFileSync(join(SRC, name), "utf8") }));
  const FIELDS = "(?:text|detail|hint|reason|theme|title|message)";
  /** A sentence as the subject of a regular expression, of a comparison of parts, or of a split. */
  const PARSES = [
    new RegExp(`\\.(?:exec|test)\\([^()]*\\b\\w+\\.${FIELDS}\\b`),
    /\b(?:reason|detail|hint|theme)\??\.(?:match|replace|search|split|slice)\(/,
    new RegExp(
      `\\.${FIELDS}\\??\\.(?:match|matchAll|replace|replaceAll|search|split|startsWith|endsWith|includes|indexOf|slice)\\(`,
    ),
  ];

  const parsed = (text: string) => PARSES.some((pattern) => pattern.test(text));

  test("are not parsed anywhere", () => {
    expect(sources.length).toBeGreaterThan(100);
    const found = sources.filter(({ source }) => parsed(source)).map(({ name }) => name);
    expect(found).toEqual([]);
  });

  test("would be found if they were", () => {
    expect(parsed("const [, share] = LIKELY.exec(question.text) ?? [];")).toBe(true);
    expect(parsed("const left = question.text.replace(WHICH, '');")).toBe(true);
    expect(parsed('if (job.reason.startsWith("Waiting"))')).toBe(true);
    expect(parsed("job.reason || fallback")).toBe(false);
  });
});
