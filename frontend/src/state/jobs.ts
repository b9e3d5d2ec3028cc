/** Titles, colours and available commands of job states. */

import type { Job, JobCommand, JobState, StationCommand } from "../api/client";

export interface StateStyle {
  readonly title: string;
  readonly tone: "grey" | "blue" | "green" | "amber" | "red";
}

export const STATE_STYLES: Readonly<Record<JobState, StateStyle>> = {
  received: { title: "Waiting for program", tone: "grey" },
  compiling: { title: "Preparing program", tone: "blue" },
  ready: { title: "Ready to send", tone: "green" },
  queued: { title: "Queued", tone: "blue" },
  running: { title: "Running", tone: "blue" },
  held: { title: "Paused", tone: "amber" },
  done: { title: "Finished", tone: "green" },
  refused: { title: "Refused", tone: "red" },
  interrupted: { title: "Interrupted", tone: "amber" },
  scrapped: { title: "Board scrapped", tone: "grey" },
  continued: { title: "Continued by another job", tone: "grey" },
  cancelled: { title: "Cancelled", tone: "grey" },
};

/** Commands that are also given from other places than the machine. */
export type OfficeCommand = Exclude<JobCommand, StationCommand>;

/** Actions that have forms of their own, or belong to the page of the station. */
const ELSEWHERE: ReadonlySet<string> = new Set(["accept", "rest", "confirm", "resume", "end"]);

/**
 * Commands offered as buttons outside of the station, of those that the server allows.
 *
 * What starts or continues a machine is not among them: that is done where the machine is seen.
 */
export function commandsOf(job: Job): readonly OfficeCommand[] {
  const commands = job.actions.filter((word): word is OfficeCommand => !ELSEWHERE.has(word));
  // Out of date: the server refuses its start until it is compiled again.
  return job.waiting_for === "compile"
    ? commands.filter((word) => word === "recompile" || word === "cancel")
    : commands.filter((word) => word !== "recompile");
}

/** The job waits for the operator to check the table and confirm. */
export const needsOperator = (job: Job): boolean =>
  job.waiting_for === "confirmation" || job.waiting_for === "sheet";

/** The machine reports nothing: a person at it confirms that it has finished. */
export const awaitsEnd = (job: Job): boolean =>
  job.state === "held" && job.message?.code === "waiting.for-end";

/** The job goes on only if the person at the machine does something. */
export const waitsAtMachine = (job: Job): boolean =>
  needsOperator(job) || (job.state === "held" && job.requested_action === "");

/** Title and colour of the state of a job. */
export function stateStyleOf(job: Job): StateStyle {
  if (job.waiting_for === "confirmation") return { title: "Waiting for operator", tone: "amber" };
  if (job.waiting_for === "compile") return { title: "Out of date", tone: "amber" };
  if (job.waiting_for === "sheet") return { title: "Waiting for new sheet", tone: "amber" };
  if (awaitsEnd(job)) return { title: "Has the machine finished?", tone: "amber" };
  return STATE_STYLES[job.state];
}

/** Text of a confirmation dialog. */
export interface Confirmation {
  readonly title: string;
  readonly text: string;
  readonly yes: string;
  readonly no: string;
}

const sheets = ({ copies }: Job): string =>
  copies === 1 ? "the sheet is" : `all ${copies} sheets are`;

/** Confirmation needed before a command is sent; null if none. */
export function confirmationBefore(job: Job, word: JobCommand): Confirmation | null {
  if (word === "cancel" && isOnTable(job)) {
    return {
      title: "Cancel the running job?",
      text:
        "The machine stops, lifts the tool and releases its stations. " +
        "The board on the table is probably unusable.",
      yes: "Cancel job",
      no: "Do not cancel",
    };
  }
  if (word === "scrap") {
    return {
      title: "End this job because its board is scrap?",
      text:
        "Remove the board from the table first. The job ends, and the table is free for the next " +
        "job. Copies that are not made can be queued afterwards.",
      yes: "End job, board is scrap",
      no: "Do not end job",
    };
  }
  if (word === "finish") {
    return {
      title: "Mark this job as finished?",
      text: `Mark the job as finished only if ${sheets(job)} completely cut. The job ends as finished, and the table is free for the next job.`,
      yes: "Mark as finished",
      no: "Do not mark as finished",
    };
  }
  return null;
}

/** The program is being compiled. */
export const isCompiling = (job: Job): boolean =>
  job.state === "received" || job.state === "compiling";

/** The job has started on the machine and is not finished. */
export const isOnTable = (job: Job): boolean => job.state === "running" || job.state === "held";

/** The job is in the queue of its machine, or occupies the machine. */
export const isQueued = (job: Job): boolean =>
  isOnTable(job) || job.state === "queued" || job.state === "interrupted";

/** The job has a program and a tool path. */
export const hasProgram = (job: Job): boolean => job.program_sha256 !== "";

/** The job is in a final state. */
export const isFinal = (job: Job): boolean =>
  ["done", "refused", "scrapped", "continued", "cancelled"].includes(job.state);
