/** Lines and points of the drawing tool, over the canvas. */

import type { Point } from "../../geometry/records";
import type { Snapped } from "../../geometry/snap";
import { formatFixed } from "../../language/numbers";
import { isAreaKind, useDrafting } from "../../state/drafting/drafting";
import { measure } from "../../state/drafting/measure";
import css from "./drafting.module.css";

/** Rendered anew whenever the view changes; `toScreen` gives the pixel of a place. */
export function DraftOverlay({ toScreen }: { toScreen(place: Point): Point }) {
  const { tool, first, second, cursor } = useDrafting();
  if (tool === null || isAreaKind(tool)) return null;
  const last = second ?? cursor;
  const from = first === null ? null : toScreen(first);
  const to = last === null ? null : toScreen(last);
  return (
    <svg className={css.overlay} aria-hidden="true">
      {from !== null && to !== null && <Stretch tool={tool} from={from} to={to} />}
      {from !== null && <Mark at={from} kind="end" />}
      {to !== null && last !== null && <Mark at={to} kind={last.kind} />}
      {first !== null && from !== null && last !== null && to !== null && (
        <text className={css.figure} x={(from.x + to.x) / 2 + 8} y={(from.y + to.y) / 2 - 8}>
          {`${formatFixed(measure(first, last).distance, 2)} mm`}
        </text>
      )}
    </svg>
  );
}

function Stretch({ tool, from, to }: { tool: string; from: Point; to: Point }) {
  return (
    <>
      {tool === "circle" && (
        <circle
          className={css.stretch}
          cx={from.x}
          cy={from.y}
          r={Math.hypot(to.x - from.x, to.y - from.y)}
        />
      )}
      <line className={css.stretch} x1={from.x} y1={from.y} x2={to.x} y2={to.y} />
    </>
  );
}

/** A square for an end, a triangle for a middle, a circle for a centre, a cross elsewhere. */
function Mark({ at: { x, y }, kind }: { at: Point; kind: Snapped["kind"] }) {
  if (kind === "end")
    return <rect className={css.mark} x={x - 5} y={y - 5} width={10} height={10} />;
  if (kind === "middle") return <path className={css.mark} d={`M${x - 6} ${y + 5}h12l-6 -11z`} />;
  if (kind === "centre") return <circle className={css.mark} cx={x} cy={y} r={6} />;
  return <path className={css.mark} d={`M${x - 6} ${y}h12M${x} ${y - 6}v12`} />;
}
