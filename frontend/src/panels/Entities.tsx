/** The entities of a group of the import report; a click zooms to one. */

import { useMemo, useState } from "react";
import type { Drawing, ImportReportRow, ReportGroup } from "../api/client";
import type { Box, Edges } from "../geometry/records";
import { errorText, renderText } from "../messages/render";
import { entitiesOf, locateEntity } from "../state/importReport";
import { useEdges, useImportReport } from "../state/queries";
import { useUiStore } from "../state/store";
import { useFormatLength } from "../state/useFormatLength";
import css from "./import.module.css";
import panels from "./panels.module.css";
import { ShowMore } from "./ShowMore";

/** Entities listed at once. */
const STEP = 100;

export function Entities({ group, drawing }: { group: ReportGroup; drawing: Drawing }) {
  const { data: edges } = useEdges();
  const [most, setMost] = useState(STEP);
  const { rows: first, kept, merged, dropped } = drawing.import_report;
  // A drawing lists only its first entities; the rest is fetched here.
  const whole = useImportReport(group.outcome, first.length < kept + merged + dropped);
  const listed = whole.data?.rows ?? first;
  const rows = useMemo(() => entitiesOf(listed, group), [listed, group]);
  return (
    <div className={css.entities} data-testid="entities">
      {edges !== undefined &&
        rows.slice(0, most).map((row, at) => (
          <Entity
            // biome-ignore lint/suspicious/noArrayIndexKey: a file may name two entities alike
            key={`${row.handle} ${at}`}
            row={row}
            group={group}
            edges={edges}
            drawing={drawing}
          />
        ))}
      {whole.error && <p className={panels.note}>{errorText(whole.error)}</p>}
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
  row: ImportReportRow;
  group: ReportGroup;
  edges: Edges;
  drawing: Drawing;
}

function Entity({ row, group, edges, drawing }: Props) {
  const zoomToEdges = useUiStore((ui) => ui.zoomToEdges);
  const zoomToBox = useUiStore((ui) => ui.zoomToBox);
  const pin = useUiStore((ui) => ui.pin);
  const length = useFormatLength();
  const found = useMemo(() => locateEntity(edges, drawing, row), [edges, drawing, row]);
  const reason = renderText(row.reason);
  const meant = found !== null && "pin" in found && same(pin, found.pin);
  return (
    <button
      type="button"
      className={css.entity}
      disabled={found === null}
      aria-pressed={meant}
      title={
        found === null
          ? "This entity has no position in the file"
          : "Show this entity in the drawing"
      }
      data-testid="entity"
      onClick={() => {
        if (found === null) return;
        if ("rows" in found) zoomToEdges(found.rows);
        else zoomToBox(found.box, found.pin);
      }}
    >
      <span className={css.entityText}>
        {row.text === "" ? row.kind : `“${row.text}”`}
        <small>
          {row.text === "" ? "" : `${row.kind} `}
          {row.handle} on layer {row.layer}
          {reason !== renderText(group.reason) && ` · ${reason}`}
        </small>
      </span>
      {row.length > 0 && <span className={panels.rowFigure}>{length(row.length)}</span>}
    </button>
  );
}

const same = (a: Box | null, b: Box): boolean => a?.every((side, at) => side === b[at]) ?? false;
