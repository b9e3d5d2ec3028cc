/** Numbers of blanks and of the starts of tracks, over the canvas, in the order of the next program. */

import type { Point } from "../../geometry/records";
import { useWorkOrder } from "../../state/order/useWorkOrder";
import { freeOf } from "../../state/order/workOrder";
import { useUiStore } from "../../state/store";
import { anchorAt } from "../drafting/anchor";
import drafting from "../drafting/drafting.module.css";
import css from "./workOrder.module.css";

/** Radius of a disc with a number (pixels). */
const RADIUS = 9;
/** Half of the side of a square with the number of a blank (pixels). */
const HALF = 12;

/** Rendered anew whenever the view changes; `toScreen` gives the pixel of a place. */
export function OrderNumbers({ toScreen }: { toScreen(place: Point): Point }) {
  const work = useWorkOrder();
  const selection = useUiStore((ui) => ui.selection);
  if (work === null) return null;
  const [dx, dy] = work.placement;
  const blanks = work.parts.filter(({ number }) => number > 0);
  const marks = [
    // A single blank needs no number.
    ...(blanks.length > 1 ? blanks : []).map(({ box: [left, below, right, above] }, place) => ({
      at: toScreen({ x: (left + right) / 2, y: (below + above) / 2 }),
      number: place + 1,
      isPart: true,
      selected: true,
    })),
    ...work.items.map(({ start, edge }, place) => ({
      at: toScreen({ x: start.x - dx, y: start.y - dy }),
      number: place + 1,
      isPart: false,
      selected: selection.has(edge),
    })),
  ];
  const { transform, local } = anchorAt(marks[0]?.at ?? { x: 0, y: 0 });
  return (
    <div className={drafting.overlay} aria-hidden="true" data-testid="order-numbers">
      <svg className={drafting.anchored} style={{ transform }} role="presentation">
        {freeOf(marks, 2 * RADIUS)
          .map((mark) => ({ ...mark, at: local(mark.at) }))
          .map(({ at, number, selected, isPart }) => (
            <g key={`${isPart}${number}`} data-part={isPart}>
              {isPart ? (
                <rect
                  className={css.part}
                  x={at.x - HALF}
                  y={at.y - HALF}
                  width={2 * HALF}
                  height={2 * HALF}
                  rx={4}
                />
              ) : (
                <circle
                  className={css.disc}
                  cx={at.x}
                  cy={at.y}
                  r={RADIUS}
                  data-selected={selected}
                />
              )}
              <text className={css.figure} x={at.x} y={at.y}>
                {number}
              </text>
            </g>
          ))}
      </svg>
    </div>
  );
}
