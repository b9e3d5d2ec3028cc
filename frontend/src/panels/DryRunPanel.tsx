/** Runs above the board before a job starts: its whole path, or only round the sheet. */

import { useState } from "react";
import type { Activity, Job, Machine, OperationRequest, Station } from "../api/client";
import { renderHint, renderText } from "../messages/render";
import { formatDuration } from "../state/format";
import { type HandsClear, handsReason } from "../state/handsClear";
import { operate } from "../state/operations";
import { RUN_TITLES, reasonAgainst, runAboveBoard } from "../state/station";
import css from "./station.module.css";

interface Props {
  readonly job: Job;
  readonly machine: Machine;
  readonly station: Station | undefined;
  readonly reached: boolean;
  readonly hands: HandsClear;
}

/** Shares of the feeds of the program, in percent. */
const SHARES = [10, 25, 50, 100] as const;

interface Way {
  readonly kind: "dry_run" | "frame";
  readonly note: string;
  request(share: number): OperationRequest;
}

const WAYS: readonly Way[] = [
  {
    kind: "dry_run",
    note: "Moves along the whole program above the board. Nothing is lowered or switched on.",
    request: (share) => ({ operation: "dry_run", share }),
  },
  {
    kind: "frame",
    note: "Moves once round the sheet, or round the work, above the board.",
    request: () => ({ operation: "frame" }),
  },
];

export function DryRunPanel({ job, machine, station, reached, hands }: Props) {
  const [percent, setPercent] = useState<number>(25);
  const run = runAboveBoard(station);
  if (run !== null) return <RunAboveBoard run={run} machine={machine} />;
  const reasons = WAYS.map(
    ({ kind }) => reasonAgainst(kind, station, machine, job) ?? handsReason(kind, hands),
  );
  const [first] = reasons;
  const common = reasons.every((one) => one === first) ? (first ?? null) : null;
  return (
    <section className={css.dryRun} aria-label="Before the start" data-testid="dry-run">
      <h3>Try it above the board first</h3>
      <LastRun activity={station?.activity ?? null} job={job} />
      {common !== null && <p className={css.small}>{common}</p>}
      <fieldset className={css.steps}>
        <legend>Speed of the dry run</legend>
        {SHARES.map((one) => (
          <label key={one} className={css.step}>
            <input
              type="radio"
              name="share"
              checked={percent === one}
              onChange={() => setPercent(one)}
            />
            <span className={css.stepText} data-testid={`share-${one}`}>
              {one} %
            </span>
          </label>
        ))}
      </fieldset>
      <div className={css.wayGrid}>
        {WAYS.map(({ kind, note, request }, at) => (
          <div key={kind} className={css.way}>
            <button
              type="button"
              className={css.button}
              disabled={!reached || reasons[at] !== null}
              onClick={() =>
                void operate(
                  machine.name,
                  `Begin ${RUN_TITLES[kind].toLowerCase()}`,
                  request(percent / 100),
                )
              }
              data-testid={`operation-${kind}`}
            >
              {RUN_TITLES[kind]}
            </button>
            <small>{note}</small>
          </div>
        ))}
      </div>
    </section>
  );
}

function RunAboveBoard({ run, machine }: { run: Activity; machine: Machine }) {
  const shown = machine.stations.find(({ number }) => number === run.station);
  return (
    <section aria-label={`Progress: ${RUN_TITLES[run.kind]}`} data-testid="dry-run-progress">
      <div className={css.figures}>
        <div>
          <b>{Math.round(run.progress * 100)}</b> %
        </div>
        {run.seconds_left !== null && (
          <div>
            <b>{formatDuration(run.seconds_left)}</b> left
          </div>
        )}
      </div>
      <progress
        className={css.bar}
        value={run.progress}
        max={1}
        aria-label="Progress of the run above the board"
      />
      <p className={css.small}>
        {shown !== undefined && `Path of station ${shown.number}, ${shown.name}. `}
        Above the board, nothing is cut. The job keeps waiting for its start.
      </p>
    </section>
  );
}

const ENDS: Readonly<Partial<Record<Activity["state"], { text: string; tone: string }>>> = {
  done: { text: "has ended. If the path was right, check and start the job.", tone: "green" },
  stopped: { text: "was stopped. The tool is lifted.", tone: "amber" },
  failed: { text: "has failed.", tone: "red" },
};

/** How the last run for this job has ended. */
function LastRun({ activity, job }: { activity: Activity | null; job: Job }) {
  const end = activity === null ? undefined : ENDS[activity.state];
  if (activity === null || end === undefined || activity.job !== job.id) return null;
  if (activity.kind === "tool_check") return null;
  const { message } = activity;
  return (
    <div
      className={css.message}
      data-tone={end.tone}
      role="status"
      data-testid="dry-run-end"
      data-state={activity.state}
    >
      {RUN_TITLES[activity.kind]} {end.text}
      {message !== null && <div>{renderText(message)}</div>}
      {message !== null && <div className={css.todo}>{renderHint(message)}</div>}
    </div>
  );
}
