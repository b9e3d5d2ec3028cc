/**
 * Actions of the person at a machine, each with its outcome.
 *
 * They do not wait for one another, so that a stop never queues behind another action.
 */

import { create } from "zustand";
import { ServiceError } from "../../api/errors";
import { type Job, type JobCommand, jobService } from "../../api/jobs";
import { machineService, type OperationRequest } from "../../api/machines";
import { translate } from "../../language/translate";
import { messageHint, messageText } from "../../messages/translateMessage";
import { upsertJob } from "../cacheUpdates";
import { phaseOf, queries, queryClient } from "../queries";
import { endWithMotion } from "./handsStatement";
import { type Outcome, outcomeOf } from "./station";
import type { ToolDecision } from "./wornTools";

interface Outcomes {
  /** The last action of the person; null before the first. */
  readonly last: Outcome | null;
  /** Number of actions so far: an older action does not replace the report of a newer one. */
  readonly count: number;
  begin(label: string): number;
  report(number: number, outcome: Outcome): void;
  /** Remove the report of an action that is over; what is refused stays to be read. */
  leave(): void;
}

export const useOutcomes = create<Outcomes>()((set, get) => ({
  last: null,
  count: 0,
  begin: (label) => {
    const count = get().count + 1;
    set({ count, last: { label, state: "asked", text: "", hint: "" } });
    return count;
  },
  report: (number, last) => {
    if (number === get().count) set({ last });
  },
  leave: () => {
    if (get().last?.state === "done") set({ last: null });
  },
}));

const sleep = (milliseconds: number): Promise<void> =>
  new Promise((resolve) => setTimeout(resolve, milliseconds));

/** Time between two questions for the result of an operation (ms), early and later. */
const SOON = 150;
const LATER = 600;
/** Time (ms) after which an operation is asked for less often. */
const EARLY = 4000;
/** Time (s) in which a machine executes a command of a job, or something is wrong. */
const PROMPT = 3;

/** A failure as an outcome: what the server refused, or that nothing arrived. */
function failureOf(label: string, cause: unknown): Outcome {
  if (!(cause instanceof ServiceError)) throw cause;
  const { problem } = cause;
  return { label, state: "refused", text: messageText(problem), hint: messageHint(problem) };
}

/** Ask for an operation, and follow it until it is done, refused or expired. */
export async function operate(
  machine: string,
  label: string,
  request: OperationRequest,
  onTaken: (id: string) => void = () => {},
): Promise<Outcome> {
  const { begin, report } = useOutcomes.getState();
  const number = begin(label);
  const began = Date.now();
  let outcome: Outcome;
  try {
    let operation = await machineService.operate(machine, request);
    onTaken(operation.id);
    outcome = outcomeOf(label, operation);
    report(number, outcome);
    while (outcome.state === "taken") {
      await sleep(Date.now() - began < EARLY ? SOON : LATER);
      operation = await machineService.operation(machine, operation.id);
      outcome = outcomeOf(label, operation);
    }
    if (outcome.state === "done") endWithMotion(request.operation);
  } catch (cause) {
    outcome = failureOf(label, cause);
  }
  report(number, outcome);
  return outcome;
}

/** Begin a jog, and return its id as soon as the server has it; null if it was refused. */
export const beginJog = (
  machine: string,
  label: string,
  request: OperationRequest,
): Promise<string | null> =>
  new Promise((resolve) => {
    void operate(machine, label, request, resolve).finally(() => resolve(null));
  });

/** State that the button of a jog is still held; false: the jog has ended. */
export async function renewJog(machine: string, id: string): Promise<boolean> {
  try {
    await machineService.renewJog(machine, id);
    return true;
  } catch (cause) {
    if (!(cause instanceof ServiceError)) throw cause;
    // Without an answer the next statement may arrive; the machine stops if none does.
    return cause.problem.status !== 409;
  }
}

/** Run an action whose success is seen otherwise, and report its failure. */
export async function reportFailure(label: string, action: () => Promise<void>): Promise<void> {
  try {
    await action();
  } catch (cause) {
    const { begin, report } = useOutcomes.getState();
    report(begin(label), failureOf(label, cause));
  }
}

/** Run an action that is no operation of the machine, and report its outcome. */
export async function reportAction(label: string, action: () => Promise<void>): Promise<void> {
  const outcomes = useOutcomes.getState();
  const number = outcomes.begin(label);
  try {
    await action();
    outcomes.report(number, { label, state: "done", text: "", hint: "" });
  } catch (cause) {
    outcomes.report(number, failureOf(label, cause));
  }
}

/** Whether the machine has executed a command of a job. */
export function isCarriedOut(word: JobCommand | "confirm", job: Job): boolean {
  if (job.requested_action !== "") return false;
  if (word === "hold") return job.state !== "running";
  if (word === "resume" || word === "end") return job.state !== "held";
  if (word === "confirm") return job.waiting_for === "" && job.state !== "queued";
  return job.state !== "running" && job.state !== "held";
}

/** Commands that start motion: they are sent once and given up rather than sent late. */
const STARTS: ReadonlySet<JobCommand | "confirm"> = new Set(["confirm", "resume"]);

/** What the operator has checked at the machine. */
export interface Checked {
  /** Ids of the checks that were ticked. */
  readonly ids: string[];
  /** What was decided about tools at the end of their lives. */
  readonly tools: ToolDecision;
}

/** Start a job or its next copy, and follow it until the machine runs. */
export const startJob = (job: string, { ids, tools }: Checked): Promise<void> =>
  followCommand(job, translate("operations.start"), "confirm", () =>
    jobService
      .confirmNow(job, { checked: ids, changed: tools.changed, worn_reason: tools.reason })
      .finally(() => endWithMotion("start")),
  );

/** Send a command of a job, and follow it until the machine has carried it out. */
export function commandJob(job: string, label: string, word: JobCommand): Promise<void> {
  const phase = phaseOf(job);
  return followCommand(job, label, word, () =>
    word === "resume" || word === "end"
      ? jobService.goOnNow(job, word, phase).finally(() => endWithMotion(word))
      : jobService.command(job, word),
  );
}

async function followCommand(
  job: string,
  label: string,
  word: JobCommand | "confirm",
  send: () => Promise<Job>,
): Promise<void> {
  const { begin, report } = useOutcomes.getState();
  const number = begin(label);
  try {
    upsertJob(await send());
    report(number, { label, state: "taken", text: "", hint: "" });
    const began = Date.now();
    for (;;) {
      const now = queryClient.getQueryData(queries.job(job).queryKey);
      if (now === undefined || isCarriedOut(word, now)) break;
      if (Date.now() - began > PROMPT * 1000) {
        report(number, {
          label,
          state: "taken",
          text: translate("operations.theMachineHasNotReacted", { prompt: PROMPT }),
          hint: STARTS.has(word) ? "" : translate("operations.ifItMustStopNow"),
        });
      }
      await sleep(SOON);
    }
    report(number, { label, state: "done", text: "", hint: "" });
  } catch (cause) {
    report(number, failureOf(label, cause));
  }
}
