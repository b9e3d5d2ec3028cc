/** The verdict of the verification: accepted or refused, figures and findings. */

import {
  IconAlertOctagonFilled,
  IconAlertTriangleFilled,
  IconInfoCircle,
  IconRosetteDiscountCheckFilled,
  IconRulerMeasure,
  IconStopwatch,
} from "@tabler/icons-react";
import { type ReactNode, useState } from "react";
import type { Finding, Job, VerdictSummary } from "../../api/client";
import { formatNumber } from "../../language/numbers";
import { translate } from "../../language/translate";
import { messageText } from "../../messages/translateMessage";
import { UNCUT } from "../../state/drawing/palette";
import {
  formatArea,
  formatBytes,
  formatDeviation,
  formatDuration,
  formatHundredths,
  formatLength,
} from "../../state/format";
import { type FigureUnit, PROGRAM_FACT_LINES, PROGRAM_FIGURE_LINES } from "../../state/job/figures";
import { useVerdict } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { Permitted } from "../accounts/Permitted";
import css from "../shared/panels.module.css";
import { AcceptForm } from "./AcceptForm";
import verdictCss from "./verdict.module.css";

const SHOWN = 100;
/** Half the side of the zoom box: at least (mm), and relative to the size of the area. */
const MIN_VIEW = 8;
const VIEW = 2;

/** How a figure is shown, by its unit. */
const FORMATS: Readonly<Record<FigureUnit, (value: number) => string>> = {
  mm: formatHundredths,
  s: formatDuration,
  bytes: formatBytes,
  "": formatNumber,
};

export function VerdictCard({ job }: { job: Job }) {
  const { data: fullVerdict } = useVerdict();
  const { verdict } = job;
  if (verdict === null) return null;
  const findings = fullVerdict?.findings ?? [];
  return (
    <article
      className={verdictCss.verdict}
      data-accepted={verdict.accepted}
      data-faulty={isFaulty(verdict, findings)}
      data-testid="verdict"
      aria-label={translate("verdictCard.resultOfTheProgramCheck")}
    >
      <div className={verdictCss.verdictHead}>
        <span className={verdictCss.verdictIcon} style={{ display: "flex" }}>
          {verdict.accepted ? (
            <IconRosetteDiscountCheckFilled size={22} aria-hidden />
          ) : isFaulty(verdict, findings) ? (
            <IconAlertOctagonFilled size={22} aria-hidden />
          ) : (
            <IconAlertTriangleFilled size={22} aria-hidden />
          )}
        </span>
        <span className={verdictCss.verdictTitle}>{title(verdict, findings)}</span>
      </div>
      <Deviation verdict={verdict} />
      <dl className={verdictCss.figures} style={{ marginBottom: 0 }}>
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
        <div>
          <dt>{translate("verdictCard.machineTime")}</dt>
          <dd>{formatDuration(verdict.seconds)}</dd>
        </div>
        {PROGRAM_FIGURE_LINES.map(({ name, title, unit }) => {
          const value = verdict[name] ?? 0;
          return value === 0 ? null : (
            <div key={name} data-testid={`figure-${name}`}>
              <dt>{messageText(title)}</dt>
              <dd>{FORMATS[unit](value)}</dd>
            </div>
          );
        })}
        {PROGRAM_FACT_LINES.map(({ name, unit }) =>
          job[name] === 0 ? null : (
            <div key={name} data-testid={`fact-${name}`}>
              <dt>{translate(`fact.${name}`)}</dt>
              <dd>{FORMATS[unit](job[name])}</dd>
            </div>
          ),
        )}
      </dl>
      <div className={verdictCss.notes}>
        <Unreached verdict={verdict} />
        <UnreachedEdges verdict={verdict} />
        <WideSlits verdict={verdict} />
        <Saved verdict={verdict} />
      </div>
      {findings.length > 0 && (
        <div className={verdictCss.findings} data-testid="findings">
          {findings.slice(0, SHOWN).map((finding, at) => (
            // biome-ignore lint/suspicious/noArrayIndexKey: two findings may read alike
            <Row key={at} finding={finding} />
          ))}
          {findings.length > SHOWN && (
            <p className={css.note} style={{ padding: "0 8px" }}>
              {translate("verdictCard.andMoreFindings", { findings: findings.length - SHOWN })}
            </p>
          )}
        </div>
      )}
      {job.actions.includes("accept") && (
        <Permitted request="POST /api/v1/jobs/{id}/exceptions">
          <AcceptForm job={job} findings={findings} />
        </Permitted>
      )}
    </article>
  );
}

/** Heading of the card: whether the program matches the drawing, and otherwise why not. */
function title(verdict: VerdictSummary, findings: readonly Finding[]): string {
  if (verdict.accepted)
    return verdict.exceptions === 0
      ? translate("verdictCard.programMatchesTheDrawing")
      : translate("verdictCard.programMatchesTheDrawingExcept", { exceptions: verdict.exceptions });
  return isFaulty(verdict, findings)
    ? translate("verdictCard.programHasErrorsAndCannot")
    : translate("verdictCard.toolCannotMakeEveryLine");
}

/** Whether a program is refused for more than shortfalls. */
const isFaulty = (verdict: VerdictSummary, findings: readonly Finding[]): boolean =>
  !verdict.accepted &&
  (findings.length === 0 || findings.some((finding) => finding.severity === "fault"));

