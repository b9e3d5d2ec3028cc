/** The open job: state, progress, operator commands and verdict. */

import { Button, Group, Progress, Stack, Text } from "@mantine/core";
import {
  IconCheck,
  IconCircleCheckFilled,
  IconDownload,
  IconPlayerPauseFilled,
  IconPlayerStopFilled,
  IconRefresh,
  IconTrash,
} from "@tabler/icons-react";
import { type ReactNode, useState } from "react";
import { type Job, jobService } from "../../api/jobs";
import { translate } from "../../language/translate";
import { translateRich } from "../../language/translateRich";
import { errorText, messageHint, messageText } from "../../messages/translateMessage";
import { useRefusal } from "../../state/accounts/accounts";
import { command } from "../../state/actions";
import { concernedRows } from "../../state/drawing/rows";
import { formatDuration } from "../../state/format";
import {
  commandsOf,
  confirmationBefore,
  hasProgram,
  isCompiling,
  isOnTable,
  needsOperator,
  type OfficeCommand,
  STATE_STYLES,
  waitsAtMachine,
} from "../../state/job/jobs";
import { canContinue } from "../../state/job/rest";
import { SHOWN_STAGES, stageProgress } from "../../state/job/stages";
import { useBoardTitle, useEdges, useJob, useMachineTitles } from "../../state/queries";
import { showDrawing } from "../../state/routes";
import { useUiStore } from "../../state/store";
import { Permitted } from "../accounts/Permitted";
import { JobHandover } from "../handover/Handover";
import { OrderCard } from "../order/OrderDetails";
import { ConfirmDialog } from "../shared/ConfirmDialog";
import css from "../shared/panels.module.css";
import { Figures, Hint, LinkButton, Note } from "../shared/parts";
import { Section } from "../shared/Section";
import { RestPanel } from "./RestPanel";
import { StateBadge } from "./StateBadge";
import { VerdictCard } from "./VerdictCard";
import { WaitsAtMachine } from "./WaitsAtMachine";

export function JobPanel() {
  const { data: job, error } = useJob();
  const drawing = useUiStore((ui) => ui.drawing);
  if (job === undefined && error !== null)
    return (
      <Section title={translate("jobPanel.openJob")}>
        <div className={css.callout} data-tone="amber" role="alert" data-testid="no-job">
          {errorText(error)}{" "}
          <LinkButton onClick={() => showDrawing(drawing)}>
            {translate("jobPanel.showTheDrawingWithoutAJob")}
          </LinkButton>
        </div>
      </Section>
    );
  if (job === undefined) return null;
  return (
    <section className={css.section} aria-label={translate("jobPanel.openJob")}>
      <Stack gap={12} p={16}>
        <Group justify="space-between" gap={8}>
          <JobBoard job={job} />
          <StateBadge job={job} testId="job-state" />
        </Group>
        {isCompiling(job) && <Compiling job={job} />}
        {waitsAtMachine(job) && <WaitsAtMachine job={job} />}
        {job.state === "queued" && !needsOperator(job) && <Waiting job={job} />}
        {isOnTable(job) && <Running job={job} />}
        <Outcome job={job} />
        <VerdictCard job={job} />
        <Controls job={job} />
        {canContinue(job) && <Rest key={job.id} job={job} />}
        <OrderCard job={job} />
        <JobHandover job={job} />
        {hasProgram(job) && (
          <Button
            component="a"
            href={jobService.programUrl(job.id)}
            download
            size="xs"
            variant="subtle"
            color="gray"
            leftSection={<IconDownload size={15} aria-hidden />}
            data-testid="program"
          >
            {job.state === "refused"
              ? translate("jobPanel.downloadRefusedProgramLines", { lines: job.lines })
              : translate("jobPanel.downloadMachineProgramLines", { lines: job.lines })}
          </Button>
        )}
      </Stack>
    </section>
  );
}

/** The board and the machine for which the program was made. */
function JobBoard({ job }: { job: Job }) {
  const title = useBoardTitle(job.board);
  const machine = useMachineTitles()(job.machine);
  return (
    <Note data-testid="job-board">
      {translateRich("jobPanel.board", {
        title,
        machine,
        b: (children) => <b>{children}</b>,
      })}
    </Note>
  );
}

