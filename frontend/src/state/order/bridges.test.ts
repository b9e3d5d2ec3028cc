import { describe, expect, test } from "vitest";
import type { Edges } from "../../geometry/records";
import { bridgeNear, bridgePlaces, distanceAlong, withBridgeWidth, withoutBridge } from "./bridges";

const [CUT, CREASE] = [1, 2];
/** A cut from (0, 0) to (100, 0), a half circle above it, a crease, and a short cut. */
const EDGES = {
  ends: new Float64Array([0, 0, 100, 0, 100, 0, 0, 0, 0, 10, 100, 10, 0, 20, 1, 20]),
  bulge: new Float64Array([0, 1, 0, 0]),
  lineType: new Uint8Array([CUT, CUT, CREASE, CUT]),
} as Edges;

describe("a click on an edge", () => {
  test("places a bridge at the nearest point of a line or an arc", () => {
    expect(bridgeNear(EDGES, 0, { x: 25, y: 3 }, 2)).toEqual({ edges: [0], at: 0.25, width: 2 });
    expect(bridgeNear(EDGES, 1, { x: 50, y: 60 }, 2)?.at).toBe(0.5);
  });

  test("keeps the bridge on the edge", () => {
    expect(bridgeNear(EDGES, 0, { x: 0, y: 0 }, 2)?.at).toBe(0.01);
    expect(bridgeNear(EDGES, 0, { x: 120, y: 0 }, 2)?.at).toBe(0.99);
  });

  test("places none on a crease or on an edge that is too short", () => {
    expect(bridgeNear(EDGES, 2, { x: 25, y: 10 }, 2)).toBeNull();
    expect(bridgeNear(EDGES, 3, { x: 0.5, y: 20 }, 2)).toBeNull();
  });
});

test("bridges are listed, changed, marked and removed", () => {
  const bridges = [
    { edges: [0], at: 0.25, width: 2 },
    { edges: [0], at: 0.5, width: 2 },
  ];
  expect(withBridgeWidth(bridges, 1, 3)[1]?.width).toBe(3);
  expect(withoutBridge(bridges, 0)).toEqual([bridges[1]]);
  expect(bridgePlaces(bridges, EDGES)).toEqual([
    { x: 25, y: 0 },
    { x: 50, y: 0 },
  ]);
  expect(bridgePlaces([{ edges: [9], at: 0, width: 1 }], EDGES)).toEqual([]);
  expect(bridges.map((bridge) => distanceAlong(bridge, EDGES))).toEqual([25, 50]);
});
