/** The feed of the program that runs: slower, as programmed, faster. */

import { SimpleGrid } from "@mantine/core";
import type { Job } from "../../api/jobs";
import type { Machine, Station } from "../../api/machines";
import { translate } from "../../language/translate";
import { translateRich } from "../../language/translateRich";
import { operate } from "../../state/station/operations";
import { overrideSteps } from "../../state/station/station";
import { ControlGroup, WideButton } from "./parts";

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
    <ControlGroup
      data-testid="feed-override"
      legend={translateRich("feedOverride.feedOfTheProgram", {
        percent: station?.override ?? "",
        b: (children) => <b data-testid="feed-override-value">{children}</b>,
      })}
    >
      <SimpleGrid cols={3} spacing={8}>
        {steps.map(({ name, label, percent, enabled }) => (
          <WideButton
            key={name}
            disabled={!reached || !enabled}
            onClick={() =>
              void operate(machine.name, translate("feedOverride.feed2", { percent }), {
                operation: "feed_override",
                percent,
              })
            }
            data-testid={`feed-${name}`}
          >
            {label}
          </WideButton>
        ))}
      </SimpleGrid>
    </ControlGroup>
  );
}
