import { expect, test } from "vitest";
import { hashOf, routeOf } from "./routes";

test.each([
  ["#/", null, null],
  ["#/drawings/d1", "d1", null],
  ["#/drawings/d1/jobs/j1", "d1", "j1"],
])("%s and back", (hash, drawing, job) => {
  expect(routeOf(hash)).toEqual({ drawing, job });
  expect(hashOf({ drawing, job })).toBe(hash);
});

test.each(["", "#", "#/nowhere", "#/drawings/", "#/drawings/%E0%A4%A"])(
  "%s opens nothing",
  (hash) => {
    expect(routeOf(hash)).toEqual({ drawing: null, job: null });
  },
);
