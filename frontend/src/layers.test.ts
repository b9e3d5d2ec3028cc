/** app → panels → state → api → geometry  and  app → viewer → scene → geometry: held by a test. */

import { readdirSync, readFileSync } from "node:fs";
import { dirname, join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import { describe, expect, test } from "vitest";

const SRC = dirname(fileURLToPath(import.meta.url));

const MAY_IMPORT: Readonly<Record<string, readonly string[]>> = {
  geometry: ["geometry"],
  language: ["language"],
  messages: ["messages", "language", "api"],
  api: ["api", "language", "geometry"],
  state: ["state", "messages", "language", "api", "geometry"],
  panels: ["panels", "state", "messages", "language", "api", "geometry"],
  scene: ["scene", "geometry"],
  viewer: ["viewer", "scene", "geometry"],
  docs: [],
  app: ["app", "panels", "state", "messages", "language", "api", "viewer", "scene", "geometry"],
};

/** Libraries that only some layers may import. */
const ONLY_IN: Readonly<Record<string, readonly string[]>> = {
  three: ["viewer"],
  react: ["language", "state", "panels", "app"],
  "@mantine/core": ["panels", "app"],
  flatbush: ["geometry"],
  zustand: ["state"],
  wouter: ["app"],
  "wouter/use-hash-location": ["state", "app"],
  "intl-messageformat": ["language"],
};

interface Import {
  readonly file: string;
  readonly layer: string;
  readonly target: string;
}

function imports(): Import[] {
  return readdirSync(SRC, { recursive: true, encoding: "utf8" })
    .filter((name) => /\.tsx?$/.test(name) && name.includes("/"))
    .flatMap((file) => {
      const text = readFileSync(join(SRC, file), "utf8");
      return [...text.matchAll(/(?:from\s+|import\s+|import\()"([^"]+)"/g)].map(
        ([, found = ""]) => ({
          file,
          layer: file.split("/")[0] ?? "",
          target: found.startsWith(".") ? relative(SRC, join(SRC, dirname(file), found)) : found,
        }),
      );
    });
}

describe("layers", () => {
  const all = imports();

  test("every folder has a layer", () => {
    expect([...new Set(all.map(({ layer }) => layer))].sort()).toEqual(
      Object.keys(MAY_IMPORT).sort(),
    );
  });

  test("no layer imports one above it", () => {
    const wrong = all.filter(({ layer, target, file }) => {
      const floor = target.split("/")[0] ?? "";
      return floor in MAY_IMPORT && !MAY_IMPORT[layer]?.includes(floor) && file !== target;
    });
    expect(wrong).toEqual([]);
  });

  test("libraries stay where they belong", () => {
    const wrong = all.filter(({ layer, target, file }) => {
      const homes = ONLY_IN[target];
      return homes !== undefined && !homes.includes(layer) && !file.endsWith(".test.ts");
    });
    expect(wrong).toEqual([]);
  });

  test("the scene uses neither DOM nor WebGL", () => {
    const names = readdirSync(join(SRC, "scene")).filter((name) => !name.endsWith(".test.ts"));
    for (const name of names) {
      const text = readFileSync(join(SRC, "scene", name), "utf8");
      expect(text, name).not.toMatch(/\b(window|document|HTMLElement|WebGL\w*Context)\b/);
    }
  });
});
