/** The entities of a group of the import report; each is shown where it is, as far as it has a place. */

import { useMemo, useState } from "react";
import type { Drawing, LedgerRow, ReportGroup } from "../api/client";
import type { Box, Edges } from "../geometry/records";
import { useLength } from "../state/measure";
import { useEdges, useLedger } from "../state/queries";
import { entitiesOf, foundOf } from "../state/report";
import { usePage } from "../state/store";
import css from "./import.module.css";
import panels from "./panels.module.css";
import { ShowMore } from "./ShowMore";

/** Entities that come at once. */
const STEP = 100;

export function Entities({ group, drawing }: { group: ReportGroup; drawing: Drawing }) {
  const { data: edges } = useEdges();
  const [most, setMost] = useState(STEP);
  const { rows: first, kept, merged, dropped } = drawing.ledger;
  // A drawing lists the first of its entities only; the rest is asked for here.
  const whole = useLedger(group.fate, first.length < kept + merged + dropped);
  const listed = whole.data?.rows ?? first;
  const rows = useMemo(() => entitiesOf(listed, group), [listed, group]);
  return (
    <div className={css.entities} data-testid="entities">
      {edges !== undefined &&
        rows.slice(0, most).map((row, at) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: a file may name two entities alike
          <Entity key={`${row.handle} ${at}`} row={row} edges={edges} drawing={drawing} />
        ))}
      {whole.error && <p className={panels.note}>{whole.error.message}</p>}
      {(rows.length > most || whole.isFetching) && (
        <ShowMore
          left={Math.max(rows.length, group.count) - Math.min(rows.length, most)}
          busy={whole.isFetching}
          act={() => setMost(most + STEP)}
        />
      )}
    </div>
  );
}

interface Props {
  row: LedgerRow;
  edges: Edges;
  drawing: Drawing;
}

function Entity({ row, edges, drawing }: Props) {
  const look = usePage((page) => page.look);
  const lookAt = usePage((page) => page.lookAt);
  const pin = usePage((page) => page.pin);
  const length = useLength();
  const found = useMemo(() => foundOf(edges, drawing, row), [edges, drawing, row]);
  const meant = found !== null && "pin" in found && same(pin, found.pin);
  return (
    <button
      type="button"
      className={css.entity}
      disabled={found === null}
      aria-pressed={meant}
      title={found === null ? "The file gives it no place on the sheet" : "Show it"}
      data-testid="entity"
      onClick={() => {
        if (found === null) return;
        if ("rows" in found) look(found.rows);
        else lookAt(found.box, found.pin);
      }}
    >
      <span className={css.entityWords}>
        {row.text === "" ? row.kind : `“${row.text}”`}
        <small>
          {row.text === "" ? "" : `${row.kind} `}
          {row.handle} on {row.layer}
          {particular(row) !== "" && ` · ${particular(row)}`}
        </small>
      </span>
      {row.length > 0 && <span className={panels.rowFigure}>{length(row.length)}</span>}
    </button>
  );
}

const same = (a: Box | null, b: Box): boolean => a?.every((side, at) => side === b[at]) ?? false;

/** What its reason says beyond that of the group. */
const particular = ({ reason, theme }: LedgerRow): string =>
  reason === theme ? "" : reason.replace(`${theme}: `, "");
