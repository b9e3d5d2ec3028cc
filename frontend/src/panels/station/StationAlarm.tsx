/** What keeps the machine from work: its alarm or its hold, what to do, and the ways out. */

import { IconAlertTriangleFilled } from "@tabler/icons-react";
import type { Job, Machine, Station } from "../../api/client";
import { messageHint, messageText } from "../../messages/translateMessage";
import { useRefusal } from "../../state/accounts/accounts";
import { type HandsClear, handsReason } from "../../state/station/handsClear";
import { operate } from "../../state/station/operations";
import { reasonAgainst } from "../../state/station/station";
import { headingOf, waysOut } from "../../state/station/wayOut";
import { HandsClearButton } from "./HandsClearButton";
import css from "./station.module.css";

interface Props {
  readonly machine: Machine;
  readonly station: Station;
  readonly job: Job | undefined;
  readonly reached: boolean;
  readonly hands: HandsClear;
}

export function StationAlarm({ machine, station, job, reached, hands }: Props) {
  const refusal = useRefusal("POST /api/v1/machines/{name}/operations");
  const message = station.alarm ?? station.obstacle;
  if (message === null) return null;
  const hint = messageHint(message);
  const ways = waysOut(station, job);
  return (
    <section
      className={css.alarm}
      role="alert"
      data-testid={station.alarm === null ? "obstacle" : "alarm"}
    >
      <h2>
        <IconAlertTriangleFilled color="var(--bad)" aria-hidden />
        {headingOf(station, job)}
      </h2>
      <p>{messageText(message)}</p>
      {hint !== "" && <p className={css.todo}>{hint}</p>}
      {ways.length > 0 && <HandsClearButton hands={hands} reached={reached} />}
      <div className={css.answers}>
        {ways.map(({ operation, title, note }) => {
          const reason =
            refusal ??
            reasonAgainst(operation, station, machine, job) ??
            handsReason(operation, hands);
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
