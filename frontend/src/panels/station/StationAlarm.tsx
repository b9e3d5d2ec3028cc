/** What keeps the machine from work: its alarm or its hold, what to do, and the ways out. */

import { Flex, SimpleGrid, Text, Title } from "@mantine/core";
import { IconAlertTriangleFilled } from "@tabler/icons-react";
import type { Job } from "../../api/jobs";
import type { Machine, Station } from "../../api/machines";
import { messageHint, messageText } from "../../messages/translateMessage";
import { useRefusal } from "../../state/accounts/accounts";
import { type HandsClear, handsReason } from "../../state/station/handsClear";
import { operate } from "../../state/station/operations";
import { reasonAgainst } from "../../state/station/station";
import { headingOf, waysOut } from "../../state/station/wayOut";
import panels from "../shared/panels.module.css";
import { HandsClearButton } from "./HandsClearButton";
import { NotedButton, WideButton } from "./parts";

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
    <Flex
      component="section"
      direction="column"
      gap={8}
      className={panels.callout}
      data-tone="red"
      role="alert"
      data-testid={station.alarm === null ? "obstacle" : "alarm"}
    >
      <Title order={2} fz={22}>
        <Flex align="center" gap={8}>
          <IconAlertTriangleFilled color="var(--bad)" aria-hidden />
          {headingOf(station, job)}
        </Flex>
      </Title>
      <p>{messageText(message)}</p>
      {hint !== "" && (
        <Text c="ink.0" fw={600}>
          {hint}
        </Text>
      )}
      {ways.length > 0 && <HandsClearButton hands={hands} reached={reached} />}
      <SimpleGrid cols={2} spacing={12}>
        {ways.map(({ operation, title, note }) => {
          const reason =
            refusal ??
            reasonAgainst(operation, station, machine, job) ??
            handsReason(operation, hands);
          return (
            <NotedButton key={operation} note={reason ?? note}>
              <WideButton
                disabled={!reached || reason !== null}
                onClick={() => void operate(machine.name, title, { operation })}
                data-testid={`alarm-${operation}`}
              >
                {title}
              </WideButton>
            </NotedButton>
          );
        })}
      </SimpleGrid>
    </Flex>
  );
}
