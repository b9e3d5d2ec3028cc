/** The open job: state, progress, operator commands and verdict. */

import { Button, Progress } from "@mantine/core";
import {
  IconCheck,
  IconCircleCheckFilled,
  IconDownload,
  IconPlayerPauseFilled,
  IconPlayerStopFilled,
  IconRefresh,
  IconSend2,
  IconTrash,
} from "@tabler/icons-react";
import { type ReactNode, useState } from "react";
import { type Job, service } from "../api/client";
import { renderHint, renderText } from "../messages/render";
import { useRefusal } from "../state/accounts";
import { command } from "../state/actions";
import { formatDuration, pluralize } from "../state/format";
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
} from "../state/jobs";
import { useBoardTitle, useEdges, useJob } from "../state/queries";
import { canContinue } from "../state/rest";
import { concernedRows } from "../state/rows";
import { SHOWN_STAGES, stageProgress } from "../state/stages";
import { useUiStore } from "../state/store";
import { ConfirmDialog } from "./ConfirmDialog";
import jobCss from "./job.module.css";
import { OrderCard } from "./OrderDetails";
import { Permitted } from "./Permitted";
import css from "./panels.module.css";
import { RestPanel } from "./RestPanel";
import { Section } from "./Section";
import { StateBadge } from "./StateBadge";
import { VerdictCard } from "./VerdictCard";
import verdictCss from "./verdict.module.css";
import { WaitsAtMachine } from "./WaitsAtMachine";

export function JobPanel() {
  const { data: job } = useJob();
  if (job === undefined) return null;
  return (
    <Section title="Open job" aside={<StateBadge job={job} testId="job-state" />}>
      <div style={{ display: "grid", gridTemplateColumns: "minmax(0, 1fr)", gap: 12 }}>
        <JobBoard job={job} />
        <OrderCard job={job} />
        {isCompiling(job) && <Compiling job={job} />}
        {waitsAtMachine(job) && <WaitsAtMachine job={job} />}
        {job.state === "queued" && !needsOperator(job) && <Waiting job={job} />}
        {isOnTable(job) && <Running job={job} />}
        <Outcome job={job} />
        <Controls job={job} />
        {canContinue(job) && <Rest key={job.id} job={job} />}
        <VerdictCard job={job} />
        {hasProgram(job) && (
          <Button
            component="a"
            href={service.programUrl(job.id)}
            download
            size="xs"
            variant="subtle"
            color="gray"
            leftSection={<IconDownload size={15} aria-hidden />}
            data-testid="program"
          >
            Download {job.state === "refused" ? "refused" : "machine"} program (
            {pluralize(job.lines, "line")})
          </Button>
        )}
      </div>
    </Section>
  );
}

/** The board and the machine for which the program was made. */
function JobBoard({ job }: { job: Job }) {
  const title = useBoardTitle(job.board);
  return (
    <p className={css.note} style={{ margin: 0 }} data-testid="job-board">
      Board: <b>{title}</b> · {job.machine}
    </p>
  );
}

/** Where another job continues; open at once where a sheet lies half cut on the table. */
function Rest({ job }: { job: Job }) {
  const [open, setOpen] = useState(job.state === "interrupted" || job.remaining_copies > 0);
  return (
    <details open={open} onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary className={jobCss.summary} data-testid="rest-open">
        Rest of the sheet, or one more copy
      </summary>
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
      <ol className={jobCss.stages} aria-hidden="true">
        {SHOWN_STAGES.map((stage, at) => (
          <li key={stage} data-state={at < index ? "done" : at === index ? "now" : "open"} />
        ))}
      </ol>
      <div className={css.runFigures} style={{ marginTop: 0 }}>
        <span>{title}</span>
        <span>{Math.round(job.progress * 100)} %</span>
      </div>
    </div>
  );
}

function Waiting({ job }: { job: Job }) {
  return (
    <div className={jobCss.callout} data-tone="grey" role="status" data-testid="waiting">
      {job.message === null
        ? `The job waits for the machine ${job.machine}.`
        : renderText(job.message)}
      <Hint message={job.message} />
    </div>
  );
}

