/** The person at a machine: what is on its table, what may be asked of it, and why not. */

import type { Job } from "../../api/jobs";
import type { Activity, Machine, Operation, OperationRequest, Station } from "../../api/machines";
import { translate } from "../../language/translate";
import { messageText } from "../../messages/translateMessage";
import { isFinal, isOnTable, needsOperator, stateStyleOf } from "../job/jobs";

export type Tone = "grey" | "blue" | "green" | "amber" | "red";

export interface StationTitle {
  readonly title: string;
  readonly tone: Tone;
}

export const AXES = ["X", "Y", "Z", "C"] as const;
export type Axis = (typeof AXES)[number];
export type OperationName = OperationRequest["operation"];

const STATES: Readonly<Record<Station["state"], StationTitle>> = {
  "": { title: translate("stationState.controllerNotConnected"), tone: "grey" },
  idle: { title: translate("stationState.atRest"), tone: "green" },
  run: { title: translate("stationState.moving"), tone: "blue" },
  hold: { title: translate("stationState.held"), tone: "amber" },
  jog: { title: translate("stationState.movingByHand"), tone: "blue" },
  home: { title: translate("stationState.homing"), tone: "blue" },
  check: { title: translate("stationState.checkMode"), tone: "blue" },
  door: { title: translate("stationState.safetyDoorOpen"), tone: "red" },
  alarm: { title: translate("stationState.alarm"), tone: "red" },
  sleep: { title: translate("stationState.asleep"), tone: "amber" },
  tool: { title: translate("stationState.waitsForATool"), tone: "amber" },
  busy: { title: translate("stationState.busy"), tone: "amber" },
  unreported: { title: translate("stationState.connected"), tone: "green" },
};

/** A job that is or was on the table decides what the page shows; a final one only informs. */
const occupies = (job: Job | undefined): job is Job => job !== undefined && !isFinal(job);

/** Names of the runs above the board, as a title and as a label of their outcome. */
export const RUN_TITLES: Readonly<Record<Activity["kind"], string>> = {
  dry_run: translate("stationState.dryRun"),
  frame: translate("stationState.frame"),
  tool_check: translate("stationState.toolCheck"),
};

/** The run above the board that the machine executes now; null if there is none. */
export function runAboveBoard(station: Station | undefined): Activity | null {
  const activity = station?.activity ?? null;
  return activity?.state === "running" || activity?.state === "held" ? activity : null;
}

/** The one title that a person reads from two metres away. */
export function titleOf(station: Station | undefined, job: Job | undefined): StationTitle {
  if (station === undefined) return { title: translate("stationState.connecting"), tone: "grey" };
  if (station.gateway === "")
    return { title: translate("stationState.machineNotConnected"), tone: "grey" };
  if (station.alarm !== null) return { title: translate("stationState.alarm"), tone: "red" };
  if (!station.connected)
    return { title: translate("stationState.controllerNotConnected"), tone: "red" };
  // Its job does not move, although it counts as running.
  if (station.state === "door") return STATES.door;
  if (station.obstacle !== null && station.state !== "idle") return STATES[station.state];
  const run = runAboveBoard(station);
  if (run !== null) {
    const title = RUN_TITLES[run.kind];
    return run.state === "held"
      ? { title: translate("stationState.paused", { title }), tone: "amber" }
      : { title, tone: "blue" };
  }
  const waits = (one: Job) => needsOperator(one) || one.waiting_for === "compile";
  if (occupies(job) && (isOnTable(job) || waits(job) || job.state === "interrupted")) {
    return stateStyleOf(job);
  }
  return STATES[station.state];
}

const MOVING: ReadonlySet<Station["state"]> = new Set(["run", "jog", "home"]);

/** Whether the machine moves now, by its own report. */
export const isMoving = (station: Station | undefined): boolean =>
  MOVING.has(station?.state ?? "") || runAboveBoard(station)?.state === "running";

/** Whether the machine moves, or may move at any moment. */
export function moves(station: Station | undefined, job: Job | undefined): boolean {
  return (
    MOVING.has(station?.state ?? "") ||
    (job?.state === "running" && job.waiting_for === "") ||
    // Taken, but not executed yet.
    job?.requested_action === "resume"
  );
}

/** What the Stop button does now; null if there is nothing to stop. */
export interface Stop {
  readonly act: "cancel" | "stop_jog";
  /** Whether a question comes first. A moving machine is stopped at once. */
  readonly asks: boolean;
}

