/** Runs above the board before a job starts: its whole path, or only round the sheet. */

import { useState } from "react";
import type { Activity, Job, Machine, OperationRequest, Station } from "../../api/client";
import { insideSentence } from "../../language/numbers";
import { translate } from "../../language/translate";
import { translateRich } from "../../language/translateRich";
import { messageHint, messageText } from "../../messages/translateMessage";
import { formatDuration } from "../../state/format";
import { type HandsClear, handsReason } from "../../state/station/handsClear";
import { operate } from "../../state/station/operations";
import { RUN_TITLES, reasonAgainst, runAboveBoard } from "../../state/station/station";
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
    note: translate("dryRunPanel.movesAlongTheWholeProgram"),
    request: (share) => ({ operation: "dry_run", share }),
  },
  {
    kind: "frame",
    note: translate("dryRunPanel.movesOnceRoundTheSheet"),
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
    <section
      className={css.dryRun}
      aria-label={translate("dryRunPanel.beforeTheStart")}
      data-testid="dry-run"
    >
      <h3>{translate("dryRunPanel.tryItAboveTheBoard")}</h3>
      <LastRun activity={station?.activity ?? null} job={job} />
      {common !== null && <p className={css.small}>{common}</p>}
      <fieldset className={css.steps}>
        <legend>{translate("dryRunPanel.speedOfTheDryRun")}</legend>
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
                  translate("dryRunPanel.begin", { kind: insideSentence(RUN_TITLES[kind]) }),
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
    <section
      aria-label={translate("dryRunPanel.progress", { kind: RUN_TITLES[run.kind] })}
      data-testid="dry-run-progress"
    >
      <div className={css.figures}>
        <div>
          <b>{Math.round(run.progress * 100)}</b> %
        </div>
        {run.seconds_left !== null && (
          <div>
            {translateRich("dryRunPanel.left", {
              secondsLeft: formatDuration(run.seconds_left),
              b: (children) => <b>{children}</b>,
            })}
          </div>
        )}
      </div>
      <progress
        className={css.bar}
        value={run.progress}
        max={1}
        aria-label={translate("dryRunPanel.progressOfTheRunAbove")}
      />
      <p className={css.small}>
        {shown !== undefined
          ? translate("dryRunPanel.pathOfStationAboveThe", {
              number: shown.number,
              name: shown.name,
            })
          : translate("dryRunPanel.aboveTheBoardNothingIs")}
      </p>
    </section>
  );
}

const ENDS = {
  done: { text: "dryRunPanel.done", tone: "green" },
  stopped: { text: "dryRunPanel.stopped", tone: "amber" },
  failed: { text: "dryRunPanel.failed", tone: "red" },
} as const;

const endOf = (state: Activity["state"]) =>
  state === "done" || state === "stopped" || state === "failed" ? ENDS[state] : undefined;

/** How the last run for this job has ended. */
function LastRun({ activity, job }: { activity: Activity | null; job: Job }) {
  const end = activity === null ? undefined : endOf(activity.state);
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
      {translate(end.text, { run: RUN_TITLES[activity.kind] })}
      {message !== null && <div>{messageText(message)}</div>}
      {message !== null && <div className={css.todo}>{messageHint(message)}</div>}
    </div>
  );
}
