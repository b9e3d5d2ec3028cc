/** Statistics of machines and periods, with bars of the copies. */

import { Paper, SegmentedControl, SimpleGrid, Text, Title } from "@mantine/core";
import { type CSSProperties, useState } from "react";
import type { Statistics } from "../../api/machines";
import { formatDate } from "../../language/numbers";
import { translate } from "../../language/translate";
import { errorText } from "../../messages/translateMessage";
import { formatDuration, formatMetres } from "../../state/format";
import { useBoardTitles, useMachineTitles, useStatistics } from "../../state/queries";
import { Note } from "../shared/parts";
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
  const titleOf = useMachineTitles();
  const names = [...new Set((data ?? []).map((row) => row.machine))];
  return (
    <>
      <SegmentedControl
        fullWidth
        mb={12}
        value={step}
        onChange={(value) => setStep(value as Step)}
        data={[...STEPS]}
        aria-label={translate("statisticsView.lengthOfAPeriod")}
      />
      {error && (
        <Note py={32} fz={14} ta="center">
          {errorText(error)}
        </Note>
      )}
      {data !== undefined && data.length === 0 && (
        <Note py={32} fz={14} ta="center">
          {translate("statisticsView.noJobHasRunOn")}
        </Note>
      )}
      {names.map((name) => (
        <Paper key={name} component="section" radius={12} p={16} mb={14} data-testid="statistics">
          <Title order={2} fz={15} mb={10}>
            {titleOf(name)}
          </Title>
          <Periods rows={(data ?? []).filter((row) => row.machine === name)} step={step} />
        </Paper>
      ))}
    </>
  );
}

/** One row per period, newest first; the bar is its share of the greatest number of copies. */
function Periods({ rows, step }: { rows: readonly Statistics[]; step: Step }) {
  const titleOf = useBoardTitles();
  const most = Math.max(1, ...rows.map(({ copies }) => copies));
  return (
    <ul>
      {rows.toReversed().map((row) => (
        <li key={row.start} className={css.row}>
          <Text fw={550} mb={4}>
            {periodText(row.start, step)}
          </Text>
          <div
            className={css.bar}
            style={{ "--share": `${(100 * row.copies) / most}%` } as CSSProperties}
          >
            {`${translate("statisticsView.copies", { copies: row.copies })} · ${translate("statisticsView.jobsFinished", { jobs: row.jobs })}`}
          </div>
          <SimpleGrid
            component="dl"
            cols={{ base: 2, sm: 4 }}
            spacing={16}
            verticalSpacing={4}
            mt={6}
            fz={12.5}
          >
            <div>
              <Text component="dt" fz={11.5} c="ink.3">
                {translate("statisticsView.sheets")}
              </Text>
              <dd>
                {Object.entries(row.sheets)
                  .map(([board, count]) => `${count} ${titleOf(board)}`)
                  .join(", ") || "–"}
              </dd>
            </div>
            <div>
              <Text component="dt" fz={11.5} c="ink.3">
                {translate("statisticsView.length")}
              </Text>
              <dd>
                {Object.entries(row.lengths)
                  .map(([kind, metres]) => `${formatMetres(metres)} ${LINE_TYPES[kind] ?? kind}`)
                  .join(", ") || "–"}
              </dd>
            </div>
            <div>
              <Text component="dt" fz={11.5} c="ink.3">
                {translate("statisticsView.onTheMachine")}
              </Text>
              <dd>{formatDuration(row.seconds)}</dd>
            </div>
            <Text component="div" c={row.interruptions > 0 ? "var(--warn-ink)" : "ink.1"}>
              <Text component="dt" fz={11.5} c="ink.3">
                {translate("statisticsView.interrupted")}
              </Text>
              <dd>
                {translate("statisticsView.ofRuns", {
                  interruptions: row.interruptions,
                  runs: row.runs,
                  interruptedShare: Math.round(row.interrupted_share * 100),
                })}
              </dd>
            </Text>
          </SimpleGrid>
        </li>
      ))}
    </ul>
  );
}
