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
  interrupted: ["requeue", "finish", "scrap"],
  done: [],
  refused: [],
  scrapped: [],
  cancelled: [],
};

/** What the operator can ask of a job; `confirm` has a card of its own. */
export function commandsOf(job: Job): readonly JobCommand[] {
  const words = COMMANDS[job.state];
  // The confirmation of the sheet is what lets it go on.
  if (needsOperator(job)) return words.filter((word) => word !== "resume");
  // Every line was executed: to cut it again would spoil a board for nothing.
  const whole = job.lines > 0 && job.line === job.lines;
  if (job.state === "interrupted" && whole) return ["finish", "scrap"];
  return words;
}

/** The machine waits for somebody who looks at the table and confirms. */
export const needsOperator = (job: Job): boolean =>
  job.waiting_for === "confirmation" || job.waiting_for === "sheet";

/** What the state is called and how it is coloured. */
export function lookOf(job: Job): StateLook {
  if (job.waiting_for === "confirmation") return { title: "To confirm", tone: "amber" };
  if (job.waiting_for === "sheet") return { title: "New sheet", tone: "amber" };
  return STATE_LOOKS[job.state];
}

/** A question that is asked before a command is sent. */
export interface Ask {
  readonly title: string;
  readonly text: string;
  readonly yes: string;
}

const sheets = ({ copies }: Job): string =>
  copies === 1 ? "The sheet is" : `All ${copies} sheets are`;

/** What has to be asked before a command is sent; null where it can be sent at once. */
export function askBefore(job: Job, word: JobCommand): Ask | null {
  if (word === "cancel" && isOnTable(job)) {
    return {
      title: "Cancel the running job?",
      text:
        "The machine holds, lifts the tool and releases its stations. " +
        "The board on the table is probably lost.",
      yes: "Cancel the job",
    };
  }
  if (word === "scrap") {
    return {
      title: "Scrap this job?",
      text:
        "The job is given up, with the copies that are left. Its table is free for the next job. " +
        "Take the board off the table first.",
      yes: "Scrap the job",
    };
  }
  if (word === "finish") {
    return {
      title: "Is it finished?",
      text: `${sheets(job)} complete. The job ends as done, and its table is free for the next job.`,
      yes: "It is finished",
    };
  }
  return null;
}

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
