/** The tool in each station of a machine, by carriage, and zones that no tool may enter. */

import { Group, Text } from "@mantine/core";
import type { ReactNode } from "react";
import type { Machine } from "../../api/machines";
import { formatNumber, withMinusSign } from "../../language/numbers";
import { translate } from "../../language/translate";
import { ZONE } from "../../state/drawing/palette";
import { Note, StationNumber } from "../shared/parts";
import { dimensionText } from "../station/toolText";
import jobCss from "./job.module.css";

/** A number with a minus sign that is as wide as a plus sign. */
const signed = (value: number): string => withMinusSign(formatNumber(value));

const carriageText = ({ number, letters, park }: Machine["carriages"][number]): string =>
  `${translate("machinePanel.carriageAxes", { number, axes: [...letters].join(", ") })} · ${translate("machinePanel.parksAtMm", { axis: letters[1] ?? "", park: signed(park) })}`;

const zoneText = ({ x, y, width, height, top }: Machine["zones"][number]): string =>
  `${translate("machinePanel.xTo", { x: signed(x), x2: signed(x + width) })} · ${translate("machinePanel.yTo", { y: signed(y), y2: signed(y + height) })} · ${translate("machinePanel.mmHigh", { top })}`;

export function MachineTools({ machine }: { machine: Machine }) {
  return (
    <>
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
              mark={<span className={jobCss.zone} style={{ color: ZONE }} />}
              name={zone.name}
              text={zoneText(zone)}
            />
          ))}
        </div>
      )}
    </>
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
