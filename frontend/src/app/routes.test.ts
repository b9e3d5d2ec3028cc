import { expect, test } from "vitest";
import { hashOf, routeOf } from "./routes";

test.each([
  ["#/", null, null, null],
  ["#/drawings/d1", "d1", null, null],
  ["#/drawings/d1/jobs/j1", "d1", "j1", null],
  ["#/station/my%20table", null, null, "my table"],
])("%s and back", (hash, drawing, job, station) => {
  expect(routeOf(hash)).toEqual({ drawing, job, station });
  expect(hashOf({ drawing, job, station })).toBe(hash);
});

test("the station page keeps its address while it shows a job", () => {
  expect(hashOf({ drawing: "d1", job: "j1", station: "table" })).toBe("#/station/table");
});

test.each(["", "#", "#/nowhere", "#/drawings/", "#/drawings/%E0%A4%A", "#/station/"])(
  "%s opens nothing",
  (hash) => {
    expect(routeOf(hash)).toEqual({ drawing: null, job: null, station: null });
  },
);
