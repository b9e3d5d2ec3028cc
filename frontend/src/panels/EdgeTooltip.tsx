/** The edge under the cursor, its figures, and the moves that pass there. */

import { Fragment } from "react";
import type { Verdict } from "../api/client";
import { type Edges, lineTypeOf, MOTIONS, type Motion, type Toolpath } from "../geometry/records";
import { formatDeviation, formatHundredths } from "../state/format";
import { ruleText } from "../state/inspect";
import { LINE_STYLES, TRAVEL } from "../state/palette";
import { useEdges, useJob, useMachines, useToolpath, useVerdict } from "../state/queries";
import { layerOf } from "../state/rows";
import { useUiStore } from "../state/store";
import { useFormatLength } from "../state/useFormatLength";
import overlayCss from "./overlay.module.css";
import css from "./panels.module.css";
import { Swatch } from "./Swatch";

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
        <span className={css.rowFigure} style={{ marginLeft: "auto", paddingLeft: 12 }}>
          {length(edges.length[row] ?? 0)}
        </span>
      </div>
      <dl>
        <dt>Layer in file</dt>
        <dd>{layerOf(edges, row)}</dd>
        <dt>Object in file</dt>
        <dd>
          {edges.handles[row]} (edge number {row})
        </dd>
        <dt>Reason for line type</dt>
        <dd>{ruleText(edges.rules[edges.rule[row] ?? -1] ?? "")}</dd>
        {verdict !== undefined && verdict.edge_deviation.length === edges.bulge.length && (
          <>
            <dt>Deviation from drawing</dt>
            <dd>{formatDeviation(verdict.edge_deviation[row] ?? Number.NaN)}</dd>
            <Figures figures={deviationParts(verdict, row)} />
            <dt>Overcut length</dt>
            <dd>{formatHundredths(verdict.edge_overcut[row] ?? Number.NaN)}</dd>
            <dt>Uncut length</dt>
            <dd>{formatHundredths(verdict.edge_uncut[row] ?? Number.NaN)}</dd>
            <dt>Gap at each end of the edge</dt>
            <dd>{formatHundredths(verdict.edge_setback[row] ?? Number.NaN)}</dd>
            <Figures figures={optionalFigures(verdict, row)} />
          </>
        )}
      </dl>
    </>
  );
}

interface Figure {
  readonly title: string;
  readonly value: string;
}

function Figures({ figures }: { figures: readonly Figure[] }) {
  return figures.map(({ title, value }) => (
    <Fragment key={title}>
      <dt>{title}</dt>
      <dd>{value}</dd>
    </Fragment>
  ));
}

/** The parts of the deviation of an edge; none if all of it is the deviation of the tool path. */
function deviationParts(verdict: Verdict, row: number): Figure[] {
  const figure = (column: readonly number[]) => column[row] ?? 0;
  const rounding = figure(verdict.edge_blending);
  const fit = figure(verdict.edge_fit_error);
  if (rounding === 0 && fit === 0) return [];
  return [
    {
      title: "Tool path off the edge",
      value: formatDeviation(figure(verdict.edge_path_deviation)),
    },
    { title: "Corner rounding by controller", value: formatDeviation(rounding) },
    { title: "Edge off the curve in file", value: formatDeviation(fit) },
  ];
}

/** Figures that only some edges have: groove section, board faces, unreachable length. */
function optionalFigures(verdict: Verdict, row: number): Figure[] {
  const figure = (column: readonly number[]) => column[row] ?? 0;
  const listed: Figure[] = [];
  const width = figure(verdict.edge_width);
  if (width > 0) {
    listed.push(
      { title: "Groove width", value: `${formatHundredths(width)} at the top face` },
      { title: "Board thickness under groove", value: formatHundredths(figure(verdict.edge_web)) },
      {
        title: "Position error of groove sides",
        value: formatDeviation(figure(verdict.edge_flank)),
      },
    );
  }
  const top = figure(verdict.edge_top_overcut);
  const bottom = figure(verdict.edge_bottom_uncut);
  if (top >= MIN_LISTED)
    listed.push({ title: "Overcut on top face", value: formatHundredths(top) });
  if (bottom >= MIN_LISTED)
    listed.push({ title: "Uncut on bottom face", value: formatHundredths(bottom) });
  const left = figure(verdict.edge_unreached);
  if (left >= MIN_LISTED)
    listed.push({
      title: "Unreachable length",
      value: `${formatHundredths(left)}, up to ${formatHundredths(figure(verdict.edge_unreached_distance))} from the cut`,
    });
  const slit = figure(verdict.edge_slit_length);
  if (slit >= MIN_LISTED)
    listed.push({ title: "Slit as wide as the tool", value: formatHundredths(slit) });
  return listed;
}

const MOTION_TITLES: Readonly<Record<Motion, string>> = {
  rapid: "Move above board",
  plunge: "Plunge into board",
  "lead-in": "Lead-in",
  feed: "Cut or crease",
  swivel: "Tool turn",
  "lead-out": "Lead-out",
  lift: "Lift out of board",
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
          stations?.find(({ number }) => number === tool)?.name ?? `Tool station ${tool}`;
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
              <span>tip height {(toolpath.pose[row * 4 + 6] ?? 0).toFixed(2)} mm</span>
              <span>{line > 0 ? `program line ${line.toLocaleString("en")}` : ""}</span>
            </div>
          </div>
        );
      })}
      {rows.length > MOVES && (
        <div className={overlayCss.tooltipMove}>
          <span>… and {rows.length - MOVES} more moves</span>
        </div>
      )}
    </div>
  );
}