/** Where another job continues; open at once where a sheet lies half cut on the table. */
function Rest({ job }: { job: Job }) {
  const [open, setOpen] = useState(job.state === "interrupted" || job.remaining_copies > 0);
  return (
    <details open={open} onToggle={(event) => setOpen(event.currentTarget.open)}>
      <Text component="summary" mih={32} mb={8} fw={600} data-testid="rest-open">
        {translate("jobPanel.restOfTheSheetOr")}
      </Text>
      {open && (
        <Permitted request="POST /api/v1/jobs/{id}/rest">
          <RestPanel job={job} />
        </Permitted>
      )}
    </details>
  );
}

function Compiling({ job }: { job: Job }) {
  const { title, index } = stageProgress(job.stage);
  return (
    <div role="status" data-testid="stage">
      <Progress.Root size={5} mb={8} bg="transparent" style={{ gap: 3 }} aria-hidden>
        {SHOWN_STAGES.map((stage, at) => (
          <Progress.Section
            key={stage}
            withAria={false}
            value={100 / SHOWN_STAGES.length}
            color={at > index ? "gray" : "blue"}
            animated={at === index}
          />
        ))}
      </Progress.Root>
      <Figures>
        <span>{title}</span>
        <span>{Math.round(job.progress * 100)} %</span>
      </Figures>
    </div>
  );
}

function Waiting({ job }: { job: Job }) {
  const machine = useMachineTitles()(job.machine);
  return (
    <div className={css.callout} data-tone="grey" role="status" data-testid="waiting">
      {job.message === null
        ? translate("jobPanel.theJobWaitsForThe", { machine })
        : messageText(job.message)}
      <HintOf message={job.message} />
    </div>
  );
}

/** The hint of a message, if it has one. */
function HintOf({ message }: { message: Job["message"] }) {
  const hint = message === null ? "" : messageHint(message);
  return hint === "" ? null : <Hint>{hint}</Hint>;
}

function Running({ job }: { job: Job }) {
  const held = job.state === "held";
  const left = job.seconds_left;
  return (
    <div data-testid="run" data-on-table>
      <Progress
        value={job.progress * 100}
        size="lg"
        color={held ? "yellow" : "blue"}
        striped={held}
        transitionDuration={200}
        aria-label={translate("jobPanel.progressOfTheJobOn")}
        data-testid="run-progress"
      />
      <Figures mt={8}>
        <span>{`${translate("jobPanel.done", { progress: Math.round(job.progress * 100) })}${job.copies > 1 ? ` · ${translate("jobPanel.copyOf", { copiesDone: Math.min(job.copies_done + 1, job.copies), copies: job.copies })}` : ""}`}</span>
        <span>{translate("jobPanel.programLineOf", { line: job.line, lines: job.lines })}</span>
        <span data-testid="time-left">
          {left === null ? "" : translate("jobPanel.left", { left: formatDuration(left) })}
        </span>
      </Figures>
    </div>
  );
}

function Outcome({ job }: { job: Job }) {
  const { data: edges } = useEdges();
  const zoomToEdges = useUiStore((ui) => ui.zoomToEdges);
  if (job.state === "done") {
    return (
      <div className={css.callout} data-tone="green" data-testid="done" role="status">
        <Group gap={10} wrap="nowrap">
          <IconCircleCheckFilled size={20} color="var(--good)" aria-hidden />
          <Text span c="ink.0" fz={15} fw={650}>
            {translate("jobPanel.copiesFinished", { copies: job.copies })}
          </Text>
        </Group>
        <Hint>{translate("jobPanel.theTableIsFreeFor")}</Hint>
      </div>
    );
  }
  // WaitsAtMachine shows what the job waits for, and VerdictCard the shortfalls of its program.
  if (job.waiting_for !== "" || waitsAtMachine(job) || job.actions.includes("accept")) return null;
  const fallback = job.state === "cancelled" ? translate("jobPanel.theJobWasCancelled") : "";
  const text = job.message === null ? fallback : messageText(job.message);
  if (text === "") return null;
  const { tone } = STATE_STYLES[job.state];
  const rows = edges === undefined ? [] : concernedRows(edges, job);
  return (
    <div
      className={css.callout}
      data-tone={tone === "red" || tone === "amber" ? tone : "grey"}
      data-testid="reason"
      role={tone === "red" ? "alert" : "status"}
    >
      {text}
      <HintOf message={job.message} />
      {rows.length > 0 && (
        <Button mt={8} size="compact-xs" variant="default" onClick={() => zoomToEdges(rows)}>
          {translate("jobPanel.showEdgesInTheDrawing", { rows: rows.length })}
        </Button>
      )}
    </div>
  );
}

