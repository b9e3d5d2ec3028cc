/** What leads a machine out of a state in which it does not work, and what is against a start. */

import type { Job } from "../../api/jobs";
import type { Station } from "../../api/machines";
import { translate } from "../../language/translate";
import { messageText } from "../../messages/translateMessage";
import { isOnTable, needsOperator } from "../job/jobs";
import { type OperationName, runAboveBoard } from "./station";

/** An operation that frees the machine. */
export interface Way {
  readonly operation: Extract<OperationName, "home" | "unlock" | "release">;
  readonly title: string;
  readonly note: string;
}

const HOME: Way = {
  operation: "home",
  title: translate("wayOut.home"),
  note: translate("wayOut.findsTheZeroOfAll"),
};
const UNLOCK: Way = {
  operation: "unlock",
  title: translate("wayOut.unlock"),
  note: translate("wayOut.clearsTheAlarmWithoutHoming"),
};
const POWER: Way = {
  operation: "unlock",
  title: translate("wayOut.unlock"),
  note: translate("wayOut.switchesTheMachineOnIt"),
};
const RELEASE: Way = {
  operation: "release",
  title: translate("wayOut.release"),
  note: translate("wayOut.discardsWhatTheMachineHolds"),
};

/** Alarms that one operation only leads out of. */
const ALARMS: Readonly<Record<string, readonly Way[]>> = {
  "linuxcnc.estop": [POWER],
  "linuxcnc.machine-off": [POWER],
  "linuxcnc.not-homed": [HOME],
  "mcx314.alarm-unhomed": [HOME],
};

/** Whether a job is on the machine that is held or moves, other than between two copies. */
const isInJob = (job: Job | undefined): boolean =>
  job !== undefined && isOnTable(job) && job.waiting_for !== "sheet";

/** The operations that free a machine; none in a job, which is resumed or stopped. */
export function waysOut(station: Station, job: Job | undefined): readonly Way[] {
  if (station.alarm !== null) return ALARMS[station.alarm.code] ?? [HOME, UNLOCK];
  if (station.obstacle === null || isInJob(job)) return [];
  // A pressed limit switch is left by a jog or by homing.
  return station.state === "idle" ? [HOME] : [RELEASE];
}

/** The heading above the alarm or the obstacle of a machine. */
export function headingOf(station: Station, job: Job | undefined): string {
  if (station.alarm !== null) return translate("wayOut.alarm");
  return isInJob(job)
    ? translate("wayOut.theJobDoesNotMove")
    : translate("wayOut.theMachineTakesNoJob");
}

/** Why a job or its next copy cannot start now, besides what must be checked; null if it can. */
export function reasonAgainstStart(
  job: Job | undefined,
  station: Station | undefined,
): string | null {
  if (job === undefined) return translate("wayOut.thereIsNoJobFor");
  if (runAboveBoard(station) !== null) return translate("wayOut.theMachineRunsAboveThe");
  const obstacle = station?.alarm ?? station?.obstacle ?? null;
  if (obstacle !== null && !isInJob(job)) return messageText(obstacle);
  if (!needsOperator(job) || !job.actions.includes("confirm"))
    return translate("wayOut.noJobWaitsForIts");
  return null;
}

/** Why nothing can be resumed now, besides hands at the machine; null if it can. */
export function reasonAgainstResume(
  job: Job | undefined,
  station: Station | undefined,
): string | null {
  const words = job?.actions ?? [];
  // A job that waits for a sheet goes on with Start, after the checks.
  if (
    runAboveBoard(station)?.state !== "held" &&
    !words.includes("resume") &&
    !words.includes("end")
  )
    return translate("wayOut.noJobIsHeld");
  return station?.state === "door" ? translate("wayOut.closeTheSafetyDoorFirst") : null;
}
