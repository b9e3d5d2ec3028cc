/** The machine that a new job proposes, and the state of a machine in one word. */

import type { Job } from "../../api/jobs";
import type { Machine } from "../../api/machines";
import { needsOperator } from "./jobs";

type Connection = Pick<Machine, "name" | "gateway">;

/** Name of the first machine that is connected, otherwise of the first one; null if there is none. */
export function proposedMachine(machines: readonly Connection[]): string | null {
  const connected = machines.find(({ gateway }) => gateway === "connected");
  return (connected ?? machines[0])?.name ?? null;
}

/** State of a machine; `occupant` is the job that occupies it, also while it waits for a person. */
export function machineWord(
  machine: Pick<Machine, "gateway" | "job">,
  occupant: Job | undefined,
): "offline" | "free" | "waiting" | "interrupted" | "busy" {
  if (machine.gateway !== "connected") return "offline";
  if (occupant !== undefined && needsOperator(occupant)) return "waiting";
  if (occupant?.state === "interrupted") return "interrupted";
  return machine.job === null && occupant === undefined ? "free" : "busy";
}
