/** The feed of the program that runs: slower, as programmed, faster. */

import type { Job, Machine, Station } from "../api/client";
import { operate } from "../state/operations";
import { overrideSteps } from "../state/station";
import css from "./station.module.css";

interface Props {
  readonly machine: Machine;
  readonly station: Station | undefined;
  readonly job: Job;
  readonly reached: boolean;
}

export function FeedOverride({ machine, station, job, reached }: Props) {
  const steps = overrideSteps(machine, station, job);
  if (steps === null) return null;
  return (
    <fieldset className={css.feedOverride} data-testid="feed-override">
      <legend>
        Feed <b data-testid="feed-override-value">{station?.override} %</b> of the program
      </legend>
      {steps.map(({ name, label, percent, enabled }) => (
        <button
          key={name}
          type="button"
          className={css.output}
          disabled={!reached || !enabled}
          onClick={() =>
            void operate(machine.name, `Feed ${percent} %`, {
              operation: "feed_override",
              percent,
            })
          }
          data-testid={`feed-${name}`}
        >
          {label}
        </button>
      ))}
    </fieldset>
  );
}
