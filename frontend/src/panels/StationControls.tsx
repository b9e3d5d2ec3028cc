/** Start, Hold, Resume and Stop in large type, always in the same places. */

import {
  IconHandStop,
  IconPlayerPauseFilled,
  IconPlayerPlayFilled,
  IconPlayerStopFilled,
  IconPlayerTrackNextFilled,
} from "@tabler/icons-react";
import { type ReactNode, useEffect, useState } from "react";
import type { Job, JobCommand, Station } from "../api/client";
import { useRefusal } from "../state/accounts";
import { type HandsClear, handsReason } from "../state/handsClear";
import { awaitsEnd, confirmationBefore } from "../state/jobs";
import { type Checked, commandJob, operate, startJob } from "../state/operations";
import { runAboveBoard, type Stop, stopOf } from "../state/station";
import { reasonAgainstResume, reasonAgainstStart } from "../state/wayOut";
import { AskOnce } from "./AskOnce";
import css from "./station.module.css";

interface Props {
  readonly machine: string;
  readonly station: Station | undefined;
  readonly job: Job | undefined;
  readonly reached: boolean;
  readonly hands: HandsClear;
  /** What the person has checked; null while something is not ticked. */
  readonly checked: Checked | null;
}

interface Control {
  readonly name: string;
  readonly testId: string;
  readonly tone: string;
  readonly icon: ReactNode;
  /** Why it is disabled; null: it can be pressed. */
  readonly reason: string | null;
  act(): void;
}

const has = (job: Job | undefined, word: JobCommand | "confirm"): boolean =>
  job?.actions.includes(word) === true;

/** Question before a job is ended whose machine does not move. */
const questionOf = (job: Job) =>
  confirmationBefore(job, "cancel") ?? {
    title: "Cancel the job?",
    text: "The job has not started. It leaves the queue of the machine.",
    yes: "Cancel job",
    no: "Keep job",
  };

export function StationControls({ machine, station, job, reached, hands, checked }: Props) {
  const refusal = useRefusal("POST /api/v1/machines/{name}/operations");
  const [asking, setAsking] = useState<string | null>(null);
  const stop = stopOf(station, job);
  const asks = asking !== null && asking === job?.id && stop?.asks === true;
  // A question that no longer applies must not return later.
  useEffect(() => {
    if (!asks) setAsking(null);
  }, [asks]);

  const run = runAboveBoard(station);
  const holds = (state: "running" | "held") => run?.state === state;
  const send = (label: string, word: JobCommand) => {
    if (job !== undefined) void commandJob(job.id, label, word);
  };
  const halt = ({ act, asks }: Stop) => {
    if (act === "stop_jog") void operate(machine, "Stop", { operation: "stop_jog" });
    else if (asks) setAsking(job?.id ?? null);
    else send("Stop", "cancel");
  };
  const controls: readonly Control[] = [
    {
      name: "Start",
      testId: "station-start",
      tone: "green",
      icon: <IconPlayerPlayFilled aria-hidden />,
      reason:
        reasonAgainstStart(job, station) ??
        (checked !== null ? null : "Check and tick everything that is listed first."),
      act: () => {
        if (job !== undefined && checked !== null) void startJob(job.id, checked);
      },
    },
    {
      name: "Hold",
      testId: "station-hold",
      tone: "amber",
      icon: <IconPlayerPauseFilled aria-hidden />,
      reason: holds("running")
        ? null
        : !has(job, "hold")
          ? "No job runs."
          : station?.state === "unreported"
            ? "This machine cannot be held from here. Use its own controls."
            : null,
      act: () =>
        run === null ? send("Hold", "hold") : void operate(machine, "Hold", { operation: "hold" }),
    },
    {
      name: job !== undefined && awaitsEnd(job) ? "Has finished" : "Resume",
      testId: "station-resume",
      tone: "blue",
      icon: <IconPlayerTrackNextFilled aria-hidden />,
      reason:
        reasonAgainstResume(job, station) ??
        (run === null && has(job, "end") ? null : handsReason("resume", hands)),
      act: () =>
        run === null
          ? has(job, "end")
            ? send("Has finished", "end")
            : send("Resume", "resume")
          : void operate(machine, "Resume", { operation: "resume" }),
    },
    {
      name: "Stop",
      testId: "station-stop",
      tone: "red",
      icon: <IconPlayerStopFilled aria-hidden />,
      reason: stop === null ? "There is nothing to stop." : null,
      act: () => stop !== null && halt(stop),
    },
  ];
  return (
    <section className={css.controls} aria-label="Job controls">
      {refusal !== null && (
        <p className={css.message} data-testid="role-reason">
          {refusal}
        </p>
      )}
      {asks && job !== undefined && (
        <AskOnce
          {...questionOf(job)}
          disabled={!reached}
          onNo={() => setAsking(null)}
          onYes={() => {
            setAsking(null);
            send("Stop", "cancel");
          }}
        />
      )}
      <div className={css.big}>
        {controls.map(({ name, testId, tone, icon, reason, act }) => {
          const why = reached ? (refusal ?? reason) : "There is no connection to the server.";
          return (
            <button
              key={name}
              type="button"
              className={css.control}
              data-tone={tone}
              data-testid={testId}
              disabled={why !== null}
              title={why ?? undefined}
              onClick={act}
            >
              {icon}
              {name}
            </button>
          );
        })}
        <p className={css.emergency} data-testid="emergency">
          <IconHandStop size={34} color="var(--bad)" aria-hidden />
          <span>
            <b>This is not an emergency stop.</b> In danger, press the red emergency stop button on
            the machine.
          </span>
        </p>
      </div>
    </section>
  );
}
