import { describe, expect, test } from "vitest";
import { MOTIONS, type Toolpath } from "../../geometry/records";
import { buildTimeline } from "../../geometry/timeline";
import { largestOffset } from "./compensation";

const FEED = MOTIONS.indexOf("feed");

/** Two cuts of 10 mm along X, with the tools of stations 1 and 2; the second begins at y = 5. */
const path = {
  pose: new Float64Array([0, 0, 0, 0, 10, 0, 0, 0, 20, 5, 0, 90]),
  bulge: new Float64Array([0, 0]),
  feed: new Float64Array([600, 600]),
  motion: new Uint8Array([FEED, FEED]),
  tool: new Uint8Array([1, 2]),
  source: new Int32Array([3, 4]),
  line: new Int32Array([1, 2]),
  placement: [1, 2],
} as unknown as Toolpath;

describe("the largest offset of head and tip", () => {
  test("is at the tool with the largest distance", () => {
    const offsets = new Map([
      [1, { left: 0, behind: 0.4, blade: 0 }],
      [2, { left: 3, behind: 0, blade: 0 }],
    ]);
    const found = largestOffset(buildTimeline(path), offsets);
    expect(found?.edge).toBe(4);
    expect(found?.head).toEqual({ x: 19, y: 3 });
    // tip = head - left · (sin 90°, -cos 90°)
    expect(found?.tip.x).toBeCloseTo(16);
    expect(found?.tip.y).toBeCloseTo(3);
    expect(found?.from).toBeCloseTo(1);
  });

  test("is none if every tool runs on its line", () => {
    expect(largestOffset(buildTimeline(path), new Map())).toBeNull();
  });
});
