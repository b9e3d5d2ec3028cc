import { expect, test } from "vitest";
import type { Placed } from "../../api/layouts";
import { collidingCopies, overlap } from "./collisions";
import {
  alignShift,
  begin,
  change,
  type Draft,
  mostCopies,
  NEW_SHEET,
  normalTurn,
  record,
  redo,
  snapShift,
  undo,
} from "./placing";
import { remnantOf } from "./remnant";
import { boxOfPlaced, type Copy, copiesOf, type DrawingShape, turnShape } from "./shapes";

const UPRIGHT = { turn: 0, mirror: false };
/** An L of 100 × 60 mm with arms of 20 mm; its edges and its outline. */
const CORNERS = [10, 5, 110, 5, 110, 25, 30, 25, 30, 65, 10, 65];
const L: DrawingShape = {
  name: "L",
  edges: {
    ends: Float64Array.from(
      CORNERS.flatMap((_, at) =>
        at % 2 ? [] : [0, 1, 2, 3].map((k) => CORNERS[(at + k) % CORNERS.length] ?? 0),
      ),
    ),
    bulge: new Float64Array(6),
  },
  outlines: [CORNERS],
  holes: [],
  area: 2800,
};
const placed = (x: number, y: number, fields: Partial<Placed> = {}): Placed => ({
  ...{ drawing: "a", revision: null, x, y, turn: 0, mirror: false },
  ...{ columns: 1, rows: 1, gap_x: 0, gap_y: 0, ...fields },
});
const SHEET = { ...NEW_SHEET, width: 300, height: 200 };
const copies = (...list: Placed[]): Copy[] => copiesOf(list, (one) => turnShape(L, one));
const colliding = (...list: Placed[]) => [...collidingCopies(copies(...list), SHEET)].sort();

test("a drawing is mirrored, turned and put with its box at the origin", () => {
  const { width, height, outlines } = turnShape(L, { turn: 90, mirror: true });
  expect([width, height]).toEqual([60, 100]);
  // The corner of the L is at the right below after the mirror, and at the right above then.
  expect(outlines[0]?.slice(0, 2)).toEqual([60, 100]);
  expect(turnShape(L, { turn: -90, mirror: false }).width).toBe(60);
  expect(turnShape(L, { turn: 45, mirror: false }).width).toBeCloseTo(160 / Math.SQRT2);
});

test("rows and columns are copies at the distance of their boxes", () => {
  const one = placed(5, 10, { columns: 2, rows: 2, gap_x: 3, gap_y: 7 });
  expect(copies(one).map(({ x, y }) => [x, y])).toEqual([
    [5, 10],
    [108, 10],
    [5, 77],
    [108, 77],
  ]);
  expect(boxOfPlaced(one, turnShape(L, UPRIGHT))).toEqual([5, 10, 208, 137]);
});

test("copies that touch do not collide, and those that cross or lie within each other do", () => {
  expect(colliding(placed(0, 0), placed(100, 0))).toEqual([]);
  expect(colliding(placed(0, 0), placed(99.9, 0))).toEqual([0, 1]);
  expect(colliding(placed(0, 0), placed(0, 0))).toEqual([0, 1]);
  // The boxes overlap; one L lies in the corner of the other.
  expect(colliding(placed(0, 0), placed(25, 25))).toEqual([]);
  expect(colliding(placed(0, 0), placed(10, 25))).toEqual([0, 1]);
  // Turned by 180°, both interlock with no room between them.
  expect(colliding(placed(0, 0), placed(20, 20, { turn: 180 }))).toEqual([]);
  expect(colliding(placed(0, 0), placed(19, 19, { turn: 180 }))).toEqual([0, 1]);
});

test("a small shape within a large one collides", () => {
  const square = (size: number) => [0, 0, size, 0, size, size, 0, size];
  const shape = (size: number) => ({
    width: size,
    height: size,
    outlines: [square(size)],
    holes: [],
  });
  const inner: Copy = { placed: 0, x: 20, y: 20, shape: shape(5) };
  const outer: Copy = { placed: 1, x: 0, y: 0, shape: shape(50) };
  expect(overlap(inner, outer)).toBe(true);
  expect(overlap(outer, inner)).toBe(true);
  expect(overlap({ ...inner, x: 60 }, outer)).toBe(false);
});

