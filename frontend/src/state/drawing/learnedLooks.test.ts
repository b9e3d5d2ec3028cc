import { describe, expect, test } from "vitest";
import { lookFacts, lookKey, lookOf, lookTitle, refusedLooks } from "./learnedLooks";

const LOOK = { layer: "q7", colour: 5, true_colour: -1, linetype: "dashed", line_width: -1 };

describe("a look", () => {
  test("is named by its layer, or by its lack of a meaning", () => {
    expect(lookTitle(LOOK)).toBe("Layer q7");
    expect(lookTitle({ ...LOOK, layer: "" })).toBe("Layers whose name suggests no line type");
  });

  test("shows a line width only where widths matter, and a true colour as it is", () => {
    expect(lookFacts(LOOK)).toContain("line style dashed");
    expect(lookFacts(LOOK)).not.toContain("width");
    expect(lookFacts({ ...LOOK, true_colour: 0xff, line_width: 35 })).toBe(
      "Colour #0000ff, line style dashed, line width 0.35 mm",
    );
  });

  test("has a key of its own fields only", () => {
    const more = { ...LOOK, type: "crease" as const, drawings: ["a.dxf"], used: false };
    expect(lookKey(more)).toBe(lookKey(LOOK));
    expect(lookOf(more)).toEqual(LOOK);
    expect(refusedLooks([more, { ...more, used: true }])).toEqual([more]);
  });
});
