/** Numbers at the starts of the tracks, over the canvas, in the order of the next program. */

import type { Point } from "../../geometry/records";
import { useWorkOrder } from "../../state/order/useWorkOrder";
import { freeOf } from "../../state/order/workOrder";
import { useUiStore } from "../../state/store";
import { anchorAt } from "../drafting/anchor";
import drafting from "../drafting/drafting.module.css";
import css from "./workOrder.module.css";

/** Radius of a disc with a number (pixels). */
const RADIUS = 9;

/** Rendered anew whenever the view changes; `toScreen` gives the pixel of a place. */
export function OrderNumbers({ toScreen }: { toScreen(place: Point): Point }) {
  const work = useWorkOrder();
  const selection = useUiStore((ui) => ui.selection);
  if (work === null) return null;
  const [dx, dy] = work.placement;
  const marks = work.items.map(({ start, edge }, place) => ({
    at: toScreen({ x: start.x - dx, y: start.y - dy }),
    number: place + 1,
    selected: selection.has(edge),
  }));
  const { transform, local } = anchorAt(marks[0]?.at ?? { x: 0, y: 0 });
  return (
    <div className={drafting.overlay} aria-hidden="true" data-testid="order-numbers">
      <svg className={drafting.anchored} style={{ transform }} role="presentation">
        {freeOf(marks, 2 * RADIUS)
          .map((mark) => ({ ...mark, at: local(mark.at) }))
          .map(({ at, number, selected }) => (
            <g key={number}>
              <circle
                className={css.disc}
                cx={at.x}
                cy={at.y}
                r={RADIUS}
                data-selected={selected}
              />
              <text className={css.figure} x={at.x} y={at.y}>
                {number}
              </text>
            </g>
          ))}
      </svg>
    </div>
  );
}
