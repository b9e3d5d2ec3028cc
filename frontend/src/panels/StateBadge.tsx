/** The state of a job, in a word and a tone. */

import type { Job } from "../api/client";
import { lookOf } from "../state/jobs";
import css from "./panels.module.css";

export function StateBadge({ job, testId }: { job: Job; testId?: string }) {
  const { title, tone } = lookOf(job);
  return (
    <span className={css.badge} data-tone={tone} data-testid={testId} data-state={job.state}>
      {title}
    </span>
  );
}
