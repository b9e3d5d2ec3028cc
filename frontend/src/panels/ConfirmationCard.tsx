/** Board and tools that the operator has to check and confirm before a job starts. */

import { Button } from "@mantine/core";
import { IconPlayerPlayFilled } from "@tabler/icons-react";
import { useQuery } from "@tanstack/react-query";
import type { Job } from "../api/client";
import { renderHint, renderText } from "../messages/render";
import { confirmJob } from "../state/actions";
import { checksKey } from "../state/checks";
import { queries, useBoards } from "../state/queries";
import { sheetText } from "../state/sheet";
import { useUiStore } from "../state/store";
import { useWornTools } from "../state/wornTools";
import jobCss from "./job.module.css";
import { Permitted } from "./Permitted";
import css from "./panels.module.css";
import { WornTools } from "./WornTools";

const CHECKS: Readonly<Record<string, string>> = {
  "waiting.for-start":
    "The job waits for the operator. Check that the table is clear, and that board and tools are as listed below.",
  "waiting.unconfirmed-run":
    "The job was started without the confirmation of the operator. Check that board and tools are as listed below, then confirm the job.",
};

function buttonOf(job: Job): string {
  if (job.waiting_for === "sheet") return "New sheet is on the table: start next copy";
  if (job.is_rest && job.state === "queued") return "Sheet is in place: continue cutting";
  return job.state === "queued" ? "Table is ready: start machine" : "Table is ready: continue job";
}

/** What to check, without board and tools, which the card lists. */
function textOf({ message, waiting_for }: Job): string {
  if (message === null) return "";
  return waiting_for === "confirmation" && message.code in CHECKS
    ? (CHECKS[message.code] ?? "")
    : renderText(message);
}

export function ConfirmationCard({ job }: { job: Job }) {
  const { data: boards } = useBoards();
  const busy = useUiStore((ui) => ui.busy);
  const copy = checksKey(job);
  const { data: asked } = useQuery(queries.confirmation(job.id, copy));
  const wornTools = useWornTools(asked, copy);
  const { decision } = wornTools;
  const hint = job.message === null ? "" : renderHint(job.message);
  const board = boards?.find(({ name }) => name === job.board);
  return (
    <div
      className={jobCss.callout}
      data-tone="amber"
      role="status"
      data-testid="confirmation"
      data-waiting-for={job.waiting_for}
    >
      <div data-testid="waiting">{textOf(job)}</div>
      <dl className={jobCss.setUp}>
        <dt>Board on the table</dt>
        <dd>
          {board?.title || job.board}
          {job.copies > 1 && ` · copy ${job.copies_done + 1} of ${job.copies}`}
          {job.sheet && <div data-testid="confirm-sheet">Sheet {sheetText(job.sheet)}</div>}
        </dd>
        {job.tools.length > 0 && (
          <>
            <dt>Tools in the stations</dt>
            <dd>
              {job.tools.map(({ station, name }) => (
                <div key={station} className={jobCss.tool}>
                  <span className={jobCss.stationNumber}>{station}</span> {name}
                </div>
              ))}
            </dd>
          </>
        )}
      </dl>
      <Permitted request="POST /api/v1/jobs/{id}/confirm">
        <WornTools tools={wornTools} />
        {hint !== "" && <div className={css.hint}>{hint}</div>}
        <Button
          fullWidth
          size="md"
          px="xs"
          color="green"
          mt={10}
          leftSection={<IconPlayerPlayFilled size={20} aria-hidden />}
          disabled={busy || decision === null}
          onClick={() => decision !== null && void confirmJob(job.id, decision)}
          data-testid="confirm"
        >
          {buttonOf(job)}
        </Button>
      </Permitted>
    </div>
  );
}
