/** Legend of the marks and swept areas of the tool path. */

import { useMemo } from "react";
import { deepestZ } from "../../geometry/depths";
import { halfContactLength, type Sweep, sweepOf } from "../../geometry/sweep";
import { translate } from "../../language/translate";
import { MARKS, SWEPT } from "../../state/drawing/palette";
import { formatHundredths } from "../../state/format";
import { useBoardCaliper, useJob, useMachines, useToolpath } from "../../state/queries";
import { useUiStore } from "../../state/store";
import css from "../shared/panels.module.css";
import overlayCss from "./overlay.module.css";

const MARK_STYLES: readonly { mark: keyof typeof MARKS; title: string; size: number }[] = [
  { mark: "plunge", title: translate("pathLegend.toolEntersBoard"), size: 5 },
  { mark: "swivel", title: translate("pathLegend.toolTurnsOnTheSpot"), size: 7 },
  { mark: "lift", title: translate("pathLegend.toolLeavesBoard"), size: 10 },
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
  if (swept.length === 0) return <span>{translate("pathLegend.noCutWidthsToShow")}</span>;
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
  if (sweep.kind === "disc")
    return translate("pathLegend.removesAStripWide", {
      radius: formatHundredths(2 * sweep.radius),
    });
  if (sweep.kind === "groove") {
    return translate("pathLegend.cutsAGrooveWideAt", {
      depth: formatHundredths(2 * depth * sweep.slope),
      depth2: formatHundredths(depth),
    });
  }
  return translate("pathLegend.pressesOnOfTheCrease", {
    radius: formatHundredths(2 * halfContactLength(sweep.radius, depth)),
    depth: formatHundredths(depth),
  });
}
