/** The selected edges: line type, deciding rule, confidence and other possible types. */

import type { LineType } from "../geometry/records";
import { useRefusal } from "../state/accounts";
import { retype } from "../state/actions";
import { colourName, indexColour } from "../state/colours";
import { pluralize } from "../state/format";
import { isSetByHand } from "../state/history";
import { type EdgeSummary, ruleText, summarizeEdges } from "../state/inspect";
import { LINE_STYLES } from "../state/palette";
import { useEdges } from "../state/queries";
import { layerOf, rowsOfLayer } from "../state/rows";
import { useUiStore } from "../state/store";
import { useFormatLength, useFormatLineWidth } from "../state/useFormatLength";
import css from "./inspector.module.css";
import { USE_PROFILE_TYPE } from "./labels";
import { Refusal } from "./Permitted";
import panels from "./panels.module.css";
import { previewHandlers } from "./previewHandlers";
import { Section } from "./Section";
import { Swatch } from "./Swatch";

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
      title={rows.length === 1 ? `Selected edge ${row}` : pluralize(rows.length, "selected edge")}
      aside={<span className={panels.rowFigure}>{formatLength(summary.length)}</span>}
    >
      <div data-testid="inspector">
        <Reasons summary={summary} />
        {summary.more > 0 && (
          <p className={panels.note}>
            … and {summary.more} more reasons for the line types of the selected edges
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
        <Facts summary={summary} handle={rows.length === 1 ? (edges.handles[row] ?? "") : null} />
        {alike.length > rows.length && (
          <button type="button" className={panels.link} onClick={() => selectEdges(alike)}>
            Select all {alike.length.toLocaleString("en")} edges with this layer and colour
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
              <span className={panels.rowFigure}>{pluralize(decided.length, "edge")}</span>
            )}
          </div>
          <div className={css.trust}>
            <span className={css.trustText} data-testid="why">
              {ruleText(rule)}
            </span>
            <span className={css.meter} aria-hidden>
              <span style={{ width: `${100 * confidence}%`, background: tone(confidence) }} />
            </span>
            <span className={panels.figure}>{Math.round(100 * confidence)} % confidence</span>
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
        Other possible line types (click to set)
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
          <dt>Object in file</dt>
          <dd>{handle}</dd>
        </>
      )}
      <dt>Layer in file</dt>
      <dd>{summary.layers.join(", ")}</dd>
      <dt>Colour in file</dt>
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
      <dt>Line style in file</dt>
      <dd>{summary.linetypes.join(", ")}</dd>
      {summary.lineWidths.length > 0 && (
        <>
          <dt>Line width in file</dt>
          <dd>{summary.lineWidths.map(lineWidth).join(", ")}</dd>
        </>
      )}
      {summary.outcome !== "" && (
        <>
          <dt>Import result</dt>
          <dd>{summary.outcome}</dd>
        </>
      )}
    </dl>
  );
}

const tone = (confidence: number): string =>
  confidence >= 0.9 ? "var(--good)" : confidence >= 0.6 ? "var(--warn)" : "var(--bad)";
