/** The import report: what was kept, merged and dropped, and why. The lengths add up. */

import { Box, Flex, Progress, SegmentedControl, Text } from "@mantine/core";
import { IconChevronDown, IconFocusCentered } from "@tabler/icons-react";
import { useState } from "react";
import type { Drawing, ReportGroup } from "../../api/drawings";
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
import { Figure, Note } from "../shared/parts";
import { Section } from "../shared/Section";
import { Entities } from "./Entities";

type Report = NonNullable<Drawing["report"]>;

/** Element id of the report. */
export const REPORT = "import-report";

const TITLES: Readonly<Record<ImportOutcome, string>> = {
  kept: translate("importPanel.kept"),
  merged: translate("importPanel.merged"),
  dropped: translate("importPanel.dropped"),
};

const COLOURS: Readonly<Record<ImportOutcome, string>> = {
  kept: "var(--good)",
  merged: "var(--accent)",
  dropped: "#8b97a6",
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
      aside={<Figure>{summarizeReport(report)}</Figure>}
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
      <Box mx={-8} data-testid="report-groups">
        {groups.map((group) => (
          <GroupRow
            key={`${group.outcome} ${group.what} ${messageText(group.reason)}`}
            group={group}
            drawing={drawing}
          />
        ))}
        {groups.length === 0 && (
          <Note px={8}>
            {translate("importPanel.noObjectOfThisFile", {
              outcome: outcome ?? "kept",
            })}
          </Note>
        )}
      </Box>
    </Section>
  );
}

function Bar({ report }: { report: Report }) {
  const formatLength = useFormatLength();
  return (
    <Box mb={12} data-testid="report-bar">
      <Progress.Root
        size={10}
        style={{ gap: 2 }}
        role="img"
        aria-label={translate("importPanel.totalLengthsOfTheLines")}
      >
        {lengthShares(report).map(({ outcome, share }) =>
          share > 0 ? (
            <Progress.Section
              key={outcome}
              withAria={false}
              value={100 * Math.max(share, 0.01)}
              color={COLOURS[outcome]}
            />
          ) : null,
        )}
      </Progress.Root>
      <Flex component="dl" justify="space-between" wrap="wrap" gap="4px 8px" mt={8} fz={11.5}>
        {lengthShares(report).map(({ outcome, length }) => (
          <div key={outcome}>
            <Flex component="dt" align="center" gap={5} c="ink.3">
              <Box component="span" w={8} h={8} bdrs={2} bg={COLOURS[outcome]} />
              {TITLES[outcome]}
            </Flex>
            <dd>{formatLength(length)}</dd>
          </div>
        ))}
        <div>
          <Flex component="dt" align="center" gap={5} c="ink.3">
            {translate("importPanel.totalLength")}
          </Flex>
          <dd data-testid="report-drawn">{formatLength(report.drawn)}</dd>
        </div>
      </Flex>
    </Box>
  );
}

function GroupRow({ group, drawing }: { group: ReportGroup; drawing: Drawing }) {
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
        className={panels.pick}
        aria-expanded={isEdges ? undefined : open}
        title={isEdges ? SHOW_EDGES : translate("importPanel.listTheseObjectsOfThe")}
        data-testid={`report-${group.outcome}`}
        onClick={() => {
          if (!isEdges) setOpen(!open);
          else if (edges !== undefined) zoomToEdges(rowsOfGroup(edges, group));
        }}
      >
        <Box
          component="span"
          flex="none"
          w={8}
          h={8}
          mt={4}
          bdrs={2}
          bg={COLOURS[group.outcome]}
          title={TITLES[group.outcome]}
        />
        <Text span flex={1} fz={12} className={panels.sentence}>
          {reason}
          <Text span display="block" fz={11.5} c="ink.3">
            {isEdges
              ? translate("importPanel.edges", { count: group.count })
              : translate("importPanel.objects", { count: group.count })}
            {several && ` · ${group.kinds.join(", ")}`}
          </Text>
        </Text>
        {group.length > 0 && <Figure>{formatLength(group.length)}</Figure>}
        {isEdges ? (
          <IconFocusCentered size={14} className={panels.chevron} aria-hidden />
        ) : (
          <IconChevronDown size={14} className={panels.chevron} data-open={open} aria-hidden />
        )}
      </button>
      {open && <Entities group={group} drawing={drawing} />}
    </div>
  );
}
