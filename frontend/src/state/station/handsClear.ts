/** The statement of the person at a machine that hands are clear of it. */

import { useEffect, useRef, useState } from "react";
import { machineService, type Station } from "../../api/machines";
import { translate } from "../../language/translate";
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
  NEEDING.has(operation) && left === 0 ? translate("handsClear.stateFirstThatHandsAre") : null;

/** Time between two updates of the time that is left (ms). */
const TICK = 250;

/** Make the statement on the server, and then on this page. */
export const stateHandsClear = (machine: string): Promise<void> =>
  reportFailure(translate("handsClear.handsClear"), async () => {
    const asked = Date.now();
    const { seconds } = await machineService.stateHandsClear(machine);
    useHandsStatement.getState().make(machine, asked + seconds * 1000);
  });

/** Take the statement back on this page, and on the server: from there on nothing moves by it. */
export function withdrawHandsClear(machine: string): Promise<void> {
  useHandsStatement.getState().end();
  return reportFailure(translate("handsClear.takeBackHandsClear"), () =>
    machineService.withdrawHandsClear(machine),
  );
}

/** The statement about one machine. It ends after a minute, and with the motion that it permits. */
export function useHandsClear(machine: string, station: Station | undefined): HandsClear {
  const statement = useHandsStatement();
  const [now, setNow] = useState(0);
  const moving = isMoving(station);
  const moved = useRef(false);
  const { until, end } = statement;
  useEffect(() => {
    if (moved.current && !moving) end();
    moved.current = moving;
  }, [moving, end]);
  // Who leaves the page no longer looks at the machine.
  useEffect(
    () => () => {
      if (useHandsStatement.getState().until !== 0) void withdrawHandsClear(machine);
    },
    [machine],
  );
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
      setNow(Date.now());
      void (counts ? withdrawHandsClear(machine) : stateHandsClear(machine));
    },
  };
}
