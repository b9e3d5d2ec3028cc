import { expect, test } from "vitest";
import type { Folding } from "../../api/folding";
import { faultyPanels, foldOfPanel, wantedOf } from "./folding";

const FOLDING = {
  folds: [
    { number: 1, parent: 1, child: 2 },
    { number: 2, parent: 3, child: 2 },
  ],
  order: [1],
  findings: [{ panels: [2, 3] }, { panels: [2, 1] }],
} as unknown as Folding;

test("the request has the angles that the user chose", () => {
  const choices = {
    board: "e-flute",
    sideUp: "inside",
    opening: null,
    angles: { 3: -45 },
  } as const;
  expect(wantedOf(choices)).toEqual({ board: "e-flute", side_up: "inside", angle: ["3:-45"] });
  expect(wantedOf({ ...choices, opening: 60 })).toMatchObject({ opening: 60 });
});

test("panels with faults are marked once", () => {
  expect(faultyPanels(FOLDING)).toEqual(new Set([0, 1, 2]));
});

test("the fold of a panel is the one that turns it", () => {
  expect(foldOfPanel(FOLDING, 1)?.number).toBe(1);
  expect(foldOfPanel(FOLDING, 0)).toBeUndefined();
});
