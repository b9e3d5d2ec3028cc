import { expect, test } from "vitest";
import { ServiceError } from "../api/errors";
import {
  differences,
  emptyTable,
  faultsOf,
  fieldLabel,
  fieldsOf,
  isOptional,
  itemLabel,
  resolved,
} from "./definitions";

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

test("the description of a field replaces that of its table", () => {
  const root = { $defs: { Axis: { type: "object", description: "An axis.", properties: {} } } };
  const field = { description: "the lift", anyOf: [{ $ref: "#/$defs/Axis" }, { type: "null" }] };
  expect(resolved(field, root).description).toBe("the lift");
  expect(resolved({ anyOf: field.anyOf }, root).description).toBe("An axis.");
  expect(isOptional(field)).toBe(true);
  expect(isOptional({ $ref: "#/$defs/Axis" })).toBe(false);
});

test("the settings of a controller follow its language", () => {
  const condition = (language: string, controller: object) =>
    JSON.parse(
      `{"if": {"properties": {"dialect": {"const": "${language}"}}},
        "then": {"properties": {"controller": ${JSON.stringify(controller)}}}}`,
    );
  const schema = {
    properties: { dialect: { type: "string" }, controller: { description: "settings" } },
    allOf: [
      condition("hpgl", { properties: { pen: { type: "array" } } }),
      condition("grblhal", { maxProperties: 0 }),
    ],
  };
  const settings = (dialect: string) => fieldsOf(schema, { dialect }).controller;
  expect(settings("hpgl")).toEqual({
    description: "settings",
    properties: { pen: { type: "array" } },
  });
  expect(settings("grblhal")).toEqual({ description: "settings", maxProperties: 0 });
  expect(settings("other")).toEqual({ description: "settings" });
});

test("a new table has the tables that it needs, and no invented values", () => {
  const root = {
    $defs: {
      Axis: { properties: { low: { type: "number" } }, required: ["low"] },
      Carriage: {
        properties: {
          park: { type: "number" },
          y: { $ref: "#/$defs/Axis" },
          z: { anyOf: [{ $ref: "#/$defs/Axis" }, { type: "null" }] },
        },
        required: ["park", "y"],
      },
    },
  };
  expect(emptyTable({ $ref: "#/$defs/Carriage" }, root)).toEqual({ y: {} });
});

test("fields have names for people", () => {
  expect(fieldLabel("into_mat", "into_mat")).toBe("Depth in the mat");
  expect(fieldLabel("feed", "feed")).toBe("Loading of sheets");
  expect(fieldLabel("feed", "station 1 → tool → feed")).toBe("Feed rate");
  expect(fieldLabel("crease_along", "crease_along")).toBe("Crease along");
  expect(itemLabel("perforation", 1)).toBe("Length of gaps");
  expect(itemLabel("station", 1)).toBe("Station 2");
});
