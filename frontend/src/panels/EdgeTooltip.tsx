/** What the edge under the cursor is, and why. */

import { lineTypeOf } from "../geometry/records";
import { LINE_LOOKS } from "../state/palette";
import { useEdges, useVerdict } from "../state/queries";
import { layerOf } from "../state/rows";
import { usePage } from "../state/store";
import { deviation, length } from "../state/words";
import css from "./panels.module.css";
import { Swatch } from "./Swatch";

const WIDTH = 320;
const HEIGHT = 170;

export function EdgeTooltip({ width, height }: { width: number; height: number }) {
  const hover = usePage((page) => page.hover);
  const { data: edges } = useEdges();
  const { data: verdict } = useVerdict();
  if (hover === null || edges === undefined || hover.row >= edges.bulge.length) return null;
  const { row, x, y } = hover;
  const type = lineTypeOf(edges.lineType[row]);
  const missed = verdict?.edge_deviation[row];
  const side = x + WIDTH + 24 > width ? { right: width - x + 14 } : { left: x + 16 };
  const level = y + HEIGHT + 24 > height ? { bottom: height - y + 12 } : { top: y + 16 };
  return (
    <div
      className={`${css.float} ${css.tooltip}`}
      style={{ ...side, ...level }}
      role="tooltip"
      data-testid="edge-tooltip"
    >
      <div className={css.tooltipHead}>
        <Swatch type={type} />
        {LINE_LOOKS[type].title}
        <span className={css.rowFigure} style={{ marginLeft: "auto", paddingLeft: 12 }}>
          {length(edges.length[row] ?? 0)}
        </span>
      </div>
      <dl>
        <dt>Layer</dt>
        <dd>{layerOf(edges, row)}</dd>
        <dt>Handle</dt>
        <dd>
          {edges.handles[row]} · edge {row}
        </dd>
        <dt>Rule</dt>
        <dd>{ruleWords(edges.rules[edges.rule[row] ?? -1] ?? "")}</dd>
        {missed !== undefined && (
          <>
            <dt>Deviation</dt>
            <dd>{deviation(missed)}</dd>
          </>
        )}
      </dl>
    </div>
  );
}

const ruleWords = (rule: string): string =>
  rule === "override" ? "decided by hand" : rule === "" ? "none" : rule;
