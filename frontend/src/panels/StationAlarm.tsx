/** The alarm that locks the machine: its meaning, what to do, and the two ways out. */

import { IconAlertTriangleFilled } from "@tabler/icons-react";
import type { Job, Machine, Station } from "../api/client";
import { renderHint, renderText } from "../messages/render";
import { useRefusal } from "../state/accounts";
import { operate } from "../state/operations";
import { reasonAgainst } from "../state/station";
import css from "./station.module.css";

interface Props {
  readonly machine: Machine;
  readonly station: Station;
  readonly job: Job | undefined;
  readonly reached: boolean;
}

const WAYS = [
  { operation: "home", title: "Home", note: "Finds the zero of all axes. The machine moves." },
  {
    operation: "unlock",
    title: "Unlock",
    note: "Clears the alarm without homing. The position may be wrong.",
  },
] as const;

export function StationAlarm({ machine, station, job, reached }: Props) {
  const refusal = useRefusal("POST /api/v1/machines/{name}/operations");
  if (station.alarm === null) return null;
  const hint = renderHint(station.alarm);
  return (
    <section className={css.alarm} role="alert" data-testid="alarm">
      <h2>
        <IconAlertTriangleFilled color="var(--bad)" aria-hidden />
        Alarm
      </h2>
      <p>{renderText(station.alarm)}</p>
      {hint !== "" && <p className={css.todo}>{hint}</p>}
      <div className={css.answers}>
        {WAYS.map(({ operation, title, note }) => {
          const reason = refusal ?? reasonAgainst(operation, station, machine, job);
          return (
            <div key={operation} className={css.way}>
              <button
                type="button"
                className={css.button}
                disabled={!reached || reason !== null}
                onClick={() => void operate(machine.name, title, { operation })}
                data-testid={`alarm-${operation}`}
              >
                {title}
              </button>
              <small>{reason ?? note}</small>
            </div>
          );
        })}
      </div>
    </section>
  );
}
