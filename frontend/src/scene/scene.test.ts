import { describe, expect, test } from "vitest";
import { vCutter } from "../geometry/footprint.fixture";
import { type Edges, LINE_TYPES, type Toolpath } from "../geometry/records";
import { cornersOnDrawing } from "../geometry/similarity";
import { buildTimeline } from "../geometry/timeline";
import { tipOffset } from "../geometry/tip";
import { dielineLines, highlightLines, type Palette } from "./dieline";
import { NEVER, type Rgba, rgba } from "./lines";
import { gridLines, gridStep, zoneLines } from "./overlays";
import { pathLines } from "./pathLines";

const RED: Rgba = [255, 0, 0, 255];
const BLUE: Rgba = [0, 0, 255, 255];
const GREY: Rgba = [128, 128, 128, 255];

const PALETTE = Object.fromEntries(
  LINE_TYPES.map((type) => [
    type,
    { colour: type === "cut" ? RED : BLUE, dash: type === "crease" ? "dashed" : "solid" },
  ]),
) as Palette;

/** A cut of 100 mm, and a crease along a quarter circle of radius 10. */
const EDGES: Edges = {
  ends: Float64Array.of(0, 0, 100, 0, 10, 0, 0, 10),
  bulge: Float64Array.of(0, Math.tan(Math.PI / 8)),
  lineType: Uint8Array.of(1, 2),
  layer: Int32Array.of(0, 0),
  colour: Int32Array.of(1, 3),
  linetype: Int32Array.of(0, 0),
  lineWidth: Int32Array.of(-1, -1),
  rule: Int32Array.of(0, 0),
  confidence: Float64Array.of(1, 1),
  length: Float64Array.of(100, 5 * Math.PI),
  handles: ["A", "B"],
  layers: ["0"],
  rules: [""],
  ruleCodes: [""],
  linetypes: ["Continuous"],
  alternatives: [],
  outcome: new Uint8Array(2),
  reason: new Int32Array(2),
  reasons: [""],
};
const ORIGIN = { x: 50, y: 0 };

describe("the dieline", () => {
  test("is coloured by line type, about the origin", () => {
    const lines = dielineLines(EDGES, ORIGIN, PALETTE);
    expect([...lines.ends.slice(0, 4)]).toEqual([-50, 0, 50, 0]);
    expect([...lines.colour.slice(0, 4)]).toEqual(RED);
    expect([...lines.colour.slice(4, 8)]).toEqual(BLUE);
  });

  test("has arcs in pieces that run on from each other", () => {
    const lines = dielineLines(EDGES, ORIGIN, PALETTE);
    expect(lines.count).toBeGreaterThan(10);
    for (let at = 2; at < lines.count; at++) {
      expect(lines.row[at]).toBe(1);
      expect(lines.ends[at * 4]).toBe(lines.ends[at * 4 - 2]);
      expect(lines.along[at]).toBeGreaterThan(lines.along[at - 1] ?? 0);
    }
    expect(lines.along[lines.count - 1]).toBeLessThan(5 * Math.PI);
  });

  test("leaves out hidden edges", () => {
    const lines = dielineLines(EDGES, ORIGIN, PALETTE, { shown: (row) => row === 0 });
    expect(lines.count).toBe(1);
  });

  test("keeps its digits a kilometre from zero", () => {
    const far = 1_000_000;
    const ends = Float64Array.of(far, far, far + 0.25, far);
    const lines = dielineLines(
      { ...EDGES, ends, bulge: Float64Array.of(0) },
      { x: far, y: far },
      PALETTE,
    );
    expect([...lines.ends]).toEqual([0, 0, 0.25, 0]);
  });

  test("a highlight of a row that is not there is empty", () => {
    expect(highlightLines(EDGES, ORIGIN, [7, -1], RED).count).toBe(0);
  });

  test("holds more pieces than it first had room for", () => {
    const many = 1000;
    const edges = {
      ...EDGES,
      ends: new Float64Array(many * 4).map((_, at) => at),
      bulge: new Float64Array(many),
      lineType: new Uint8Array(many).fill(1),
    };
    const lines = dielineLines(edges, { x: 0, y: 0 }, PALETTE);
    expect(lines.count).toBe(many);
    expect([...lines.ends.slice(-4)]).toEqual([3996, 3997, 3998, 3999]);
    expect([...lines.time.slice(-2)]).toEqual([Math.fround(NEVER), Math.fround(NEVER)]);
  });
});

