/** Every class of a style sheet is used, and every class that is used exists. */

import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";

const SRC = dirname(fileURLToPath(import.meta.url));
const FILES = readdirSync(SRC, { recursive: true, encoding: "utf8" });
const SHEETS = FILES.filter((file) => file.endsWith(".module.css"));

/** The classes that the rules of a style sheet name. */
function classesOf(sheet: string): Set<string> {
  const selectors = sheet.replace(/\/\*[\s\S]*?\*\//g, "").replace(/\{[^{}]*\}/g, "{}");
  return new Set([...selectors.matchAll(/\.([a-zA-Z]\w*)/g)].map(([, name]) => String(name)));
}

/** The classes of each style sheet that the components name. */
function usedClasses(): Map<string, Set<string>> {
  const used = new Map<string, Set<string>>(SHEETS.map((sheet) => [sheet, new Set()]));
  for (const file of FILES.filter((name) => name.endsWith(".tsx"))) {
    const source = readFileSync(join(SRC, file), "utf8");
    for (const [, alias, path] of source.matchAll(/import (\w+) from "([^"]*\.module\.css)"/g)) {
      const names = source.matchAll(new RegExp(`\\b${alias}\\.(?!module\\.css)(\\w+)`, "g"));
      const sheet = used.get(join(dirname(file), String(path)));
      for (const [, name] of names) sheet?.add(String(name));
    }
  }
  return used;
}

test.each([...usedClasses()])("%s has the classes that are used, and no others", (sheet, used) => {
  const classes = classesOf(readFileSync(join(SRC, sheet), "utf8"));
  expect(
    [...classes].filter((name) => !used.has(name)),
    "unused",
  ).toEqual([]);
  expect(
    [...used].filter((name) => !classes.has(name)),
    "missing",
  ).toEqual([]);
});

test("a class that no component names is found", () => {
  const sheet =
    ".row > .mark:hover { margin: .5em }\n/* .old { } */\n@media (x) { .wide { a: b } }";
  expect([...classesOf(sheet)]).toEqual(["row", "mark", "wide"]);
});
