/** The import report: what was kept, merged and dropped, and why. The lengths add up. */

import { SegmentedControl } from "@mantine/core";
import { IconChevronRight, IconFocusCentered } from "@tabler/icons-react";
import { useState } from "react";
import type { Drawing, ReportGroup } from "../api/client";
import type { ImportOutcome } from "../geometry/records";
import { renderText } from "../messages/render";
import { pluralize } from "../state/format";
import {
  groupsOf,
  lengthShares,
  OUTCOME_FILTERS,
  rowsOfGroup,
  summarizeReport,
} from "../state/importReport";
import { useDrawing, useEdges } from "../state/queries";
import { useUiStore } from "../state/store";
import { useFormatLength } from "../state/useFormatLength";
import { Entities } from "./Entities";
import css from "./import.module.css";
import { SHOW_EDGES } from "./labels";
import panels from "./panels.module.css";
import { Section } from "./Section";

type Report = NonNullable<Drawing["report"]>;

/** Element id of the report. */
export const REPORT = "import-report";

const TITLES: Readonly<Record<ImportOutcome, string>> = {
  kept: "Kept",
  merged: "Merged",
  dropped: "Dropped",
};

export function ImportPanel() {
  const { data: drawing } = useDrawing();
  const [outcome, setOutcome] = useState<ImportOutcome | null>(null);
  const report = drawing?.report;
  if (drawing === undefined || report === undefined || report === null) return null;
  const groups = groupsOf(report, outcome);
  return (
    <Section
      id={REPORT}
      title="Import report"
      aside={<span className={panels.rowFigure}>{summarizeReport(report)}</span>}
    >
      <Bar report={report} />
      <SegmentedControl
        fullWidth
        size="xs"
        mb={6}
        value={outcome ?? "all"}
        onChange={(choice) => setOutcome(OUTCOME_FILTERS.find((one) => one === choice) ?? null)}
        data={[
          { value: "all", label: "All" },
          ...OUTCOME_FILTERS.map((word) => ({ value: word, label: TITLES[word] })),
        ]}
        aria-label="List objects with this import result"
      />
      <div className={css.groups} data-testid="report-groups">
        {groups.map((group) => (
          <Group
            key={`${group.outcome} ${group.what} ${renderText(group.reason)}`}
            group={group}
            drawing={drawing}
          />
        ))}
        {groups.length === 0 && (
          <p className={panels.note} style={{ padding: "0 8px" }}>
            No object of this file was {TITLES[outcome ?? "kept"].toLowerCase()}.
          </p>
        )}
      </div>
    </Section>
  );
}

function Bar({ report }: { report: Report }) {
  const formatLength = useFormatLength();
  return (
    <div className={css.sum} data-testid="report-bar">
      <div
        className={css.bar}
        role="img"
        aria-label="Total lengths of the lines that the import kept, merged and dropped"
      >
        {lengthShares(report).map(({ outcome, share }) =>
          share > 0 ? (
            <span
              key={outcome}
              data-outcome={outcome}
              style={{ flexGrow: Math.max(share, 0.01) }}
            />
          ) : null,
        )}
      </div>
      <dl className={css.sums}>
        {lengthShares(report).map(({ outcome, length }) => (
          <div key={outcome}>
            <dt>
              <span className={css.outcome} data-outcome={outcome} />
              {TITLES[outcome]}
            </dt>
            <dd>{formatLength(length)}</dd>
          </div>
        ))}
        <div>
          <dt>Total length</dt>
          <dd data-testid="report-drawn">{formatLength(report.drawn)}</dd>
        </div>
      </dl>
    </div>
  );
}

function Group({ group, drawing }: { group: ReportGroup; drawing: Drawing }) {
  const { data: edges } = useEdges();
  const zoomToEdges = useUiStore((ui) => ui.zoomToEdges);
  const formatLength = useFormatLength();
  const [open, setOpen] = useState(false);
  const isEdges = group.what === "edges";
  const reason = renderText(group.reason) || "Kept as drawn";
  const several = group.kinds.length > 0 && !isEdges;
  return (
    <div>
      <button
        type="button"
        className={css.group}
        aria-expanded={isEdges ? undefined : open}
        title={isEdges ? SHOW_EDGES : "List these objects of the file"}
        data-testid={`report-${group.outcome}`}
        onClick={() => {
          if (!isEdges) setOpen(!open);
          else if (edges !== undefined) zoomToEdges(rowsOfGroup(edges, group));
        }}
      >
        <span className={css.outcome} data-outcome={group.outcome} title={TITLES[group.outcome]} />
        <span className={css.groupText}>
          {reason}
          <small>
            {pluralize(group.count, isEdges ? "edge" : "object")}
            {several && ` · ${group.kinds.join(", ")}`}
          </small>
        </span>
        {group.length > 0 && <span className={panels.rowFigure}>{formatLength(group.length)}</span>}
        {isEdges ? (
          <IconFocusCentered size={14} className={css.turn} aria-hidden />
        ) : (
          <IconChevronRight size={14} className={css.turn} data-open={open} aria-hidden />
        )}
      </button>
      {open && <Entities group={group} drawing={drawing} />}
    </div>
  );
}
