/** All jobs: running first, then queued, then ready, then finished. */

import { Progress } from "@mantine/core";
import { useEffect, useState } from "react";
import type { Job } from "../api/client";
import { errorText } from "../messages/render";
import { formatAgo, formatDuration } from "../state/format";
import { isCompiling, isFinal, isOnTable, needsOperator } from "../state/jobs";
import { useBoards, useJobs } from "../state/queries";
import { useUiStore } from "../state/store";
import { ConfirmationCard } from "./ConfirmationCard";
import jobCss from "./job.module.css";
import css from "./panels.module.css";
import { Section } from "./Section";
import { ShowMore } from "./ShowMore";
import { StateBadge } from "./StateBadge";

/** Rows listed at once. */
const STEP = 30;

/** Sort key of a job; jobs with the same key are sorted by age, newest first. */
function sortKey(job: Job): number {
  if (isOnTable(job) || needsOperator(job) || job.state === "interrupted") return 0;
  if (job.state === "queued") return 1;
  return isFinal(job) ? 3 : 2;
}

export function QueuePanel() {
  const list = useJobs();
  const { data: jobs, error } = list;
  // The open job has its confirmation card in the job panel.
  const current = useUiStore((ui) => ui.job);
  const [limit, setLimit] = useState(STEP);
  const [now, setNow] = useState(() => Date.now() / 1000);
  useEffect(() => {
    const timer = setInterval(() => setNow(Date.now() / 1000), 30_000);
    return () => clearInterval(timer);
  }, []);
  const listed = [...(jobs ?? [])].sort((a, b) => sortKey(a) - sortKey(b) || b.created - a.created);
  const waiting = listed.filter(({ state }) => state === "queued").length;
  return (
    <Section
      title="All jobs"
      flush
      aside={<span className={css.rowFigure}>{waiting > 0 ? `${waiting} in the queue` : ""}</span>}
    >
      <div data-testid="queue">
        {error && <p className={css.note}>{errorText(error)}</p>}
        {listed.slice(0, limit).map((job) => (
          <div key={job.id}>
            <Row job={job} now={now} />
            {needsOperator(job) && job.id !== current && (
              <div className={jobCss.inRow}>
                <ConfirmationCard job={job} />
              </div>
            )}
          </div>
        ))}
        {jobs !== undefined && jobs.length === 0 && (
          <p className={css.note} style={{ padding: "0 8px", margin: "0 0 8px" }}>
            There are no jobs yet. To create a job, open a drawing and prepare its program.
          </p>
        )}
        {(listed.length > limit || list.hasNextPage) && (
          <ShowMore
            busy={list.isFetchingNextPage}
            act={() => {
              setLimit(limit + STEP);
              if (listed.length < limit + STEP && list.hasNextPage) void list.fetchNextPage();
            }}
          />
        )}
      </div>
    </Section>
  );
}

function Row({ job, now }: { job: Job; now: number }) {
  const open = useUiStore((ui) => ui.open);
  const current = useUiStore((ui) => ui.job === job.id);
  const { data: boards } = useBoards();
  const moving = isOnTable(job) || isCompiling(job);
  return (
    <button
      type="button"
      className={jobCss.jobRow}
      aria-current={current}
      onClick={() => open(job.drawing, job.id)}
      data-testid="queue-row"
    >
      <span className={css.rowName}>{job.drawing_name}</span>
      <StateBadge job={job} />
      <small>
        {boards?.find(({ name }) => name === job.board)?.title || job.board}
        {job.copies > 1 ? ` · ${job.copies} copies` : ""} · {formatAgo(job.updated, now)}
      </small>
      <small>{job.seconds > 0 ? `machine time ${formatDuration(job.seconds)}` : ""}</small>
      {moving && (
        <Progress
          className={jobCss.bar ?? ""}
          value={job.progress * 100}
          size={3}
          color={job.state === "held" ? "yellow" : "blue"}
          aria-label={`Progress of ${job.drawing_name}`}
        />
      )}
    </button>
  );
}
