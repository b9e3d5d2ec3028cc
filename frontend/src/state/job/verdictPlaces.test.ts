import { expect, test } from "vitest";
import { placesOf } from "./verdictPlaces";

test("places with a visible figure, the largest first", () => {
  expect(placesOf([0, 0.3, 0.01, 2, 0.3, Number.NaN])).toEqual([3, 1, 4]);
  expect(placesOf([])).toEqual([]);
});
