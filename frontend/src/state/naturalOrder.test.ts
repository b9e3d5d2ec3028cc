import { expect, test } from "vitest";
import { byTitle } from "./naturalOrder";

const titled = (...titles: string[]) => titles.map((title, at) => ({ name: `b${at}`, title }));

test("numbers in titles are ordered by their value", () => {
  const boards = titled("Foam 10 mm", "Foam 5 mm", "Foam 2.5 mm", "Board 20 mm");
  expect(byTitle(boards).map(({ title }) => title)).toEqual([
    "Board 20 mm",
    "Foam 2.5 mm",
    "Foam 5 mm",
    "Foam 10 mm",
  ]);
});

test("an entry without a title is ordered by its name", () => {
  const entries = [
    { name: "m-10", title: "" },
    { name: "x", title: "m-3" },
  ];
  expect(byTitle(entries).map(({ name }) => name)).toEqual(["x", "m-10"]);
});
