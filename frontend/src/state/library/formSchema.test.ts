import { expect, test } from "vitest";
import { formSchema } from "./formSchema";

test("a list of fixed length has one schema for each item, with its title and the help", () => {
  const origin = {
    type: "array",
    description: "corner of a drawing (mm)",
    items: { type: "number" },
    itemTitles: ["Place in X", "Place in Y"],
    minItems: 2,
    maxItems: 2,
  };
  expect(formSchema({ properties: { origin } }).properties?.origin).toMatchObject({
    items: [
      { type: "number", title: "Place in X", description: "Corner of a drawing (mm)" },
      { type: "number", title: "Place in Y", description: "Corner of a drawing (mm)" },
    ],
    additionalItems: false,
  });
});

test("a field whose name is that of a keyword is no text", () => {
  const schema = { properties: { title: { type: "string", title: "Title" } } };
  expect(formSchema(schema)).toEqual(schema);
});

test("help begins with a capital, except a unit and a symbol of a formula", () => {
  const help = (description: string) => formSchema({ description }).description;
  expect(help("depth of a crease (mm)")).toBe("Depth of a crease (mm)");
  expect(help("mm")).toBe("mm");
  expect(help("e, distance of the tip (mm)")).toBe("e, distance of the tip (mm)");
});
