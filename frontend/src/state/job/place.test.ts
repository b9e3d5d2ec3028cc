import { expect, test } from "vitest";
import type { Toolpath } from "../../geometry/records";
import { buildTimeline } from "../../geometry/timeline";
import { edgeAt } from "./place";

const PATH: Toolpath = {
  pose: new Float64Array(16),
  bulge: new Float64Array(3),
  motion: Uint8Array.of(0, 3, 0),
  feed: new Float64Array(3),
  source: Int32Array.of(-1, 7, -1),
  tool: Uint8Array.of(1, 1, 1),
  line: Int32Array.of(1, 2, 3),
  seconds: Float64Array.of(1, 2, 1),
  placement: [0, 0],
};

test("the edge is the one that the tool makes, and in the air the last one", () => {
  const timeline = buildTimeline(PATH);
  expect([0.5, 2, 3.5].map((time) => edgeAt(timeline, time))).toEqual([-1, 7, 7]);
});
