/** Where the slider has the head: tool, position on the table, heading and lean. */

import type { Job } from "../../api/jobs";
import { poseAt, rowAt, type Timeline } from "../../geometry/timeline";
import { degree } from "../../geometry/units";
import { formatFixed, withMinusSign } from "../../language/numbers";
import { translate } from "../../language/translate";
import { isOnTable } from "../../state/job/jobs";
import { useMachines } from "../../state/queries";
import { useUiStore } from "../../state/store";
import css from "./check.module.css";

interface Props {
  readonly job: Job;
  readonly timeline: Timeline;
}

/** Nothing while the slider is not in use. */
export function HeadFigures({ job, timeline }: Props) {
  const previewTime = useUiStore((ui) => ui.previewTime);
  const { data: machines } = useMachines();
  const pose = previewTime === null ? null : poseAt(timeline, previewTime);
  if (pose === null || previewTime === null || isOnTable(job)) return null;
  const number = timeline.toolpath.tool[rowAt(timeline, previewTime)];
  const station = machines
    ?.find(({ name }) => name === job.machine)
    ?.stations.find((one) => one.number === number);
  const tilt = Number(station?.tool.dimensions.tilt ?? 0);
  const fixed = (value: number, digits: number) => withMinusSign(formatFixed(value, digits));
  // The axis may have made several turns.
  const turns = 360 * Math.ceil(degree(pose.c) / 360 - 0.5);
  const figures = [
    { name: "x", title: "X", value: fixed(pose.x, 2) },
    { name: "y", title: "Y", value: fixed(pose.y, 2) },
    { name: "z", title: "Z", value: fixed(pose.z, 2) },
    {
      name: "c",
      title: translate("headFigures.heading"),
      value: `${fixed(degree(pose.c) - turns, 1)}°`,
    },
    { name: "lean", title: translate("headFigures.lean"), value: `${fixed(tilt, 1)}°` },
  ];
  return (
    <dl className={css.head} data-testid="head-figures">
      <div className={css.headTool}>
        <dt>{`T${number}`}</dt>
        <dd>{station?.name ?? ""}</dd>
      </div>
      {figures.map(({ name, title, value }) => (
        <div key={name} data-figure={name}>
          <dt>{title}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}
