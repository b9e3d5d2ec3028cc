import { expect, test } from "vitest";
import type { Board, Confirmation, Drawing, Job } from "../api/client";
import { checkedStations, checksKey, checksOf } from "./checks";

const KNIFE = { station: 1, name: "Knife", kind: "knife", used: 12.34, life: 500, warning: "" };
const WHEEL = { station: 3, name: "Wheel", kind: "crease-wheel", used: 0, life: null, warning: "" };
const ASKED = {
  awaited: true,
  machine: "table",
  board: "grey",
  tools: [KNIFE, WHEEL],
  placement: [20, 30],
  sheet: null,
  copy: 1,
  copies: 2,
  first_of_batch: true,
  rest_of_sheet: false,
  unfinished_sheet: "",
} as Confirmation;
const DRAWING = { bounds: [5, 5, 405, 305] } as unknown as Drawing;
const BOARD = { name: "grey", title: "Greyboard" } as Board;

test("board, place, each tool and the clear table are checked before the first sheet", () => {
  const checks = checksOf(ASKED, BOARD, DRAWING);
  expect(checks.map(({ key }) => key)).toEqual(["board", "place", "tool 1", "tool 3", "clear"]);
  expect(checks[0]?.title).toBe("Greyboard");
  expect(checks[1]?.detail).toContain("X 20, Y 30 mm");
  expect(checks[1]?.detail).toContain("400.0 × 300.0");
  expect(checks[2]?.detail).toContain("12 of 500 m");
  expect(checkedStations(checks)).toEqual([1, 3]);
});

test("the next sheet needs a check of worn tools only", () => {
  const worn = { ...KNIFE, used: 505, warning: "over" as const };
  const next = { ...ASKED, copy: 2, first_of_batch: false };
  const checks = checksOf(next, BOARD, DRAWING);
  expect(checks.map(({ key }) => key)).toEqual(["board", "place", "clear"]);
  expect(checkedStations(checks)).toBeNull();
  const warned = checksOf({ ...next, tools: [worn, WHEEL] } as Confirmation, BOARD, DRAWING);
  expect(warned[2]).toMatchObject({ key: "tool 1", warns: true });
  expect(warned[2]?.detail).toContain("change it");
});

test("the rest of a sheet needs the begun sheet, not a new one", () => {
  const checks = checksOf({ ...ASKED, rest_of_sheet: true }, BOARD, DRAWING);
  expect(checks[0]?.detail).toContain("begun sheet");
  expect(checks[1]?.title).toContain("not moved");
});

test("an unfinished sheet of an earlier job must be removed", () => {
  const checks = checksOf({ ...ASKED, unfinished_sheet: "abc" }, BOARD, DRAWING);
  expect(checks.at(-2)?.title).toBe("Unfinished sheet is removed");
  expect(checks.at(-2)?.detail).toContain("Job abc");
});

test("ticks of one copy are void for the next, and for another job", () => {
  const job = { id: "j", copies_done: 0, waiting_for: "confirmation" } as Job;
  const keys = [job, { ...job, copies_done: 1 }, { ...job, id: "k" }].map(checksKey);
  expect(new Set(keys).size).toBe(3);
});