test("a small shape in a hole of a large one does not collide", () => {
  const square = (low: number, high: number) => [low, low, high, low, high, high, low, high];
  const inner = { width: 5, height: 5, outlines: [square(0, 5)], holes: [] };
  const frame = { width: 50, height: 50, outlines: [square(0, 50)], holes: [square(10, 40)] };
  const collide = (x: number, y: number): boolean =>
    overlap({ placed: 0, x, y, shape: inner }, { placed: 1, x: 0, y: 0, shape: frame });
  expect([collide(20, 20), collide(10, 35)]).toEqual([false, false]);
  const filling = { ...inner, outlines: [square(0, 30)] };
  const hosting = { placed: 1, x: 0, y: 0, shape: frame };
  expect(overlap({ placed: 0, x: 10, y: 10, shape: filling }, hosting)).toBe(false);
  expect([collide(8, 20), collide(2, 2), collide(36, 20)]).toEqual([true, true, true]);
  // What is larger than the hole lies on board, also where it touches the hole.
  const larger = { ...inner, outlines: [square(0, 35)] };
  expect(overlap({ placed: 0, x: 5, y: 10, shape: larger }, hosting)).toBe(true);
  expect(overlap({ placed: 0, x: 10, y: 10, shape: larger }, hosting)).toBe(true);
});

test("copies that extend over the edge of the sheet collide", () => {
  expect(colliding(placed(200, 140))).toEqual([]);
  expect(colliding(placed(200.1, 140))).toEqual([0]);
  expect(colliding(placed(0, -0.1))).toEqual([0]);
});

test("undo and redo restore drafts, and a drag is one step", () => {
  const draft = (x: number): Draft => ({ sheet: SHEET, placed: [placed(x, 0)] });
  let history = record(begin(draft(0)), draft(1));
  for (const x of [2, 3]) history = record(history, draft(x), true);
  expect(undo(history).present).toEqual(draft(0));
  expect(redo(undo(history)).present).toEqual(draft(3));
  expect(undo(undo(history)).present).toEqual(draft(0));
  expect(record(undo(history), draft(9)).future).toEqual([]);
});

test("only chosen drawings change", () => {
  const draft = { sheet: SHEET, placed: [placed(0, 0), placed(5, 5)] };
  const changed = change(draft, new Set([1]), ({ x }) => ({ x: x + 1 }));
  expect(changed.placed.map(({ x }) => x)).toEqual([0, 6]);
});

test("boxes snap to sides within reach, and beside others with the gap", () => {
  const other = [100, 0, 150, 50] as const;
  expect(snapShift([42, 1, 96, 40], [other], 5, 4)).toEqual([-1, -1]);
  expect(snapShift([42, 20, 90, 40], [other], 5, 4)).toEqual([0, 0]);
});

test("boxes align with a frame", () => {
  const box = [10, 20, 30, 50] as const;
  const frame = [0, 0, 100, 100] as const;
  expect(alignShift(box, frame, "right")).toEqual([70, 0]);
  expect(alignShift(box, frame, "centreY")).toEqual([0, 15]);
});

test("a sheet is filled with as many rows and columns as fit", () => {
  const size = { width: 100, height: 60 };
  expect(mostCopies(placed(0, 0, { gap_x: 0 }), size, SHEET)).toEqual({ columns: 3, rows: 3 });
  expect(mostCopies(placed(1, 0, { gap_y: 11 }), size, SHEET)).toEqual({ columns: 2, rows: 2 });
});

test("turns are between 0 and 360°", () => {
  expect([normalTurn(-90), normalTurn(450), normalTurn(0)]).toEqual([270, 90, 0]);
});

test("the remnant is the larger strip beside all copies, unless it is too small", () => {
  const shape = turnShape(L, UPRIGHT);
  const copies: Copy[] = [{ placed: 0, x: 10, y: 10, shape }];
  // Right of the L of 100 mm: 300 − 110 − 5 = 185 × 200; above: 300 × (200 − 70 − 5).
  expect(remnantOf(copies, SHEET, 5)).toEqual({ width: 300, height: 125 });
  expect(remnantOf(copies, { width: 300, height: 160 }, 5)).toEqual({ width: 185, height: 160 });
  expect(remnantOf(copies, { width: 190, height: 160 }, 5)).toBeNull();
  expect(remnantOf([], SHEET, 5)).toBeNull();
});