describe("the travel", () => {
  /** A rapid of 20 mm, then a V-groove of 100 mm due east at the sheet's (1.5, -4) + (20, 20). */
  const PATH: Toolpath = {
    pose: Float64Array.of(
      ...[1.5, 16, 20, 0],
      ...[21.5, 16, 20, 0],
      ...[121.5, 16, 0, 0],
      ...[121.5, 16, 0, 90],
    ),
    bulge: Float64Array.of(0, 0, 0),
    motion: Uint8Array.of(0, 3, 4),
    feed: Float64Array.of(0, 6000, 36_000),
    source: Int32Array.of(-1, 0, -1),
    tool: Uint8Array.of(3, 3, 3),
    line: Int32Array.of(1, 2, 3),
    placement: [20, 20],
  };
  const colours = { head: BLUE, lead: BLUE, tip: RED, rapid: GREY };
  const offsets = new Map([[3, tipOffset(vCutter(4, 1.5))]]);
  const travel = pathLines(buildTimeline(PATH), { x: 0, y: 0 }, colours, offsets);

  test("is in the drawing's coordinates: the placement is taken off", () => {
    expect([...travel.head.ends.slice(0, 4)]).toEqual([1.5, -4, 101.5, -4]);
  });

  test("keeps rapids apart, and dashed", () => {
    expect(travel.rapids.count).toBe(1);
    expect(travel.rapids.dash[0]).not.toBe(0);
    expect(travel.head.row[0]).toBe(1);
  });

  test("has the tip on the line while the head runs beside it", () => {
    expect([...travel.tip.ends.slice(0, 4)]).toEqual([0, 0, 100, 0]);
  });

  test("has the tip swing about the head when the head turns on the spot", () => {
    const pieces = travel.tip.count - 1;
    expect(pieces).toBe(18);
    for (let at = 1; at <= pieces; at++) {
      const x = travel.tip.ends[at * 4 + 2] ?? 0;
      const y = travel.tip.ends[at * 4 + 3] ?? 0;
      expect(Math.hypot(x - 101.5, y + 4)).toBeCloseTo(Math.hypot(4, 1.5), 4);
    }
  });

  test("has the time of each segment", () => {
    const [from = 0, to = 0] = travel.head.time;
    // 100 mm and 20 mm down at 6000 mm/min.
    expect(to - from).toBeCloseTo(Math.hypot(100, 20) / 100, 4);
  });
});

describe("furniture", () => {
  test.each([
    [1, 10],
    [0.5, 100],
    [10, 1],
    [100, 0.1],
  ])("at %f pixels to the mm the grid's step is %f mm", (scale, step) => {
    expect(gridStep(scale)).toBeCloseTo(step, 12);
  });

  test("grid lines stand on whole steps", () => {
    const lines = gridLines([-15, -15, 15, 15], { x: 0, y: 0 }, 1, GREY, RED);
    expect(lines.count).toBe(6);
    expect([...lines.ends.slice(0, 4)]).toEqual([-10, -15, -10, 15]);
  });

  test("a colour's hexadecimal is its bytes", () => {
    expect(rgba("#ff8000", 0.5)).toEqual([255, 128, 0, 128]);
  });
});

test("the lines of a keep-out zone lie in its box", () => {
  const { count, ends } = zoneLines(
    [cornersOnDrawing([10, 20, 50, 30], [1, 0, 0, 0])],
    ORIGIN,
    RED,
  );
  expect(count).toBeGreaterThan(4);
  for (let at = 0; at < ends.length; at += 2) {
    const [x = 0, y = 0] = [(ends[at] ?? 0) + ORIGIN.x, (ends[at + 1] ?? 0) + ORIGIN.y];
    expect(x).toBeGreaterThanOrEqual(10);
    expect(x).toBeLessThanOrEqual(50);
    expect(y).toBeGreaterThanOrEqual(20);
    expect(y).toBeLessThanOrEqual(30);
  }
});
