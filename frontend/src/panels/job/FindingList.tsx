/** A list of findings of a verdict; a click zooms to the edges of one. */

import { Box, Text } from "@mantine/core";
import {
  IconAlertOctagonFilled,
  IconAlertTriangleFilled,
  IconInfoCircle,
} from "@tabler/icons-react";
import type { ReactNode } from "react";
import type { Finding } from "../../api/jobs";
import { translate } from "../../language/translate";
import { messageText } from "../../messages/translateMessage";
import { edgesOf } from "../../state/job/findingKinds";
import { useUiStore } from "../../state/store";
import css from "../shared/panels.module.css";
import { Note } from "../shared/parts";

const SHOWN = 100;

export function FindingList({ findings }: { findings: readonly Finding[] }) {
  return (
    <Box mah={260} fz={12} mt={8} mx={-6} style={{ overflow: "auto" }} data-testid="findings">
      {findings.slice(0, SHOWN).map((finding, at) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: two findings may read alike
        <Row key={at} finding={finding} />
      ))}
      {findings.length > SHOWN && (
        <Note px={8}>
          {translate("verdictCard.andMoreFindings", { findings: findings.length - SHOWN })}
        </Note>
      )}
    </Box>
  );
}

/** Icon and name of each severity. */
const SEVERITIES: Readonly<
  Record<Finding["severity"], { icon: ReactNode; name: string; colour: string }>
> = {
  fault: {
    icon: <IconAlertOctagonFilled size={15} aria-hidden />,
    name: translate("verdictCard.error"),
    colour: "var(--bad)",
  },
  shortfall: {
    icon: <IconAlertTriangleFilled size={15} aria-hidden />,
    name: translate("verdictCard.shortfall"),
    colour: "var(--warn)",
  },
  note: {
    icon: <IconInfoCircle size={15} aria-hidden />,
    name: translate("verdictCard.note"),
    colour: "ink.3",
  },
};

function Row({ finding }: { finding: Finding }) {
  const zoomToEdges = useUiStore((ui) => ui.zoomToEdges);
  return (
    <button
      type="button"
      className={css.pick}
      disabled={finding.edge < 0}
      onClick={() => zoomToEdges(edgesOf(finding))}
      data-severity={finding.severity}
      data-testid="finding"
    >
      <Text span mt={1} c={SEVERITIES[finding.severity].colour}>
        {SEVERITIES[finding.severity].icon}
      </Text>
      <span>
        <Text span fw={600} c={SEVERITIES[finding.severity].colour}>
          {SEVERITIES[finding.severity].name}
        </Text>
        {" · "}
        {place(finding)}
        {messageText(finding)}
        {finding.acceptance && (
          <Text component="em" display="block" c="ink.3">
            {translate("verdictCard.acceptedBy", {
              by: finding.acceptance.by,
              reason: finding.acceptance.reason,
            })}
          </Text>
        )}
      </span>
    </button>
  );
}

/** Edge and line of a finding, to put in front of its text. */
function place(finding: Finding): string {
  const parts = [
    ...(finding.edge >= 0 ? [translate("verdictCard.edge", { edge: finding.edge })] : []),
    ...(finding.line >= 0 ? [translate("verdictCard.programLine", { line: finding.line })] : []),
  ].join(", ");
  return parts && `${parts.charAt(0).toUpperCase()}${parts.slice(1)}: `;
}
