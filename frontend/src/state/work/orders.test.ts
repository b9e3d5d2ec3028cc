import { describe, expect, test } from "vitest";
import type { Job, OrderRow } from "../../api/jobs";
import { groupByFile, nextAction } from "./orders";

const row = (id: string, part: Partial<Job> | null = null, questions = 0, file = id): OrderRow =>
  ({
    drawing: { id, questions },
    file,
    job: part === null ? null : { id: `j-${id}`, machine: "table", waiting_for: "", ...part },
  }) as unknown as OrderRow;

describe("the next action", () => {
  test.each<[string, OrderRow, string, boolean]>([
    ["questions", row("d", null, 2), "#/drawings/d/lines", true],
    ["no job", row("d"), "#/drawings/d/sheet", false],
    ["compiling", row("d", { state: "compiling" }), "#/drawings/d/check/jobs/j-d", false],
    ["ready", row("d", { state: "ready" }), "#/drawings/d/check/jobs/j-d", true],
    ["refused", row("d", { state: "refused" }), "#/drawings/d/check/jobs/j-d", true],
    ["queued", row("d", { state: "queued" }), "#/machines", false],
    [
      "waits for the operator",
      row("d", { state: "queued", waiting_for: "confirmation" }),
      "#/station/table",
      true,
    ],
    ["running", row("d", { state: "running" }), "#/station/table", false],
    ["interrupted", row("d", { state: "interrupted" }), "#/station/table", true],
    ["done", row("d", { state: "done" }), "#/drawings/d/check/jobs/j-d", false],
    // A drawing that got questions later does not hide its job at the machine.
    ["running with questions", row("d", { state: "running" }, 1), "#/station/table", false],
  ])("%s", (_, given, href, urgent) => {
    expect(nextAction(given)).toMatchObject({ href, urgent });
  });
});

test("drawings of one file are one group, and a row that was loaded twice is one", () => {
  const [a, b, c] = [row("a", null, 0, "x"), row("b", null, 0, "y"), row("c", null, 0, "x")];
  expect(groupByFile([a, b, c, a])).toEqual([
    { first: a, others: [c] },
    { first: b, others: [] },
  ]);
});
