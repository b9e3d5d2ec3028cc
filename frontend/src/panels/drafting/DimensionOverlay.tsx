/** Dimensions over the canvas: of the drawing, of the selected edges, and kept measurements. */

import { useMemo } from "react";
import { boundsOf } from "../../geometry/bounds";
import type { Box, Point } from "../../geometry/records";
import { sizeOf } from "../../geometry/size";
import { formatFixed } from "../../language/numbers";
import { translate } from "../../language/translate";
import { type Dimension, dimensionKey, useDimensions } from "../../state/drafting/dimensions";
import { useDrafting } from "../../state/drafting/drafting";
import { measure } from "../../state/drafting/measure";
import { useEdges } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { anchorAt } from "./anchor";
import css from "./drafting.module.css";

interface Props {
  /** The pixel of a place; the component is rendered anew whenever the view changes. */
  toScreen(place: Point): Point;
  /** Empty if the unit of the file is unknown. */
  readonly unit: "mm" | "";
}

/** Distance of a dimension line from what it measures (pixels). */
const OVERALL = 14;
const SELECTED = 12;
/** A dimension line that is shorter has no figure (pixels). */
const SHORTEST = 26;

const NONE: readonly Dimension[] = [];

export function DimensionOverlay({ toScreen, unit }: Props) {
  const shown = useDimensions((dimensions) => dimensions.shown);
  const drawing = useUiStore((ui) => ui.drawing);
  const kept = useDimensions((dimensions) => dimensions.kept.get(drawing ?? "") ?? NONE);
  const selection = useUiStore((ui) => ui.selection);
  const { data: edges } = useEdges();
  const measuring = useDrafting((draft) => draft.tool === "measure");
  const overall = useMemo(() => (edges === undefined ? null : boundsOf(edges)), [edges]);
  const size = useMemo(() => {
    const rows = [...selection].filter((row) => row < (edges?.bulge.length ?? 0));
    return edges === undefined ? null : sizeOf(edges, rows);
  }, [edges, selection]);
  if (!shown || drawing === null) return null;
  const figure = (length: number) => `${formatFixed(length, 2)}${unit === "" ? "" : ` ${unit}`}`;
  const line = (from: Point, to: Point, text: string, apart: number) => (
    <DimensionLine
      key={`${dimensionKey({ from, to })} ${apart}`}
      from={toScreen(from)}
      to={toScreen(to)}
      text={text}
      apart={apart}
    />
  );
  const sides = (box: Box, apart: number) => [
    line({ x: box[0], y: box[1] }, { x: box[2], y: box[1] }, figure(box[2] - box[0]), apart),
    line({ x: box[2], y: box[1] }, { x: box[2], y: box[3] }, figure(box[3] - box[1]), apart),
  ];
  return (
    <>
      <div className={css.overlay} role="img" aria-label={translate("dimensions.dimensions")}>
        <div className={css.dimension} data-testid="overall-size">
          {overall !== null && sides(overall, OVERALL)}
        </div>
        <div className={css.dimension} data-tone="selected" data-testid="selection-size">
          {size?.kind === "box" &&
            String(size.box) !== String(overall) &&
            sides(size.box, SELECTED)}
          {size?.kind === "line" && line(size.from, size.to, figure(size.length), SELECTED)}
          {size?.kind === "arc" && line(size.centre, size.at, `R ${figure(size.radius)}`, 0)}
        </div>
        <div className={css.dimension} data-tone="kept" data-testid="kept-dimensions">
          {kept.map(({ from, to }) =>
            line(from, to, measuring ? "" : figure(measure(from, to).distance), 0),
          )}
        </div>
      </div>
      {measuring &&
        kept.map((dimension) => (
          <Removable
            key={dimensionKey(dimension)}
            text={figure(measure(dimension.from, dimension.to).distance)}
            at={middle(toScreen(dimension.from), toScreen(dimension.to))}
            remove={() => useDimensions.getState().remove(drawing, dimension)}
          />
        ))}
    </>
  );
}

const middle = (a: Point, b: Point): Point => ({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 });

interface LineProps {
  readonly from: Point;
  readonly to: Point;
  readonly text: string;
  /** Distance from the measured points, to the right of the direction on the screen (pixels). */
  readonly apart: number;
}

/** A line between two points, moved aside, with a tick at each end and its figure. */
function DimensionLine({ text, apart, ...ends }: LineProps) {
  const { transform, local } = anchorAt(ends.from);
  const [from, to] = [local(ends.from), local(ends.to)];
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  if (length < 1) return null;
  const along = { x: (to.x - from.x) / length, y: (to.y - from.y) / length };
  const side = { x: -along.y * apart, y: along.x * apart };
  const a = { x: from.x + side.x, y: from.y + side.y };
  const b = { x: to.x + side.x, y: to.y + side.y };
  const tick = ({ x, y }: Point) =>
    `M${x - 4 * (along.x - along.y)} ${y - 4 * (along.y + along.x)}L${x + 4 * (along.x - along.y)} ${y + 4 * (along.y + along.x)}`;
  // Read from the left or from below.
  const turned = (Math.atan2(along.y, along.x) * 180) / Math.PI;
  const angle = turned > 90 || turned <= -90 ? turned + 180 : turned;
  const at = middle(a, b);
  return (
    // The parent has the label.
    <svg className={css.anchored} style={{ transform }} aria-hidden="true">
      {apart > 0 && <path d={`M${from.x} ${from.y}L${a.x} ${a.y}M${to.x} ${to.y}L${b.x} ${b.y}`} />}
      <path d={`M${a.x} ${a.y}L${b.x} ${b.y}${tick(a)}${tick(b)}`} />
      {length >= SHORTEST && text !== "" && (
        <text
          className={css.dimensionText}
          transform={`translate(${at.x} ${at.y}) rotate(${angle})`}
          textAnchor="middle"
          dy="0.35em"
        >
          {text}
        </text>
      )}
    </svg>
  );
}

interface RemovableProps {
  readonly text: string;
  readonly at: Point;
  remove(): void;
}

/** The figure of a kept measurement as a button that removes it. */
function Removable({ text, at, remove }: RemovableProps) {
  return (
    <button
      type="button"
      className={css.removable}
      style={{ left: at.x, top: at.y }}
      aria-label={translate("dimensions.removeTheDimension", { text })}
      title={translate("dimensions.removeTheDimension", { text })}
      onClick={remove}
      data-testid="remove-dimension"
    >
      {text}
      <span aria-hidden>×</span>
    </button>
  );
}
