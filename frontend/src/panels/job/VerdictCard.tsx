/** The verdict of the verification: accepted or refused, figures and findings. */

import { Box, Flex, Group, Progress, Stack, Text } from "@mantine/core";
import {
  IconAlertOctagonFilled,
  IconAlertTriangleFilled,
  IconRosetteDiscountCheckFilled,
  IconStopwatch,
} from "@tabler/icons-react";
import { useState } from "react";
import type { Finding, Job, VerdictSummary } from "../../api/jobs";
import { translate } from "../../language/translate";
import { messageText } from "../../messages/translateMessage";
import { translucent, UNCUT } from "../../state/drawing/palette";
import { formatArea, formatDeviation, formatDuration, formatLength } from "../../state/format";
import { figureText, PROGRAM_FACT_LINES, PROGRAM_FIGURE_LINES } from "../../state/job/figures";
import { deviationOfOthers } from "../../state/job/findingKinds";
import { useVerdict } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { Permitted } from "../accounts/Permitted";
import css from "../shared/panels.module.css";
import { Figures, LinkButton, Note } from "../shared/parts";
import { AcceptForm } from "./AcceptForm";
import { FindingKinds } from "./FindingKinds";
import { FindingList } from "./FindingList";
import { ShowCompensation } from "./ShowCompensation";
import { OvercutClause, VerdictPlaces } from "./VerdictPlaces";

/** Half the side of the zoom box: at least (mm), and relative to the size of the area. */
const MIN_VIEW = 8;
const VIEW = 2;

export function VerdictCard({ job }: { job: Job }) {
  const { data: fullVerdict } = useVerdict();
  const { verdict } = job;
  if (verdict === null) return null;
  const findings = fullVerdict?.findings ?? [];
  const faults = findings.filter(({ severity }) => severity === "fault");
  const others = findings.filter(({ severity }) => severity !== "fault");
  return (
    <article
      className={css.callout}
      data-tone={verdict.accepted ? "green" : isFaulty(verdict, findings) ? "red" : "amber"}
      data-accepted={verdict.accepted}
      data-faulty={isFaulty(verdict, findings)}
      data-testid="verdict"
      aria-label={translate("verdictCard.resultOfTheProgramCheck")}
    >
      <Group gap={10} wrap="nowrap" align="flex-start">
        <Box component="span" display="flex" c="var(--tone)">
          {verdict.accepted ? (
            <IconRosetteDiscountCheckFilled size={22} aria-hidden />
          ) : isFaulty(verdict, findings) ? (
            <IconAlertOctagonFilled size={22} aria-hidden />
          ) : (
            <IconAlertTriangleFilled size={22} aria-hidden />
          )}
        </Box>
        <Text span c="ink.0" fz={14} fw={600} lh={1.4} data-testid="verdict-sentence">
          {title(verdict, findings, fullVerdict?.edge_deviation)}
          {isFaulty(verdict, findings) ? "." : <OvercutClause verdict={verdict} />}
          {job.actions.includes("accept") && (
            <>
              {" "}
              <LinkButton fz={14} onClick={focusAcceptance} data-testid="to-acceptance">
                {translate("verdictCard.acceptThem")}
              </LinkButton>
            </>
          )}
        </Text>
      </Group>
      <Stack gap={4} mt={8} mx={-6} fz={12.5}>
        <VerdictPlaces verdict={verdict} />
        <Unreached verdict={verdict} />
        <FindingKinds verdict={verdict} findings={findings} />
      </Stack>
      <ShowCompensation />
      {faults.length > 0 && <FindingList findings={faults} />}
      {job.actions.includes("accept") && (
        <Permitted request="POST /api/v1/jobs/{id}/exceptions">
          <AcceptForm job={job} findings={findings} />
        </Permitted>
      )}
      <dl className={css.pairs}>
        <div>
          <dt>{translate("verdictCard.machineTime")}</dt>
          <dd>{formatDuration(verdict.seconds)}</dd>
        </div>
      </dl>
      <details data-testid="verdict-details">
        <summary className={css.summary}>{translate("verdictCard.details")}</summary>
        <Saved verdict={verdict} />
        <Deviation verdict={verdict} />
        <dl className={css.pairs}>
          <div>
            <dt>{translate("verdictCard.longestOvercut")}</dt>
            <dd>{formatLength(verdict.overcut)}</dd>
          </div>
          <div>
            <dt>{translate("verdictCard.longestLengthLeftUncut")}</dt>
            <dd>{formatLength(verdict.uncut)}</dd>
          </div>
          <div>
            <dt>{translate("verdictCard.totalLengthLeftOutAs")}</dt>
            <dd>{formatLength(verdict.setback_total)}</dd>
          </div>
          {PROGRAM_FIGURE_LINES.map(({ name, title, unit }) => {
            const value = verdict[name] ?? 0;
            return value === 0 ? null : (
              <div key={name} data-testid={`figure-${name}`}>
                <dt>{messageText(title)}</dt>
                <dd>{figureText(value, unit)}</dd>
              </div>
            );
          })}
          {PROGRAM_FACT_LINES.map(({ name, unit }) =>
            job[name] === 0 ? null : (
              <div key={name} data-testid={`fact-${name}`}>
                <dt>{translate(`fact.${name}`)}</dt>
                <dd>{figureText(job[name], unit)}</dd>
              </div>
            ),
          )}
        </dl>
        {others.length > 0 && <FindingList findings={others} />}
      </details>
    </article>
  );
}

