/** The machine: whether its table is there, and which tool stands in which station. */

import type { Machine } from "../api/client";
import { useMachines } from "../state/queries";
import { usePage } from "../state/store";
import jobCss from "./job.module.css";
import css from "./panels.module.css";
import { Section } from "./Section";

const WORDS: Readonly<Record<string, string>> = {
  back: "back",
  blade_angle: "blade angle",
  blade_width: "blade",
  half_width: "half width",
  radius: "radius",
  tilt: "tilt",
  trail: "trail",
  width: "width",
};
const ANGLES = new Set(["tilt", "blade_angle"]);

const inWords = ({ dimensions }: Machine["stations"][number]["tool"]): string =>
  Object.entries(dimensions)
    .filter(([name, value]) => name in WORDS && typeof value === "number" && value !== 0)
    .map(([name, value]) => `${WORDS[name]} ${value}${ANGLES.has(name) ? "°" : "\u202fmm"}`)
    .join(" · ");

export function MachinePanel() {
  const { data: machines } = useMachines();
  const chosen = usePage((page) => page.machine);
  const machine = machines?.find(({ name }) => name === chosen) ?? machines?.[0];
  if (machine === undefined) return null;
  return (
    <Section title="Machine" flush aside={<Gateway machine={machine} />}>
      <div style={{ padding: "0 8px 6px" }} className={css.note}>
        {machine.title || machine.name} · speaks {machine.dialect}
      </div>
      {machine.stations.map((station) => (
        <div key={station.number} className={jobCss.station}>
          <span className={jobCss.stationNumber}>{station.number}</span>
          <span>{station.name}</span>
          <span className={jobCss.stationTool}>{inWords(station.tool)}</span>
        </div>
      ))}
    </Section>
  );
}

function Gateway({ machine }: { machine: Machine }) {
  const there = machine.gateway === "connected";
  return (
    <span className={css.badge} data-tone={there ? "green" : "grey"}>
      {there ? "Connected" : "Absent"}
    </span>
  );
}
