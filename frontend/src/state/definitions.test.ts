import { expect, test } from "vitest";
import { ServiceError } from "../api/errors";
import { differences, faultsOf, resolved } from "./definitions";

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

test("a reference that may be null is resolved", () => {
  const root = { $defs: { Axis: { type: "object", properties: { low: { type: "number" } } } } };
  const found = resolved({ anyOf: [{ $ref: "#/$defs/Axis" }, { type: "null" }] }, root);
  expect(Object.keys(found.properties ?? {})).toEqual(["low"]);
});
