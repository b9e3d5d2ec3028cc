import { expect, test } from "vitest";
import { ServiceError } from "../../api/errors";
import { differences, faultsOf, faultTree, pathText, sentFields, withValue } from "./definitions";

test("differences name changed, added and removed fields by their path", () => {
  const before = {
    width: 1600,
    station: [{ name: "Knife", tool: { feed: 1 } }],
    perforation: [3, 2],
  };
  const after = { width: 1600, station: [{ name: "Knife", tool: { feed: 2 } }, { name: "Wheel" }] };
  expect(differences(before, after)).toEqual([
    { path: "station 1 → tool → feed", before: "1", after: "2" },
    { path: "perforation", before: "3, 2", after: "–" },
    { path: "station 2 → name", before: "–", after: "Wheel" },
  ]);
});

test("faults of another error are none", () => {
  expect(faultsOf(new Error("no"))).toEqual({});
  expect(faultsOf(ServiceError)).toEqual({});
});

test("a path of keys is written as faults name it", () => {
  expect(pathText(["station", 1, "tool", "feed"])).toBe("station 2 → tool → feed");
  expect(pathText(["origin", 0])).toBe("origin 1");
});

test("faults are shown at the fields that they name", () => {
  const fields = { station: [{}, { tool: {} }], deflection: { "Router 2": { x: -1 } } };
  const faults = {
    "station 2 → tool → feed": "is missing",
    "deflection → Router 2 → x": "is negative",
    origin: "is missing",
  };
  expect(faultTree(faults, fields)).toEqual({
    station: { 1: { tool: { feed: { __errors: ["is missing"] } } } },
    deflection: { "Router 2": { x: { __errors: ["is negative"] } } },
    origin: { __errors: ["is missing"] },
  });
});

test("a value is set at a path, and the rest is kept", () => {
  const fields = { station: [{ name: "Knife" }, { name: "Wheel", tool: { kind: "knife" } }] };
  expect(withValue(fields, ["station", 1, "tool"], { kind: "laser" })).toEqual({
    station: [{ name: "Knife" }, { name: "Wheel", tool: { kind: "laser" } }],
  });
  expect(withValue({ gantry: { park: 5 }, width: 1 }, ["gantry"], undefined)).toEqual({ width: 1 });
  expect(withValue({}, ["gantry", "carriage", 0, "park"], 5)).toEqual({
    gantry: { carriage: [{ park: 5 }] },
  });
});

test("empty fields and lists without values are not sent", () => {
  expect(sentFields({ gantry: { park: null, min_distance: 4 } })).toEqual({
    gantry: { min_distance: 4 },
  });
  expect(sentFields({ force: [undefined, undefined], origin: [1, undefined] })).toEqual({
    force: undefined,
    origin: [1, undefined],
  });
});
