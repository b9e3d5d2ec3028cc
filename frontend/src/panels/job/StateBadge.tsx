/** Badge with the state of a job. */

import { Badge, type MantineSize } from "@mantine/core";
import type { Job } from "../../api/jobs";
import { stateStyleOf } from "../../state/job/jobs";
import { BADGE_COLOURS } from "../shared/parts";

interface Props {
  readonly job: Job;
  readonly testId?: string;
  readonly size?: MantineSize;
}

export function StateBadge({ job, testId, size = "md" }: Props) {
  const { title, tone } = stateStyleOf(job);
  return (
    <Badge
      component="span"
      size={size}
      color={BADGE_COLOURS[tone]}
      data-testid={testId}
      data-state={job.state}
      flex="none"
      miw="max-content"
    >
      {title}
    </Badge>
  );
}
