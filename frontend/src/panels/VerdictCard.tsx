/** The verdict: whether the program cuts what was drawn, in figures, and where it does not. */

import {
  IconAlertOctagonFilled,
  IconMapPin,
  IconRosetteDiscountCheckFilled,
  IconStopwatch,
} from "@tabler/icons-react";
import { useState } from "react";
import type { Finding, Job, VerdictSummary } from "../api/client";
import { UNCUT } from "../state/palette";
import { useVerdict } from "../state/queries";
import { usePage } from "../state/store";
import { area, count, deviation, duration, length } from "../state/words";
import css from "./panels.module.css";
import verdictCss from "./verdict.module.css";

const SHOWN = 100;
/** Half the side of what is shown about a small place (mm), and of a large one, to its size. */
const LEAST_VIEW = 8;
const VIEW = 2;

export function VerdictCard({ job }: { job: Job }) {
  const { data: whole } = useVerdict();
  const { verdict } = job;
  if (verdict === null) return null;
  const findings = whole?.findings ?? [];
  return (
    <article
      className={verdictCss.verdict}
      data-accepted={verdict.accepted}
      data-testid="verdict"
      aria-label="Verdict"
    >
      <div className={verdictCss.verdictHead}>
        <span className={verdictCss.verdictIcon} style={{ display: "flex" }}>
          {verdict.accepted ? (
            <IconRosetteDiscountCheckFilled size={22} aria-hidden />
          ) : (
            <IconAlertOctagonFilled size={22} aria-hidden />
          )}
        </span>
        <span className={verdictCss.verdictTitle}>
          {verdict.accepted ? "Verified" : "Refused by verification"}
        </span>
      </div>
      <Deviation verdict={verdict} />
      <dl className={verdictCss.figures} style={{ marginBottom: 0 }}>
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
      <div className={verdictCss.told}>
        <Unreached verdict={verdict} />
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
              … and {count(findings.length - SHOWN, "more finding")}.
            </p>
          )}
        </div>
      )}
    </article>
  );
}

/** What the cutter does not get to; each click goes to another place, from the largest on. */
function Unreached({ verdict }: { verdict: VerdictSummary }) {
  const { data: whole } = useVerdict();
  const [next, setNext] = useState(0);
  const lookAt = usePage((page) => page.lookAt);
  if (verdict.unreached_places === 0) return null;
  const goThere = () => {
    const there = whole?.areas[next % whole.areas.length];
    if (there === undefined) return;
    const reach = Math.max(LEAST_VIEW, VIEW * Math.sqrt(there.area));
    lookAt([there.x - reach, there.y - reach, there.x + reach, there.y + reach]);
    setNext(next + 1);
  };
  return (
    <button type="button" className={verdictCss.toldRow} onClick={goThere} data-testid="unreached">
      <span className={verdictCss.toldArea} style={{ color: UNCUT, background: `${UNCUT}66` }} />
      <span>
        {area(verdict.unreached)} in {count(verdict.unreached_places, "place")} stay uncut: the
        cutter does not get there.
      </span>
    </button>
  );
}

/** What the short lifts are worth. */
function Saved({ verdict }: { verdict: VerdictSummary }) {
  const full = verdict.seconds_retracted ?? 0;
  const share = full <= 0 ? 0 : Math.round((1 - verdict.seconds / full) * 100);
  if (share < 1) return null;
  return (
    <div className={verdictCss.toldRow} data-testid="saved">
      <IconStopwatch size={15} style={{ flex: "none", marginTop: 1 }} aria-hidden />
      <span>
        Saves {share}
        {"\u202f"}% against full retracts: {(full - verdict.seconds).toFixed(1)}
        {"\u202f"}s.
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
        <span>Farthest from the line</span>
        <span style={{ color: "var(--ink-0)", fontWeight: 600 }} data-testid="deviation">
          {deviation(verdict.deviation)}
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
      className={verdictCss.finding}
      disabled={finding.edge < 0}
      onClick={() => look([finding.edge])}
      data-testid="finding"
    >
      <IconMapPin size={15} style={{ flex: "none", marginTop: 1 }} aria-hidden />
      <span>{finding.text}</span>
    </button>
  );
}
