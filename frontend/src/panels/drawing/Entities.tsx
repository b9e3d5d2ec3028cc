/** The entities of a group of the import report; a click zooms to one. */

import { Stack, Text } from "@mantine/core";
import { useMemo, useState } from "react";
import type { Drawing, ImportReportRow, ReportGroup } from "../../api/drawings";
import type { Box, Edges } from "../../geometry/records";
import { translate } from "../../language/translate";
import { errorText, messageText } from "../../messages/translateMessage";
import { entitiesOf, locateEntity } from "../../state/drawing/importReport";
import { useFormatLength } from "../../state/drawing/useFormatLength";
import { useEdges, useImportReport } from "../../state/queries";
import { useUiStore } from "../../state/store";
import panels from "../shared/panels.module.css";
import { Figure, Note } from "../shared/parts";
import { ShowMore } from "../shared/ShowMore";

/** Entities listed at once. */
const STEP = 100;

export function Entities({ group, drawing }: { group: ReportGroup; drawing: Drawing }) {
  const { data: edges } = useEdges();
  const [limit, setLimit] = useState(STEP);
  const { rows: firstRows, kept, merged, dropped } = drawing.import_report;
  // A drawing lists only its first entities; the rest is fetched here.
  const report = useImportReport(group.outcome, firstRows.length < kept + merged + dropped);
  const listed = report.data?.rows ?? firstRows;
  const rows = useMemo(() => entitiesOf(listed, group), [listed, group]);
  return (
    <Stack gap={0} mah={276} mx={8} mb={8} pl={6} className={panels.inset} data-testid="entities">
      {edges !== undefined &&
        rows.slice(0, limit).map((row, at) => (
          <Entity
            // biome-ignore lint/suspicious/noArrayIndexKey: a file may name two entities alike
            key={`${row.handle} ${at}`}
            row={row}
            group={group}
            edges={edges}
            drawing={drawing}
          />
        ))}
      {report.error && <Note>{errorText(report.error)}</Note>}
      {(rows.length > limit || report.isFetching) && (
        <ShowMore
          left={Math.max(rows.length, group.count) - Math.min(rows.length, limit)}
          busy={report.isFetching}
          act={() => setLimit(limit + STEP)}
        />
      )}
    </Stack>
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
  const location = useMemo(() => locateEntity(edges, drawing, row), [edges, drawing, row]);
  const reason = messageText(row.reason);
  const isPinned = location !== null && "pin" in location && equalBoxes(pin, location.pin);
  return (
    <button
      type="button"
      className={panels.pick}
      disabled={location === null}
      aria-pressed={isPinned}
      title={
        location === null
          ? translate("entities.thisObjectHasNoPosition")
          : translate("entities.showThePositionOfThis")
      }
      data-testid="entity"
      onClick={() => {
        if (location === null) return;
        if ("rows" in location) zoomToEdges(location.rows);
        else zoomToBox(location.box, location.pin);
      }}
    >
      <Text span flex={1} fz={12}>
        {row.text === "" ? row.kind : `“${row.text}”`}
        <Text
          span
          display="block"
          fz={11.5}
          c="ink.3"
        >{`${row.text === "" ? translate("entities.onLayer", { handle: row.handle, layer: row.layer }) : translate("entities.onLayer2", { kind: row.kind, handle: row.handle, layer: row.layer })}${reason !== messageText(group.reason) ? ` · ${reason}` : ""}`}</Text>
      </Text>
      {row.length > 0 && <Figure>{length(row.length)}</Figure>}
    </button>
  );
}

const equalBoxes = (a: Box | null, b: Box): boolean =>
  a?.every((side, at) => side === b[at]) ?? false;
