/** Start, Hold, Resume and Stop in large type, always in the same places. */

import {
  IconHandStop,
  IconPlayerPauseFilled,
  IconPlayerPlayFilled,
  IconPlayerStopFilled,
  IconPlayerTrackNextFilled,
} from "@tabler/icons-react";
import { type ReactNode, useEffect, useState } from "react";
import type { Job, JobCommand } from "../../api/jobs";
import type { Station } from "../../api/machines";
import { translate } from "../../language/translate";
import { translateRich } from "../../language/translateRich";
import { useRefusal } from "../../state/accounts/accounts";
import { awaitsEnd, confirmationBefore } from "../../state/job/jobs";
import { type HandsClear, handsReason } from "../../state/station/handsClear";
import { type Checked, commandJob, operate, startJob } from "../../state/station/operations";
import { runAboveBoard, type Stop, stopOf } from "../../state/station/station";
import { reasonAgainstResume, reasonAgainstStart } from "../../state/station/wayOut";
import panels from "../shared/panels.module.css";
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
    title: translate("stationControls.cancelTheJob"),
    text: translate("stationControls.theJobHasNotStarted"),
    yes: translate("stationControls.cancelJob"),
    no: translate("stationControls.keepJob"),
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
    if (act === "stop_jog")
      void operate(machine, translate("stationControls.stop"), { operation: "stop_jog" });
    else if (asks) setAsking(job?.id ?? null);
    else send(translate("stationControls.stop"), "cancel");
  };
  const controls: readonly Control[] = [
    {
      name: translate("stationControls.start"),
      testId: "station-start",
      tone: "green",
      icon: <IconPlayerPlayFilled aria-hidden />,
      reason:
        reasonAgainstStart(job, station) ??
        (checked !== null ? null : translate("stationControls.checkAndTickEverythingThat")),
      act: () => {
        if (job !== undefined && checked !== null) void startJob(job.id, checked);
      },
    },
    {
      name: translate("stationControls.hold"),
      testId: "station-hold",
      tone: "amber",
      icon: <IconPlayerPauseFilled aria-hidden />,
      reason: holds("running")
        ? null
        : !has(job, "hold")
          ? translate("stationControls.noJobRuns")
          : station?.state === "unreported"
            ? translate("stationControls.thisMachineCannotBeHeld")
            : null,
      act: () =>
        run === null
          ? send(translate("stationControls.hold"), "hold")
          : void operate(machine, translate("stationControls.hold"), { operation: "hold" }),
    },
    {
      name:
        job !== undefined && awaitsEnd(job)
          ? translate("stationControls.hasFinished")
          : translate("stationControls.resume"),
      testId: "station-resume",
      tone: "blue",
      icon: <IconPlayerTrackNextFilled aria-hidden />,
      reason:
        reasonAgainstResume(job, station) ??
        (run === null && has(job, "end") ? null : handsReason("resume", hands)),
      act: () =>
        run === null
          ? has(job, "end")
            ? send(translate("stationControls.hasFinished"), "end")
            : send(translate("stationControls.resume"), "resume")
          : void operate(machine, translate("stationControls.resume"), { operation: "resume" }),
    },
    {
      name: translate("stationControls.stop"),
      testId: "station-stop",
      tone: "red",
      icon: <IconPlayerStopFilled aria-hidden />,
      reason: stop === null ? translate("stationControls.thereIsNothingToStop") : null,
      act: () => stop !== null && halt(stop),
    },
  ];
  return (
    <section className={css.controls} aria-label={translate("stationControls.jobControls")}>
      {refusal !== null && (
        <p className={panels.callout} data-testid="role-reason">
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
            send(translate("stationControls.stop"), "cancel");
          }}
        />
      )}
      <div className={css.big}>
        {controls.map(({ name, testId, tone, icon, reason, act }) => {
          const why = reached
            ? (refusal ?? reason)
            : translate("stationControls.thereIsNoConnectionTo");
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
            {translateRich("stationControls.thisIsNotAnEmergency", {
              b: (children) => <b>{children}</b>,
            })}
          </span>
        </p>
      </div>
    </section>
  );
}
