/** Runs above the board before a job starts: its whole path, or only round the sheet. */

import { Flex, Progress, SimpleGrid, Text, Title } from "@mantine/core";
import { useState } from "react";
import type { Job } from "../../api/jobs";
import type { Activity, Machine, OperationRequest, Station } from "../../api/machines";
import { insideSentence } from "../../language/numbers";
import { translate } from "../../language/translate";
import { translateRich } from "../../language/translateRich";
import { messageHint, messageText } from "../../messages/translateMessage";
import { formatDuration } from "../../state/format";
import { type HandsClear, handsReason } from "../../state/station/handsClear";
import { operate } from "../../state/station/operations";
import { RUN_TITLES, reasonAgainst, runAboveBoard } from "../../state/station/station";
import panels from "../shared/panels.module.css";
import { NotedButton, Steps, WideButton } from "./parts";
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
    <Flex
      component="section"
      direction="column"
      gap={12}
      pt={14}
      className={panels.divided}
      aria-label={translate("dryRunPanel.beforeTheStart")}
      data-testid="dry-run"
    >
      <Title order={3} fz={18}>
        {translate("dryRunPanel.tryItAboveTheBoard")}
      </Title>
      <LastRun activity={station?.activity ?? null} job={job} />
      {common !== null && (
        <Text fz={15} c="ink.2">
          {common}
        </Text>
      )}
      <Steps
        title={translate("dryRunPanel.speedOfTheDryRun")}
        data={SHARES.map((value) => ({ value, label: `${value} %` }))}
        testId="share"
        value={percent}
        onChange={setPercent}
      />
      <SimpleGrid cols={2} spacing={12}>
        {WAYS.map(({ kind, note, request }, at) => (
          <NotedButton key={kind} note={note}>
            <WideButton
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
            </WideButton>
          </NotedButton>
        ))}
      </SimpleGrid>
    </Flex>
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
      <Progress
        size={18}
        value={100 * run.progress}
        aria-label={translate("dryRunPanel.progressOfTheRunAbove")}
      />
      <Text fz={15} c="ink.2">
        {shown !== undefined
          ? translate("dryRunPanel.pathOfStationAboveThe", {
              number: shown.number,
              name: shown.name,
            })
          : translate("dryRunPanel.aboveTheBoardNothingIs")}
      </Text>
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
      className={panels.callout}
      data-tone={end.tone}
      role="status"
      data-testid="dry-run-end"
      data-state={activity.state}
    >
      {translate(end.text, { run: RUN_TITLES[activity.kind] })}
      {message !== null && <div>{messageText(message)}</div>}
      {message !== null && (
        <Text component="div" mt={6} c="ink.0" fw={600}>
          {messageHint(message)}
        </Text>
      )}
    </div>
  );
}
