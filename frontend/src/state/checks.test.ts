import { expect, test } from "vitest";
import type { Board, Drawing, Job, Machine } from "../api/client";
import { checksKey, checksOf } from "./checks";

const JOB = {
  id: "j",
  board: "grey",
  waiting_for: "confirmation",
  copies_done: 0,
  sheet: null,
  tools: [
    { station: 1, name: "Knife", kind: "knife" },
    { station: 3, name: "Wheel", kind: "crease-wheel" },
  ],
} as unknown as Job;
const MACHINE = { origin: [20, 30] } as unknown as Machine;
const DRAWING = { bounds: [5, 5, 405, 305] } as unknown as Drawing;
const BOARD = { name: "grey", title: "Greyboard" } as Board;

test("board, place, each tool and the clear table are checked before the first sheet", () => {
  const checks = checksOf(JOB, BOARD, MACHINE, DRAWING);
  expect(checks.map(({ key }) => key)).toEqual(["board", "place", "tool 1", "tool 3", "clear"]);
  expect(checks[0]?.title).toBe("Greyboard");
  expect(checks[1]?.detail).toContain("X 20, Y 30 mm");
  expect(checks[1]?.detail).toContain("400.0 × 300.0");
});

test("the next sheet needs no check of the tools", () => {
  const checks = checksOf({ ...JOB, waiting_for: "sheet" }, BOARD, MACHINE, DRAWING);
  expect(checks.map(({ key }) => key)).toEqual(["board", "place", "clear"]);
});

test("ticks of one copy are void for the next, and for another job", () => {
  const keys = [JOB, { ...JOB, copies_done: 1 }, { ...JOB, id: "k" }].map(checksKey);
  expect(new Set(keys).size).toBe(3);
});
