import { expect, test } from "vitest";
import { hashOf, routeOf } from "./routes";

test.each([
  ["#/", null, null, null, false],
  ["#/drawings/d1", "d1", null, null, false],
  ["#/drawings/d1/jobs/j1", "d1", "j1", null, false],
  ["#/station/my%20table", null, null, "my table", false],
  ["#/library", null, null, null, true],
])("%s and back", (hash, drawing, job, station, library) => {
  expect(routeOf(hash)).toEqual({ drawing, job, station, library });
  expect(hashOf({ drawing, job, station, library })).toBe(hash);
});

test("the station page keeps its address while it shows a job", () => {
  expect(hashOf({ drawing: "d1", job: "j1", station: "table", library: false })).toBe(
    "#/station/table",
  );
});

test.each(["", "#", "#/nowhere", "#/drawings/", "#/drawings/%E0%A4%A", "#/station/"])(
  "%s opens nothing",
  (hash) => {
    expect(routeOf(hash)).toEqual({ drawing: null, job: null, station: null, library: false });
  },
);
