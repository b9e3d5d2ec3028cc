/** Title, facts and text of a question card. */

import type { Question } from "../api/client";
import { LINE_TYPES, type LineType } from "../geometry/records";
import { renderText, type ServerMessage, typed } from "../messages/render";
import { colourName } from "./colours";

export interface QuestionText {
  /** Confidence of the most likely answer (%); null if there is none. */
  readonly percent: number | null;
  /** Evidence for it, or the question itself if its facts are not on the card. */
  readonly text: string;
}

/** Title of the card of a question about edges: their layer, or what is missing. */
export function edgeQuestionTitle({ kind, layer }: Pick<Question, "kind" | "layer">): string {
  if (layer !== "") return `Layer ${layer}`;
  return kind === "tool" ? "No tool for these edges" : "Edges without a line type";
}

/**
 * Colour, line styles and line widths of the edges of a question; edges of several colours have no
 * colour.
 */
export function edgeQuestionFacts(
  { colour }: Pick<Question, "colour">,
  linetypes: readonly string[],
  lineWidths: readonly string[],
): string {
  const facts = [];
  if (colour !== 0) facts.push(`Colour ${colourName(colour)}`);
  if (linetypes.length > 0)
    facts.push(`${linetypes.length === 1 ? "Line style" : "Line styles"} ${linetypes.join(", ")}`);
  if (lineWidths.length > 0) {
    const title = lineWidths.length === 1 ? "Line width" : "Line widths";
    facts.push(`${title} ${lineWidths.join(", ")}`);
  }
  return facts.join(" · ");
}

const capitalized = (text: string): string => text.charAt(0).toUpperCase() + text.substring(1);

/** The text for a question about edges; the card shows their layer, colour and length already. */
export function edgeQuestionText(question: ServerMessage): QuestionText {
  const message = typed(question);
  if (message.code !== "question.line-type" && message.code !== "question.line-type-by-width")
    return { percent: null, text: renderText(question) };
  const { guess } = message.arguments;
  if (guess?.code === "question.guess") {
    const { percent, reason } = guess.arguments;
    return { percent, text: capitalized(renderText(reason)) };
  }
  if (guess?.code === "question.shape")
    return { percent: null, text: capitalized(renderText(guess.arguments.reason)) };
  return { percent: null, text: "" };
}

/** Why the unit is unknown; the sizes and the evidence are on the answers. */
export function unitQuestionText(question: ServerMessage): string {
  const message = typed(question);
  return message.code === "question.unit"
    ? renderText(message.arguments.reason)
    : renderText(question);
}

/** Identifies a question among those of a drawing and its job. */
export const questionKey = ({ code, arguments: given }: ServerMessage): string =>
  JSON.stringify([code, given]);

/** The edges of all questions with a most likely answer, and this answer. */
export const suggestions = (questions: readonly Question[]) =>
  questions.flatMap((question) => {
    const [type] = question.choices;
    const { percent } = edgeQuestionText(question);
    return percent !== null && isLineType(type) ? [{ rows: question.edges, type }] : [];
  });

/** Whether a word is a line type that a user can choose. */
export const isLineType = (word: string | undefined): word is LineType =>
  LINE_TYPES.some((type) => type === word) && word !== "unclassified";
