import { expect, test } from "vitest";
import { groupChecks, touched } from "./checkGroups";
import type { Check } from "./checks";

const check = (key: string, station: number | null = null, warns = false): Check => ({
  key,
  title: `${key} is right.`,
  detail: "",
  station,
  warns,
});
const KNIFE = check("station-1", 1);
const WHEEL = check("station-3", 3);
const CHECKS = [
  check("board"),
  check("sheet"),
  KNIFE,
  WHEEL,
  check("table-clear"),
  check("hands-clear"),
];
const keys = (checks: readonly Check[]) =>
  groupChecks(checks).map((group) => [group.key, ...group.checks.map(({ key }) => key)]);

test("a start has three rows, and no check is lost", () => {
  expect(keys(CHECKS)).toEqual([
    ["material", "board", "sheet"],
    ["tools", "station-1", "station-3"],
    ["table", "table-clear", "hands-clear"],
  ]);
});

test("a worn tool and a sheet that was left have rows of their own", () => {
  const worn = check("station-3", 3, true);
  const [board, sheet, ...rest] = CHECKS.filter(({ key }) => key !== "station-3");
  const checks = [board, sheet, check("unfinished-sheet"), rest[0], worn, ...rest.slice(1)];
  expect(keys(checks as Check[])).toEqual([
    ["material", "board", "sheet"],
    ["unfinished-sheet", "unfinished-sheet"],
    ["station-1", "station-1"],
    ["station-3", "station-3"],
    ["table", "table-clear", "hands-clear"],
  ]);
});

test("a check that is alone has no title beside its text", () => {
  const fed = [check("board"), check("hands-clear")];
  expect(groupChecks(fed).map(({ key, title }) => [key, title])).toEqual([
    ["board", ""],
    ["hands-clear", ""],
  ]);
});

test("a check that the page does not know has a row of its own", () => {
  expect(keys([...CHECKS, check("vacuum")]).at(-1)).toEqual(["vacuum", "vacuum"]);
});

test("a touch ticks what is missing, and a second one takes all back", () => {
  const [, , table] = groupChecks(CHECKS);
  if (table === undefined) throw new Error("no row");
  expect(touched(table, new Set())).toEqual(["table-clear", "hands-clear"]);
  expect(touched(table, new Set(["table-clear"]))).toEqual(["hands-clear"]);
  expect(touched(table, new Set(["table-clear", "hands-clear"]))).toEqual([
    "table-clear",
    "hands-clear",
  ]);
});
