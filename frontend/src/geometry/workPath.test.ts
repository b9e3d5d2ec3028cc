import { expect, test } from "vitest";
import type { Toolpath } from "./records";
import { splitWork, workPath } from "./workPath";

/** A cut to the right, a move above the board, and half a circle. */
const TOOLPATH = {
  pose: Float64Array.of(0, 0, 0, 0, 10, 0, 0, 0, 10, 5, 5, 0, 0, 5, 0, 0),
  bulge: Float64Array.of(0, 0, 1),
  motion: Uint8Array.of(1, 0, 1),
} as unknown as Toolpath;

test("moves above the board are no work, and the others are made in their order", () => {
  const work = workPath(TOOLPATH);
  expect(splitWork(work, 0)).toEqual(["", "M0 0L10 0M10 5A5 5 0 0 1 0 5"]);
  expect(splitWork(work, 1)).toEqual(["M0 0L10 0", "M10 5A5 5 0 0 1 0 5"]);
  expect(splitWork(work, 2)).toEqual(["M0 0L10 0", "M10 5A5 5 0 0 1 0 5"]);
  expect(splitWork(work, 3)).toEqual(["M0 0L10 0M10 5A5 5 0 0 1 0 5", ""]);
});
