import { describe, expect, test } from "vitest";
import type { ToolSection } from "../../api/jobs";
import { closesEarly, measuresOf, sectionView } from "./section";

const NONE: ToolSection["cross"] = {
  top_width: null,
  flank_angle: null,
  fold_angle: null,
  rim_width: null,
  wheel_radius: null,
  contact_length: null,
  blade_width: null,
  blade_angle: null,
  blade_lead: null,
};
const TOOL = { station: 3, name: "V-cutter", kind: "v-cutter", passes: 1, beyond: 0 };
const GROOVE: ToolSection = {
  ...TOOL,
  shape: "groove",
  depth: 1.6,
  base: 0.4,
  cross: { ...NONE, top_width: 3.2, flank_angle: 45, fold_angle: 90 },
};
const KNIFE: ToolSection = {
  ...TOOL,
  shape: "line",
  depth: 2,
  base: 0,
  beyond: 0.3,
  passes: 2,
  cross: { ...NONE, blade_width: 3, blade_angle: 10, blade_lead: 0.35 },
};
const BOARD = { caliper: 2, required_fold: 90 };

describe("a section", () => {
  test("has a letter for each dimension of its picture", () => {
    const groove = measuresOf(BOARD, GROOVE);
    expect(groove.map(({ name, letter }) => `${letter} ${name}`)).toEqual([
      "a caliper",
      "b depth",
      "c base",
      "d topWidth",
      "e foldAngle",
      " requiredFold",
      " flankAngle",
    ]);
    const cut = measuresOf(BOARD, KNIFE);
    // Nothing remains below a cut; the tip is in the mat.
    expect(cut.map(({ name }) => name)).toEqual([
      ...["caliper", "depth", "beyond"],
      ...["bladeAngle", "bladeWidth", "bladeLead", "passes"],
    ]);
    expect(cut.find(({ name }) => name === "beyond")).toMatchObject({ value: 0.3, letter: "c" });
  });

  test("is to scale in both directions", () => {
    const view = sectionView(2, GROOVE);
    expect((2 * view.half) / view.scale).toBeCloseTo(3.2, 9);
    expect((view.y.bottom - view.y.top) / view.scale).toBeCloseTo(2, 9);
    // A flank of 45°: as wide as it is deep.
    expect(view.half).toBeCloseTo(view.y.depth - view.y.top, 9);
    expect(sectionView(2, KNIFE).y.tip).toBeGreaterThan(view.y.bottom);
  });

  test("thin and thick boards fit into the picture", () => {
    for (const caliper of [0.3, 2, 10, 60]) {
      const { x, half, height } = sectionView(caliper, { ...GROOVE, depth: 0.8 * caliper });
      expect(x.middle - half).toBeGreaterThanOrEqual(x.left);
      expect(height).toBeLessThan(260);
    }
  });

  test("a groove that closes too early is told from one that does not", () => {
    expect(closesEarly(BOARD, GROOVE)).toBe(false);
    expect(closesEarly({ required_fold: 120 }, GROOVE)).toBe(true);
    expect(closesEarly(BOARD, KNIFE)).toBe(false);
  });
});
