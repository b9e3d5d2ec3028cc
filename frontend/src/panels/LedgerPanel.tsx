/** The ledger: what became of every entity of the file, what was dropped and why. */

import { SegmentedControl } from "@mantine/core";
import { useState } from "react";
import type { LedgerRow } from "../api/client";
import { useDrawing, useEdges } from "../state/queries";
import { rowsOfHandles } from "../state/rows";
import { usePage } from "../state/store";
import { length } from "../state/words";
import css from "./panels.module.css";
import { Section } from "./Section";

const FATES = ["dropped", "merged", "kept"] as const;
const SHOWN = 200;

export function LedgerPanel() {
  const { data: drawing } = useDrawing();
  const [chosen, setChosen] = useState<LedgerRow["fate"] | null>(null);
  if (drawing === undefined) return null;
  const { ledger } = drawing;
  const fate = chosen ?? FATES.find((word) => ledger[word] > 0) ?? "kept";
  const rows = ledger.rows.filter((row) => row.fate === fate);
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
        onChange={(word) => setChosen(word as LedgerRow["fate"])}
        data={FATES.map((word) => ({ value: word, label: `${word} ${ledger[word]}` }))}
        aria-label="Fate of the entities"
      />
      <div className={css.findings} style={{ margin: "0 -8px" }} data-testid="ledger">
        {rows.slice(0, SHOWN).map((row, at) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: a file may name two entities alike
          <Entity key={`${row.handle} ${at}`} row={row} />
        ))}
        {rows.length === 0 && (
          <p className={css.note} style={{ padding: "0 8px" }}>
            Nothing was {fate}.
          </p>
        )}
        {rows.length > SHOWN && (
          <p className={css.note} style={{ padding: "0 8px" }}>
            … and {rows.length - SHOWN} more.
          </p>
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
