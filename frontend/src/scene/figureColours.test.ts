import { describe, expect, test } from "vitest";
import { type Edges, LINE_TYPES } from "../geometry/records";
import { dielineLines, type Palette } from "./dieline";
import {
  type FigureMap,
  figureColours,
  isWorked,
  type Scale,
  scaleColour,
  stretchColours,
} from "./figureColours";
import type { Rgba } from "./lines";

const SCALE: Scale = {
  stops: [
    [0, 0, 100, 255],
    [0, 100, 200, 255],
    [200, 200, 0, 255],
  ],
  beyond: [255, 0, 0, 255],
  unworked: [90, 90, 90, 255],
};

/** Two cuts, a crease and an ignored edge, each 10 mm long. */
const EDGES: Edges = {
  ends: Float64Array.of(0, 0, 10, 0, 10, 0, 10, 10, 0, 0, 0, 10, 0, 10, 10, 10),
  bulge: Float64Array.of(0, 0, 0, 0),
  lineType: Uint8Array.of(1, 1, 2, LINE_TYPES.indexOf("ignored")),
  layer: Int32Array.of(0, 0, 0, 0),
  colour: Int32Array.of(1, 1, 1, 1),
  linetype: Int32Array.of(0, 0, 0, 0),
  lineWidth: Int32Array.of(-1, -1, -1, -1),
  rule: Int32Array.of(0, 0, 0, 0),
  confidence: Float64Array.of(1, 1, 1, 1),
  length: Float64Array.of(10, 10, 10, 10),
  handles: ["A", "B", "C", "D"],
  layers: ["0"],
  rules: [""],
  ruleCodes: [""],
  linetypes: ["Continuous"],
  alternatives: [],
  outcome: new Uint8Array(4),
  reason: new Int32Array(4),
  reasons: [""],
};
const MAP: FigureMap = {
  figure: [0, 0.005, 0.02, 0],
  limit: 0.01,
  uncut: [0, 0, 0, 0],
  setback: [0, 0, 4, 0],
};

describe("a figure on the scale", () => {
  test.each<[number, Rgba]>([
    [0, [0, 0, 100, 255]],
    [0.75, [0, 50, 150, 255]],
    [1.5, [0, 100, 200, 255]],
    [2.25, [100, 150, 100, 255]],
    [3, [200, 200, 0, 255]],
  ])("%f mm of 3 lies between its stops", (figure, colour) => {
    expect(scaleColour(figure, 3, SCALE)).toEqual(colour);
  });

  test("rounded at its limit is not above it", () => {
    expect(scaleColour(3.000_000_000_4, 3, SCALE)).toEqual(SCALE.stops[2]);
  });

  test.each([3.001, Number.POSITIVE_INFINITY, Number.NaN])("%f mm of 3 is beyond", (figure) => {
    expect(scaleColour(figure, 3, SCALE)).toEqual(SCALE.beyond);
  });

  test("with limit 0, only 0 is within", () => {
    expect(scaleColour(0, 0, SCALE)).toEqual(SCALE.stops[0]);
    expect(scaleColour(0.1, 0, SCALE)).toEqual(SCALE.beyond);
  });
});

describe("the map", () => {
  const colours = figureColours(EDGES, MAP, SCALE);
  const at = (row: number) => [...colours.slice(row * 4, row * 4 + 4)];

  test("colours each edge by its figure", () => {
    expect(at(0)).toEqual(SCALE.stops[0]);
    expect(at(1)).toEqual(SCALE.stops[1]);
    expect(at(2)).toEqual(SCALE.beyond);
  });

  test("leaves what is not worked grey", () => {
    expect(at(3)).toEqual(SCALE.unworked);
    expect(isWorked(EDGES, { ...MAP, uncut: [10, 0, 0, 0] }, 0)).toBe(false);
    expect(isWorked(EDGES, { ...MAP, uncut: [9, 0, 0, 0] }, 0)).toBe(true);
    expect(isWorked(EDGES, { ...MAP, uncut: [0, 0, 6, 0] }, 2)).toBe(false);
  });

  test("takes a crease that is pressed on the spot for worked", () => {
    expect(isWorked(EDGES, { ...MAP, setback: [0, 0, 10, 0] }, 2)).toBe(true);
  });

  test("has the colours of the line types, without their gaps", () => {
    const palette = Object.fromEntries(
      LINE_TYPES.map((type) => [type, { colour: [1, 2, 3, 255], dash: "dotted" }]),
    ) as unknown as Palette;
    const lines = dielineLines(EDGES, { x: 0, y: 0 }, palette, { colours });
    expect([...lines.colour]).toEqual([...colours]);
    expect([...lines.dash]).toEqual([0, 0, 0, 0]);
  });
});

