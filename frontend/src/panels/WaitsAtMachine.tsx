/** A job that goes on only at its machine: where, with which board and tools, and the way there. */

import { IconArrowRight } from "@tabler/icons-react";
import type { Job } from "../api/client";
import { awaitsEnd } from "../state/jobs";
import { useBoardTitle, useMachines } from "../state/queries";
import { sheetText } from "../state/sheet";
import jobCss from "./job.module.css";

/** What the person at the machine decides. */
function reasonOf(job: Job): string {
  if (awaitsEnd(job)) return "The operator states there when the machine has finished.";
  if (job.waiting_for === "sheet") {
    return `Copy ${job.copies_done} of ${job.copies} is finished. The next one needs a new sheet.`;
  }
  if (job.waiting_for === "confirmation") return "Table, board and tools are checked there first.";
  return "The job is paused, and goes on from there.";
}

export function WaitsAtMachine({ job }: { job: Job }) {
  const { data: machines } = useMachines();
  const machine = machines?.find(({ name }) => name === job.machine)?.title || job.machine;
  const board = useBoardTitle(job.board);
  return (
    <div
      className={jobCss.callout}
      data-tone="amber"
      role="status"
      data-testid="waits-at-machine"
      data-waiting-for={job.waiting_for}
    >
      <div data-testid="waits-text">
        <b>Waits for the operator at {machine}.</b> {reasonOf(job)}
      </div>
      <dl className={jobCss.setUp}>
        <dt>Board on the table</dt>
        <dd>
          {board}
          {job.copies > 1 && ` · copy ${job.copies_done + 1} of ${job.copies}`}
          {job.sheet && <div data-testid="needed-sheet">Sheet {sheetText(job.sheet)}</div>}
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
      <a
        className={jobCss.wayToStation}
        href={`#/station/${encodeURIComponent(job.machine)}`}
        data-testid="to-station"
      >
        Station of {machine} <IconArrowRight size={16} aria-hidden />
      </a>
    </div>
  );
}
