import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { type Drawing, drawingService, type Question } from "../../api/drawings";
import { ServiceError } from "../../api/errors";
import { type Job, jobService } from "../../api/jobs";
import { compile, patchDrawing } from "../actions";
import { useNotifications } from "../notifications";
import { queries, queryClient } from "../queries";
import { useUiStore } from "../store";

const QUESTION: Question = {
  code: "question.tool",
  arguments: { edges: 2, type: "half-cut", machine: "router-table" },
  text: "router-table has no tool for 2 edges.",
  hint: "",
  kind: "tool",
  choices: ["cut", "ignored"],
  edges: [0, 1],
  layer: "",
  colour: 0,
};

const refusal = () =>
  new ServiceError({
    type: "about:blank",
    title: "",
    status: 409,
    code: "drawing.open-questions",
    arguments: { count: 1, questions: [] },
    text: "1 question about the drawing must be answered first",
    detail: "1 question about the drawing must be answered first",
    hint: "",
    source: [],
    edges: [],
    questions: [QUESTION],
    revision: null,
  });

describe("the questions for which a job was refused", () => {
  const order = vi.spyOn(jobService, "compile");
  const patch = vi.spyOn(drawingService, "patchDrawing");
  const asked = () => useUiStore.getState().compileQuestions;
  const codes = () => useNotifications.getState().list.map(({ code }) => code);

  beforeEach(async () => {
    queryClient.clear();
    queryClient.setQueryData(queries.drawing("d1").queryKey, { id: "d1", revision: 1 } as Drawing);
    patch.mockReset().mockResolvedValue({ id: "d1", revision: 2 } as Drawing);
    useUiStore.getState().open("d1");
    order.mockReset().mockRejectedValue(refusal());
    await compile("router-table", "e-flute");
  });
  afterEach(() => queryClient.clear());

  test("are shown with a message", () => {
    expect(asked()).toEqual([QUESTION]);
    expect(codes()).toEqual(["drawing.open-questions"]);
  });

  test("disappear with the message when the drawing changes", async () => {
    await patchDrawing({ profile: "german" });
    expect(asked()).toEqual([]);
    expect(codes()).toEqual([]);
  });

  test("disappear with the message when another machine asks none", async () => {
    order.mockResolvedValue({ id: "j1" } as Job);
    await compile("demo-table", "e-flute");
    expect(asked()).toEqual([]);
    expect(codes()).toEqual([]);
  });
});
