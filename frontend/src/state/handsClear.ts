/** The statement of the person at a machine that hands are clear of it. */

import { useEffect, useRef, useState } from "react";
import type { Station } from "../api/client";
import { service } from "../api/client";
import { useHandsStatement } from "./handsStatement";
import { reportFailure } from "./operations";
import { isMoving, type OperationName } from "./station";

/** Id of the check that is this statement. */
export const HANDS = "hands-clear";

export interface HandsClear {
  /** Time (s) for which the statement still counts; 0: nobody has made it. */
  readonly left: number;
  /** Make the statement, or take it back. */
  toggle(): void;
}

/** Operations that move or lower something by themselves. A jog moves only while it is held. */
const NEEDING: ReadonlySet<OperationName> = new Set([
  "home",
  "zero",
  "park",
  "dry_run",
  "frame",
  "tool_check",
  "resume",
  "switch",
  "spindle",
]);

/** Why an operation cannot be asked for before hands are stated to be clear; null if it can. */
export const handsReason = (operation: OperationName, { left }: HandsClear): string | null =>
  NEEDING.has(operation) && left === 0 ? "State first that hands are clear." : null;

/** Time between two updates of the time that is left (ms). */
const TICK = 250;

/** The statement about one machine. It ends after a minute, and with the motion that it permits. */
export function useHandsClear(machine: string, station: Station | undefined): HandsClear {
  const statement = useHandsStatement();
  const [now, setNow] = useState(0);
  const moving = isMoving(station);
  const moved = useRef(false);
  const { until, make, end } = statement;
  useEffect(() => {
    if (moved.current && !moving) end();
    moved.current = moving;
  }, [moving, end]);
  // Who leaves the page no longer looks at the machine.
  useEffect(() => end, [end]);
  useEffect(() => {
    if (until === 0) return;
    const timer = setInterval(() => {
      setNow(Date.now());
      if (Date.now() >= until) end();
    }, TICK);
    return () => clearInterval(timer);
  }, [until, end]);
  const counts = until !== 0 && statement.machine === machine;
  return {
    left: counts ? Math.max(Math.ceil((until - now) / 1000), 1) : 0,
    toggle: () => {
      if (counts) {
        end();
        return;
      }
      const asked = Date.now();
      void reportFailure("Hands clear", async () => {
        const { seconds } = await service.stateHandsClear(machine);
        setNow(Date.now());
        make(machine, asked + seconds * 1000);
      });
    },
  };
}
