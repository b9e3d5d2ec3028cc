/** The job of the machine: what to check before it starts, its progress, and how it ended. */

import { Fieldset, Flex, Group, Progress, Stack, Text, Title } from "@mantine/core";
import { useState } from "react";
import type { Job, JobCommand } from "../../api/jobs";
import type { Machine, Station } from "../../api/machines";
import { translate } from "../../language/translate";
import { translateRich } from "../../language/translateRich";
import { messageHint, messageText } from "../../messages/translateMessage";
import { formatDuration } from "../../state/format";
import {
  type Confirmation,
  confirmationBefore,
  isOnTable,
  needsOperator,
} from "../../state/job/jobs";
import { canContinue, tracksLeft } from "../../state/job/rest";
import { useBoardTitle, useTracks } from "../../state/queries";
import type { Check } from "../../state/station/checks";
import type { HandsClear } from "../../state/station/handsClear";
import { commandJob } from "../../state/station/operations";
import { recompileNote } from "../../state/station/toolCheck";
import type { WornToolsState } from "../../state/station/wornTools";
import { TicketButton } from "../handover/Handover";
import { RemainingCopies } from "../job/RemainingCopies";
import { RestPanel } from "../job/RestPanel";
import { StateBadge } from "../job/StateBadge";
import { OrderCard } from "../order/OrderDetails";
import panels from "../shared/panels.module.css";
import { AskOnce } from "./AskOnce";
import { DryRunPanel } from "./DryRunPanel";
import { FeedOverride } from "./FeedOverride";
import { HandsClearButton } from "./HandsClearButton";
import { MarksPanel } from "./MarksPanel";
import { NotedButton, WideButton } from "./parts";
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
    <Flex
      component="section"
      direction="column"
      gap={10}
      aria-label={translate("stationJob.job")}
      data-testid="station-job"
      data-state={job.state}
    >
      <Group gap={8} justify="space-between">
        <Title order={2} fz={22} miw={0} style={{ overflowWrap: "anywhere" }}>
          {job.drawing_name}
        </Title>
        <StateBadge job={job} testId="station-job-state" size="xl" />
      </Group>
      {/* Large: on another board than its own, a job cuts at wrong depths. */}
      <Text
        fz={30}
        fw={700}
        lh={1.15}
        style={{ overflowWrap: "anywhere" }}
        data-testid="station-board"
      >
        {board}
      </Text>
      <Text c="ink.2">{`${translate("stationJob.copies", { copies: job.copies })}${job.seconds > 0 ? ` · ${translate("stationJob.each", { seconds: formatDuration(job.seconds) })}` : ""}`}</Text>
      <OrderCard job={job} />
      <TicketButton job={job} size="lg" />
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
          {job.registration != null && <MarksPanel {...props} key={job.program_sha256} />}
          {checks !== null && <ToolCheckPanel {...props} checks={checks} />}
        </>
      )}
      {job.actions.includes("recheck") && (
        <NotedButton note={translate("stationJob.theMachineChecksTheProgram")}>
          <WideButton
            disabled={!reached}
            onClick={() => void commandJob(job.id, translate("stationJob.tryAgain"), "recheck")}
            data-testid="station-recheck"
          >
            {translate("stationJob.tryAgain")}
          </WideButton>
        </NotedButton>
      )}
      {job.waiting_for === "compile" && (
        <NotedButton note={recompileNote(machine)}>
          <WideButton
            disabled={!reached || !job.actions.includes("recompile")}
            onClick={() =>
              void commandJob(job.id, translate("stationJob.compileAgain"), "recompile")
            }
            data-testid="station-recompile"
          >
            {translate("stationJob.compileTheJobAgain")}
          </WideButton>
        </NotedButton>
      )}
      {(job.state === "interrupted" || job.state === "cancelled") && (
        <AfterInterruption job={job} reached={reached} />
      )}
      {job.state === "done" && <RemainingCopies job={job} />}
    </Flex>
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
            {translateRich("stationJob.left", {
              secondsLeft: formatDuration(job.seconds_left),
              b: (children) => <b>{children}</b>,
            })}
          </div>
        )}
        {job.copies > 1 && (
          <div data-testid="station-copy">
            {translateRich("stationJob.copyOf", {
              copiesDone: Math.min(job.copies_done + 1, job.copies),
              copies: job.copies,
              b: (children) => <b>{children}</b>,
            })}
          </div>
        )}
      </div>
      <Progress
        size={18}
        value={100 * job.progress}
        aria-label={translate("stationJob.progressOfTheJobOn")}
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
      <p className={panels.callout} data-tone="green" role="status" data-testid="station-done">
        {translate("stationJob.copiesFinishedTheTableIs", { copies: job.copies })}
      </p>
    );
  }
  const text = job.message === null ? "" : messageText(job.message);
  if (text === "") {
    return job.state === "cancelled" ? (
      <p className={panels.callout}>{translate("stationJob.theJobWasCancelled")}</p>
    ) : null;
  }
  const hint = job.message === null ? "" : messageHint(job.message);
  const tone = job.state === "interrupted" || needsOperator(job) ? "amber" : "grey";
  return (
    <div className={panels.callout} data-tone={tone} role="status" data-testid="station-reason">
      <div>{text}</div>
      {hint !== "" && (
        <Text component="div" mt={6} c="ink.0" fw={600}>
          {hint}
        </Text>
      )}
    </div>
  );
}

