import { expect, test } from "vitest";
import type { Figure, TestPiece } from "../../api/testpieces";
import { chosenEntry, givenMeasures, measureFields, withFigures } from "./measured";

const PIECE = {
  measures: {
    properties: {
      reading: { title: "Accuracy of reading", type: "number", default: 0.05 },
      first_through: { title: "N", type: "integer" },
      caliper: { title: "T", anyOf: [{ type: "number" }, { type: "null" }], default: null },
    },
    required: ["first_through"],
  },
} as unknown as TestPiece;

test("the accuracy of reading is the last field and has a value", () => {
  const fields = measureFields(PIECE);
  expect(fields.map(({ name }) => name)).toEqual(["first_through", "caliper", "reading"]);
  expect(fields.map(({ whole }) => whole)).toEqual([true, false, false]);
  expect(givenMeasures(fields, {})).toBeNull();
  expect(givenMeasures(fields, { first_through: 7, caliper: "" })).toEqual({
    first_through: 7,
    reading: 0.05,
  });
});

test("a figure changes one value of the definition and keeps the others", () => {
  const fields = { title: "T", station: [{ datum: { x: 1, z: 0 } }, { datum: { x: 2, z: -1.5 } }] };
  const figure = { path: ["station", 1, "datum", "z"], after: -1.4 } as unknown as Figure;
  expect(withFigures(fields, [figure])).toEqual({
    title: "T",
    station: [{ datum: { x: 1, z: 0 } }, { datum: { x: 2, z: -1.4 } }],
  });
  const deflection = { path: ["deflection", "Router", "x"], after: 0.08 } as unknown as Figure;
  expect(withFigures({ title: "B" }, [deflection])).toEqual({
    title: "B",
    deflection: { Router: { x: 0.08 } },
  });
});

test("the entry that is measured is awaited, and any other name has the first entry", () => {
  const machines = [{ name: "demo-table" }, { name: "other-table" }];
  expect(chosenEntry(machines, "other-table", null)).toBe(machines[1]);
  expect(chosenEntry(machines, "removed-table", null)).toBe(machines[0]);
  expect(chosenEntry(machines, null, null)).toBe(machines[0]);
  expect(chosenEntry(machines, "new-table", "new-table")).toBeUndefined();
  expect(chosenEntry([...machines, { name: "new-table" }], "new-table", "new-table")?.name).toBe(
    "new-table",
  );
});
