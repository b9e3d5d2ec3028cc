import { describe, expect, test } from "vitest";
import type { Question } from "../../api/drawings";
import type { Job } from "../../api/jobs";
import { firstStep, openQuestions, stepStatuses } from "./steps";

const job = (state: Job["state"]): Pick<Job, "state" | "verdict" | "waiting_for"> => ({
  state,
  verdict: null,
  waiting_for: "",
});

describe("the step that needs the user first", () => {
  test.each([
    [2, true, "lines"],
    [1, false, "lines"],
    [0, false, "sheet"],
    [0, true, "check"],
  ] as const)("%i questions, job %s: %s", (questions, hasJob, step) => {
    expect(firstStep(questions, hasJob)).toBe(step);
  });
});

describe("the marks of the steps", () => {
  const kinds = (part: Partial<Parameters<typeof stepStatuses>[0]>) => {
    const statuses = stepStatuses({ questions: 0, chosen: true, job: null, ...part });
    return Object.values(statuses).map(({ kind }) => kind);
  };
  test("questions are counted", () => {
    expect(stepStatuses({ questions: 3, chosen: false, job: null }).lines).toEqual({
      kind: "open",
      count: 3,
    });
  });
  test.each([
    [{ chosen: false }, ["done", "open", "todo", "todo"]],
    [{}, ["done", "done", "done", "todo"]],
    [{ job: job("compiling") }, ["done", "done", "done", "busy"]],
    [{ job: job("ready") }, ["done", "done", "done", "open"]],
    [{ job: job("refused") }, ["done", "done", "done", "warning"]],
    [{ job: job("queued") }, ["done", "done", "done", "done"]],
  ] as const)("%o", (part, expected) => {
    expect(kinds(part)).toEqual(expected);
  });
});

test("a question that several lists contain is asked once", () => {
  const one = { code: "question.line-type", arguments: { layer: "A" } } as unknown as Question;
  const other = { code: "question.unit", arguments: {} } as unknown as Question;
  expect(openQuestions([one], [one, other], [])).toHaveLength(2);
});
