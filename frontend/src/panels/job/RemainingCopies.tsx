/** Orders the copies of a stopped batch that no job makes. */

import { Button, Stack, Text } from "@mantine/core";
import { IconCopy } from "@tabler/icons-react";
import type { Job } from "../../api/jobs";
import { translate } from "../../language/translate";
import { continueJob } from "../../state/actions";
import { REMAINING_COPIES, remainingText } from "../../state/job/rest";
import { useUiStore } from "../../state/store";
import css from "../shared/panels.module.css";

/** Nothing is shown if no copies remain. */
export function RemainingCopies({ job }: { job: Job }) {
  const busy = useUiStore((ui) => ui.busy);
  if (job.remaining_copies === 0) return null;
  return (
    <Stack gap={8} className={css.callout} data-tone="amber" data-testid="remaining-copies">
      <Text component="div" fz={15}>
        {remainingText(job)}
      </Text>
      {job.state !== "interrupted" && (
        <Button
          size="md"
          mih={44}
          leftSection={<IconCopy size={16} aria-hidden />}
          disabled={busy}
          onClick={() => void continueJob(job.id, REMAINING_COPIES)}
          data-testid="order-remaining"
        >
          {translate("remainingCopies.queueTheRemainingCopies", {
            remainingCopies: job.remaining_copies,
          })}
        </Button>
      )}
    </Stack>
  );
}
