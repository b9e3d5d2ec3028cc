/** Statistics of machines and periods, with bars of the copies. */

import { SegmentedControl } from "@mantine/core";
import { useState } from "react";
import type { Statistics } from "../api/client";
import { errorText } from "../messages/render";
import { formatDuration, formatMetres, pluralize } from "../state/format";
import { useBoardTitles, useMachines, useStatistics } from "../state/queries";
import css from "./history.module.css";

const STEPS = [
  { value: "day", label: "Days" },
  { value: "week", label: "Weeks" },
  { value: "month", label: "Months" },
] as const;
type Step = (typeof STEPS)[number]["value"];

/** Days that are shown for each step. */
const SHOWN: Readonly<Record<Step, number>> = { day: 31, week: 182, month: 731 };

const LINE_TYPES: Readonly<Record<string, string>> = {
  cut: "cut",
  crease: "creased",
  "v-groove": "grooved",
  perforation: "perforated",
  "half-cut": "half-cut",
  combi: "cut and creased",
};

function periodText(start: string, step: Step): string {
  const date = new Date(start);
  if (step === "month") return date.toLocaleDateString([], { month: "long", year: "numeric" });
  const text = date.toLocaleDateString([], { day: "numeric", month: "short" });
  return step === "week" ? `Week of ${text}` : text;
}

export function StatisticsView({ machine }: { machine: string }) {
  const [step, setStep] = useState<Step>("week");
  // Rounded to hours, so that the same period is the same request.
  const since = Math.floor(Date.now() / 3.6e6) * 3600 - SHOWN[step] * 86_400;
  const { data, error } = useStatistics({ machine, step, since });
  const { data: machines } = useMachines();
  const names = [...new Set((data ?? []).map((row) => row.machine))];
  return (
    <>
      <div className={css.filters}>
        <SegmentedControl
          style={{ gridColumn: "1 / -1" }}
          value={step}
          onChange={(value) => setStep(value as Step)}
          data={[...STEPS]}
          aria-label="Length of a period"
        />
      </div>
      {error && <p className={css.note}>{errorText(error)}</p>}
      {data !== undefined && data.length === 0 && (
        <p className={css.note}>No job has run on a machine in this time.</p>
      )}
      {names.map((name) => (
        <section key={name} className={css.card} data-testid="statistics">
          <h2>{machines?.find((one) => one.name === name)?.title || name}</h2>
          <Periods rows={(data ?? []).filter((row) => row.machine === name)} step={step} />
        </section>
      ))}
    </>
  );
}

/** One row per period, newest first; the bar is its share of the greatest number of copies. */
function Periods({ rows, step }: { rows: readonly Statistics[]; step: Step }) {
  const titleOf = useBoardTitles();
  const most = Math.max(1, ...rows.map(({ copies }) => copies));
  return (
    <ul className={css.periods}>
      {rows.toReversed().map((row) => (
        <li key={row.start} className={css.period}>
          <span className={css.when}>{periodText(row.start, step)}</span>
          <span className={css.track}>
            <span className={css.fill} style={{ width: `${(100 * row.copies) / most}%` }} />
            <span className={css.onBar}>
              {pluralize(row.copies, "copy", "copies")} · {pluralize(row.jobs, "job")} finished
            </span>
          </span>
          <dl className={css.figures}>
            <div>
              <dt>Sheets</dt>
              <dd>
                {Object.entries(row.sheets)
                  .map(([board, count]) => `${count} ${titleOf(board)}`)
                  .join(", ") || "–"}
              </dd>
            </div>
            <div>
              <dt>Length</dt>
              <dd>
                {Object.entries(row.lengths)
                  .map(([kind, metres]) => `${formatMetres(metres)} ${LINE_TYPES[kind] ?? kind}`)
                  .join(", ") || "–"}
              </dd>
            </div>
            <div>
              <dt>On the machine</dt>
              <dd>{formatDuration(row.seconds)}</dd>
            </div>
            <div data-bad={row.interruptions > 0}>
              <dt>Interrupted</dt>
              <dd>
                {row.interruptions} of {pluralize(row.runs, "run")} (
                {Math.round(row.interrupted_share * 100)} %)
              </dd>
            </div>
          </dl>
        </li>
      ))}
    </ul>
  );
}