/** Sending is the main action of the step. */
type PanelCommand = Exclude<OfficeCommand, "release">;

const LOOKS: Readonly<
  Record<
    PanelCommand,
    { title: string; icon: ReactNode; colour: string; variant: string; testId: string }
  >
> = {
  recompile: {
    title: translate("jobPanel.compileJobAgain"),
    icon: <IconRefresh size={16} />,
    colour: "blue",
    variant: "filled",
    testId: "recompile",
  },
  hold: {
    title: translate("jobPanel.pauseJob"),
    icon: <IconPlayerPauseFilled size={16} />,
    colour: "yellow",
    variant: "light",
    testId: "hold",
  },
  cancel: {
    title: translate("jobPanel.cancelJob"),
    icon: <IconPlayerStopFilled size={16} />,
    colour: "red",
    variant: "subtle",
    testId: "cancel",
  },
  finish: {
    title: translate("jobPanel.markJobAsFinished"),
    icon: <IconCheck size={16} />,
    colour: "green",
    variant: "light",
    testId: "finish",
  },
  recheck: {
    title: translate("jobPanel.letTheMachineTryAgain"),
    icon: <IconRefresh size={16} />,
    colour: "blue",
    variant: "light",
    testId: "recheck",
  },
  requeue: {
    title: translate("jobPanel.queueJobAgain"),
    icon: <IconRefresh size={16} />,
    colour: "blue",
    variant: "filled",
    testId: "requeue",
  },
  scrap: {
    title: translate("jobPanel.endJobBoardIsScrap"),
    icon: <IconTrash size={16} />,
    colour: "red",
    variant: "subtle",
    testId: "scrap",
  },
};

const titleOf = (word: OfficeCommand): string =>
  word === "release" ? translate("jobPanel.sendJobToMachine") : LOOKS[word].title;

/** What a designer may ask for, too, before a job is queued. */
const OF_DESIGNERS: readonly OfficeCommand[] = ["recompile", "cancel"];

const isBeforeQueue = ({ state }: Job): boolean =>
  ["received", "compiling", "ready", "refused"].includes(state);

function Controls({ job }: { job: Job }) {
  const reasons = {
    designer: useRefusal("POST /api/v1/jobs/{id}/cancel"),
    operator: useRefusal("POST /api/v1/jobs/{id}/release"),
  };
  const reasonAgainst = (word: OfficeCommand) =>
    // A queued job is the operator's.
    OF_DESIGNERS.includes(word) && isBeforeQueue(job) ? reasons.designer : reasons.operator;
  const busy = useUiStore((ui) => ui.busy);
  const [asking, setAsking] = useState<PanelCommand | null>(null);
  const all = commandsOf(job);
  const words = all.filter((word): word is PanelCommand => word !== "release");
  // The job may change while the dialog is open: close it when the command is no longer possible.
  const open = asking !== null && words.includes(asking) ? confirmationBefore(job, asking) : null;
  if (all.length === 0) return null;
  const refused = all.find((word) => reasonAgainst(word) !== null);
  const send = (word: PanelCommand) => {
    if (confirmationBefore(job, word) === null) void command(job.id, word);
    else setAsking(word);
  };
  return (
    <Group gap={8}>
      <ConfirmDialog
        confirmation={open}
        onYes={() => {
          setAsking(null);
          if (asking !== null) void command(job.id, asking);
        }}
        onNo={() => setAsking(null)}
      />
      {words.map((word, at) => {
        const { icon, colour, variant, testId, title } = LOOKS[word];
        return (
          <Button
            key={word}
            style={at === 0 && words.length > 1 ? { flex: "1 0 auto" } : {}}
            leftSection={icon}
            color={colour}
            variant={variant}
            disabled={busy || reasonAgainst(word) !== null}
            title={reasonAgainst(word) ?? undefined}
            // Requested, but not executed by the machine yet.
            loading={job.requested_action === word}
            onClick={() => send(word)}
            data-testid={testId}
          >
            {title}
          </Button>
        );
      })}
      {refused !== undefined && (
        <Note flex="1 0 100%" data-testid="role-reason">
          {`${titleOf(refused)}: ${reasonAgainst(refused)}`}
        </Note>
      )}
    </Group>
  );
}
