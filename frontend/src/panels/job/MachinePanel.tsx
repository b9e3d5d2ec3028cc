/** The machine: connection, carriages if there are several, and the tool in each station. */

import { Anchor, Badge, Group, Text } from "@mantine/core";
import type { ReactNode } from "react";
import type { Machine } from "../../api/client";
import { formatNumber, withMinusSign } from "../../language/numbers";
import { translate } from "../../language/translate";
import { CANVAS } from "../../state/drawing/palette";
import { useMachines } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { PairedDevices } from "../accounts/PairedDevices";
import { Note, StationNumber } from "../shared/parts";
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
      <Note component="div" px={8} pb={6}>
        {translate("machinePanel.controllerLanguage", {
          title: machine.title || machine.name,
          language: machine.language,
        })}
        {" · "}
        <Anchor
          fz={12}
          href={`#/station/${encodeURIComponent(machine.name)}`}
          data-testid="open-station"
        >
          {translate("machinePanel.openStationPage")}
        </Anchor>{" "}
        ·{" "}
        <Anchor fz={12} href="#/library" data-testid="open-library">
          {translate("machinePanel.machinesAndBoards")}
        </Anchor>{" "}
        ·{" "}
        <Anchor fz={12} href="#/webhooks" data-testid="open-webhooks">
          {translate("machinePanel.webhooks")}
        </Anchor>
      </Note>
      <PairedDevices key={machine.name} machine={machine.name} />
      {machine.carriages.map((carriage) => (
        <div key={carriage.number}>
          {machine.carriages.length > 1 && (
            <Note component="div" px={8} py={3}>
              {carriageText(carriage)}
            </Note>
          )}
          {machine.stations
            .filter((station) => station.carriage === carriage.number)
            .map((station) => (
              <Item
                key={station.number}
                mark={<StationNumber>{station.number}</StationNumber>}
                name={station.name}
                text={dimensionText(station.tool)}
              />
            ))}
        </div>
      ))}
      {machine.zones.length > 0 && (
        <div data-testid="zones">
          <Note component="div" px={8} py={3}>
            {translate("machinePanel.keepOutZonesWhichNo")}
          </Note>
          {machine.zones.map((zone) => (
            <Item
              key={`${zone.name} ${zone.x} ${zone.y}`}
              mark={<span className={jobCss.zone} style={{ color: CANVAS.zone }} />}
              name={zone.name}
              text={zoneText(zone)}
            />
          ))}
        </div>
      )}
    </Section>
  );
}

function Gateway({ machine }: { machine: Machine }) {
  const connected = machine.gateway === "connected";
  return (
    <Badge component="span" color={connected ? "green" : "gray"}>
      {connected ? translate("machinePanel.connected") : translate("machinePanel.notConnected")}
    </Badge>
  );
}

interface ItemProps {
  readonly mark: ReactNode;
  readonly name: string;
  readonly text: string;
}

/** A station or a zone of the machine. */
function Item({ mark, name, text }: ItemProps) {
  return (
    <Group gap={8} px={8} py={6} wrap="nowrap" align="flex-start">
      {mark}
      <div>
        {name}
        <Text fz={11.5} c="ink.3">
          {text}
        </Text>
      </div>
    </Group>
  );
}