export function stopOf(station: Station | undefined, job: Job | undefined): Stop | null {
  // A run above the board is stopped; the job keeps waiting.
  if (runAboveBoard(station) !== null) return { act: "stop_jog", asks: false };
  // So is a jog or a homing cycle: to cancel the waiting job would not stop the machine.
  const byHand = station?.state === "jog" || station?.state === "home";
  if (byHand && !(job && isOnTable(job)) && station.operations.includes("stop_jog"))
    return { act: "stop_jog", asks: false };
  if (job?.actions.includes("cancel") && (isOnTable(job) || needsOperator(job)))
    return { act: "cancel", asks: !moves(station, job) };
  return null;
}

/** Operations that free the controller while a job waits for its next sheet. */
const BETWEEN_COPIES: ReadonlySet<OperationName> = new Set([
  "unlock",
  "home",
  "release",
  "lift",
  "stop_jog",
]);

/** Age (s) from which a report of the machine is named old. */
const OLD = 2;

/** How old the report of a machine is, if a person should know; "" while it is new. */
export function ageText(station: Station | undefined): string {
  const age = station?.seen_seconds_ago ?? null;
  return age === null || age < OLD ? "" : translate("stationState.sAgo", { age: Math.round(age) });
}

/** Heights may be this much below the lift (mm): rounding of reports. */
const ROUNDING = 0.01;

/** Height from which the head may move across the board (mm). */
const liftOf = ({ travel_z, axes }: Machine): number =>
  Math.min(travel_z, axes.z?.high ?? travel_z);

const isLifted = (station: Station, machine: Machine): boolean =>
  station.position !== null && station.position[2] >= liftOf(machine) - ROUNDING;

/**
 * Why an operation cannot be asked for now; null if it can.
 *
 * The server and the gateway check again: this only saves the person a refusal.
 */
export function reasonAgainst(
  operation: OperationName,
  station: Station | undefined,
  machine: Machine,
  job: Job | undefined,
  axis?: Axis,
): string | null {
  if (station === undefined) return translate("stationState.theStateOfTheMachine");
  if (station.gateway === "") return translate("stationState.theMachineIsNotConnected");
  if (!station.connected) return translate("stationState.theControllerOfTheMachine");
  // Between two copies the controller is freed, and the job keeps waiting for its sheet.
  const free = BETWEEN_COPIES.has(operation) && job?.waiting_for === "sheet";
  if (job !== undefined && isOnTable(job) && !free) {
    if (station.alarm !== null) return translate("stationState.aJobIsOnThis");
    return job.state === "held"
      ? translate("stationState.aJobIsHeldOn")
      : translate("stationState.aJobRunsOnThis");
  }
  if (!station.operations.includes(operation))
    return translate("stationState.theControllerOfThisMachine");
  const run = runAboveBoard(station);
  if (operation === "hold")
    return run?.state === "running" ? null : translate("stationState.nothingRuns");
  if (operation === "resume")
    return run?.state === "held" ? null : translate("stationState.nothingIsHeld");
  if (run !== null && operation !== "stop_jog")
    return translate("stationState.theMachineRunsAboveThe");
  if (operation === "unlock")
    return station.alarm === null ? translate("stationState.thereIsNoAlarm") : null;
  if (operation === "release") {
    if (station.state === "door") return translate("stationState.closeTheSafetyDoorFirst");
    return station.obstacle !== null && station.state !== "idle"
      ? null
      : translate("stationState.nothingIsHeld");
  }
  if (operation === "home") return null;
  if (station.alarm !== null) return translate("stationState.anAlarmLocksTheMachine");
  if (operation === "stop_jog") return null;
  if (station.obstacle !== null && station.state !== "idle")
    return translate("stationState.theMachineIsNotFree");
  if (station.state !== "idle") return translate("stationState.theMachineMovesWaitUntil");
  const acrossBoard =
    operation === "switch" || operation === "spindle" || (operation === "jog" && axis !== "Z");
  if (acrossBoard && !isLifted(station, machine))
    return translate("stationState.theToolIsDownRaise", { machine: liftOf(machine) });
  return null;
}

/** Limits of an axis; undefined if the machine does not state them or has no such axis. */
function limitsOf(machine: Machine, axis: Axis) {
  // The heading is C for a person, whatever its letter in programs.
  const letter = axis === "C" ? machine.carriages[0]?.letters[3] : axis;
  return letter === undefined ? undefined : machine.axes[letter.toLowerCase()];
}

