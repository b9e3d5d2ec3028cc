/** The sheet with its copies: they are chosen, and moved by dragging or with the arrow keys. */

import { type KeyboardEvent, type PointerEvent, useRef, useState } from "react";
import type { LayoutSheet } from "../../api/layouts";
import { translate } from "../../language/translate";
import css from "./layout.module.css";
import type { Copy, Ring } from "./shapes";

interface Props {
  readonly sheet: LayoutSheet;
  /** Margin at each edge of the sheet (mm). */
  readonly margin: number;
  readonly copies: readonly Copy[];
  readonly colliding: ReadonlySet<number>;
  readonly chosen: ReadonlySet<number>;
  readonly onChoose: (placed: number, more: boolean) => void;
  readonly onChooseNone: () => void;
  /** A drag by (x, y) mm since its begin; `reach` is the distance within which it snaps (mm). */
  readonly onDrag: (x: number, y: number, reach: number) => void;
  readonly onDragEnd: () => void;
  readonly onKey: (event: KeyboardEvent) => void;
}

/** Distance within which a dragged copy snaps (pixels). */
const REACH = 8;

interface Drag {
  readonly x: number;
  readonly y: number;
  readonly scale: number;
}

const pathOf = (ring: Ring): string => {
  let path = "";
  for (let at = 0; at + 1 < ring.length; at += 2)
    path += `${at === 0 ? "M" : "L"}${ring[at]?.toFixed(3)} ${ring[at + 1]?.toFixed(3)}`;
  return `${path}Z`;
};

export function SheetCanvas(props: Props) {
  const { sheet, margin, copies, colliding, chosen, onChoose, onChooseNone } = props;
  const picture = useRef<SVGSVGElement>(null);
  const [drag, setDrag] = useState<Drag | null>(null);
  const room = Math.max(sheet.width, sheet.height) * 0.04;
  const frame = [-room, -sheet.height - room, sheet.width + 2 * room, sheet.height + 2 * room];

  const start = (event: PointerEvent<SVGElement>, placed: number) => {
    const matrix = picture.current?.getScreenCTM();
    if (event.button !== 0 || !matrix) return;
    event.stopPropagation();
    event.currentTarget.setPointerCapture(event.pointerId);
    if (!chosen.has(placed) || event.shiftKey) onChoose(placed, event.shiftKey);
    setDrag({ x: event.clientX, y: event.clientY, scale: matrix.a });
  };
  const move = (event: PointerEvent) => {
    if (drag === null) return;
    const x = (event.clientX - drag.x) / drag.scale;
    const y = (drag.y - event.clientY) / drag.scale;
    props.onDrag(x, y, event.altKey ? 0 : REACH / drag.scale);
  };
  const end = () => {
    if (drag !== null) props.onDragEnd();
    setDrag(null);
  };
  return (
    <svg
      ref={picture}
      className={css.canvas}
      viewBox={frame.join(" ")}
      role="application"
      aria-label={translate("layoutEditor.theSheet")}
      // biome-ignore lint/a11y/noNoninteractiveTabindex: arrow keys move the chosen copies
      tabIndex={0}
      onKeyDown={props.onKey}
      onPointerDown={onChooseNone}
      onPointerMove={move}
      onPointerUp={end}
      onPointerCancel={end}
      data-testid="sheet-canvas"
    >
      <g transform="scale(1 -1)">
        <rect className={css.sheet} width={sheet.width} height={sheet.height} />
        {2 * margin < Math.min(sheet.width, sheet.height) && (
          <rect
            className={css.margin}
            x={margin}
            y={margin}
            width={sheet.width - 2 * margin}
            height={sheet.height - 2 * margin}
          />
        )}
        {sheet.grain !== null && <Grain sheet={sheet} />}
        {copies.map((copy, index) => (
          <g
            // biome-ignore lint/suspicious/noArrayIndexKey: copies are told apart by their number
            key={index}
            transform={`translate(${copy.x} ${copy.y})`}
            className={css.copy}
            data-chosen={chosen.has(copy.placed)}
            data-colliding={colliding.has(index)}
            onPointerDown={(event) => start(event, copy.placed)}
            data-testid="sheet-copy"
          >
            <rect className={css.box} width={copy.shape.width} height={copy.shape.height} />
            <path
              d={[...copy.shape.outlines, ...copy.shape.holes].map(pathOf).join("")}
              fillRule="evenodd"
            />
          </g>
        ))}
      </g>
    </svg>
  );
}

/** An arrow with two heads along the grain, in the middle of the sheet. */
function Grain({ sheet }: { sheet: LayoutSheet }) {
  const half = Math.min(sheet.width, sheet.height) * 0.12;
  const head = half * 0.3;
  const turn = sheet.grain === "y" ? 90 : 0;
  return (
    <path
      className={css.grain}
      transform={`translate(${sheet.width / 2} ${sheet.height / 2}) rotate(${turn})`}
      d={
        `M${-half} 0L${half} 0M${half - head} ${head}L${half} 0L${half - head} ${-head}` +
        `M${head - half} ${head}L${-half} 0L${head - half} ${-head}`
      }
    />
  );
}
