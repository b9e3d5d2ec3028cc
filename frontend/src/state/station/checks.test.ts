import { expect, test } from "vitest";
import type { Drawing } from "../../api/drawings";
import type { Confirmation, Job } from "../../api/jobs";
import { checksKey, checksOf } from "./checks";

const KNIFE = { station: 1, name: "Knife", kind: "knife", used: 12.34, life: 500, warning: "" };
const WHEEL = { station: 3, name: "Wheel", kind: "crease-wheel", used: 0, life: null, warning: "" };
const check = (id: string, code: string, more: object = {}, station: number | null = null) => ({
  id,
  text: "",
  message: { code, arguments: more, text: "", hint: "" },
  station,
});
const ASKED = {
  awaited: true,
  machine: "table",
  board: "grey",
  checks: [
    check("board", "check.board", { board: "Greyboard", caliper: null }),
    check("sheet", "check.sheet-larger", { place: null }),
    check("station-1", "check.station", { station: 1, tool: "Knife" }, 1),
    check("station-3", "check.station", { station: 3, tool: "Wheel" }, 3),
    check("table-clear", "check.table"),
    check("hands-clear", "check.hands"),
  ],
  tools: [KNIFE, WHEEL],
  placement: [20, 30],
  sheet: null,
  copy: 1,
  copies: 2,
  first_of_batch: true,
  rest_of_sheet: false,
  unfinished_sheet: "",
} as unknown as Confirmation;
const DRAWING = { bounds: [5, 5, 405, 305] } as unknown as Drawing;

test("the ticks are the checks that the server asks for, by their ids", () => {
  const checks = checksOf(ASKED, DRAWING);
  expect(checks.map(({ key }) => key)).toEqual(ASKED.checks.map(({ id }) => id));
  expect(checks[0]?.title).toBe("The board on the table is Greyboard.");
  expect(checks[1]?.detail).toContain("400.0 × 300.0");
  expect(checks[2]).toMatchObject({ station: 1, warns: false });
  expect(checks[2]?.detail).toContain("12 of 500 m");
});

test("a worn tool warns, and says so", () => {
  const worn = { ...KNIFE, used: 505, warning: "over" as const };
  const [, , knife, wheel] = checksOf({ ...ASKED, tools: [worn, WHEEL] } as Confirmation, DRAWING);
  expect(knife).toMatchObject({ key: "station-1", warns: true });
  expect(knife?.detail).toContain("change it");
  expect(wheel?.warns).toBe(false);
});

test("the size of the drawing is told only where the sheet has no size of its own", () => {
  const rest = checksOf({ ...ASKED, rest_of_sheet: true }, DRAWING);
  expect(rest[1]?.detail).toBe("");
});

test("ticks of one copy are void for the next, and for another job", () => {
  const job = { id: "j", copies_done: 0, waiting_for: "confirmation" } as Job;
  const keys = [job, { ...job, copies_done: 1 }, { ...job, id: "k" }].map(checksKey);
  expect(new Set(keys).size).toBe(3);
});
