/** The queues of the machines in the order in which they run, then the jobs in no queue. */

import { Progress, Text } from "@mantine/core";
import { useEffect, useState } from "react";
import type { Job } from "../../api/client";
import { translate } from "../../language/translate";
import { errorText } from "../../messages/translateMessage";
import { formatAgo, formatDuration } from "../../state/format";
import { isCompiling, isFinal, isQueued } from "../../state/job/jobs";
import { useBoardTitle, useJobs, useMachines } from "../../state/queries";
import { showDrawing } from "../../state/routes";
import { useUiStore } from "../../state/store";
import { secondsOf } from "../../state/times";
import { AskOperator } from "../accounts/OperatorForm";
import { OrderLine } from "../order/OrderDetails";
import css from "../shared/panels.module.css";
import { Name, Note } from "../shared/parts";
import { Section } from "../shared/Section";
import { ShowMore } from "../shared/ShowMore";
import { MachineQueue } from "./MachineQueue";
import { StateBadge } from "./StateBadge";

/** Rows listed at once. */
const STEP = 30;

/** Sort key of a job; jobs with the same key are sorted by age, newest first. */
function sortKey(job: Job): number {
  return isFinal(job) ? 1 : 0;
}

export function QueuePanel() {
  const list = useJobs();
  const { data: jobs, error } = list;
  const [limit, setLimit] = useState(STEP);
  const [now, setNow] = useState(() => Date.now() / 1000);
  useEffect(() => {
    const timer = setInterval(() => setNow(Date.now() / 1000), 30_000);
    return () => clearInterval(timer);
  }, []);
  const listed = (jobs ?? [])
    .filter((job) => !isQueued(job))
    .sort((a, b) => sortKey(a) - sortKey(b) || b.created.localeCompare(a.created));
  const { data: machines } = useMachines();
  const chosen = useUiStore((ui) => ui.machine) ?? machines?.[0]?.name;
  const queues = new Set((jobs ?? []).filter(isQueued).map(({ machine }) => machine));
  if (chosen !== undefined) queues.add(chosen);
  return (
    <>
      {jobs?.some(isQueued) && <AskOperator />}
      {[...queues].map((name) => (
        <MachineQueue
          key={name}
          machine={name}
          title={machines?.find((machine) => machine.name === name)?.title || name}
        />
      ))}
      <Section title={translate("queuePanel.otherJobs")} flush>
        <div data-testid="other-jobs">
          {error && <Note>{errorText(error)}</Note>}
          {listed.slice(0, limit).map((job) => (
            <Row key={job.id} job={job} now={now} />
          ))}
          {jobs !== undefined && jobs.length === 0 && (
            <Note style={{ padding: "0 8px", margin: "0 0 8px" }}>
              {translate("queuePanel.thereAreNoJobsYet")}
            </Note>
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
    </>
  );
}

function Row({ job, now }: { job: Job; now: number }) {
  const current = useUiStore((ui) => ui.job === job.id);
  const board = useBoardTitle(job.board);
  const moving = isCompiling(job);
  return (
    <button
      type="button"
      className={css.pick}
      style={{ flexWrap: "wrap", alignItems: "center" }}
      aria-current={current}
      onClick={() => showDrawing(job.drawing, job.id)}
      data-testid="queue-row"
    >
      <Name>{job.drawing_name}</Name>
      <StateBadge job={job} />
      <Text
        span
        flex="1 0 55%"
        fz={11.5}
        c="ink.3"
      >{`${board}${job.copies > 1 ? ` · ${translate("queuePanel.copies", { copies: job.copies })}` : ""} · ${formatAgo(secondsOf(job.updated), now)}`}</Text>
      <Text span fz={11.5} c="ink.3">
        {job.seconds > 0
          ? translate("queuePanel.machineTime", { seconds: formatDuration(job.seconds) })
          : ""}
      </Text>
      <OrderLine job={job} now={now} />
      {moving && (
        <Progress
          flex="1 0 100%"
          value={job.progress * 100}
          size={3}
          color="blue"
          aria-label={translate("queuePanel.progressOf", { drawingName: job.drawing_name })}
        />
      )}
    </button>
  );
}
