/** Stages of a compile, as the progress bar shows them. */

import type { Job } from "../api/client";

export type Stage = Exclude<Job["stage"], "">;

/** Title of every stage that the server can report; null: a compile does not report it. */
export const COMPILE_STAGES: Readonly<Record<Stage, string | null>> = {
  prepare: null,
  read: "Reading the drawing",
  classify: null,
  store: null,
  clean: "Removing duplicate lines and closing gaps",
  plan: "Assigning tools to cuts and creases",
  compensate: "Calculating tool paths",
  sequence: "Choosing the order of the cuts",
  process: "Writing the program",
  verify: "Checking the program",
  done: null,
};

/** The stages of the progress bar, in order. */
export const SHOWN_STAGES: readonly Stage[] = (Object.keys(COMPILE_STAGES) as Stage[]).filter(
  (stage) => COMPILE_STAGES[stage] !== null,
);

/** Text and position of a stage; before the first and without a stage the job waits. */
export function stageProgress(stage: Job["stage"]): { title: string; index: number } {
  if (stage === "") return { title: "Waiting for the server to begin", index: -1 };
  if (stage === "prepare")
    return { title: "Waiting for the server to finish its first start", index: -1 };
  if (stage === "done") return { title: "Program is ready", index: SHOWN_STAGES.length };
  return { title: COMPILE_STAGES[stage] ?? stage, index: SHOWN_STAGES.indexOf(stage) };
}
