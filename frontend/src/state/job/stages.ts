/** Stages of a compile, as the progress bar shows them. */

import type { Job } from "../../api/jobs";
import { translate } from "../../language/translate";

export type Stage = Exclude<Job["stage"], "">;

/** Title of every stage that the server can report; null: a compile does not report it. */
export const COMPILE_STAGES: Readonly<Record<Stage, string | null>> = {
  prepare: null,
  read: translate("stages.readingTheDrawing"),
  classify: null,
  store: null,
  clean: translate("stages.removingDuplicateLinesAndClosing"),
  plan: translate("stages.assigningToolsToCutsAnd"),
  compensate: translate("stages.calculatingToolPaths"),
  sequence: translate("stages.choosingTheOrderOfThe"),
  process: translate("stages.writingTheProgram"),
  verify: translate("stages.checkingTheProgram"),
  done: null,
};

/** The stages of the progress bar, in order. */
export const SHOWN_STAGES: readonly Stage[] = (Object.keys(COMPILE_STAGES) as Stage[]).filter(
  (stage) => COMPILE_STAGES[stage] !== null,
);

/** Text and position of a stage; before the first and without a stage the job waits. */
export function stageProgress(stage: Job["stage"]): { title: string; index: number } {
  if (stage === "") return { title: translate("stages.waitingForTheServerTo"), index: -1 };
  if (stage === "prepare") return { title: translate("stages.waitingForTheServerTo2"), index: -1 };
  if (stage === "done")
    return { title: translate("stages.programIsReady"), index: SHOWN_STAGES.length };
  return { title: COMPILE_STAGES[stage] ?? stage, index: SHOWN_STAGES.indexOf(stage) };
}
