/** The selected edges: line type, deciding rule, confidence and other possible types. */

import { Box, Group, Progress, Text } from "@mantine/core";
import type { ReactNode } from "react";
import type { LineType } from "../../geometry/records";
import { translate } from "../../language/translate";
import { useRefusal } from "../../state/accounts/accounts";
import { retype } from "../../state/actions";
import { colourName, indexColour } from "../../state/drawing/colours";
import { isSetByHand } from "../../state/drawing/history";
import { type EdgeSummary, ruleText, summarizeEdges } from "../../state/drawing/inspect";
import { LINE_STYLES } from "../../state/drawing/palette";
import { layerOf, rowsOfLayer } from "../../state/drawing/rows";
import { useFormatLength, useFormatLineWidth } from "../../state/drawing/useFormatLength";
import { useEdges } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { Refusal } from "../accounts/Permitted";
import { EdgeOptions } from "../order/EdgeOptions";
import { USE_PROFILE_TYPE } from "../shared/labels";
import panels from "../shared/panels.module.css";
import { Figure, LinkButton, Note } from "../shared/parts";
import { Section } from "../shared/Section";
import { Swatch } from "../shared/Swatch";
import { EdgeFigures } from "./EdgeFigures";
import { previewHandlers } from "./previewHandlers";

export function InspectorPanel() {
  const selection = useUiStore((ui) => ui.selection);
  const { data: edges } = useEdges();
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}/edges");
  const selectEdges = useUiStore((ui) => ui.selectEdges);
  const formatLength = useFormatLength();
  const rows = [...selection].filter((row) => row < (edges?.bulge.length ?? 0));
  const [row] = rows;
  if (edges === undefined || row === undefined) return null;
  const summary = summarizeEdges(edges, rows);
  const alike = rowsOfLayer(edges, layerOf(edges, row), edges.colour[row] ?? 0);
  const byHand = rows.some((one) => isSetByHand(edges, one));
  return (
    <Section
      title={
        rows.length === 1
          ? translate("inspectorPanel.selectedEdge", { row })
          : translate("inspectorPanel.selectedEdges", { rows: rows.length })
      }
      aside={<Figure>{formatLength(summary.length)}</Figure>}
    >
      <div data-testid="inspector">
        <Reasons summary={summary} />
        {summary.more > 0 && (
          <Note>{translate("inspectorPanel.andMoreReasonsForThe", { more: summary.more })}</Note>
        )}
        {summary.alternatives.length > 0 && (
          <Alternatives types={summary.alternatives} rows={rows} />
        )}
        {byHand && (
          <LinkButton
            type="button"
            disabled={busy || refusal !== null}
            onClick={() => void retype(rows, null)}
          >
            {USE_PROFILE_TYPE}
          </LinkButton>
        )}
        <Refusal reason={refusal} />
        <EdgeOptions edges={edges} rows={rows} />
        <Facts summary={summary} handle={rows.length === 1 ? (edges.handles[row] ?? "") : null}>
          {rows.length === 1 && <EdgeFigures row={row} edges={edges.bulge.length} />}
        </Facts>
        {alike.length > rows.length && (
          <LinkButton type="button" onClick={() => selectEdges(alike)}>
            {translate("inspectorPanel.selectAllEdgesWithThis", { alike: alike.length })}
          </LinkButton>
        )}
      </div>
    </Section>
  );
}

/** Line type, rule and confidence of the edges, by reason. */
function Reasons({ summary }: { summary: EdgeSummary }) {
  return (
    <>
      {summary.reasons.map(({ type, rule, confidence, rows: decided }) => (
        <div key={`${type} ${rule}`}>
          <Group gap={9} c="ink.0" fz={14} fw={600}>
            <Swatch type={type} />
            {LINE_STYLES[type].title}
            {summary.reasons.length > 1 && (
              <Figure>{translate("inspectorPanel.edges", { decided: decided.length })}</Figure>
            )}
          </Group>
          <Box mt={10} mb={4} fz={12} c="ink.2">
            <Text className={panels.sentence} data-testid="why">
              {ruleText(rule)}
            </Text>
            <Group gap={10}>
              <Progress
                flex={1}
                size={5}
                value={100 * confidence}
                color={tone(confidence)}
                aria-hidden
              />

              {translate("inspectorPanel.confidence", { confidence: Math.round(100 * confidence) })}
            </Group>
          </Box>
        </div>
      ))}
    </>
  );
}

/** Buttons for the other possible line types. */
function Alternatives({ types, rows }: { types: readonly LineType[]; rows: readonly number[] }) {
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}/edges");
  return (
    <>
      <Note mt={10}>{translate("inspectorPanel.otherPossibleLineTypesClick")}</Note>
      <Group gap={6} mt={8}>
        {types.map((type) => (
          <button
            key={type}
            type="button"
            className={panels.choice}
            disabled={busy || refusal !== null}
            data-testid={`alternative-${type}`}
            {...previewHandlers(() => [{ rows, type }])}
            onClick={() => void retype(rows, type)}
          >
            <Swatch type={type} />
            {LINE_STYLES[type].title}
          </button>
        ))}
      </Group>
    </>
  );
}

interface FactsProps {
  summary: EdgeSummary;
  /** null: more than one edge */
  handle: string | null;
  children: ReactNode;
}

function Facts({ summary, handle, children }: FactsProps) {
  const lineWidth = useFormatLineWidth();
  return (
    <Box component="dl" className={panels.facts} data-end mt={10} fz={12}>
      {handle !== null && (
        <>
          <dt>{translate("inspectorPanel.objectInFile")}</dt>
          <dd>{handle}</dd>
        </>
      )}
      <dt>{translate("inspectorPanel.layerInFile")}</dt>
      <dd>{summary.layers.join(", ")}</dd>
      <dt>{translate("inspectorPanel.colourInFile")}</dt>
      <dd>
        {summary.colours.map((colour) => (
          <span key={colour} style={{ display: "block", whiteSpace: "nowrap" }}>
            <span
              className={panels.dot}
              style={{ display: "inline-block", background: indexColour(colour) }}
            />{" "}
            {colourName(colour)}
          </span>
        ))}
      </dd>
      <dt>{translate("inspectorPanel.lineStyleInFile")}</dt>
      <dd>{summary.linetypes.join(", ")}</dd>
      {summary.lineWidths.length > 0 && (
        <>
          <dt>{translate("inspectorPanel.lineWidthInFile")}</dt>
          <dd>{summary.lineWidths.map(lineWidth).join(", ")}</dd>
        </>
      )}
      {summary.outcome !== "" && (
        <>
          <dt>{translate("inspectorPanel.importResult")}</dt>
          <dd>{summary.outcome}</dd>
        </>
      )}
      {children}
    </Box>
  );
}

const tone = (confidence: number): string =>
  confidence >= 0.9 ? "var(--good)" : confidence >= 0.6 ? "var(--warn)" : "var(--bad)";
