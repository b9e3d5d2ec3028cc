/** Head of the station page: the machine, its state in large type, and the connections. */

import { Anchor, Flex, Group, Text, Title } from "@mantine/core";
import { IconPlugConnected, IconPlugConnectedX } from "@tabler/icons-react";
import type { Job } from "../../api/jobs";
import type { Machine, Station } from "../../api/machines";
import { formatFixed, withMinusSign } from "../../language/numbers";
import { translate } from "../../language/translate";
import { useMe } from "../../state/accounts/accounts";
import { AXES, ageText, titleOf, turnsTools } from "../../state/station/station";
import { OperatorButton } from "../accounts/OperatorForm";
import { LanguageMenu } from "../shared/LanguageMenu";
import css from "./station.module.css";

interface Props {
  readonly machine: Machine;
  readonly station: Station | undefined;
  readonly job: Job | undefined;
  readonly reached: boolean;
}

export function StationHeader({ machine, station, job, reached }: Props) {
  const { title, tone } = reached
    ? titleOf(station, job)
    : { title: translate("stationHeader.noConnection"), tone: "red" as const };
  const paired = useMe()?.kind === "device";
  const connected = reached && station?.connected === true;
  return (
    <header className={css.header}>
      <div className={css.names}>
        <Title order={1} c="ink.2" fz={17} fw={550} lineClamp={1}>
          {machine.title || machine.name}
        </Title>
        <div className={css.state} data-tone={tone} role="status" data-testid="station-state">
          {title}
        </div>
        {reached && ageText(station) !== "" && (
          <Text component="small" c="var(--warn-ink)" data-testid="station-age">
            {translate("stationHeader.reported", { station: ageText(station) })}
          </Text>
        )}
      </div>
      <Position machine={machine} station={reached ? station : undefined} />
      <div className={css.links} data-tone={connected ? "green" : "red"}>
        <Flex align="center" gap={8} fw={600} data-testid="station-connection">
          {connected ? <IconPlugConnected aria-hidden /> : <IconPlugConnectedX aria-hidden />}
          {!reached
            ? translate("stationHeader.noServer")
            : connected
              ? translate("stationHeader.connected")
              : translate("stationHeader.noController")}
        </Flex>
        <Group gap={8}>
          <OperatorButton />
          <LanguageMenu />
          {/* Elsewhere the rail leads there. */}
          {paired && <Anchor href="#/">{translate("stationHeader.allDrawings")}</Anchor>}
        </Group>
      </div>
    </header>
  );
}

interface PositionProps {
  readonly machine: Machine;
  readonly station: Station | undefined;
}

/** Position of the axes in the coordinates of programs; C only if an axis turns the tools. */
function Position({ machine, station }: PositionProps) {
  const position = station?.position ?? null;
  const axes = AXES.filter((axis) => axis !== "C" || turnsTools(machine));
  return (
    <dl
      className={css.position}
      aria-label={translate("stationHeader.positionOfTheAxes")}
      data-testid="station-position"
    >
      {axes.map((axis, at) => (
        <div key={axis}>
          <Text component="dt" fz={15} c="ink.2">
            {axis}
          </Text>
          <dd>
            {position === null ? "–" : withMinusSign(formatFixed(position[at] ?? 0, 1))}
            {axis === "C" && position !== null ? "°" : ""}
          </dd>
        </div>
      ))}
    </dl>
  );
}
