/** The edge under the cursor, its figures, and the moves that pass there. */

import { Fragment } from "react";
import type { Verdict } from "../../api/client";
import {
  type Edges,
  lineTypeOf,
  MOTIONS,
  type Motion,
  type Toolpath,
} from "../../geometry/records";
import { formatFixed } from "../../language/numbers";
import { translate } from "../../language/translate";
import { messageText } from "../../messages/translateMessage";
import { ruleText } from "../../state/drawing/inspect";
import { LINE_STYLES, TRAVEL } from "../../state/drawing/palette";
import { layerOf } from "../../state/drawing/rows";
import { useFormatLength } from "../../state/drawing/useFormatLength";
import { formatDeviation, formatHundredths } from "../../state/format";
import { EDGE_FIGURE_LINES } from "../../state/job/figures";
import { useEdges, useJob, useMachines, useToolpath, useVerdict } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { Figure } from "../shared/parts";
import { Swatch } from "../shared/Swatch";
import overlayCss from "./overlay.module.css";

const WIDTH = 320;
const HEAD = 100;
const LINE = 20;
const FIGURES = 4;
/** Shorter lengths are not listed (mm). */
const MIN_LISTED = 0.005;
/** Moves listed at most; the rest is counted. */
const MOVES = 4;

export function EdgeTooltip({ width, height }: { width: number; height: number }) {
  const hover = useUiStore((ui) => ui.hover);
  const { data: edges } = useEdges();
  const { data: toolpath } = useToolpath();
  const { data: verdict } = useVerdict();
  if (hover === null) return null;
  const { x, y } = hover;
  const row = edges !== undefined && (hover.row ?? -1) < edges.bulge.length ? hover.row : null;
  const moves = hover.moves.filter((move) => move < (toolpath?.motion.length ?? 0));
  if (row === null && moves.length === 0) return null;
  const more =
    verdict === undefined || row === null
      ? 0
      : deviationParts(verdict, row).length + optionalFigures(verdict, row).length;
  const lines = (verdict === undefined ? 0 : FIGURES + more) + Math.min(moves.length, MOVES + 1);
  const estimatedHeight = HEAD + lines * LINE;
  const horizontal = x + WIDTH + 24 > width ? { right: width - x + 14 } : { left: x + 16 };
  const vertical =
    y + estimatedHeight + 24 > height ? { bottom: height - y + 12 } : { top: y + 16 };
  return (
    <div
      className={`${overlayCss.float} ${overlayCss.tooltip}`}
      style={{ ...horizontal, ...vertical }}
      role="tooltip"
      data-testid="edge-tooltip"
    >
      {row !== null && edges !== undefined && <Edge row={row} edges={edges} />}
      {moves.length > 0 && toolpath !== undefined && <Moves rows={moves} toolpath={toolpath} />}
    </div>
  );
}

function Edge({ row, edges }: { row: number; edges: Edges }) {
  const { data: verdict } = useVerdict();
  const length = useFormatLength();
  const type = lineTypeOf(edges.lineType[row]);
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
        <dt>{translate("edgeTooltip.objectInFile")}</dt>
        <dd>
          {edges.handles[row]} {translate("edgeTooltip.edgeNumber", { row })}
        </dd>
        <dt>{translate("edgeTooltip.reasonForLineType")}</dt>
        <dd>{ruleText(edges.rules[edges.rule[row] ?? -1] ?? "")}</dd>
        {verdict !== undefined && verdict.edge_deviation.length === edges.bulge.length && (
          <>
            <dt>{translate("edgeTooltip.deviationFromDrawing")}</dt>
            <dd>{formatDeviation(verdict.edge_deviation[row] ?? Number.NaN)}</dd>
            <Values figures={deviationParts(verdict, row)} />
            <dt>{translate("edgeTooltip.overcutLength")}</dt>
            <dd>{formatHundredths(verdict.edge_overcut[row] ?? Number.NaN)}</dd>
            <dt>{translate("edgeTooltip.uncutLength")}</dt>
            <dd>{formatHundredths(verdict.edge_uncut[row] ?? Number.NaN)}</dd>
            <dt>{translate("edgeTooltip.gapAtEachEndOf")}</dt>
            <dd>{formatHundredths(verdict.edge_setback[row] ?? Number.NaN)}</dd>
            <Values figures={optionalFigures(verdict, row)} />
          </>
        )}
      </dl>
    </>
  );
}

interface Value {
  readonly title: string;
  readonly value: string;
}

function Values({ figures }: { figures: readonly Value[] }) {
  return figures.map(({ title, value }) => (
    <Fragment key={title}>
      <dt>{title}</dt>
      <dd>{value}</dd>
    </Fragment>
  ));
}

/** The parts of the deviation of an edge; none if all of it is the deviation of the tool path. */
function deviationParts(verdict: Verdict, row: number): Value[] {
  const figure = (column: readonly number[]) => column[row] ?? 0;
  const rounding = figure(verdict.edge_blending);
  const fit = figure(verdict.edge_fit_error);
  if (rounding === 0 && fit === 0) return [];
  return [
    {
      title: translate("edgeTooltip.toolPathOffTheEdge"),
      value: formatDeviation(figure(verdict.edge_path_deviation)),
    },
    {
      title: translate("edgeTooltip.cornerRoundingByController"),
      value: formatDeviation(rounding),
    },
    { title: translate("edgeTooltip.edgeOffTheCurveIn"), value: formatDeviation(fit) },
  ];
}

/** Figures that only some edges have: groove section, board faces, unreachable length. */
function optionalFigures(verdict: Verdict, row: number): Value[] {
  const figure = (column: readonly number[]) => column[row] ?? 0;
  const listed: Value[] = [];
  const width = figure(verdict.edge_width);
  if (width > 0) {
    listed.push(
      {
        title: translate("edgeTooltip.grooveWidth"),
        value: translate("edgeTooltip.atTheTopFace", { width: formatHundredths(width) }),
      },
      {
        title: translate("edgeTooltip.boardThicknessUnderGroove"),
        value: formatHundredths(figure(verdict.edge_web)),
      },
      {
        title: translate("edgeTooltip.positionErrorOfGrooveSides"),
        value: formatDeviation(figure(verdict.edge_flank)),
      },
    );
  }
  const left = figure(verdict.edge_unreached);
  if (left >= MIN_LISTED)
    listed.push({
      title: translate("edgeTooltip.unreachableLength"),
      value: translate("edgeTooltip.upToFromTheCut", {
        length: formatHundredths(left),
        distance: formatHundredths(figure(verdict.edge_unreached_distance)),
      }),
    });
  for (const { name, title } of EDGE_FIGURE_LINES) {
    const value = figure(verdict[name]);
    if (value >= MIN_LISTED)
      listed.push({ title: messageText(title), value: formatHundredths(value) });
  }
  return listed;
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
