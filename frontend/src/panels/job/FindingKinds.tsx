/** Rows about the shortfalls and notes of a verdict, one for each kind; clicks zoom to the places. */

import { Text } from "@mantine/core";
import { IconAlertTriangleFilled, IconInfoCircle, IconRulerMeasure } from "@tabler/icons-react";
import { type ReactNode, useState } from "react";
import type { Finding, VerdictSummary } from "../../api/jobs";
import { translate } from "../../language/translate";
import { messageText } from "../../messages/translateMessage";
import { formatHundredths, formatLength } from "../../state/format";
import { acceptancesOf, edgesOf, kindsOf } from "../../state/job/findingKinds";
import { useUiStore } from "../../state/store";
import css from "../shared/panels.module.css";

interface Props {
  readonly verdict: VerdictSummary;
  readonly findings: readonly Finding[];
}

export function FindingKinds({ verdict, findings }: Props) {
  // These kinds are stated by their total lengths.
  const totals: Readonly<Record<string, string | undefined>> = {
    unreached:
      verdict.unreached_distance > 0
        ? translate("verdictCard.ofTheCutLinesCannot", {
            unreachedLength: formatLength(verdict.unreached_length),
            unreachedDistance: formatHundredths(verdict.unreached_distance),
          })
        : undefined,
    kerf:
      verdict.slit_places > 0
        ? translate("verdictCard.inSlitsBecomeAsWide", {
            slitLength: formatLength(verdict.slit_length),
            slitPlaces: verdict.slit_places,
          })
        : undefined,
  };
  const kinds = kindsOf(findings);
  return kinds.map(({ kind, severity, findings: own }, at) => {
    // Once for each kind, although some of its findings may be notes.
    const isFirst = kinds.findIndex((one) => one.kind === kind) === at;
    const total = isFirst ? totals[kind] : undefined;
    return (
      <KindRow
        key={`${severity} ${kind} ${own[0]?.code}`}
        findings={own}
        icon={severity === "note" || total !== undefined ? null : "shortfall"}
        testId={`kind-${kind}`}
      >
        {total ?? firstText(own)}
      </KindRow>
    );
  });
}

/** The first finding of a kind, and at how many places there is the like. */
function firstText(findings: readonly Finding[]): string {
  const [first] = findings;
  if (first === undefined) return "";
  return findings.length === 1
    ? messageText(first)
    : translate("verdictCard.andAtMorePlaces", {
        text: messageText(first),
        places: findings.length - 1,
      });
}

interface RowProps {
  readonly findings: readonly Finding[];
  readonly icon: "shortfall" | null;
  readonly testId: string;
  readonly children: ReactNode;
}

/** A row about findings; each click zooms to the edges of the next one. */
function KindRow({ findings, icon, testId, children }: RowProps) {
  const [next, setNext] = useState(0);
  const zoomToEdges = useUiStore((ui) => ui.zoomToEdges);
  const isNote = findings[0]?.severity === "note";
  const Icon =
    icon === "shortfall" ? IconAlertTriangleFilled : isNote ? IconInfoCircle : IconRulerMeasure;
  return (
    <button
      type="button"
      className={css.pick}
      title={findings.length > 1 ? translate("verdictPlaces.eachClickShowsTheNext") : undefined}
      onClick={() => {
        const finding = findings[next % findings.length];
        if (finding !== undefined) zoomToEdges(edgesOf(finding));
        setNext(next + 1);
      }}
      data-testid={testId}
    >
      <Icon
        size={15}
        style={{ flex: "none", marginTop: 1 }}
        color={icon === "shortfall" ? "var(--warn)" : "currentColor"}
        aria-hidden
      />
      <span>
        {children}
        {acceptancesOf(findings).map(({ by, reason }) => (
          <Text
            key={`${by} ${reason}`}
            component="em"
            display="block"
            fz={12}
            c="ink.2"
            data-testid="acceptance"
          >
            {translate("verdictCard.acceptedBy", { by, reason })}
          </Text>
        ))}
      </span>
    </button>
  );
}
