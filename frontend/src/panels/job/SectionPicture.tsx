/** The section of the board across an edge, to scale, with dimensions. */

import type { ToolSection } from "../../api/jobs";
import { translate } from "../../language/translate";
import type { Drawn, Measure, SectionView } from "../../state/job/section";
import { sectionView } from "../../state/job/section";
import css from "./check.module.css";
import { measureText } from "./measureTexts";

interface Props {
  readonly caliper: number;
  readonly tool: ToolSection;
  readonly measures: readonly Measure[];
}

/** Half the length of an arrow of a dimension (pixels), and shortest dimension with arrows. */
const ARROW = 3.5;
const SHORTEST = 16;

export function SectionPicture({ caliper, tool, measures }: Props) {
  const view = sectionView(caliper, tool);
  const { x, y, half } = view;
  const labels = new Map(
    measures.map((one) => [one.name, `${one.letter} ${measureText(one)}`] as const),
  );
  const label = (name: Drawn) => labels.get(name);
  const right = x.right + 12;
  return (
    <svg
      className={css.section}
      viewBox={`0 0 ${view.width} ${view.height}`}
      role="img"
      aria-label={translate("sectionPanel.sectionToScale", { tool: tool.name })}
      data-testid="section-picture"
    >
      <path className={css.board} d={view.board} />
      <path className={css.mat} d={`M${x.left} ${y.bottom + 3}H${x.right}`} />
      <path className={css.tool} d={view.tool} />
      <Vertical at={x.left - 10} from={y.top} to={y.bottom} label={label("caliper")} isLeft />
      <Vertical
        at={right}
        from={y.top}
        to={y.depth}
        label={label("depth")}
        extendTo={x.middle + (tool.shape === "groove" ? 0 : half)}
      />
      <Vertical at={right} from={y.depth} to={y.bottom} label={label("base")} />
      <Vertical
        at={right}
        from={y.bottom}
        to={y.tip}
        label={label("beyond")}
        extendTo={x.middle + half}
      />
      {label("topWidth") !== undefined && <Width view={view} label={label("topWidth")} />}
      {label("foldAngle") !== undefined && <Angle view={view} label={label("foldAngle")} />}
    </svg>
  );
}

interface VerticalProps {
  readonly at: number;
  readonly from: number;
  readonly to: number;
  readonly label: string | undefined;
  /** The text is at the left of the line. */
  readonly isLeft?: boolean;
  /** Where the extension line from the end of the dimension ends. */
  readonly extendTo?: number;
}

/** A vertical dimension; nothing without a label. */
function Vertical({ at, from, to, label, isLeft = false, extendTo }: VerticalProps) {
  if (label === undefined) return null;
  const tip = (y: number, sign: number) =>
    to - from < SHORTEST
      ? ""
      : `M${at - ARROW} ${y + sign * 6}L${at} ${y}L${at + ARROW} ${y + sign * 6}`;
  const extension = extendTo === undefined ? "" : `M${extendTo + 3} ${to}H${at + 4}`;
  return (
    <>
      <path
        className={css.dimension}
        d={`M${at} ${from}V${to}M${at - 4} ${from}h8M${at - 4} ${to}h8${tip(from, 1)}${tip(to, -1)}${extension}`}
      />
      <text
        className={css.dimensionText}
        x={isLeft ? at - 6 : at + 8}
        y={(from + to) / 2 + 4}
        textAnchor={isLeft ? "end" : "start"}
      >
        {label}
      </text>
    </>
  );
}

interface OverProps {
  readonly view: SectionView;
  readonly label: string | undefined;
}

/** Width of the opening, above the board. */
function Width({ view: { x, y, half }, label }: OverProps) {
  const at = y.top - 24;
  const [left, right] = [x.middle - half, x.middle + half];
  return (
    <>
      <path
        className={css.dimension}
        d={`M${left} ${at}H${right}M${left} ${at - 4}V${y.top - 3}M${right} ${at - 4}V${y.top - 3}`}
      />
      <text className={css.dimensionText} x={x.middle} y={at - 8} textAnchor="middle">
        {label}
      </text>
    </>
  );
}

/** Angle between the flanks of a groove, below the board. */
function Angle({ view: { x, y, half }, label }: OverProps) {
  const deep = y.depth - y.top;
  const flank = Math.hypot(half, deep);
  if (flank === 0) return null;
  const radius = 0.6 * flank;
  const [dx, dy] = [(radius * half) / flank, (radius * deep) / flank];
  return (
    <>
      <path
        className={css.dimension}
        d={`M${x.middle - dx} ${y.depth - dy}A${radius} ${radius} 0 0 1 ${x.middle + dx} ${y.depth - dy}`}
      />
      <text
        className={css.dimensionText}
        x={x.middle}
        y={Math.max(y.bottom, y.tip) + 18}
        textAnchor="middle"
      >
        {label}
      </text>
    </>
  );
}
