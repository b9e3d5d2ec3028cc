/** A job that goes on only at its machine: where, with which board and tools, and the way there. */

import { Anchor, Box, Group } from "@mantine/core";
import { IconArrowRight } from "@tabler/icons-react";
import type { Job } from "../../api/jobs";
import { translate } from "../../language/translate";
import { awaitsEnd } from "../../state/job/jobs";
import { sheetText } from "../../state/order/sheet";
import { useBoardTitle, useMachineTitles } from "../../state/queries";
import css from "../shared/panels.module.css";
import { StationNumber } from "../shared/parts";

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
  const machine = useMachineTitles()(job.machine);
  const board = useBoardTitle(job.board);
  return (
    <div
      className={css.callout}
      data-tone="amber"
      role="status"
      data-testid="waits-at-machine"
      data-waiting-for={job.waiting_for}
    >
      <div data-testid="waits-text">
        <b>{translate("waitsAtMachine.waitsForTheOperatorAt", { machine })}</b> {reasonOf(job)}
      </div>
      <Box component="dl" className={css.facts} mt={8}>
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
                <Group key={station} gap={8} mb={2} wrap="nowrap">
                  <StationNumber>{station}</StationNumber> {name}
                </Group>
              ))}
            </dd>
          </>
        )}
      </Box>
      <Anchor
        display="inline-flex"
        mih={32}
        mt={8}
        fw={600}
        style={{ alignItems: "center", gap: 6 }}
        href={`#/station/${encodeURIComponent(job.machine)}`}
        data-testid="to-station"
      >
        {translate("waitsAtMachine.stationOf", { machine })}{" "}
        <IconArrowRight size={16} aria-hidden />
      </Anchor>
    </div>
  );
}
