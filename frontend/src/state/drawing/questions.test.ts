import { expect, test } from "vitest";
import type { Question } from "../../api/drawings";
import {
  chosenAnswers,
  edgeQuestionFacts,
  edgeQuestionText,
  edgeQuestionTitle,
  followingTypes,
  questionKey,
  suggestions,
  unitQuestionText,
} from "./questions";

const reason = (text: string) => ({ code: "stored.text", arguments: { text, hint: "" } });
const LINE = { edges: 2, layer: "A", colour: "1", linetype: "X", unit: "mm" };

test("a question with a guess shows its confidence and its evidence", () => {
  const guess = {
    code: "question.guess",
    arguments: { type: "v-groove", percent: 55, reason: reason("shape: it divides two panels") },
  };
  const question = { code: "question.line-type", arguments: { ...LINE, guess } };
  expect(edgeQuestionText(question)).toEqual({
    percent: 55,
    text: "Shape: it divides two panels",
  });
});

test("a question without a guess shows the shape, or nothing", () => {
  const shape = { code: "question.shape", arguments: { reason: reason("it does not close") } };
  const line = (guess: unknown) => ({ code: "question.line-type", arguments: { ...LINE, guess } });
  expect(edgeQuestionText(line(shape)).text).toBe("It does not close");
  expect(edgeQuestionText(line(null))).toEqual({ percent: null, text: "" });
});

test("a question of another kind is shown whole", () => {
  const given = { edges: 12, type: "crease", machine: "demo-table" };
  expect(edgeQuestionText({ code: "question.tool", arguments: given }).text).toBe(
    "demo-table has no tool for 12 edges of the line type crease. Which other line type should these edges get?",
  );
});

test("the title is the layer, or what the edges of several layers lack", () => {
  expect(edgeQuestionTitle({ kind: "tool", layer: "A" })).toBe("Layer A");
  expect(edgeQuestionTitle({ kind: "tool", layer: "" })).toBe("No tool for these edges");
  expect(edgeQuestionTitle({ kind: "line-type", layer: "" })).toBe("Edges without a line type");
});

test("edges of several colours have no colour among their facts", () => {
  expect(edgeQuestionFacts({ colour: 1 }, ["DASHED"], [])).toBe(
    "Colour 1 (red) · Line style DASHED",
  );
  expect(edgeQuestionFacts({ colour: 0 }, ["DASHED", "DOT"], [])).toBe("Line styles DASHED, DOT");
});

test("the widths of the lines are facts, too", () => {
  expect(edgeQuestionFacts({ colour: 0 }, ["DOT"], ["0.5 mm"])).toBe(
    "Line style DOT · Line width 0.5 mm",
  );
  expect(edgeQuestionFacts({ colour: 0 }, [], ["0.18 mm", "0.5 mm"])).toBe(
    "Line widths 0.18 mm, 0.5 mm",
  );
});

test("a question for lines of one width has the same text on its card as other questions", () => {
  const guess = {
    code: "question.guess",
    arguments: { type: "crease", percent: 78, reason: reason("it divides two panels") },
  };
  const lines = { code: "question.line-width", arguments: { width: 0.5 } };
  const question = {
    code: "question.line-type-by-width",
    arguments: { ...LINE, lines, guess },
  };
  expect(edgeQuestionText(question)).toEqual({ percent: 78, text: "It divides two panels" });
});

test("a question for the unit shows why it is unknown", () => {
  const why = { code: "question.unit-doubtful", arguments: { stated: "in", other: "mm" } };
  const given = { reason: why, sizes: [], evidence: null };
  expect(unitQuestionText({ code: "question.unit", arguments: given })).toBe(
    "The file states the unit inches, but the drawing could also be in mm.",
  );
});

test("questions that differ in an argument have different keys", () => {
  const key = (layer: string) => questionKey({ code: "question.line-type", arguments: { layer } });
  expect(key("A")).not.toBe(key("B"));
  expect(key("A")).toBe(key("A"));
});

test("questions with a most likely answer can be accepted together", () => {
  const guess = {
    code: "question.guess",
    arguments: { type: "crease", percent: 78, reason: reason("it divides two panels") },
  };
  const shape = { code: "question.shape", arguments: { reason: reason("it is a slit") } };
  const question = (edges: number[], evidence: unknown): Question => ({
    code: "question.line-type",
    arguments: { ...LINE, guess: evidence },
    text: "",
    hint: "",
    kind: "line-type",
    choices: ["crease", "cut"],
    edges,
    layer: "A",
    colour: 1,
  });
  const asked = [question([1, 2], guess), question([3], shape), question([4], null)];
  expect(suggestions(asked)).toEqual([{ rows: [1, 2], type: "crease" }]);
  // A choice in the table replaces the most likely answer, also the choice of none.
  const [first, second] = asked.map(questionKey);
  const chosen = new Map([
    [first ?? "", null],
    [second ?? "", "cut" as const],
  ]);
  expect(chosenAnswers(asked, chosen)).toEqual([{ rows: [3], type: "cut" }]);
});

test("edges of the other rule get the line type that an answer gives them", () => {
  const following = {
    code: "stored.text",
    arguments: { text: "", hint: "" },
    text: "",
    hint: "",
    edges: [4, 5],
    layer: "CUT",
    colour: 7,
    line_types: { cut: "crease", crease: "cut" },
  };
  expect(followingTypes([following], "cut")).toEqual([{ rows: [4, 5], type: "crease" }]);
  expect(followingTypes([following], "crease")).toEqual([{ rows: [4, 5], type: "cut" }]);
  expect(followingTypes([following], "perforation")).toEqual([]);
});
