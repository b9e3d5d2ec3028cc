/** The table of a machine as it is now: the head, and what is made and left of the running job. */

import { useQuery } from "@tanstack/react-query";
import { useMemo } from "react";
import type { Job } from "../../api/jobs";
import type { Machine } from "../../api/machines";
import type { Point } from "../../geometry/records";
import type { Similarity } from "../../geometry/similarity";
import { buildTimeline, poseAt, rowAt, timeOf } from "../../geometry/timeline";
import { splitWork, workPath } from "../../geometry/workPath";
import { translate } from "../../language/translate";
import { hasProgram, isOnTable } from "../../state/job/jobs";
import { queries, useQueue, useStation } from "../../state/queries";
import css from "./table.module.css";

interface Props {
  readonly machine: Machine;
  readonly title: string;
}

export function TablePicture({ machine, title }: Props) {
  const { width, height, zones } = machine;
  const { data: queue } = useQueue(machine.name);
  const job = queue?.entries.find(({ place }) => place === 0)?.job;
  return (
    <svg
      className={css.table}
      preserveAspectRatio="xMinYMid"
      data-idle={job === undefined}
      viewBox={`0 ${-height} ${width} ${height}`}
      role="img"
      aria-label={translate("tablePicture.table", { title })}
      data-testid="table-picture"
    >
      <g transform="scale(1 -1)">
        <rect className={css.ground} width={width} height={height} />
        {zones.map(({ x, y, width, height }) => (
          <rect key={`${x} ${y}`} className={css.zone} x={x} y={y} width={width} height={height} />
        ))}
        {job === undefined ? (
          machine.gateway === "connected" && <IdleHead machine={machine} />
        ) : (
          <JobOnTable listed={job} machine={machine} />
        )}
      </g>
    </svg>
  );
}

/** The head where the machine reports it while no job is on the table. */
function IdleHead({ machine }: { machine: Machine }) {
  const { data: station } = useStation(machine.name);
  const position = station?.position ?? null;
  return position === null ? null : (
    <Head at={{ x: position[0], y: position[1] }} machine={machine} />
  );
}

interface JobProps {
  /** The job as the queue has it; events change the cached job more often. */
  readonly listed: Job;
  readonly machine: Machine;
}

function JobOnTable({ listed, machine }: JobProps) {
  const { data: job = listed } = useQuery({ ...queries.job(listed.id), initialData: listed });
  const { data: timeline } = useQuery({
    ...queries.toolpath(job.id),
    enabled: hasProgram(job),
    select: buildTimeline,
  });
  const work = useMemo(
    () => (timeline === undefined ? null : workPath(timeline.toolpath)),
    [timeline],
  );
  // An interrupted job is shown where it stopped.
  const reached = isOnTable(job) ? job : job.stopped_at;
  const seconds =
    timeline === undefined || reached === null
      ? null
      : timeOf(timeline, reached.line, reached.position);
  const row = timeline === undefined || seconds === null ? 0 : rowAt(timeline, seconds);
  const [done, left] = useMemo(
    () => (work === null ? ["", ""] : splitWork(work, row)),
    [work, row],
  );
  const pose = timeline === undefined || seconds === null ? null : poseAt(timeline, seconds);
  // The path of a measured sheet is that on the drawing.
  return (
    <g transform={matrixOf(timeline?.toolpath.similarity)}>
      <path className={css.left} d={left} data-testid="work-left" />
      <path className={css.done} d={done} data-testid="work-done" />
      {pose !== null && <Head at={pose} machine={machine} />}
    </g>
  );
}

const matrixOf = (lies: Similarity | null | undefined): string | undefined =>
  lies == null
    ? undefined
    : `matrix(${[lies[0], lies[1], -lies[1], lies[0], lies[2], lies[3]].join(" ")})`;

function Head({ at, machine }: { at: Point; machine: Machine }) {
  const radius = Math.max(machine.width, machine.height) / 70;
  return (
    <g
      className={css.head}
      style={{ transform: `translate(${at.x}px, ${at.y}px)` }}
      data-testid="table-head"
      data-x={at.x.toFixed(2)}
      data-y={at.y.toFixed(2)}
    >
      <circle r={radius} />
      <path d={`M${-2 * radius} 0H${2 * radius}M0 ${-2 * radius}V${2 * radius}`} />
    </g>
  );
}
