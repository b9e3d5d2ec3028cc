/** The statement of the person at a machine that hands are clear of it, as this page keeps it. */

import { create } from "zustand";

interface Statement {
  /** Name of the machine; empty if nothing is stated. */
  readonly machine: string;
  /** Time until which it counts (ms since 1970); 0: nothing is stated. */
  readonly until: number;
  make(machine: string, until: number): void;
  end(): void;
}

export const useHandsStatement = create<Statement>()((set) => ({
  machine: "",
  until: 0,
  make: (machine, until) => set({ machine, until }),
  end: () => set({ machine: "", until: 0 }),
}));

/** What moves the machine: the statement counts for one of them. */
const MOTIONS: ReadonlySet<string> = new Set([
  "home",
  "jog",
  "park",
  "dry_run",
  "frame",
  "tool_check",
  "resume",
  "start",
]);

/** End the statement if a machine has begun an operation that moves it. */
export function endWithMotion(operation: string): void {
  if (MOTIONS.has(operation)) useHandsStatement.getState().end();
}
