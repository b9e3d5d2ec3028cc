/** The import report: what was kept, merged and dropped, and why; the lengths add up. */

import { SegmentedControl } from "@mantine/core";
import { IconChevronRight } from "@tabler/icons-react";
import { useState } from "react";
import type { Drawing, LedgerRow, ReportGroup } from "../api/client";
import type { Fate } from "../geometry/records";
import { useDrawing, useEdges, useLedger } from "../state/queries";
import { entitiesOf, FATES_SHOWN, groupsOf, rowsOfGroup, shares } from "../state/report";
import { rowsOfHandles } from "../state/rows";
import { usePage } from "../state/store";
import { count, length } from "../state/words";
import css from "./import.module.css";
import panels from "./panels.module.css";
import { Section } from "./Section";
import { ShowMore } from "./ShowMore";

type Report = NonNullable<Drawing["report"]>;

/** Entities that come at once. */
const STEP = 100;
const TITLES: Readonly<Record<Fate, string>> = {
  kept: "Kept",
  merged: "Merged",
  dropped: "Dropped",
};

export function ImportPanel() {
  const { data: drawing } = useDrawing();
  const [fate, setFate] = useState<Fate | null>(null);
  const report = drawing?.report;
  if (drawing === undefined || report === undefined || report === null) return null;
  const groups = groupsOf(report, fate);
  const lost = report.groups
    .filter((group) => group.fate === "dropped")
    .reduce((sum, group) => sum + group.count, 0);
  return (
    <Section
      title="Import report"
      aside={
        <span className={panels.rowFigure}>
          {lost > 0 ? `${lost.toLocaleString("en")} dropped` : "all kept"}
        </span>
      }
    >
      <Bar report={report} known={drawing.unit !== null} />
      <SegmentedControl
        fullWidth
        size="xs"
        mb={6}
        value={fate ?? "all"}
        onChange={(word) => setFate(FATES_SHOWN.find((one) => one === word) ?? null)}
        data={[
          { value: "all", label: "All" },
          ...FATES_SHOWN.map((word) => ({ value: word, label: TITLES[word] })),
        ]}
        aria-label="What became of it"
      />
      <div className={css.groups} data-testid="report-groups">
        {groups.map((group) => (
          <Group
            key={`${group.fate} ${group.what} ${group.reason}`}
            group={group}
            drawing={drawing}
          />
        ))}
        {groups.length === 0 && (
          <p className={panels.note} style={{ padding: "0 8px" }}>
            Nothing was {fate}.
          </p>
        )}
      </div>
    </Section>
  );
}

function Bar({ report, known }: { report: Report; known: boolean }) {
  const said = (value: number) =>
    known ? length(value) : value.toLocaleString("en", { maximumFractionDigits: 1 });
  return (
    <div className={css.sum} data-testid="report-bar">
      <div className={css.bar} role="img" aria-label="How the drawn length is shared out">
        {shares(report).map(({ fate, share }) =>
          share > 0 ? (
            <span key={fate} data-fate={fate} style={{ flexGrow: Math.max(share, 0.01) }} />
          ) : null,
        )}
      </div>
      <dl className={css.sums}>
        {shares(report).map(({ fate, length: run }) => (
          <div key={fate}>
            <dt>
              <span className={css.fate} data-fate={fate} />
              {TITLES[fate]}
            </dt>
            <dd>{said(run)}</dd>
          </div>
        ))}
        <div>
          <dt>Drawn</dt>
          <dd data-testid="report-drawn">{said(report.drawn)}</dd>
        </div>
      </dl>
    </div>
  );
}

function Group({ group, drawing }: { group: ReportGroup; drawing: Drawing }) {
  const { data: edges } = useEdges();
  const look = usePage((page) => page.look);
  const [open, setOpen] = useState(false);
  const lines = group.what === "edges";
  const words = group.reason === "" ? "Kept as it was drawn" : group.reason;
  const several = group.kinds.length > 0 && !lines;
  return (
    <div>
      <button
        type="button"
        className={css.group}
        aria-expanded={lines ? undefined : open}
        title={lines ? "Show these edges" : "List them"}
        data-testid={`report-${group.fate}`}
        onClick={() => {
          if (!lines) setOpen(!open);
          else if (edges !== undefined) look(rowsOfGroup(edges, group));
        }}
      >
        <span className={css.fate} data-fate={group.fate} title={TITLES[group.fate]} />
        <span className={css.groupWords}>
          {words}
          <small>
            {count(group.count, lines ? "edge" : "entity", lines ? "edges" : "entities")}
            {several && ` · ${group.kinds.join(", ")}`}
          </small>
        </span>
        {group.length > 0 && (
          <span className={panels.rowFigure}>
            {drawing.unit === null ? group.length.toFixed(1) : length(group.length)}
          </span>
        )}
        {!lines && <IconChevronRight size={14} className={css.turn} data-open={open} />}
      </button>
      {open && <Entities group={group} drawing={drawing} />}
    </div>
  );
}

function Entities({ group, drawing }: { group: ReportGroup; drawing: Drawing }) {
  const [most, setMost] = useState(STEP);
  const first = drawing.ledger.rows;
  const all = drawing.ledger.kept + drawing.ledger.merged + drawing.ledger.dropped;
  // A drawing lists the first of its entities only; the rest is asked for here.
  const whole = useLedger(first.length < all);
  const rows = entitiesOf(whole.data?.rows ?? first, group);
  return (
    <div className={css.entities}>
      {rows.slice(0, most).map((row, at) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: a file may name two entities alike
        <Entity key={`${row.handle} ${at}`} row={row} />
      ))}
      {whole.error && <p className={panels.note}>{whole.error.message}</p>}
      {rows.length > most && (
        <ShowMore
          left={rows.length - most}
          busy={whole.isFetching}
          act={() => setMost(most + STEP)}
        />
      )}
    </div>
  );
}

/** One entity; one that became edges can be looked at. */
function Entity({ row }: { row: LedgerRow }) {
  const { data: edges } = useEdges();
  const look = usePage((page) => page.look);
  const rows = edges === undefined ? [] : rowsOfHandles(edges, [row.handle]);
  return (
    <button
      type="button"
      className={panels.finding}
      disabled={rows.length === 0}
      onClick={() => look(rows)}
    >
      <span style={{ flex: 1, minWidth: 0, overflowWrap: "anywhere" }}>
        {row.kind} {row.handle}
        <span style={{ color: "var(--ink-3)" }}>
          {" "}
          on {row.layer}
          {row.reason !== row.theme && ` · ${row.reason}`}
        </span>
      </span>
      {row.length > 0 && <span className={panels.rowFigure}>{length(row.length)}</span>}
    </button>
  );
}
