/** The job of the machine: what to check before it starts, its progress, and how it ended. */

import { useState } from "react";
import type { Job, JobCommand, Machine, Station } from "../api/client";
import { renderHint, renderText } from "../messages/render";
import type { Check } from "../state/checks";
import { formatDuration, pluralize } from "../state/format";
import type { HandsClear } from "../state/handsClear";
import { type Confirmation, confirmationBefore, isOnTable, needsOperator } from "../state/jobs";
import { commandJob } from "../state/operations";
import { useBoardTitle, useTracks } from "../state/queries";
import { canContinue, tracksLeft } from "../state/rest";
import { recompileNote } from "../state/toolCheck";
import type { WornToolsState } from "../state/wornTools";
import { AskOnce } from "./AskOnce";
import { DryRunPanel } from "./DryRunPanel";
import { FeedOverride } from "./FeedOverride";
import { HandsClearButton } from "./HandsClearButton";
import { OrderCard } from "./OrderDetails";
import { RemainingCopies } from "./RemainingCopies";
import { RestPanel } from "./RestPanel";
import { StateBadge } from "./StateBadge";
import { StationChecks } from "./StationChecks";
import css from "./station.module.css";
import { ToolCheckPanel } from "./ToolCheckPanel";
import { WornTools } from "./WornTools";

interface Props {
  readonly job: Job;
  readonly machine: Machine;
  readonly station: Station | undefined;
  /** null: not known yet. */
  readonly checks: readonly Check[] | null;
  readonly ticked: ReadonlySet<string>;
  readonly wornTools: WornToolsState;
  readonly reached: boolean;
  readonly hands: HandsClear;
  onTick(keys: readonly string[]): void;
}

export function StationJob(props: Props) {
  const { job, machine, station, checks, ticked, wornTools, reached, hands, onTick } = props;
  const board = useBoardTitle(job.board);
  return (
    <section className={css.job} aria-label="Job" data-testid="station-job" data-state={job.state}>
      <div className={css.jobHead}>
        <h2>{job.drawing_name}</h2>
        <StateBadge job={job} testId="station-job-state" />
      </div>
      {/* Large: on another board than its own, a job cuts at wrong depths. */}
      <p className={css.boardName} data-testid="station-board">
        {board}
      </p>
      <p className={css.jobFacts}>
        {pluralize(job.copies, "copy", "copies")}
        {job.seconds > 0 && ` · ${formatDuration(job.seconds)} each`}
      </p>
      <OrderCard job={job} />
      {isOnTable(job) && <Run job={job} />}
      <FeedOverride machine={machine} station={station} job={job} reached={reached} />
      {job.actions.includes("resume") && <HandsClearButton hands={hands} reached={reached} />}
      <Reason job={job} />
      {needsOperator(job) && checks !== null && (
        <>
          <WornTools tools={wornTools} />
          <StationChecks
            machine={machine}
            checks={checks}
            ticked={ticked}
            hands={hands}
            onTick={onTick}
          />
        </>
      )}
      {job.waiting_for === "confirmation" && job.state === "queued" && (
        <>
          <DryRunPanel
            job={job}
            machine={machine}
            station={station}
            reached={reached}
            hands={hands}
          />
          {checks !== null && <ToolCheckPanel {...props} checks={checks} />}
        </>
      )}
      {job.actions.includes("recheck") && (
        <div className={css.way}>
          <button
            type="button"
            className={css.button}
            disabled={!reached}
            onClick={() => void commandJob(job.id, "Try again", "recheck")}
            data-testid="station-recheck"
          >
            Try again
          </button>
          <small>The machine checks the program again. Nothing moves before you start it.</small>
        </div>
      )}
      {job.waiting_for === "compile" && (
        <div className={css.way}>
          <button
            type="button"
            className={css.button}
            disabled={!reached || !job.actions.includes("recompile")}
            onClick={() => void commandJob(job.id, "Compile again", "recompile")}
            data-testid="station-recompile"
          >
            Compile the job again
          </button>
          <small>{recompileNote(machine)}</small>
        </div>
      )}
      {(job.state === "interrupted" || job.state === "cancelled") && (
        <AfterInterruption job={job} reached={reached} />
      )}
      {job.state === "done" && <RemainingCopies job={job} />}
    </section>
  );
}

