/** The import report: what was kept, merged and dropped, and why. The lengths add up. */

import { SegmentedControl } from "@mantine/core";
import { IconChevronRight, IconFocusCentered } from "@tabler/icons-react";
import { useState } from "react";
import type { Drawing, ReportGroup } from "../../api/client";
import type { ImportOutcome } from "../../geometry/records";
import { translate } from "../../language/translate";
import { messageText } from "../../messages/translateMessage";
import {
  groupsOf,
  lengthShares,
  OUTCOME_FILTERS,
  rowsOfGroup,
  summarizeReport,
} from "../../state/drawing/importReport";
import { useFormatLength } from "../../state/drawing/useFormatLength";
import { useDrawing, useEdges } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { SHOW_EDGES } from "../shared/labels";
import panels from "../shared/panels.module.css";
import { Section } from "../shared/Section";
import { Entities } from "./Entities";
import css from "./import.module.css";

type Report = NonNullable<Drawing["report"]>;

/** Element id of the report. */
export const REPORT = "import-report";

const TITLES: Readonly<Record<ImportOutcome, string>> = {
  kept: translate("importPanel.kept"),
  merged: translate("importPanel.merged"),
  dropped: translate("importPanel.dropped"),
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
      title={translate("importPanel.importReport")}
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
          { value: "all", label: translate("importPanel.all") },
          ...OUTCOME_FILTERS.map((word) => ({ value: word, label: TITLES[word] })),
        ]}
        aria-label={translate("importPanel.listObjectsWithThisImport")}
      />
      <div className={css.groups} data-testid="report-groups">
        {groups.map((group) => (
          <Group
            key={`${group.outcome} ${group.what} ${messageText(group.reason)}`}
            group={group}
            drawing={drawing}
          />
        ))}
        {groups.length === 0 && (
          <p className={panels.note} style={{ padding: "0 8px" }}>
            {translate("importPanel.noObjectOfThisFile", {
              outcome: outcome ?? "kept",
            })}
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
        aria-label={translate("importPanel.totalLengthsOfTheLines")}
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
          <dt>{translate("importPanel.totalLength")}</dt>
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
  const reason = messageText(group.reason) || translate("importPanel.keptAsDrawn");
  const several = group.kinds.length > 0 && !isEdges;
  return (
    <div>
      <button
        type="button"
        className={css.group}
        aria-expanded={isEdges ? undefined : open}
        title={isEdges ? SHOW_EDGES : translate("importPanel.listTheseObjectsOfThe")}
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
            {isEdges
              ? translate("importPanel.edges", { count: group.count })
              : translate("importPanel.objects", { count: group.count })}
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
