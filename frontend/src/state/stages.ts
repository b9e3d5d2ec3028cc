/** Stages of a compile, as the progress bar shows them. */

import type { Job } from "../api/client";

export type Stage = Exclude<Job["stage"], "">;

/** Title of every stage that the server can report; null: a compile does not report it. */
export const COMPILE_STAGES: Readonly<Record<Stage, string | null>> = {
  prepare: null,
  read: "Reading",
  classify: null,
  store: null,
  clean: "Cleaning",
  plan: "Planning",
  compensate: "Compensating",
  sequence: "Sequencing",
  process: "Writing program",
  verify: "Verifying",
  done: null,
};

/** The stages of the progress bar, in order. */
export const SHOWN_STAGES: readonly Stage[] = (Object.keys(COMPILE_STAGES) as Stage[]).filter(
  (stage) => COMPILE_STAGES[stage] !== null,
);

/** Text and position of a stage; before the first and without a stage the job waits. */
export function stageProgress(stage: Job["stage"]): { title: string; index: number } {
  if (stage === "") return { title: "Waiting to start", index: -1 };
  if (stage === "prepare") return { title: "Waiting for the server to be prepared", index: -1 };
  if (stage === "done") return { title: "Done", index: SHOWN_STAGES.length };
  return { title: COMPILE_STAGES[stage] ?? stage, index: SHOWN_STAGES.indexOf(stage) };
}
