/** The jobs of a drawing, newest first; a click opens one. */

import { Progress, Text } from "@mantine/core";
import { useEffect, useState } from "react";
import type { Job } from "../../api/jobs";
import { translate } from "../../language/translate";
import { formatAgo, formatDuration } from "../../state/format";
import { isCompiling } from "../../state/job/jobs";
import { useBoardTitle, useJobsOf } from "../../state/queries";
import { showDrawing } from "../../state/routes";
import { secondsOf } from "../../state/times";
import { OrderLine } from "../order/OrderDetails";
import css from "../shared/panels.module.css";
import { Figure, Name } from "../shared/parts";
import { Section } from "../shared/Section";
import { StateBadge } from "./StateBadge";

interface Props {
  readonly drawing: string;
  /** Id of the open job, "" without one. */
  readonly open: string;
}

export function JobsOfDrawing({ drawing, open }: Props) {
  const { data: jobs = [] } = useJobsOf(drawing);
  const [now, setNow] = useState(() => Date.now() / 1000);
  useEffect(() => {
    const timer = setInterval(() => setNow(Date.now() / 1000), 30_000);
    return () => clearInterval(timer);
  }, []);
  const others = jobs.filter(({ id }) => id !== open);
  if (others.length === 0) return null;
  return (
    <Section
      title={translate("jobsOfDrawing.otherJobsOfThisDrawing")}
      aside={<Figure>{others.length}</Figure>}
      flush
    >
      <div data-testid="other-jobs">
        {others.map((job) => (
          <Row key={job.id} job={job} now={now} />
        ))}
      </div>
    </Section>
  );
}

function Row({ job, now }: { job: Job; now: number }) {
  const board = useBoardTitle(job.board);
  const moving = isCompiling(job);
  return (
    <button
      type="button"
      className={css.pick}
      style={{ flexWrap: "wrap", alignItems: "center" }}
      onClick={() => showDrawing(job.drawing, job.id, "check")}
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
