/** The ledger: what became of every entity of the file, what was dropped and why. */

import { SegmentedControl } from "@mantine/core";
import { useState } from "react";
import type { LedgerRow } from "../api/client";
import { useDrawing, useEdges, useLedger } from "../state/queries";
import { rowsOfHandles } from "../state/rows";
import { usePage } from "../state/store";
import { length } from "../state/words";
import css from "./panels.module.css";
import { Section } from "./Section";
import { ShowMore } from "./ShowMore";

const FATES = ["dropped", "merged", "kept"] as const;
/** Rows that come at once. */
const STEP = 200;

export function LedgerPanel() {
  const { data: drawing } = useDrawing();
  const [chosen, setChosen] = useState<LedgerRow["fate"] | null>(null);
  const [most, setMost] = useState(STEP);
  // A drawing lists the first of its entities only; the rest is asked for when somebody gets there.
  const [wanted, setWanted] = useState<string | null>(null);
  const whole = useLedger(drawing !== undefined && wanted === drawing.id);
  if (drawing === undefined) return null;
  const ledger = { ...drawing.ledger, rows: (whole.data ?? drawing.ledger).rows };
  const fate = chosen ?? FATES.find((word) => ledger[word] > 0) ?? "kept";
  const rows = ledger.rows.filter((row) => row.fate === fate);
  const left = ledger[fate] - Math.min(most, rows.length);
  return (
    <Section
      title="What became of the file"
      open={false}
      aside={
        <span className={css.rowFigure}>
          {ledger.dropped > 0 ? `${ledger.dropped} dropped` : "all kept"}
        </span>
      }
    >
      <SegmentedControl
        fullWidth
        size="xs"
        mb={8}
        value={fate}
        onChange={(word) => {
          setChosen(word as LedgerRow["fate"]);
          setMost(STEP);
        }}
        data={FATES.map((word) => ({ value: word, label: `${word} ${ledger[word]}` }))}
        aria-label="Fate of the entities"
      />
      <div className={css.findings} style={{ margin: "0 -8px" }} data-testid="ledger">
        {rows.slice(0, most).map((row, at) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: a file may name two entities alike
          <Entity key={`${row.handle} ${at}`} row={row} />
        ))}
        {ledger[fate] === 0 && (
          <p className={css.note} style={{ padding: "0 8px" }}>
            Nothing was {fate}.
          </p>
        )}
        {whole.error && <p className={css.note}>{whole.error.message}</p>}
        {left > 0 && (
          <ShowMore
            left={left}
            busy={whole.isFetching}
            act={() => {
              if (rows.length < ledger[fate]) setWanted(drawing.id);
              setMost(most + STEP);
            }}
          />
        )}
      </div>
    </Section>
  );
}

function Entity({ row }: { row: LedgerRow }) {
  const { data: edges } = useEdges();
  const look = usePage((page) => page.look);
  const gone = row.fate === "dropped";
  return (
    <button
      type="button"
      className={css.finding}
      disabled={gone}
      onClick={() => edges && look(rowsOfHandles(edges, [row.handle]))}
    >
      <span style={{ flex: 1, minWidth: 0, overflowWrap: "anywhere" }}>
        {row.kind} {row.handle}
        <span style={{ color: "var(--ink-3)" }}> on {row.layer}</span>
        {row.reason !== "" && (
          <span style={{ display: "block", color: "var(--ink-2)" }}>{row.reason}</span>
        )}
      </span>
      {row.length > 0 && <span className={css.rowFigure}>{length(row.length)}</span>}
    </button>
  );
}
