/** The open question that is asked now, and the keys that answer it. */

import { create } from "zustand";
import type { Question } from "../../api/drawings";
import type { LineType } from "../../geometry/records";
import { refusalOf } from "../accounts/accounts";
import { retype } from "../actions";
import { queries, queryClient } from "../queries";
import { useUiStore } from "../store";
import { questionRows, suggestedType } from "./questions";
import { openQuestions } from "./steps";

interface Asked {
  /** Index of the question; the last one if there are fewer. */
  readonly at: number;
  /** Ask another question, `by` places further; the first one follows the last one. */
  turn(by: number): void;
}

export const useAsked = create<Asked>()((set, get) => ({
  at: 0,
  turn: (by) => {
    const count = openQuestionsNow().length;
    if (count === 0) return;
    set({ at: (Math.min(get().at, count - 1) + by + count) % count });
  },
}));

/** The open questions, read once. */
export function openQuestionsNow(): ReturnType<typeof openQuestions> {
  const { drawing, job, compileQuestions } = useUiStore.getState();
  const known = queryClient.getQueryData(queries.drawing(drawing ?? "").queryKey);
  const refused = queryClient.getQueryData(queries.job(job ?? "").queryKey);
  return openQuestions(known?.questions ?? [], compileQuestions, refused?.questions ?? []);
}

/** The question that is asked now, with its most likely answer; null if it has none. */
function likelyAnswer(): { question: Question; type: LineType } | null {
  const open = openQuestionsNow();
  const [, question] = open[Math.min(useAsked.getState().at, open.length - 1)] ?? [];
  const type = question === undefined ? null : suggestedType(question);
  return question === undefined || type === null ? null : { question, type };
}

export const hasLikely = (): boolean =>
  refusalOf("PATCH /api/v1/drawings/{id}/edges") === null && likelyAnswer() !== null;

/** Answer the question that is asked now with the most likely line type. */
export function acceptLikely(): void {
  const answer = likelyAnswer();
  const edges = queryClient.getQueryData(
    queries.edges(useUiStore.getState().drawing ?? "").queryKey,
  );
  if (answer !== null) void retype(questionRows(edges, answer.question), answer.type);
}
