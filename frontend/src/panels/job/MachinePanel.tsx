/** The machine: connection, carriages if there are several, and the tool in each station. */

import type { Machine } from "../../api/client";
import { formatNumber, withMinusSign } from "../../language/numbers";
import { translate } from "../../language/translate";
import { CANVAS } from "../../state/drawing/palette";
import { useMachines } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { PairedDevices } from "../accounts/PairedDevices";
import css from "../shared/panels.module.css";
import { Section } from "../shared/Section";
import { dimensionText } from "../station/toolText";
import jobCss from "./job.module.css";

/** A number with a minus sign that is as wide as a plus sign. */
const signed = (value: number): string => withMinusSign(formatNumber(value));

const carriageText = ({ number, letters, park }: Machine["carriages"][number]): string =>
  `${translate("machinePanel.carriageAxes", { number, axes: [...letters].join(", ") })} · ${translate("machinePanel.parksAtMm", { axis: letters[1] ?? "", park: signed(park) })}`;

const zoneText = ({ x, y, width, height, top }: Machine["zones"][number]): string =>
  `${translate("machinePanel.xTo", { x: signed(x), x2: signed(x + width) })} · ${translate("machinePanel.yTo", { y: signed(y), y2: signed(y + height) })} · ${translate("machinePanel.mmHigh", { top })}`;

export function MachinePanel() {
  const { data: machines } = useMachines();
  const chosen = useUiStore((ui) => ui.machine);
  const machine = machines?.find(({ name }) => name === chosen) ?? machines?.[0];
  if (machine === undefined) return null;
  return (
    <Section
      title={translate("machinePanel.machineAndTools")}
      flush
      aside={<Gateway machine={machine} />}
    >
      <div style={{ padding: "0 8px 6px" }} className={css.note}>
        {translate("machinePanel.controllerLanguage", {
          title: machine.title || machine.name,
          language: machine.language,
        })}
        {" · "}
        <a
          className={css.link}
          href={`#/station/${encodeURIComponent(machine.name)}`}
          data-testid="open-station"
        >
          {translate("machinePanel.openStationPage")}
        </a>{" "}
        ·{" "}
        <a className={css.link} href="#/library" data-testid="open-library">
          {translate("machinePanel.machinesAndBoards")}
        </a>{" "}
        ·{" "}
        <a className={css.link} href="#/webhooks" data-testid="open-webhooks">
          {translate("machinePanel.webhooks")}
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
            {translate("machinePanel.keepOutZonesWhichNo")}
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
      {connected ? translate("machinePanel.connected") : translate("machinePanel.notConnected")}
    </span>
  );
}
