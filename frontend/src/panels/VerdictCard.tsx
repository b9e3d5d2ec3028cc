/** The verdict: whether the program cuts what was drawn, in figures, and where it does not. */

import {
  IconAlertOctagonFilled,
  IconMapPin,
  IconRosetteDiscountCheckFilled,
} from "@tabler/icons-react";
import type { Finding, Job, VerdictSummary } from "../api/client";
import { useVerdict } from "../state/queries";
import { usePage } from "../state/store";
import { count, deviation, duration, length } from "../state/words";
import css from "./panels.module.css";

const SHOWN = 100;

export function VerdictCard({ job }: { job: Job }) {
  const { data: whole } = useVerdict();
  const { verdict } = job;
  if (verdict === null) return null;
  const findings = whole?.findings ?? [];
  return (
    <article
      className={css.verdict}
      data-accepted={verdict.accepted}
      data-testid="verdict"
      aria-label="Verdict"
    >
      <div className={css.verdictHead}>
        <span className={css.verdictIcon} style={{ display: "flex" }}>
          {verdict.accepted ? (
            <IconRosetteDiscountCheckFilled size={22} aria-hidden />
          ) : (
            <IconAlertOctagonFilled size={22} aria-hidden />
          )}
        </span>
        <span className={css.verdictTitle}>
          {verdict.accepted ? "Verified" : "Refused by verification"}
        </span>
      </div>
      <Deviation verdict={verdict} />
      <dl className={css.figures} style={{ marginBottom: 0 }}>
        <div>
          <dt>Overcut</dt>
          <dd>{length(verdict.overcut)}</dd>
        </div>
        <div>
          <dt>Left uncut</dt>
          <dd>{length(verdict.uncut)}</dd>
        </div>
        <div>
          <dt>Machine time</dt>
          <dd>{duration(verdict.seconds)}</dd>
        </div>
      </dl>
      {findings.length > 0 && (
        <div className={css.findings} data-testid="findings">
          {findings.slice(0, SHOWN).map((finding, at) => (
            // biome-ignore lint/suspicious/noArrayIndexKey: two findings may read alike
            <Row key={at} finding={finding} />
          ))}
          {findings.length > SHOWN && (
            <p className={css.note} style={{ padding: "0 8px" }}>
              … and {count(findings.length - SHOWN, "more finding")}.
            </p>
          )}
        </div>
      )}
    </article>
  );
}

function Deviation({ verdict }: { verdict: VerdictSummary }) {
  const share = verdict.tolerance > 0 ? verdict.deviation / verdict.tolerance : 0;
  const within = share <= 1;
  return (
    <div style={{ marginTop: 12 }}>
      <div className={css.runFigures} style={{ margin: 0 }}>
        <span>Farthest from the line</span>
        <span style={{ color: "var(--ink-0)", fontWeight: 600 }} data-testid="deviation">
          {deviation(verdict.deviation)}
        </span>
      </div>
      <div className={css.gauge} aria-hidden="true">
        <div
          style={{
            width: `${Math.min(100, share * 100)}%`,
            background: within ? "var(--good)" : "var(--bad)",
          }}
        />
      </div>
      <div className={css.note} style={{ textAlign: "right", fontSize: 11 }}>
        {deviation(verdict.tolerance)} allowed
      </div>
    </div>
  );
}

function Row({ finding }: { finding: Finding }) {
  const look = usePage((page) => page.look);
  return (
    <button
      type="button"
      className={css.finding}
      disabled={finding.edge < 0}
      onClick={() => look([finding.edge])}
      data-testid="finding"
    >
      <IconMapPin size={15} style={{ flex: "none", marginTop: 1 }} aria-hidden />
      <span>{finding.text}</span>
    </button>
  );
}
