import { beforeEach, expect, test } from "vitest";
import { useDrafting } from "../drafting/drafting";
import { STEPS, useUiStore } from "../store";
import { COMMANDS, commandsOf } from "./commands";
import { foundBy } from "./search";

const named = (id: string) => {
  const found = COMMANDS.find((one) => one.id === id);
  if (found === undefined) throw new Error(id);
  return found;
};

beforeEach(() => {
  useUiStore.getState().open(null);
  useDrafting.getState().choose(null);
});

test("a key has one command in each step", () => {
  for (const step of STEPS) {
    const keys = commandsOf(step).flatMap((one) => one.keys.map((key) => JSON.stringify(key)));
    expect(keys.filter((key, at) => keys.indexOf(key) !== at)).toEqual([]);
  }
});

test("commands and their names are different from one another", () => {
  const ids = COMMANDS.map(({ id }) => id);
  const titles = COMMANDS.map(({ title }) => title);
  expect(new Set(ids).size).toBe(ids.length);
  expect(new Set(titles).size).toBe(titles.length);
});

test("commands of the selection need one, and tools the Lines step", () => {
  expect(named("type-crease").ready()).toBe(false);
  expect(named("select-similar").ready()).toBe(false);
  useUiStore.getState().selectEdges([1]);
  expect(named("type-crease").ready()).toBe(true);
  expect(commandsOf("check").map(({ id }) => id)).not.toContain("tool-lasso");
  expect(commandsOf("lines").map(({ id }) => id)).toContain("tool-lasso");
  expect(commandsOf(null).map(({ id }) => id)).toContain("help");
});

test("Escape gives up the tool before the selection", () => {
  useUiStore.getState().selectEdges([1, 2]);
  named("tool-lasso").run();
  expect(useDrafting.getState().tool).toBe("lasso");
  named("cancel").run();
  expect(useDrafting.getState().tool).toBeNull();
  expect(useUiStore.getState().selection.size).toBe(2);
  named("cancel").run();
  expect(useUiStore.getState().selection.size).toBe(0);
});

test("commands are found by parts of words in any order", () => {
  expect(foundBy("list sh", "Show or hide the list of edges")).toBe(true);
  expect(foundBy("vergrossern", "Vergrößern")).toBe(false);
  expect(foundBy("anderung", "Letzte Änderung")).toBe(true);
  expect(foundBy("x", "Letzte Änderung")).toBe(false);
  expect(foundBy("", "Letzte Änderung")).toBe(true);
});
