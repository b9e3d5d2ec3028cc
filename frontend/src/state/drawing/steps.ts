/** Steps from a drawing to a job: which one needs the user first, and what is open in each. */

import type { DrawingSummary, Question } from "../../api/drawings";
import type { Job } from "../../api/jobs";
import type { Step } from "../store";
import { questionKey } from "./questions";

export interface StepStatus {
  /** `open`: the user must do something. `todo`: not reached. */
  readonly kind: "done" | "open" | "todo" | "busy" | "warning";
  /** Number of open questions. */
  readonly count?: number;
}

export interface Progress {
  /** Number of open questions. */
  readonly questions: number;
  /** Whether board and machine are chosen. */
  readonly chosen: boolean;
  /** null if no job is open */
  readonly job: Pick<Job, "state" | "verdict" | "waiting_for"> | null;
}

/** All open questions: of the drawing, of a refused order, and of a refused job. */
export function openQuestions(
  ...lists: readonly (readonly Question[])[]
): readonly (readonly [key: string, Question])[] {
  const found = new Map<string, Question>();
  for (const question of lists.flat()) found.set(questionKey(question), question);
  return [...found];
}

/** The step that needs the user first; `hasJob`: a job of the drawing is open or stored. */
export function firstStep(questions: number, hasJob: boolean): Step {
  if (questions > 0) return "lines";
  return hasJob ? "check" : "sheet";
}

/** Whether a job was made before the last change of its drawing. */
export const isOutdated = (
  job: Pick<Job, "created">,
  drawing: Pick<DrawingSummary, "updated">,
): boolean => Date.parse(job.created) < Date.parse(drawing.updated);

export function stepStatuses({ questions, chosen, job }: Progress): Record<Step, StepStatus> {
  const lines: StepStatus = questions > 0 ? { kind: "open", count: questions } : { kind: "done" };
  const sheet: StepStatus = { kind: chosen ? "done" : "open" };
  return {
    lines,
    sheet,
    // All choices of the process have defaults.
    process: { kind: chosen ? "done" : "todo" },
    check: checkStatus(job),
  };
}

function checkStatus(job: Progress["job"]): StepStatus {
  if (job === null) return { kind: "todo" };
  if (job.state === "received" || job.state === "compiling") return { kind: "busy" };
  if (job.state === "refused" || job.waiting_for === "compile" || job.state === "interrupted")
    return { kind: "warning" };
  if (job.state === "ready") return { kind: "open" };
  return { kind: "done" };
}
