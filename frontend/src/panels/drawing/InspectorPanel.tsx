/** The selected edges: line type, deciding rule, confidence and other possible types. */

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
import { Section } from "../shared/Section";
import { Swatch } from "../shared/Swatch";
import css from "./inspector.module.css";
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
      aside={<span className={panels.rowFigure}>{formatLength(summary.length)}</span>}
    >
      <div data-testid="inspector">
        <Reasons summary={summary} />
        {summary.more > 0 && (
          <p className={panels.note}>
            {translate("inspectorPanel.andMoreReasonsForThe", { more: summary.more })}
          </p>
        )}
        {summary.alternatives.length > 0 && (
          <Alternatives types={summary.alternatives} rows={rows} />
        )}
        {byHand && (
          <button
            type="button"
            className={panels.link}
            disabled={busy || refusal !== null}
            onClick={() => void retype(rows, null)}
          >
            {USE_PROFILE_TYPE}
          </button>
        )}
        <Refusal reason={refusal} />
        <EdgeOptions edges={edges} rows={rows} />
        <Facts summary={summary} handle={rows.length === 1 ? (edges.handles[row] ?? "") : null} />
        {alike.length > rows.length && (
          <button type="button" className={panels.link} onClick={() => selectEdges(alike)}>
            {translate("inspectorPanel.selectAllEdgesWithThis", { alike: alike.length })}
          </button>
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
          <div className={css.inspected}>
            <Swatch type={type} />
            {LINE_STYLES[type].title}
            {summary.reasons.length > 1 && (
              <span className={panels.rowFigure}>
                {translate("inspectorPanel.edges", { decided: decided.length })}
              </span>
            )}
          </div>
          <div className={css.trust}>
            <span className={css.trustText} data-testid="why">
              {ruleText(rule)}
            </span>
            <span className={css.meter} aria-hidden>
              <span style={{ width: `${100 * confidence}%`, background: tone(confidence) }} />
            </span>
            <span className={panels.figure}>
              {translate("inspectorPanel.confidence", { confidence: Math.round(100 * confidence) })}
            </span>
          </div>
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
      <p className={panels.note} style={{ margin: "10px 0 0" }}>
        {translate("inspectorPanel.otherPossibleLineTypesClick")}
      </p>
      <div className={css.alternatives}>
        {types.map((type) => (
          <button
            key={type}
            type="button"
            className={css.alternative}
            disabled={busy || refusal !== null}
            data-testid={`alternative-${type}`}
            {...previewHandlers(() => [{ rows, type }])}
            onClick={() => void retype(rows, type)}
          >
            <Swatch type={type} />
            {LINE_STYLES[type].title}
          </button>
        ))}
      </div>
    </>
  );
}

interface FactsProps {
  summary: EdgeSummary;
  /** null: more than one edge */
  handle: string | null;
}

function Facts({ summary, handle }: FactsProps) {
  const lineWidth = useFormatLineWidth();
  return (
    <dl className={panels.facts}>
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
    </dl>
  );
}

const tone = (confidence: number): string =>
  confidence >= 0.9 ? "var(--good)" : confidence >= 0.6 ? "var(--warn)" : "var(--bad)";