/** The hint of a message, if it has one. */
function Hint({ message }: { message: Job["message"] }) {
  const hint = message === null ? "" : renderHint(message);
  return hint === "" ? null : <div className={css.hint}>{hint}</div>;
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
        aria-label="Progress of the job on the table"
        data-testid="run-progress"
      />
      <div className={css.runFigures}>
        <span>
          {Math.round(job.progress * 100)} % done
          {job.copies > 1 &&
            ` · copy ${Math.min(job.copies_done + 1, job.copies)} of ${job.copies}`}
        </span>
        <span>
          program line {job.line.toLocaleString("en")} of {job.lines.toLocaleString("en")}
        </span>
        <span data-testid="time-left">{left === null ? "" : `${formatDuration(left)} left`}</span>
      </div>
    </div>
  );
}

function Outcome({ job }: { job: Job }) {
  const { data: edges } = useEdges();
  const zoomToEdges = useUiStore((ui) => ui.zoomToEdges);
  if (job.state === "done") {
    return (
      <div className={jobCss.callout} data-tone="green" data-testid="done" role="status">
        <div className={verdictCss.verdictHead}>
          <IconCircleCheckFilled size={20} color="var(--good)" aria-hidden />
          <span className={verdictCss.verdictTitle}>
            {pluralize(job.copies, "copy", "copies")} finished
          </span>
        </div>
        <div className={css.hint}>The table is free for the next job.</div>
      </div>
    );
  }
  // WaitsAtMachine shows what the job waits for, and VerdictCard the shortfalls of its program.
  if (job.waiting_for !== "" || waitsAtMachine(job) || job.actions.includes("accept")) return null;
  const fallback = job.state === "cancelled" ? "The job was cancelled." : "";
  const text = job.message === null ? fallback : renderText(job.message);
  if (text === "") return null;
  const { tone } = STATE_STYLES[job.state];
  const rows = edges === undefined ? [] : concernedRows(edges, job);
  return (
    <div
      className={jobCss.callout}
      data-tone={tone === "red" || tone === "amber" ? tone : "grey"}
      data-testid="reason"
      role={tone === "red" ? "alert" : "status"}
    >
      {text}
      <Hint message={job.message} />
      {rows.length > 0 && (
        <Button mt={8} size="compact-xs" variant="default" onClick={() => zoomToEdges(rows)}>
          Show {pluralize(rows.length, "edge")} in the drawing
        </Button>
      )}
    </div>
  );
}

const LOOKS: Readonly<
  Record<
    OfficeCommand,
    { title: string; icon: ReactNode; colour: string; variant: string; testId: string }
  >
> = {
  release: {
    title: "Send job to machine",
    icon: <IconSend2 size={17} />,
    colour: "blue",
    variant: "filled",
    testId: "send",
  },
  recompile: {
    title: "Compile job again",
    icon: <IconRefresh size={16} />,
    colour: "blue",
    variant: "filled",
    testId: "recompile",
  },
  hold: {
    title: "Pause job",
    icon: <IconPlayerPauseFilled size={16} />,
    colour: "yellow",
    variant: "light",
    testId: "hold",
  },
  cancel: {
    title: "Cancel job",
    icon: <IconPlayerStopFilled size={16} />,
    colour: "red",
    variant: "subtle",
    testId: "cancel",
  },
  finish: {
    title: "Mark job as finished",
    icon: <IconCheck size={16} />,
    colour: "green",
    variant: "light",
    testId: "finish",
  },
  recheck: {
    title: "Let the machine try again",
    icon: <IconRefresh size={16} />,
    colour: "blue",
    variant: "light",
    testId: "recheck",
  },
  requeue: {
    title: "Queue job again",
    icon: <IconRefresh size={16} />,
    colour: "blue",
    variant: "filled",
    testId: "requeue",
  },
  scrap: {
    title: "End job, board is scrap",
    icon: <IconTrash size={16} />,
    colour: "red",
    variant: "subtle",
    testId: "scrap",
  },
};

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
  const [asking, setAsking] = useState<OfficeCommand | null>(null);
  const words = commandsOf(job);
  // The job may change while the dialog is open: close it when the command is no longer possible.
  const open = asking !== null && words.includes(asking) ? confirmationBefore(job, asking) : null;
  if (words.length === 0) return null;
  const refused = words.find((word) => reasonAgainst(word) !== null);
  const send = (word: OfficeCommand) => {
    if (confirmationBefore(job, word) === null) void command(job.id, word);
    else setAsking(word);
  };
  return (
    <div style={{ display: "flex", flexWrap: "wrap", gap: 8 }}>
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
        <p className={css.note} style={{ flexBasis: "100%", margin: 0 }} data-testid="role-reason">
          {`${LOOKS[refused].title}: ${reasonAgainst(refused)}`}
        </p>
      )}
    </div>
  );
}