/** Whether an axis of the machine turns the tools. */
export const turnsTools = (machine: Machine): boolean => limitsOf(machine, "C") !== undefined;

/** Lowest and highest position of an axis; null if the machine does not state them. */
export function travelOf(machine: Machine, axis: Axis): readonly [number, number] | null {
  const { low, high } = limitsOf(machine, axis) ?? {};
  return low === undefined || high === undefined ? null : [low, high];
}

/** A jog of one axis, shortened so that it ends inside the travel; 0 at its limit. */
export function jogDistance(
  machine: Machine,
  position: Station["position"],
  axis: Axis,
  wanted: number,
): number {
  const travel = travelOf(machine, axis);
  if (travel === null || position === null) return wanted;
  const here = position[AXES.indexOf(axis)] ?? 0;
  const target = Math.min(Math.max(here + wanted, travel[0]), travel[1]);
  // A position outside the travel is not made worse, and only jogs back to it.
  const distance = target - here;
  return Math.abs(distance) < ROUNDING || distance * wanted < 0 ? 0 : distance;
}

/** Speeds of jogs (mm/min, degrees/min): slow enough to watch the tool. */
const JOG_FEED: Readonly<Record<Axis, number>> = { X: 3000, Y: 3000, Z: 600, C: 3600 };

export function jogFeed(machine: Machine, axis: Axis): number {
  const fastest = limitsOf(machine, axis)?.velocity;
  return fastest === undefined ? JOG_FEED[axis] : Math.min(JOG_FEED[axis], fastest * 60);
}

/** One step of the feed override, such as -10 %. */
export interface OverrideStep {
  readonly name: "slower" | "nominal" | "faster";
  readonly label: string;
  readonly percent: number;
  readonly enabled: boolean;
}

/** Steps of the feed override while a job runs; null if the feed cannot be changed. */
export function overrideSteps(
  machine: Machine,
  station: Station | undefined,
  job: Job | undefined,
): readonly OverrideStep[] | null {
  const now = station?.override ?? null;
  if (now === null || station?.connected !== true || job === undefined || !isOnTable(job))
    return null;
  if (!station.operations.includes("feed_override")) return null;
  const [least, greatest] = machine.feed_override;
  const within = (percent: number) => Math.min(Math.max(percent, least), greatest);
  const steps = [
    { name: "slower", label: "−10 %", percent: within(now - 10) },
    { name: "nominal", label: "100 %", percent: 100 },
    { name: "faster", label: "+10 %", percent: within(now + 10) },
  ] as const;
  return steps.map((step) => ({ ...step, enabled: step.percent !== now }));
}

/** Outputs of the machine that a person may switch, with the station that each lowers. */
export function outputsOf(machine: Machine): readonly { number: number; name: string }[] {
  const found = machine.stations.filter(({ output }) => output >= 0);
  return found.map(({ output, name }) => ({ number: output, name }));
}

/** Stations whose spindle or oscillation a person may switch; a laser is never lit by hand. */
export const spindlesOf = (machine: Machine): readonly { number: number; name: string }[] =>
  machine.stations.filter(({ spindle, tool }) => spindle !== "" && tool.kind !== "laser");

/** An action of the person, and its outcome. */
export interface Outcome {
  readonly label: string;
  /** asked: on its way to the server. taken: the server has it, the machine not yet. */
  readonly state: "asked" | "taken" | "done" | "refused" | "expired";
  readonly text: string;
  readonly hint: string;
}

export const OUTCOME_TITLES: Readonly<Record<Outcome["state"], string>> = {
  asked: translate("stationState.sending"),
  taken: translate("stationState.acceptedWaitingForTheMachine"),
  done: translate("stationState.done"),
  refused: translate("stationState.refused"),
  expired: translate("stationState.expiredNothingWasDone"),
};

export const OUTCOME_TONES: Readonly<Record<Outcome["state"], Tone>> = {
  asked: "grey",
  taken: "blue",
  done: "green",
  refused: "red",
  expired: "amber",
};

/** Outcome of an operation whose state the server has reported. */
export const outcomeOf = (label: string, { state, message }: Operation): Outcome => ({
  label,
  state: state === "waiting" ? "taken" : state,
  text: message === null ? "" : messageText(message),
  hint: "",
});
