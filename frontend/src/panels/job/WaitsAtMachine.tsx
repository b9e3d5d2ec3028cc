/** A job that goes on only at its machine: where, with which board and tools, and the way there. */

import { IconArrowRight } from "@tabler/icons-react";
import type { Job } from "../../api/client";
import { translate } from "../../language/translate";
import { awaitsEnd } from "../../state/job/jobs";
import { sheetText } from "../../state/order/sheet";
import { useBoardTitle, useMachines } from "../../state/queries";
import jobCss from "./job.module.css";

/** What the person at the machine decides. */
function reasonOf(job: Job): string {
  if (awaitsEnd(job)) return translate("waitsAtMachine.theOperatorStatesThereWhen");
  if (job.waiting_for === "sheet") {
    return translate("waitsAtMachine.copyOfIsFinishedThe", {
      copiesDone: job.copies_done,
      copies: job.copies,
    });
  }
  if (job.waiting_for === "confirmation") return translate("waitsAtMachine.tableBoardAndToolsAre");
  return translate("waitsAtMachine.theJobIsPausedAnd");
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
        <b>{translate("waitsAtMachine.waitsForTheOperatorAt", { machine })}</b> {reasonOf(job)}
      </div>
      <dl className={jobCss.setUp}>
        <dt>{translate("waitsAtMachine.boardOnTheTable")}</dt>
        <dd>
          {`${board}${job.copies > 1 ? ` · ${translate("waitsAtMachine.copyOf", { copiesDone: job.copies_done + 1, copies: job.copies })}` : ""}`}
          {job.sheet && (
            <div data-testid="needed-sheet">
              {translate("waitsAtMachine.sheet", { sheet: sheetText(job.sheet) })}
            </div>
          )}
        </dd>
        {job.tools.length > 0 && (
          <>
            <dt>{translate("waitsAtMachine.toolsInTheStations")}</dt>
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
        {translate("waitsAtMachine.stationOf", { machine })}{" "}
        <IconArrowRight size={16} aria-hidden />
      </a>
    </div>
  );
}
