import { expect, test } from "vitest";
import type { CartonStyle } from "../../api/cartons";
import { pageProblem, ServiceError } from "../../api/errors";
import { cartonSchema, fieldFaults } from "./cartonSchema";

const style = {
  code: "fefco-0427",
  parameters: {
    type: "object",
    properties: {
      length: { type: "number", title: "Length" },
      tuck: { type: "number", title: "Tuck flap" },
    },
  },
} as unknown as CartonStyle;

const refused = (source: string[]) =>
  new ServiceError({ ...pageProblem(422, "Refused", "too small", "").problem, source });

test("dimensions come before options", () => {
  const { length, tuck } = cartonSchema(style).properties as Record<string, { group: string }>;
  expect([length?.group, tuck?.group]).toEqual(["Inner dimensions", "Options"]);
});

test.each([
  ["length", "length"],
  ["query.tuck", "tuck"],
])("an error of %s is shown at %s", (source, name) => {
  expect(Object.keys(fieldFaults(refused([source, "query.width"]), style))).toEqual([name]);
});

test.each([[[]], [["board"]]])("an error of %s belongs to no field", (source) => {
  expect(fieldFaults(refused(source), style)).toEqual({});
});

test("an error that is no refusal belongs to no field", () => {
  expect(fieldFaults(new Error("x"), style)).toEqual({});
});