type Ending = Extract<JobCommand, "requeue" | "finish" | "scrap">;

const ENDINGS: Readonly<Record<Ending, { title: string; note: string }>> = {
  requeue: {
    title: translate("stationJob.queueAgainFromTheStart"),
    note: translate("stationJob.needsANewSheetThe"),
  },
  finish: {
    title: translate("stationJob.itIsFinished"),
    note: translate("stationJob.onlyIfAllSheetsAre"),
  },
  scrap: {
    title: translate("stationJob.boardIsScrap"),
    note: translate("stationJob.endsTheJobRemoveThe"),
  },
};

const AGAIN: Confirmation = {
  title: translate("stationJob.queueTheJobAgainFrom"),
  text: translate("stationJob.theSheetOnTheTable"),
  yes: translate("stationJob.queueAgain"),
  no: translate("stationJob.doNotQueue"),
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
    <Stack gap={14} data-testid="after-interruption">
      {job.stopped_at !== null && <p>{stopText(job, job.stopped_at)}</p>}
      {canContinue(job) && (
        <Fieldset data-touch p={10} disabled={!reached} legend={<RestLegend job={job} />}>
          <RestPanel job={job} />
        </Fieldset>
      )}
      {words.map((word) => (
        <NotedButton key={word} note={ENDINGS[word].note}>
          <WideButton
            disabled={!reached}
            onClick={() => setAsking(word)}
            data-testid={`station-${word}`}
          >
            {ENDINGS[word].title}
          </WideButton>
        </NotedButton>
      ))}
    </Stack>
  );
}

/** The best way after an interruption, with what it makes. */
function RestLegend({ job }: { job: Job }) {
  const { data: tracks } = useTracks(job);
  return (
    <span data-testid="rest-title">
      {tracks === undefined
        ? translate("stationJob.continueThisSheet")
        : translate("stationJob.continueThisSheetLeft", { tracks: tracksLeft(tracks) })}
    </span>
  );
}

function stopText({ lines, tools }: Job, stop: NonNullable<Job["stopped_at"]>): string {
  const tool = tools.find(({ station }) => station === stop.station);
  return tool === undefined
    ? translate("stationJob.thePictureShowsWhereThe", { line: stop.line, lines })
    : translate("stationJob.thePictureShowsWhereThe2", { line: stop.line, lines, name: tool.name });
}
