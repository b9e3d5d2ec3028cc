/** Head of the station page: the machine, its state in large type, and the connections. */

import { IconPlugConnected, IconPlugConnectedX } from "@tabler/icons-react";
import type { Job, Machine, Station } from "../api/client";
import { AXES, ageText, titleOf, turnsTools } from "../state/station";
import { OperatorButton } from "./OperatorForm";
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
    : { title: "No connection", tone: "red" as const };
  const connected = reached && station?.connected === true;
  return (
    <header className={css.header}>
      <div className={css.names}>
        <h1 className={css.machine}>{machine.title || machine.name}</h1>
        <div className={css.state} data-tone={tone} role="status" data-testid="station-state">
          {title}
        </div>
        {reached && ageText(station) !== "" && (
          <small className={css.age} data-testid="station-age">
            Reported {ageText(station)}
          </small>
        )}
      </div>
      <Position machine={machine} station={reached ? station : undefined} />
      <div className={css.links}>
        <span
          className={css.chip}
          data-tone={connected ? "green" : "red"}
          data-testid="station-connection"
        >
          {connected ? <IconPlugConnected aria-hidden /> : <IconPlugConnectedX aria-hidden />}
          {!reached ? "No server" : connected ? "Connected" : "No controller"}
        </span>
        <div className={css.operatorAndWay}>
          <OperatorButton />
          <a className={css.leave} href="#/">
            All drawings
          </a>
        </div>
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
    <dl className={css.position} aria-label="Position of the axes" data-testid="station-position">
      {axes.map((axis, at) => (
        <div key={axis}>
          <dt>{axis}</dt>
          <dd>
            {position === null ? "–" : (position[at] ?? 0).toFixed(1).replace("-", "\u2212")}
            {axis === "C" && position !== null ? "°" : ""}
          </dd>
        </div>
      ))}
    </dl>
  );
}
