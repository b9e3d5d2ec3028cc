/** Text of a question card, beside the layer, colour and length that the card lists. */

import { renderText, type ServerMessage, typed } from "../messages/render";

export interface QuestionText {
  /** Confidence of the most likely answer (%); null if there is none. */
  readonly percent: number | null;
  /** Evidence for it, or the question itself if its facts are not on the card. */
  readonly text: string;
}

const capitalized = (text: string): string => text.charAt(0).toUpperCase() + text.substring(1);

/** The text for a question about edges; the card shows their layer, colour and length already. */
export function edgeQuestionText(question: ServerMessage): QuestionText {
  const message = typed(question);
  if (message.code !== "question.line-type") return { percent: null, text: renderText(question) };
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
