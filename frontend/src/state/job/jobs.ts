/** Titles, colours and available commands of job states. */

import type { Job, JobCommand, JobState, StationCommand } from "../../api/jobs";
import { translate } from "../../language/translate";

export interface StateStyle {
  readonly title: string;
  readonly tone: "grey" | "blue" | "green" | "amber" | "red";
}

export const STATE_STYLES: Readonly<Record<JobState, StateStyle>> = {
  received: { title: translate("jobs.waitingForProgram"), tone: "grey" },
  compiling: { title: translate("jobs.preparingProgram"), tone: "blue" },
  ready: { title: translate("jobs.readyToSend"), tone: "green" },
  queued: { title: translate("jobs.queued"), tone: "blue" },
  running: { title: translate("jobs.running"), tone: "blue" },
  held: { title: translate("jobs.paused"), tone: "amber" },
  done: { title: translate("jobs.finished"), tone: "green" },
  refused: { title: translate("jobs.refused"), tone: "red" },
  interrupted: { title: translate("jobs.interrupted"), tone: "amber" },
  scrapped: { title: translate("jobs.boardScrapped"), tone: "grey" },
  continued: { title: translate("jobs.continuedByAnotherJob"), tone: "grey" },
  cancelled: { title: translate("jobs.cancelled"), tone: "grey" },
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
  if (job.waiting_for === "confirmation")
    return { title: translate("jobs.waitingForOperator"), tone: "amber" };
  if (job.waiting_for === "compile") return { title: translate("jobs.outOfDate"), tone: "amber" };
  if (job.waiting_for === "sheet")
    return { title: translate("jobs.waitingForNewSheet"), tone: "amber" };
  if (awaitsEnd(job)) return { title: translate("jobs.hasTheMachineFinished"), tone: "amber" };
  return STATE_STYLES[job.state];
}

/** Text of a confirmation dialog. */
export interface Confirmation {
  readonly title: string;
  readonly text: string;
  readonly yes: string;
  readonly no: string;
}

/** Confirmation needed before a command is sent; null if none. */
export function confirmationBefore(job: Job, word: JobCommand): Confirmation | null {
  if (word === "cancel" && isOnTable(job)) {
    return {
      title: translate("jobs.cancelTheRunningJob"),
      text: translate("jobs.theMachineStopsLiftsThe"),
      yes: translate("jobs.cancelJob"),
      no: translate("jobs.doNotCancel"),
    };
  }
  if (word === "scrap") {
    return {
      title: translate("jobs.endThisJobBecauseIts"),
      text: translate("jobs.removeTheBoardFromThe"),
      yes: translate("jobs.endJobBoardIsScrap"),
      no: translate("jobs.doNotEndJob"),
    };
  }
  if (word === "finish") {
    return {
      title: translate("jobs.markThisJobAsFinished"),
      text: translate("jobs.markTheJobAsFinished", { copies: job.copies }),
      yes: translate("jobs.markAsFinished"),
      no: translate("jobs.doNotMarkAsFinished"),
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
