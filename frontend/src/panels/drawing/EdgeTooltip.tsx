/** The edge under the cursor in three rows; a click shows the rest in the inspector. */

import {
  type Edges,
  lineTypeOf,
  MOTIONS,
  type Motion,
  type Toolpath,
} from "../../geometry/records";
import { formatFixed } from "../../language/numbers";
import { translate } from "../../language/translate";
import { ruleText } from "../../state/drawing/inspect";
import { LINE_STYLES, TRAVEL } from "../../state/drawing/palette";
import { layerOf } from "../../state/drawing/rows";
import { useFormatLength } from "../../state/drawing/useFormatLength";
import { formatDeviation } from "../../state/format";
import { useEdges, useJob, useMachines, useToolpath, useVerdict } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { Figure } from "../shared/parts";
import { Swatch } from "../shared/Swatch";
import overlayCss from "./overlay.module.css";

const WIDTH = 300;
const HEIGHT = 96;

export function EdgeTooltip({ width, height }: { width: number; height: number }) {
  const hover = useUiStore((ui) => ui.hover);
  const { data: edges } = useEdges();
  const { data: toolpath } = useToolpath();
  if (hover === null) return null;
  const { x, y } = hover;
  const row = edges !== undefined && (hover.row ?? -1) < edges.bulge.length ? hover.row : null;
  const moves = hover.moves.filter((move) => move < (toolpath?.motion.length ?? 0));
  if (row === null && moves.length === 0) return null;
  const horizontal = x + WIDTH + 24 > width ? { right: width - x + 14 } : { left: x + 16 };
  const vertical = y + HEIGHT + 24 > height ? { bottom: height - y + 12 } : { top: y + 16 };
  return (
    <div
      className={`${overlayCss.float} ${overlayCss.tooltip}`}
      style={{ ...horizontal, ...vertical }}
      role="tooltip"
      data-testid="edge-tooltip"
    >
      {row !== null && edges !== undefined ? (
        <Edge row={row} edges={edges} />
      ) : (
        toolpath !== undefined && <Moves rows={moves} toolpath={toolpath} />
      )}
    </div>
  );
}

/** Line type and length, layer, and the deviation of the program or the reason for the type. */
function Edge({ row, edges }: { row: number; edges: Edges }) {
  const { data: verdict } = useVerdict();
  const length = useFormatLength();
  const type = lineTypeOf(edges.lineType[row]);
  const isJudged = verdict !== undefined && verdict.edge_deviation.length === edges.bulge.length;
  return (
    <>
      <div className={overlayCss.tooltipHead}>
        <Swatch type={type} />
        {LINE_STYLES[type].title}
        <Figure style={{ marginLeft: "auto", paddingLeft: 12 }}>
          {length(edges.length[row] ?? 0)}
        </Figure>
      </div>
      <dl>
        <dt>{translate("edgeTooltip.layerInFile")}</dt>
        <dd>{layerOf(edges, row)}</dd>
        {isJudged ? (
          <>
            <dt>{translate("edgeTooltip.deviationFromDrawing")}</dt>
            <dd>{formatDeviation(verdict.edge_deviation[row] ?? Number.NaN)}</dd>
          </>
        ) : (
          <>
            <dt>{translate("edgeTooltip.reasonForLineType")}</dt>
            <dd className={overlayCss.oneLine}>
              {ruleText(edges.rules[edges.rule[row] ?? -1] ?? "")}
            </dd>
          </>
        )}
      </dl>
    </>
  );
}

const MOTION_TITLES: Readonly<Record<Motion, string>> = {
  rapid: translate("edgeTooltip.moveAboveBoard"),
  plunge: translate("edgeTooltip.plungeIntoBoard"),
  "lead-in": translate("edgeTooltip.leadIn"),
  feed: translate("edgeTooltip.cutOrCrease"),
  swivel: translate("edgeTooltip.toolTurn"),
  "lead-out": translate("edgeTooltip.leadOut"),
  lift: translate("edgeTooltip.liftOutOfBoard"),
};

/** Moves listed at most; the rest is counted. */
const MOVES = 2;

/** The moves under the cursor: tool, kind of move, height and program line. */
function Moves({ rows, toolpath }: { rows: readonly number[]; toolpath: Toolpath }) {
  const { data: job } = useJob();
  const { data: machines } = useMachines();
  const stations = machines?.find(({ name }) => name === job?.machine)?.stations;
  const shown = rows.slice(0, MOVES);
  return (
    <div className={overlayCss.tooltipMoves} data-testid="moves-tooltip">
      {shown.map((row, at) => {
        const tool = toolpath.tool[row] ?? 0;
        const before = shown[at - 1];
        const named = before === undefined || toolpath.tool[before] !== tool;
        const name =
          stations?.find(({ number }) => number === tool)?.name ??
          translate("edgeTooltip.toolStation", { tool });
        const line = toolpath.line[row] ?? -1;
        return (
          <div key={row}>
            {named && (
              <div className={overlayCss.tooltipHead}>
                <span className={overlayCss.chipLine} style={{ color: TRAVEL.head }} />
                {name}
              </div>
            )}
            <div className={overlayCss.tooltipMove}>
              <span>{MOTION_TITLES[MOTIONS[toolpath.motion[row] ?? 0] ?? "rapid"]}</span>
              <span>
                {translate("edgeTooltip.tipHeightMm", {
                  height: formatFixed(toolpath.pose[row * 4 + 6] ?? 0, 2),
                })}
              </span>
              <span>{line > 0 ? translate("edgeTooltip.programLine", { line }) : ""}</span>
            </div>
          </div>
        );
      })}
      {rows.length > MOVES && (
        <div className={overlayCss.tooltipMove}>
          <span>{translate("edgeTooltip.andMoreMoves", { rows: rows.length - MOVES })}</span>
        </div>
      )}
    </div>
  );
}
