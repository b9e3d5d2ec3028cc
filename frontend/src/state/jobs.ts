/** What the states of a job mean to whoever looks at it. */

import type { Job, JobCommand, JobState } from "../api/client";

export interface StateLook {
  readonly title: string;
  readonly tone: "grey" | "blue" | "green" | "amber" | "red";
}

export const STATE_LOOKS: Readonly<Record<JobState, StateLook>> = {
  received: { title: "Received", tone: "grey" },
  compiling: { title: "Compiling", tone: "blue" },
  ready: { title: "Ready", tone: "green" },
  queued: { title: "Queued", tone: "blue" },
  running: { title: "Running", tone: "blue" },
  held: { title: "Held", tone: "amber" },
  done: { title: "Done", tone: "green" },
  refused: { title: "Refused", tone: "red" },
  interrupted: { title: "Interrupted", tone: "amber" },
  scrapped: { title: "Scrapped", tone: "grey" },
  cancelled: { title: "Cancelled", tone: "grey" },
};

const COMMANDS: Readonly<Record<JobState, readonly JobCommand[]>> = {
  received: ["cancel"],
  compiling: ["cancel"],
  ready: ["release", "cancel"],
  queued: ["cancel"],
  running: ["hold", "cancel"],
  held: ["resume", "cancel"],
  interrupted: ["requeue", "scrap"],
  done: [],
  refused: [],
  scrapped: [],
  cancelled: [],
};

export const commandsOf = (job: Job): readonly JobCommand[] => COMMANDS[job.state];

/** The service is working the drawing into a program. */
export const isCompiling = (job: Job): boolean =>
  job.state === "received" || job.state === "compiling";

/** The head is in the board. */
export const isOnTable = (job: Job): boolean => job.state === "running" || job.state === "held";

/** There is a program, so a path to look at. */
export const hasProgram = (job: Job): boolean => job.program_sha256 !== "";

/** Nothing will happen to it any more. */
export const isOver = (job: Job): boolean =>
  ["done", "refused", "scrapped", "cancelled"].includes(job.state);