/** Heading of the card, without a full stop: how exactly it makes the drawing, or why not. */
function title(
  verdict: VerdictSummary,
  findings: readonly Finding[],
  deviations: readonly number[] | undefined,
): string {
  const figures = {
    deviation: formatDeviation(
      deviations === undefined ? verdict.deviation : deviationOfOthers(deviations, findings),
    ),
    seconds: formatDuration(verdict.seconds),
  };
  if (verdict.accepted)
    return verdict.exceptions === 0
      ? translate("verdictCard.cutsYourDrawing", figures)
      : translate("verdictCard.cutsYourDrawingExcept", {
          ...figures,
          exceptions: verdict.exceptions,
        });
  return isFaulty(verdict, findings)
    ? translate("verdictCard.programHasErrorsAndCannot")
    : translate("verdictCard.toolCannotMakeLines", {
        shortfalls: verdict.shortfalls,
        ...figures,
      });
}

/** Go from the sentence to the form with which its shortfalls are accepted. */
function focusAcceptance(): void {
  document.querySelector<HTMLElement>("[data-testid=accept-reason]")?.focus();
}

/** Whether a program is refused for more than shortfalls. */
const isFaulty = (verdict: VerdictSummary, findings: readonly Finding[]): boolean =>
  !verdict.accepted &&
  (findings.length === 0 || findings.some((finding) => finding.severity === "fault"));

/** Areas that the tool cannot reach; each click zooms to the next one, the largest first. */
function Unreached({ verdict }: { verdict: VerdictSummary }) {
  const { data: fullVerdict } = useVerdict();
  const [next, setNext] = useState(0);
  const zoomToBox = useUiStore((ui) => ui.zoomToBox);
  if (verdict.unreached_places === 0) return null;
  const zoomToNext = () => {
    const area = fullVerdict?.areas[next % fullVerdict.areas.length];
    if (area === undefined) return;
    const reach = Math.max(MIN_VIEW, VIEW * Math.sqrt(area.area));
    zoomToBox([area.x - reach, area.y - reach, area.x + reach, area.y + reach]);
    setNext(next + 1);
  };
  return (
    <button type="button" className={css.pick} onClick={zoomToNext} data-testid="unreached">
      <Box
        component="span"
        w={12}
        h={12}
        mt={3}
        flex="none"
        bdrs={3}
        bd="1.5px solid currentcolor"
        style={{ color: UNCUT, background: translucent(UNCUT, 40) }}
      />
      <span>
        {translate("verdictCard.inPlacesCannotBeReached", {
          unreached: formatArea(verdict.unreached),
          unreachedPlaces: verdict.unreached_places,
        })}
      </span>
    </button>
  );
}

/** Time saved by short lifts. */
function Saved({ verdict }: { verdict: VerdictSummary }) {
  const retracted = verdict.seconds_retracted ?? 0;
  const share = retracted <= 0 ? 0 : Math.round((1 - verdict.seconds / retracted) * 100);
  if (share < 1) return null;
  return (
    <Flex gap={8} mt={4} fz={12.5} data-testid="saved">
      <IconStopwatch size={15} style={{ flex: "none", marginTop: 1 }} aria-hidden />
      <span>
        {translate("verdictCard.liftingTheToolOnlyAs", {
          retracted: formatDuration(retracted - verdict.seconds),
          share,
        })}
      </span>
    </Flex>
  );
}

function Deviation({ verdict }: { verdict: VerdictSummary }) {
  const share = verdict.tolerance > 0 ? verdict.deviation / verdict.tolerance : 0;
  const within = share <= 1;
  return (
    <div style={{ marginTop: 12 }}>
      <Figures>
        <span>{translate("verdictCard.largestDeviationFromTheDrawing")}</span>
        <span style={{ color: "var(--ink-0)", fontWeight: 600 }} data-testid="deviation">
          {formatDeviation(verdict.deviation)}
        </span>
      </Figures>
      <Progress
        size={6}
        mt={8}
        mb={4}
        value={Math.min(100, share * 100)}
        color={within ? "var(--good)" : "var(--bad)"}
        aria-hidden
      />
      <Note component="div" ta="right" fz={11}>
        {translate("verdictCard.isTheLargestAllowedDeviation", {
          tolerance: formatDeviation(verdict.tolerance),
        })}
      </Note>
    </div>
  );
}
