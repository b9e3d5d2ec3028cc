import { describe, expect, test } from "vitest";
import type { Track } from "../../api/jobs";
import type { Blanks } from "../../api/layouts";
import type { Edges } from "../../geometry/records";
import { orderOf, type WorkItem, workItems } from "./workOrder";
import {
  brokenByLayer,
  brokenByPart,
  hasStages,
  movedInLayer,
  movedPart,
  partNumbers,
  workParts,
} from "./workParts";

const [CUT, CREASE] = [1, 2];
type Row = [number, number, number, number];

/** The sides of a square. */
const square = (x: number, y: number, size: number): Row[] => [
  [x, y, x + size, y],
  [x + size, y, x + size, y + size],
  [x + size, y + size, x, y + size],
  [x, y + size, x, y],
];

/**
 * Three blanks in a row: outlines 0–3, 4–7, 8–11; holes 12–15 and 16–19 in the first and the second
 * one; a crease in the first and the third one (20, 21); a blank in the hole of the second one
 * (22–25); and a cut beside them (26).
 */
const ROWS: Row[] = [
  ...square(0, 0, 100),
  ...square(120, 1, 100),
  ...square(240, 0, 100),
  ...square(10, 10, 30),
  ...square(130, 11, 60),
  [60, 10, 60, 90],
  [300, 10, 300, 90],
  ...square(140, 21, 20),
  [400, 0, 400, 50],
];
const EDGES = {
  ends: Float64Array.from(ROWS.flat()),
  bulge: new Float64Array(ROWS.length),
  lineType: Uint8Array.from(ROWS, (_, row) => (row === 20 || row === 21 ? CREASE : CUT)),
} as Edges;
const outline = ([first, , third]: Row[]) => {
  const [x0 = 0, y0 = 0] = first ?? [];
  const [x1 = 0, y1 = 0] = third ?? [];
  return {
    area: (x1 - x0) * (y1 - y0),
    bounds: [x0, y0, x1, y1],
    outline: [
      [x0, y0],
      [x1, y0],
      [x1, y1],
      [x0, y1],
    ],
    holes: [],
  };
};
const BLANKS = {
  blanks: [square(240, 0, 100), square(120, 1, 100), square(0, 0, 100), square(140, 21, 20)].map(
    outline,
  ),
} as unknown as Blanks;

const track = (stage: number, ...edges: number[]): Track => ({
  number: 1,
  station: stage === 1 ? 2 : 1,
  stage,
  first_line: 1,
  last_line: 2,
  edges,
  start: [0, 0],
  end: [0, 0],
  state: "uncut",
});
const ITEMS = workItems(
  [
    ...[track(1, 21), track(1, 20), track(2, 22, 23, 24, 25), track(3, 12, 13, 14, 15)],
    ...[track(3, 16, 17, 18, 19), track(4, 26), track(4, 8, 9, 10, 11), track(4, 0, 1, 2, 3)],
    track(4, 4, 5, 6, 7),
  ],
  EDGES,
);
const NUMBERS = partNumbers(ITEMS, EDGES, BLANKS);
const PARTS = workParts(ITEMS, NUMBERS);
const numbersOf = (items: readonly WorkItem[]) =>
  workParts(items, NUMBERS).map(({ number }) => number);

describe("the parts of a sheet", () => {
  test("are numbered row by row, and a blank in a hole has its own tracks", () => {
    const found = orderOf(ITEMS).map((edge) => [edge, NUMBERS.get(edge)]);
    expect(found).toEqual([
      ...[
        [21, 3],
        [20, 1],
        [22, 4],
        [12, 1],
        [16, 2],
        [26, 0],
        [8, 3],
        [0, 1],
        [4, 2],
      ],
    ]);
  });

  test("are listed as they are finished, with their operations", () => {
    expect(numbersOf(ITEMS)).toEqual([4, 0, 3, 1, 2]);
    const layers = PARTS[3]?.layers.map(({ stage, place, count }) => [stage, place, count]);
    expect(layers).toEqual([
      [1, 1, 1],
      [3, 1, 2],
      [4, 2, 2],
    ]);
    expect(PARTS[3]?.box).toEqual([0, 0, 100, 100]);
  });

  test("need the operations of the program", () => {
    expect(hasStages(ITEMS)).toBe(true);
    expect(hasStages(workItems([track(0, 26)], EDGES))).toBe(false);
  });
});

describe("a part", () => {
  test("is moved in each operation, and the operations keep their order", () => {
    const moved = movedPart(ITEMS, PARTS, 3, 2);
    expect(numbersOf(moved)).toEqual([4, 0, 1, 3, 2]);
    expect(orderOf(moved)).toEqual([20, 21, 22, 12, 16, 26, 0, 8, 4]);
    expect(orderOf(movedPart(ITEMS, PARTS, 4, 1))).toEqual([21, 20, 22, 16, 12, 4, 26, 8, 0]);
  });

  test("in a hole is finished before the part around it", () => {
    const broken = brokenByPart(PARTS, 4, 0);
    expect([broken?.rule, broken?.first.number, broken?.second.number]).toEqual(["enclosed", 4, 2]);
    expect(brokenByPart(PARTS, 4, 1)).toBeNull();
    expect(brokenByPart(PARTS, 0, 1)?.rule).toBe("pieces");
  });
});

describe("the operations of a part", () => {
  test("are not moved, and the rule is named", () => {
    const layers = PARTS[3]?.layers ?? [];
    expect(brokenByLayer(layers, 1, 0)?.rule).toBe("types");
    const broken = brokenByLayer(layers, 1, 2);
    expect([broken?.rule, broken?.first.stage, broken?.second.stage]).toEqual(["enclosed", 3, 4]);
  });

  test("have tracks that are moved among themselves only", () => {
    const items = workItems([track(1, 26), track(1, 0), track(1, 20), track(1, 1)], EDGES);
    const [part] = workParts(
      items,
      new Map([
        [0, 1],
        [1, 1],
      ]),
    ).filter(({ number }) => number === 1);
    const layer = part?.layers[0];
    expect(layer && orderOf(layer.items)).toEqual([0, 1]);
    expect(layer && orderOf(movedInLayer(items, layer, 0, 1))).toEqual([26, 1, 20, 0]);
  });
});
