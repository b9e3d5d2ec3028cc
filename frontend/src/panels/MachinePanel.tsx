/** The machine: connection, carriages if there are several, and the tool in each station. */

import type { Machine } from "../api/client";
import { CANVAS } from "../state/palette";
import { useMachines } from "../state/queries";
import { useUiStore } from "../state/store";
import jobCss from "./job.module.css";
import { PairedDevices } from "./PairedDevices";
import css from "./panels.module.css";
import { Section } from "./Section";
import { dimensionText } from "./toolText";

/** A number with a minus sign that is as wide as a plus sign. */
const signed = (value: number): string => value.toLocaleString("en").replace("-", "\u2212");

const carriageText = ({ number, letters, park }: Machine["carriages"][number]): string =>
  `Carriage ${number}: axes ${[...letters].join(", ")} · parks at ${letters[1]} ${signed(park)}\u202fmm`;

const zoneText = ({ x, y, width, height, top }: Machine["zones"][number]): string =>
  `X ${signed(x)} to ${signed(x + width)} · Y ${signed(y)} to ${signed(y + height)} · ${top}\u202fmm high`;

export function MachinePanel() {
  const { data: machines } = useMachines();
  const chosen = useUiStore((ui) => ui.machine);
  const machine = machines?.find(({ name }) => name === chosen) ?? machines?.[0];
  if (machine === undefined) return null;
  return (
    <Section title="Machine and tools" flush aside={<Gateway machine={machine} />}>
      <div style={{ padding: "0 8px 6px" }} className={css.note}>
        {machine.title || machine.name}, controller language {machine.language} ·{" "}
        <a
          className={css.link}
          href={`#/station/${encodeURIComponent(machine.name)}`}
          data-testid="open-station"
        >
          Open station page
        </a>{" "}
        ·{" "}
        <a className={css.link} href="#/library" data-testid="open-library">
          Machines and boards
        </a>{" "}
        ·{" "}
        <a className={css.link} href="#/webhooks" data-testid="open-webhooks">
          Webhooks
        </a>
      </div>
      <PairedDevices key={machine.name} machine={machine.name} />
      {machine.carriages.map((carriage) => (
        <div key={carriage.number}>
          {machine.carriages.length > 1 && (
            <div style={{ padding: "4px 8px 2px" }} className={css.note}>
              {carriageText(carriage)}
            </div>
          )}
          {machine.stations
            .filter((station) => station.carriage === carriage.number)
            .map((station) => (
              <div key={station.number} className={jobCss.station}>
                <span className={jobCss.stationNumber}>{station.number}</span>
                <span>{station.name}</span>
                <span className={jobCss.stationTool}>{dimensionText(station.tool)}</span>
              </div>
            ))}
        </div>
      ))}
      {machine.zones.length > 0 && (
        <div data-testid="zones">
          <div style={{ padding: "4px 8px 2px" }} className={css.note}>
            Keep-out zones, which no tool may touch
          </div>
          {machine.zones.map((zone) => (
            <div key={`${zone.name} ${zone.x} ${zone.y}`} className={jobCss.station}>
              <span className={jobCss.zone} style={{ color: CANVAS.zone }} />
              <span>{zone.name}</span>
              <span className={jobCss.stationTool}>{zoneText(zone)}</span>
            </div>
          ))}
        </div>
      )}
    </Section>
  );
}

function Gateway({ machine }: { machine: Machine }) {
  const connected = machine.gateway === "connected";
  return (
    <span className={css.badge} data-tone={connected ? "green" : "grey"}>
      {connected ? "Connected" : "Not connected"}
    </span>
  );
}