test("what is set back is drawn fainter, each part where it is", () => {
  const palette = Object.fromEntries(
    LINE_TYPES.map((type) => [type, { colour: [1, 2, 3, 200], dash: "solid" }]),
  ) as unknown as Palette;
  const worked = Float64Array.of(0.2, 0.7, 0, 1, 0, 1, 0, 1);
  const lines = dielineLines(EDGES, { x: 0, y: 0 }, palette, {
    worked,
    shown: (row) => row === 0,
  });
  expect([...lines.ends]).toEqual([0, 0, 2, 0, 2, 0, 7, 0, 7, 0, 10, 0]);
  expect([3, 7, 11].map((at) => lines.colour[at])).toEqual([60, 200, 60]);
  expect([...lines.along]).toEqual([0, 2, 7]);
});

test("a part of an arc is that part of the same circle", () => {
  const palette = Object.fromEntries(
    LINE_TYPES.map((type) => [type, { colour: [1, 2, 3, 200], dash: "solid" }]),
  ) as unknown as Palette;
  // Half a circle of radius 5 about (5, 0), from (0, 0) below to (10, 0).
  const arc = { ...EDGES, bulge: Float64Array.of(1, 0, 0, 0) };
  const worked = Float64Array.of(0.25, 0.5, 0, 1, 0, 1, 0, 1);
  const lines = dielineLines(arc, { x: 0, y: 0 }, palette, { worked, shown: (row) => row === 0 });
  for (let at = 0; at < lines.count; at++) {
    const [x = 0, y = 0] = lines.ends.slice(at * 4 + 2, at * 4 + 4);
    expect(Math.hypot(x - 5, y)).toBeCloseTo(5, 5);
  }
  const full = [...lines.colour.keys()].filter((at) => at % 4 === 3 && lines.colour[at] === 200);
  const last = ((full.at(-1) ?? 0) - 3) / 4;
  expect(lines.ends[last * 4 + 2]).toBeCloseTo(5, 5);
  expect(lines.ends[last * 4 + 3]).toBeCloseTo(-5, 5);
});

describe("a deviation that changes along an edge", () => {
  const samples = {
    edge: Int32Array.of(1, 1, 1, 3, 3),
    place: Float64Array.of(0, 0.5, 1, 0, 1),
    deviation: Float64Array.of(0, 0, -0.003, 0, 0),
  };
  const along = stretchColours(EDGES, MAP, samples, SCALE);
  const lines = dielineLines(EDGES, { x: 0, y: 0 }, {} as Palette, {
    shown: (row) => row === 1,
    colours: figureColours(EDGES, MAP, SCALE),
    along,
  });

  test("colours each stretch, the worst like the edge", () => {
    // 0.005 for the edge, 0.003 of it found at its end: 0.002 are the controller's everywhere.
    expect([...along.first]).toEqual([0, 0, 3, 3, 5]);
    expect([...along.colour.slice(0, 4)]).toEqual([...scaleColour(0.002, 0.01, SCALE)]);
    expect([...along.colour.slice(4, 8)]).toEqual([...scaleColour(0.005, 0.01, SCALE)]);
  });

  test("keeps the colour of an edge that is not machined", () => {
    expect([...along.colour.slice(12, 16)]).toEqual([...SCALE.unworked]);
  });

  test("is drawn from stretch to stretch over the whole edge", () => {
    expect(lines.count).toBe(2);
    expect([...lines.ends]).toEqual([10, 0, 10, 5, 10, 5, 10, 10]);
    expect([...lines.colour.slice(4, 8)]).toEqual([...scaleColour(0.005, 0.01, SCALE)]);
  });
});
