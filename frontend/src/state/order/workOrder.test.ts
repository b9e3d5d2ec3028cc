import { describe, expect, test } from "vitest";
import type { Track } from "../../api/jobs";
import type { Edges } from "../../geometry/records";
import {
  brokenRule,
  freeOf,
  inChosenOrder,
  movedItem,
  newestProgram,
  orderOf,
  workItems,
} from "./workOrder";

const [CUT, CREASE] = [1, 2];
/** A square of 100 mm (edges 0 to 3), two lines in it (4 and 5), and a small cut in it (6). */
const EDGES = {
  ends: new Float64Array([
    ...[0, 0, 100, 0, 100, 0, 100, 100, 100, 100, 0, 100, 0, 100, 0, 0],
    ...[20, 10, 20, 90, 40, 10, 40, 90, 60, 50, 80, 50],
  ]),
  bulge: new Float64Array(7),
  lineType: new Uint8Array([CUT, CUT, CUT, CUT, CREASE, CREASE, CUT]),
} as Edges;

const track = (edges: number[], station = 1, end: [number, number] = [0, 0]): Track => ({
  number: 1,
  station,
  first_line: 1,
  last_line: 2,
  edges,
  start: [0, 0],
  end,
  stage: 1,
  state: "uncut",
});

const ITEMS = workItems(
  [track([4], 2), track([5], 2), track([6], 1, [20, 0]), track([0, 1, 2, 3])],
  EDGES,
);

describe("the tracks of a program", () => {
  test("are items with an edge that stands for each", () => {
    expect(orderOf(ITEMS)).toEqual([4, 5, 6, 0]);
    expect(ITEMS.map(({ type }) => type)).toEqual(["crease", "crease", "cut", "cut"]);
    expect(ITEMS.map(({ closed }) => closed)).toEqual([true, true, false, true]);
  });

  test("along the same edge are one item, and others get an edge of their own", () => {
    const shared = workItems([track([4]), track([4]), track([0, 1, 2]), track([2, 3, 0])], EDGES);
    expect(orderOf(shared)).toEqual([4, 1, 3]);
  });
});

describe("the chosen order", () => {
  test("puts listed tracks into the places of listed tracks", () => {
    expect(orderOf(inChosenOrder(ITEMS, []))).toEqual([4, 5, 6, 0]);
    expect(orderOf(inChosenOrder(ITEMS, [5, 4]))).toEqual([5, 4, 6, 0]);
    // Any edge of a track identifies it.
    expect(orderOf(inChosenOrder(ITEMS, [2, 4]))).toEqual([0, 5, 6, 4]);
  });

  test("is that of the items after a move", () => {
    expect(orderOf(movedItem(ITEMS, 0, 2))).toEqual([5, 6, 4, 0]);
    expect(orderOf(movedItem(ITEMS, 3, 0))).toEqual([0, 4, 5, 6]);
    expect(orderOf(movedItem(ITEMS, 9, 0))).toEqual([4, 5, 6, 0]);
  });

  test("may not break a rule", () => {
    expect(brokenRule(ITEMS, 0, 1)).toBeNull();
    expect(brokenRule(ITEMS, 1, 0)).toBeNull();
    const types = brokenRule(ITEMS, 0, 2);
    expect([types?.rule, types?.first.edge, types?.second.edge]).toEqual(["types", 4, 6]);
    const enclosed = brokenRule(ITEMS, 3, 2);
    expect([enclosed?.rule, enclosed?.first.edge, enclosed?.second.edge]).toEqual([
      "enclosed",
      6,
      0,
    ]);
    const tools = workItems([track([4], 2), track([5], 3)], EDGES);
    expect(brokenRule(tools, 1, 0)?.rule).toBe("tools");
  });
});

test("the tracks are those of the newest job with a program", () => {
  const jobs = [
    { program_sha256: "a", created: "2026-01-01" },
    { program_sha256: "b", created: "2026-01-03" },
    { program_sha256: "", created: "2026-01-05" },
  ];
  expect(newestProgram(jobs)?.program_sha256).toBe("b");
  expect(newestProgram([])).toBeNull();
});

test("numbers that would cover another one are left out, selected ones last", () => {
  const at = (x: number, selected = false) => ({ at: { x, y: 0 }, selected });
  expect(freeOf([at(0), at(10), at(30)], 18).map((mark) => mark.at.x)).toEqual([0, 30]);
  expect(freeOf([at(0), at(10, true), at(30)], 18).map((mark) => mark.at.x)).toEqual([10, 30]);
});
