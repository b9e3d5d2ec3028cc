import { expect, test } from "vitest";
import type { Confirmation } from "../../api/jobs";
import { decisionOf, wornToolsOf } from "./wornTools";

const tool = (station: number, warning: "" | "near" | "over") => ({
  station,
  name: `Tool ${station}`,
  kind: "knife",
  used: 510,
  life: 500,
  warning,
});
const ASKED = { tools: [tool(1, "over"), tool(2, "near"), tool(3, "over")] } as Confirmation;
const WORN = wornToolsOf(ASKED);

test("only tools at the end of their lives need a decision", () => {
  expect(WORN.map(({ station }) => station)).toEqual([1, 3]);
  expect(decisionOf([], new Set(), "")).toEqual({ changed: [], reason: "" });
});

test("each worn tool is changed, or stays in use for a reason", () => {
  expect(decisionOf(WORN, new Set(), "")).toBeNull();
  expect(decisionOf(WORN, new Set([1]), "  ")).toBeNull();
  expect(decisionOf(WORN, new Set([1]), " last sheet ")).toEqual({
    changed: [1],
    reason: "last sheet",
  });
  expect(decisionOf(WORN, new Set([1, 3]), "typed before")).toEqual({
    changed: [1, 3],
    reason: "",
  });
});
