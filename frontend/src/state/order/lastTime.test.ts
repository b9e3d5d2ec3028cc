import { expect, test } from "vitest";
import type { Job } from "../../api/jobs";
import { DEFAULT_CORNERS } from "./corners";
import { asLastTime, isSame } from "./lastTime";
import { DEFAULT_OPTIONS } from "./options";

const DEPTHS = [
  { edges: [3], line_type: null, passes: 2, depth: null },
  { edges: [], line_type: "cut", passes: 3, depth: null },
];
const JOB = {
  ...DEFAULT_OPTIONS,
  drawing: "d1",
  corners: { ...DEFAULT_CORNERS, type: "D", at: [{ x: 1, y: 2, type: "C", k: null }] },
  lift: "least",
  feed_factor: 0.5,
  program_note: "grain up",
  cut_depths: DEPTHS,
  work_order: [4, 3],
} as unknown as Job;

test("another drawing gets what does not concern single edges", () => {
  const { corners, lift, options } = asLastTime(JOB, "d2");
  expect([corners.type, corners.at, lift]).toEqual(["D", [], "least"]);
  expect([options.feed_factor, options.program_note]).toEqual([0.5, "grain up"]);
  expect(options.cut_depths).toEqual([DEPTHS[1]]);
  expect(options.work_order).toEqual([]);
});

test("the same drawing gets everything", () => {
  const { corners, options } = asLastTime(JOB, "d1");
  expect(corners.at).toHaveLength(1);
  expect(options.cut_depths).toEqual(DEPTHS);
  expect(options.work_order).toEqual([4, 3]);
});

test("equal options are recognised whatever their order", () => {
  const one = asLastTime(JOB, "d1");
  const { feed_factor, ...others } = one.options;
  expect(isSame(one, { ...one, options: { ...others, feed_factor } })).toBe(true);
  expect(isSame(one, asLastTime(JOB, "d2"))).toBe(false);
});
