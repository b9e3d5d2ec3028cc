/** Title, facts and text of a question card. */

import type { FollowingEdges, Question } from "../../api/drawings";
import { type Edges, LINE_TYPES, type LineType } from "../../geometry/records";
import { translate } from "../../language/translate";
import { messageText, type ServerMessage, typed } from "../../messages/translateMessage";
import { colourName } from "./colours";
import { rowsOfLayer } from "./rows";

export interface QuestionText {
  /** Confidence of the most likely answer (%); null if there is none. */
  readonly percent: number | null;
  /** Evidence for it, or the question itself if its facts are not on the card. */
  readonly text: string;
}

/** Title of the card of a question about edges: their layer, or what is missing. */
export function edgeQuestionTitle({ kind, layer }: Pick<Question, "kind" | "layer">): string {
  if (layer !== "") return translate("questions.layer", { layer });
  return kind === "tool"
    ? translate("questions.noToolForTheseEdges")
    : translate("questions.edgesWithoutALineType");
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
  if (colour !== 0) facts.push(translate("questions.colour", { colour: colourName(colour) }));
  if (linetypes.length > 0)
    facts.push(
      translate("questions.lineStyles", { count: linetypes.length, names: linetypes.join(", ") }),
    );
  if (lineWidths.length > 0)
    facts.push(
      translate("questions.lineWidths", {
        count: lineWidths.length,
        widths: lineWidths.join(", "),
      }),
    );
  return facts.join(" · ");
}

const capitalized = (text: string): string => text.charAt(0).toUpperCase() + text.substring(1);

/** The text for a question about edges; the card shows their layer, colour and length already. */
export function edgeQuestionText(question: ServerMessage): QuestionText {
  const message = typed(question);
  if (message.code !== "question.line-type" && message.code !== "question.line-type-by-width")
    return { percent: null, text: messageText(question) };
  const { guess } = message.arguments;
  if (guess?.code === "question.guess") {
    const { percent, reason } = guess.arguments;
    return { percent, text: capitalized(messageText(reason)) };
  }
  if (guess?.code === "question.shape")
    return { percent: null, text: capitalized(messageText(guess.arguments.reason)) };
  return { percent: null, text: "" };
}

/** Why the unit is unknown; the sizes and the evidence are on the answers. */
export function unitQuestionText(question: ServerMessage): string {
  const message = typed(question);
  return message.code === "question.unit"
    ? messageText(message.arguments.reason)
    : messageText(question);
}

/** The line types that edges get by an answer about other edges; none if they stay open. */
export const followingTypes = (
  follows: readonly FollowingEdges[],
  answer: LineType,
): { rows: readonly number[]; type: LineType }[] =>
  follows.flatMap(({ edges, line_types }) => {
    const type = line_types[answer];
    return isLineType(type) ? [{ rows: edges, type }] : [];
  });

/** Identifies a question among those of a drawing and its job. */
export const questionKey = ({ code, arguments: given }: ServerMessage): string =>
  JSON.stringify([code, given]);

/** The edges that a question asks about; without a list, those of its layer and colour. */
export const questionRows = (
  edges: Edges | undefined,
  { edges: rows, layer, colour }: Pick<Question, "edges" | "layer" | "colour">,
): readonly number[] =>
  rows.length > 0 || edges === undefined ? rows : rowsOfLayer(edges, layer, colour);

/** The most likely answer to a question; null if there is none. */
export function suggestedType(question: Question): LineType | null {
  const [type] = question.choices;
  return edgeQuestionText(question).percent !== null && isLineType(type) ? type : null;
}

/** The edges of questions with the chosen line types; without a choice, the most likely one. */
export const chosenAnswers = (
  questions: readonly Question[],
  chosen: ReadonlyMap<string, LineType | null>,
): { rows: readonly number[]; type: LineType }[] =>
  questions.flatMap((question) => {
    const key = questionKey(question);
    const type = chosen.has(key) ? chosen.get(key) : suggestedType(question);
    return type ? [{ rows: question.edges, type }] : [];
  });

/** The edges of all questions with a most likely answer, and this answer. */
export const suggestions = (questions: readonly Question[]) => chosenAnswers(questions, new Map());

/** Whether a word is a line type that a user can choose. */
export const isLineType = (word: string | undefined): word is LineType =>
  LINE_TYPES.some((type) => type === word) && word !== "unclassified";
