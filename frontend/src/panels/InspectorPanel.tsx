/** The edges that are chosen: what they are and why, how sure that is, and what else they could be. */

import { retype } from "../state/actions";
import { colourWords, indexColour } from "../state/colours";
import { isByHand } from "../state/history";
import { inspected, ruleWords } from "../state/inspect";
import { useLength } from "../state/measure";
import { LINE_LOOKS } from "../state/palette";
import { useEdges } from "../state/queries";
import { layerOf, rowsOfLayer } from "../state/rows";
import { usePage } from "../state/store";
import { count } from "../state/words";
import css from "./inspector.module.css";
import panels from "./panels.module.css";
import { showing } from "./pointing";
import { Section } from "./Section";
import { Swatch } from "./Swatch";

export function InspectorPanel() {
  const selection = usePage((page) => page.selection);
  const { data: edges } = useEdges();
  const busy = usePage((page) => page.busy);
  const choose = usePage((page) => page.choose);
  const length = useLength();
  const rows = [...selection].filter((row) => row < (edges?.bulge.length ?? 0));
  const [row] = rows;
  if (edges === undefined || row === undefined) return null;
  const found = inspected(edges, rows);
  const alike = rowsOfLayer(edges, layerOf(edges, row), edges.colour[row] ?? 0);
  const byHand = rows.some((one) => isByHand(edges, one));
  return (
    <Section
      title={rows.length === 1 ? `Edge ${row}` : count(rows.length, "edge")}
      aside={<span className={panels.rowFigure}>{length(found.length)}</span>}
    >
      <div data-testid="inspector">
        {found.why.map(({ type, rule, confidence, rows: those }) => (
          <div key={`${type} ${rule}`}>
            <div className={css.inspected}>
              <Swatch type={type} />
              {LINE_LOOKS[type].title}
              {found.why.length > 1 && (
                <span className={panels.rowFigure}>{count(those.length, "edge")}</span>
              )}
            </div>
            <div className={css.trust}>
              <span className={css.trustWords} data-testid="why">
                {ruleWords(rule)}
              </span>
              <span className={css.meter} aria-hidden>
                <span style={{ width: `${100 * confidence}%`, background: tone(confidence) }} />
              </span>
              <span className={panels.figure}>{Math.round(100 * confidence)} % sure</span>
            </div>
          </div>
        ))}
        {found.more > 0 && <p className={panels.note}>… and {found.more} other reasons</p>}
        {found.alternatives.length > 0 && (
          <>
            <p className={panels.note} style={{ margin: "10px 0 0" }}>
              It could also be
            </p>
            <div className={css.alternatives}>
              {found.alternatives.map((type) => (
                <button
                  key={type}
                  type="button"
                  className={css.alternative}
                  disabled={busy}
                  data-testid={`alternative-${type}`}
                  {...showing(() => [{ rows, type }])}
                  onClick={() => void retype(rows, type)}
                >
                  <Swatch type={type} />
                  {LINE_LOOKS[type].title}
                </button>
              ))}
            </div>
          </>
        )}
        {byHand && (
          <button
            type="button"
            className={panels.link}
            disabled={busy}
            onClick={() => void retype(rows, null)}
          >
            Let the profile decide again
          </button>
        )}
        <dl className={panels.facts}>
          {rows.length === 1 && (
            <>
              <dt>Handle in the file</dt>
              <dd>{edges.handles[row]}</dd>
            </>
          )}
          <dt>Layer</dt>
          <dd>{found.layers.join(", ")}</dd>
          <dt>Colour</dt>
          <dd>
            {found.colours.map((colour) => (
              <span key={colour} style={{ display: "block", whiteSpace: "nowrap" }}>
                <span
                  className={panels.dot}
                  style={{ display: "inline-block", background: indexColour(colour) }}
                />{" "}
                {colourWords(colour)}
              </span>
            ))}
          </dd>
          <dt>Linetype</dt>
          <dd>{found.linetypes.join(", ")}</dd>
          {found.fate !== "" && (
            <>
              <dt>Cleaning</dt>
              <dd>{found.fate}</dd>
            </>
          )}
        </dl>
        {alike.length > rows.length && (
          <button type="button" className={panels.link} onClick={() => choose(alike)}>
            Choose all {alike.length.toLocaleString("en")} of this layer and colour
          </button>
        )}
      </div>
    </Section>
  );
}

const tone = (confidence: number): string =>
  confidence >= 0.9 ? "var(--good)" : confidence >= 0.6 ? "var(--warn)" : "var(--bad)";
