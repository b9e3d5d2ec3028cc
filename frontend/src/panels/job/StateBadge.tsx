/** Badge with the state of a job. */

import type { Job } from "../../api/client";
import { stateStyleOf } from "../../state/job/jobs";
import css from "../shared/panels.module.css";

export function StateBadge({ job, testId }: { job: Job; testId?: string }) {
  const { title, tone } = stateStyleOf(job);
  return (
    <span className={css.badge} data-tone={tone} data-testid={testId} data-state={job.state}>
      {title}
    </span>
  );
}
