import { beforeEach, expect, test } from "vitest";
import type { Drawing, Question } from "../../api/drawings";
import { queries, queryClient } from "../queries";
import { useUiStore } from "../store";
import { hasLikely, openQuestionsNow, useAsked } from "./asked";

const question = (layer: string, code = "question.line-type"): Question =>
  ({
    kind: "line-type",
    code,
    arguments: { layer, guess: null },
    layer,
    colour: 7,
    edges: [0],
    choices: ["cut", "crease"],
  }) as unknown as Question;

const show = (...questions: Question[]) => {
  useUiStore.getState().open("d");
  queryClient.setQueryData(queries.drawing("d").queryKey, { questions } as unknown as Drawing);
};

beforeEach(() => {
  queryClient.clear();
  useAsked.setState({ at: 0 });
});

test("the questions are asked in turn", () => {
  show(question("A"), question("B"), question("C"));
  expect(openQuestionsNow()).toHaveLength(3);
  const { turn } = useAsked.getState();
  turn(1);
  turn(1);
  expect(useAsked.getState().at).toBe(2);
  turn(1);
  expect(useAsked.getState().at).toBe(0);
  turn(-1);
  expect(useAsked.getState().at).toBe(2);
});

test("after an answer the next question takes its place", () => {
  show(question("A"), question("B"), question("C"));
  useAsked.setState({ at: 2 });
  show(question("A"), question("B"));
  useAsked.getState().turn(-1);
  expect(useAsked.getState().at).toBe(0);
});

test("a question without a guess has no likely answer", () => {
  expect(hasLikely()).toBe(false);
  show(question("A"));
  expect(hasLikely()).toBe(false);
});