function Run({ job }: { job: Job }) {
  const percent = Math.round(job.progress * 100);
  return (
    <div data-testid="station-run">
      <div className={css.figures}>
        <div>
          <b>{percent}</b> %
        </div>
        {job.seconds_left !== null && (
          <div data-testid="station-left">
            <b>{formatDuration(job.seconds_left)}</b> left
          </div>
        )}
        {job.copies > 1 && (
          <div data-testid="station-copy">
            copy <b>{Math.min(job.copies_done + 1, job.copies)}</b> of {job.copies}
          </div>
        )}
      </div>
      <progress
        className={css.bar}
        value={job.progress}
        max={1}
        aria-label="Progress of the job on the table"
      />
    </div>
  );
}

/** Why the job waits or how it ended, with what to do. */
function Reason({ job }: { job: Job }) {
  // The list of checks contains the same items.
  if (job.message?.code === "waiting.for-start") return null;
  if (job.state === "done") {
    return (
      <p className={css.message} data-tone="green" role="status" data-testid="station-done">
        {pluralize(job.copies, "copy", "copies")} finished. The table is free for the next job.
      </p>
    );
  }
  const text = job.message === null ? "" : renderText(job.message);
  if (text === "") {
    return job.state === "cancelled" ? <p className={css.message}>The job was cancelled.</p> : null;
  }
  const hint = job.message === null ? "" : renderHint(job.message);
  const tone = job.state === "interrupted" || needsOperator(job) ? "amber" : "grey";
  return (
    <div className={css.message} data-tone={tone} role="status" data-testid="station-reason">
      <div>{text}</div>
      {hint !== "" && <div className={css.todo}>{hint}</div>}
    </div>
  );
}

type Ending = Extract<JobCommand, "requeue" | "finish" | "scrap">;

const ENDINGS: Readonly<Record<Ending, { title: string; note: string }>> = {
  requeue: {
    title: "Queue again from the start",
    note: "Needs a new sheet: the whole copy is cut again.",
  },
  finish: { title: "It is finished", note: "Only if all sheets are completely cut." },
  scrap: { title: "Board is scrap", note: "Ends the job. Remove the board first." },
};

const AGAIN: Confirmation = {
  title: "Queue the job again from the start?",
  text: "The sheet on the table cannot be used for it. Put a new sheet on the table before you start.",
  yes: "Queue again",
  no: "Do not queue",
};

/** Where the machine stopped is drawn in the picture; here is what can be done about it. */
function AfterInterruption({ job, reached }: { job: Job; reached: boolean }) {
  const [asking, setAsking] = useState<Ending | null>(null);
  const words = job.actions.filter((word): word is Ending => word in ENDINGS);
  if (asking !== null && words.includes(asking)) {
    return (
      <AskOnce
        {...(confirmationBefore(job, asking) ?? AGAIN)}
        disabled={!reached}
        onNo={() => setAsking(null)}
        onYes={() => {
          setAsking(null);
          void commandJob(job.id, ENDINGS[asking].title, asking);
        }}
      />
    );
  }
  return (
    <div className={css.ways} data-testid="after-interruption">
      {job.stopped_at !== null && <p>{stopText(job, job.stopped_at)}</p>}
      {canContinue(job) && (
        <fieldset className={css.rest} disabled={!reached}>
          <RestLegend job={job} />
          <RestPanel job={job} />
        </fieldset>
      )}
      {words.map((word) => (
        <div key={word} className={css.way}>
          <button
            type="button"
            className={css.button}
            disabled={!reached}
            onClick={() => setAsking(word)}
            data-testid={`station-${word}`}
          >
            {ENDINGS[word].title}
          </button>
          <small>{ENDINGS[word].note}</small>
        </div>
      ))}
    </div>
  );
}

/** The best way after an interruption, with what it makes. */
function RestLegend({ job }: { job: Job }) {
  const { data: tracks } = useTracks(job);
  const left = tracks === undefined ? "" : `, ${tracksLeft(tracks)} left`;
  return <legend data-testid="rest-title">Continue this sheet{left}</legend>;
}

function stopText({ lines, tools }: Job, stop: NonNullable<Job["stopped_at"]>): string {
  const tool = tools.find(({ station }) => station === stop.station);
  return (
    `The picture shows where the head stopped: line ${stop.line.toLocaleString("en")} of ` +
    `${lines.toLocaleString("en")}${tool === undefined ? "" : `, ${tool.name} in use`}.`
  );
}
