/** Legend of the marks and swept areas of the tool path. */

import { useMemo } from "react";
import { deepestZ } from "../geometry/depths";
import { halfContactLength, type Sweep, sweepOf } from "../geometry/sweep";
import { formatHundredths } from "../state/format";
import { MARKS, SWEPT } from "../state/palette";
import { useBoardCaliper, useJob, useMachines, useToolpath } from "../state/queries";
import { useUiStore } from "../state/store";
import overlayCss from "./overlay.module.css";
import css from "./panels.module.css";

const MARK_STYLES: readonly { mark: keyof typeof MARKS; title: string; size: number }[] = [
  { mark: "plunge", title: "tool enters board", size: 5 },
  { mark: "swivel", title: "tool turns on the spot", size: 7 },
  { mark: "lift", title: "tool leaves board", size: 10 },
];

export function PathLegend() {
  const layers = useUiStore((ui) => ui.layers);
  const { data: toolpath } = useToolpath();
  if (toolpath === undefined || !(layers.moves || layers.swept)) return null;
  return (
    <div className={`${overlayCss.float} ${overlayCss.legend}`} data-testid="path-legend">
      {layers.swept && <Tools />}
      {layers.moves &&
        MARK_STYLES.map(({ mark, title, size }) => (
          <span key={mark}>
            <span
              className={css.dot}
              style={{ width: size, height: size, background: MARKS[mark] }}
            />
            {title}
          </span>
        ))}
    </div>
  );
}

function Tools() {
  const { data: toolpath } = useToolpath();
  const { data: machines } = useMachines();
  const { data: job } = useJob();
  const depths = useMemo(
    () => (toolpath === undefined ? new Map<number, number>() : deepestZ(toolpath)),
    [toolpath],
  );
  const caliper = useBoardCaliper(job?.board);
  const stations = machines?.find(({ name }) => name === job?.machine)?.stations ?? [];
  const swept = stations.flatMap(({ number, name, tool }) => {
    const z = depths.get(number);
    const sweep = sweepOf(tool.footprint);
    return z === undefined || sweep === null ? [] : [{ number, name, sweep, depth: caliper - z }];
  });
  if (swept.length === 0)
    return <span>No cut widths to show: every tool of this program cuts on the line itself.</span>;
  return swept.map(({ number, name, sweep, depth }) => (
    <span key={number}>
      <span className={overlayCss.band} style={{ background: COLOURS[sweep.kind], opacity: 0.6 }} />
      <b>{name}</b>
      {sweepText(sweep, depth)}
    </span>
  ));
}

const COLOURS: Readonly<Record<Sweep["kind"], string>> = {
  disc: SWEPT.cutter,
  groove: SWEPT.groove,
  wheel: SWEPT.crease,
};

function sweepText(sweep: Sweep, depth: number): string {
  if (sweep.kind === "disc") return `removes a strip ${formatHundredths(2 * sweep.radius)} wide`;
  if (sweep.kind === "groove") {
    return `cuts a groove ${formatHundredths(2 * depth * sweep.slope)} wide at the top face, ${formatHundredths(depth)} deep`;
  }
  return `presses on ${formatHundredths(2 * halfContactLength(sweep.radius, depth))} of the crease at a time, ${formatHundredths(depth)} deep`;
}
