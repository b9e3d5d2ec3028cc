/** Figures of the verdict for one edge, for the inspector. */

import { Fragment } from "react";
import type { Verdict } from "../../api/jobs";
import { translate } from "../../language/translate";
import { messageText } from "../../messages/translateMessage";
import { formatDeviation, formatHundredths } from "../../state/format";
import { EDGE_FIGURE_LINES } from "../../state/job/figures";
import { useVerdict } from "../../state/queries";

/** Shorter lengths are not listed (mm). */
const MIN_LISTED = 0.005;

/** Rows of a list of facts; none without a verdict of these edges. */
export function EdgeFigures({ row, edges }: { row: number; edges: number }) {
  const { data: verdict } = useVerdict();
  if (verdict === undefined || verdict.edge_deviation.length !== edges) return null;
  return (
    <>
      <dt>{translate("edgeTooltip.deviationFromDrawing")}</dt>
      <dd>{formatDeviation(verdict.edge_deviation[row] ?? Number.NaN)}</dd>
      <Values figures={deviationParts(verdict, row)} />
      <Values figures={lengths(verdict, row)} />
      <Values figures={optionalFigures(verdict, row)} />
    </>
  );
}

/** Lengths that the program cuts too far or leaves; those that are 0 are left out. */
function lengths(verdict: Verdict, row: number): Value[] {
  const listed = [
    { title: translate("edgeTooltip.overcutLength"), column: verdict.edge_overcut },
    { title: translate("edgeTooltip.uncutLength"), column: verdict.edge_uncut },
    { title: translate("edgeTooltip.gapAtEachEndOf"), column: verdict.edge_setback },
  ];
  return listed
    .map(({ title, column }) => ({ title, length: column[row] ?? 0 }))
    .filter(({ length }) => length >= MIN_LISTED)
    .map(({ title, length }) => ({ title, value: formatHundredths(length) }));
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
