/** Statistics of machines and periods, with bars of the copies. */

import { SegmentedControl } from "@mantine/core";
import { useState } from "react";
import type { Statistics } from "../../api/client";
import { formatDate } from "../../language/numbers";
import { translate } from "../../language/translate";
import { errorText } from "../../messages/translateMessage";
import { formatDuration, formatMetres } from "../../state/format";
import { useBoardTitles, useMachines, useStatistics } from "../../state/queries";
import css from "./history.module.css";

const STEPS = [
  { value: "day", label: translate("statisticsView.days") },
  { value: "week", label: translate("statisticsView.weeks") },
  { value: "month", label: translate("statisticsView.months") },
] as const;
type Step = (typeof STEPS)[number]["value"];

/** Days that are shown for each step. */
const SHOWN: Readonly<Record<Step, number>> = { day: 31, week: 182, month: 731 };

const LINE_TYPES: Readonly<Record<string, string>> = {
  cut: translate("statisticsView.cut"),
  crease: translate("statisticsView.creased"),
  "v-groove": translate("statisticsView.grooved"),
  perforation: translate("statisticsView.perforated"),
  "half-cut": translate("statisticsView.halfCut"),
  combi: translate("statisticsView.cutAndCreased"),
};

function periodText(start: string, step: Step): string {
  const date = new Date(start);
  if (step === "month") return formatDate(date, { month: "long", year: "numeric" });
  const text = formatDate(date, { day: "numeric", month: "short" });
  return step === "week" ? translate("statisticsView.weekOf", { text }) : text;
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
          aria-label={translate("statisticsView.lengthOfAPeriod")}
        />
      </div>
      {error && <p className={css.note}>{errorText(error)}</p>}
      {data !== undefined && data.length === 0 && (
        <p className={css.note}>{translate("statisticsView.noJobHasRunOn")}</p>
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
            <span
              className={css.onBar}
            >{`${translate("statisticsView.copies", { copies: row.copies })} · ${translate("statisticsView.jobsFinished", { jobs: row.jobs })}`}</span>
          </span>
          <dl className={css.figures}>
            <div>
              <dt>{translate("statisticsView.sheets")}</dt>
              <dd>
                {Object.entries(row.sheets)
                  .map(([board, count]) => `${count} ${titleOf(board)}`)
                  .join(", ") || "–"}
              </dd>
            </div>
            <div>
              <dt>{translate("statisticsView.length")}</dt>
              <dd>
                {Object.entries(row.lengths)
                  .map(([kind, metres]) => `${formatMetres(metres)} ${LINE_TYPES[kind] ?? kind}`)
                  .join(", ") || "–"}
              </dd>
            </div>
            <div>
              <dt>{translate("statisticsView.onTheMachine")}</dt>
              <dd>{formatDuration(row.seconds)}</dd>
            </div>
            <div data-bad={row.interruptions > 0}>
              <dt>{translate("statisticsView.interrupted")}</dt>
              <dd>
                {translate("statisticsView.ofRuns", {
                  interruptions: row.interruptions,
                  runs: row.runs,
                  interruptedShare: Math.round(row.interrupted_share * 100),
                })}
              </dd>
            </div>
          </dl>
        </li>
      ))}
    </ul>
  );
}