/** Icon and name of each severity. */
const SEVERITIES: Readonly<Record<Finding["severity"], { icon: ReactNode; name: string }>> = {
  fault: {
    icon: <IconAlertOctagonFilled size={15} aria-hidden />,
    name: translate("verdictCard.error"),
  },
  shortfall: {
    icon: <IconAlertTriangleFilled size={15} aria-hidden />,
    name: translate("verdictCard.shortfall"),
  },
  note: { icon: <IconInfoCircle size={15} aria-hidden />, name: translate("verdictCard.note") },
};

/** Edges that the tool cannot reach. */
function UnreachedEdges({ verdict }: { verdict: VerdictSummary }) {
  if (verdict.unreached_distance <= 0) return null;
  return (
    <KindRow kind="unreached">
      {translate("verdictCard.ofTheCutLinesCannot", {
        unreachedLength: formatLength(verdict.unreached_length),
        unreachedDistance: formatHundredths(verdict.unreached_distance),
      })}
    </KindRow>
  );
}

/** Slits that become as wide as the tool. */
function WideSlits({ verdict }: { verdict: VerdictSummary }) {
  if (verdict.slit_places === 0) return null;
  return (
    <KindRow kind="kerf">
      {translate("verdictCard.inSlitsBecomeAsWide", {
        slitLength: formatLength(verdict.slit_length),
        slitPlaces: verdict.slit_places,
      })}
    </KindRow>
  );
}

/** Row about all findings of one kind; a click zooms to their edges. */
function KindRow({ kind, children }: { kind: string; children: ReactNode }) {
  const { data: fullVerdict } = useVerdict();
  const zoomToEdges = useUiStore((ui) => ui.zoomToEdges);
  const zoom = () => {
    const own = (fullVerdict?.findings ?? []).filter((finding) => finding.kind === kind);
    if (own.length > 0) zoomToEdges(own.flatMap(edgesOf));
  };
  return (
    <button
      type="button"
      className={verdictCss.noteRow}
      onClick={zoom}
      data-testid={`kind-${kind}`}
    >
      <IconRulerMeasure size={15} style={{ flex: "none", marginTop: 1 }} aria-hidden />
      <span>{children}</span>
    </button>
  );
}

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
    <button
      type="button"
      className={verdictCss.noteRow}
      onClick={zoomToNext}
      data-testid="unreached"
    >
      <span className={verdictCss.noteArea} style={{ color: UNCUT, background: `${UNCUT}66` }} />
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
    <div className={verdictCss.noteRow} data-testid="saved">
      <IconStopwatch size={15} style={{ flex: "none", marginTop: 1 }} aria-hidden />
      <span>
        {translate("verdictCard.liftingTheToolOnlyAs", {
          retracted: formatDuration(retracted - verdict.seconds),
          share,
        })}
      </span>
    </div>
  );
}

function Deviation({ verdict }: { verdict: VerdictSummary }) {
  const share = verdict.tolerance > 0 ? verdict.deviation / verdict.tolerance : 0;
  const within = share <= 1;
  return (
    <div style={{ marginTop: 12 }}>
      <div className={css.runFigures} style={{ margin: 0 }}>
        <span>{translate("verdictCard.largestDeviationFromTheDrawing")}</span>
        <span style={{ color: "var(--ink-0)", fontWeight: 600 }} data-testid="deviation">
          {formatDeviation(verdict.deviation)}
        </span>
      </div>
      <div className={verdictCss.gauge} aria-hidden="true">
        <div
          style={{
            width: `${Math.min(100, share * 100)}%`,
            background: within ? "var(--good)" : "var(--bad)",
          }}
        />
      </div>
      <div className={css.note} style={{ textAlign: "right", fontSize: 11 }}>
        {translate("verdictCard.isTheLargestAllowedDeviation", {
          tolerance: formatDeviation(verdict.tolerance),
        })}
      </div>
    </div>
  );
}

function Row({ finding }: { finding: Finding }) {
  const zoomToEdges = useUiStore((ui) => ui.zoomToEdges);
  return (
    <button
      type="button"
      className={verdictCss.finding}
      disabled={finding.edge < 0}
      onClick={() => zoomToEdges(edgesOf(finding))}
      data-severity={finding.severity}
      data-testid="finding"
    >
      <span className={verdictCss.severity}>{SEVERITIES[finding.severity].icon}</span>
      <span>
        <b className={verdictCss.severity}>{SEVERITIES[finding.severity].name}</b>
        {" · "}
        {place(finding)}
        {messageText(finding)}
        {finding.acceptance && (
          <em className={verdictCss.acceptance} data-testid="acceptance">
            {translate("verdictCard.acceptedBy", {
              by: finding.acceptance.by,
              reason: finding.acceptance.reason,
            })}
          </em>
        )}
      </span>
    </button>
  );
}

/** The edges that the tool makes as one with that of a finding, such as the chords of a curve. */
const edgesOf = ({ edge, edges }: Finding): readonly number[] =>
  edges.length > 0 ? edges : [edge];

/** Edge and line of a finding, to put in front of its text. */
function place(finding: Finding): string {
  const parts = [
    ...(finding.edge >= 0 ? [translate("verdictCard.edge", { edge: finding.edge })] : []),
    ...(finding.line >= 0 ? [translate("verdictCard.programLine", { line: finding.line })] : []),
  ].join(", ");
  return parts && `${parts.charAt(0).toUpperCase()}${parts.slice(1)}: `;
}
