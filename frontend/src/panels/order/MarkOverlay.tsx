/** Marks of a printed sheet over the canvas, and the point that the next click takes. */

import type { Point } from "../../geometry/records";
import { useMarkPicking } from "../../state/order/marks";
import { useUiStore } from "../../state/store";
import { anchorAt } from "../drafting/anchor";
import drafting from "../drafting/drafting.module.css";

/** Rendered anew whenever the view changes; `toScreen` gives the pixel of a place. */
export function MarkOverlay({ toScreen }: { toScreen(place: Point): Point }) {
  const marks = useUiStore((ui) => ui.registration?.marks);
  const cursor = useMarkPicking((picking) => picking.cursor);
  if ((marks === undefined || marks.length === 0) && cursor === null) return null;
  return (
    <div className={drafting.overlay} aria-hidden="true" data-testid="mark-overlay">
      {marks?.map(([x, y], at) => (
        <Cross key={`${x} ${y}`} at={toScreen({ x, y })} text={String(at + 1)} />
      ))}
      {cursor !== null && <Cross at={toScreen(cursor)} text="" />}
    </div>
  );
}

function Cross({ at, text }: { at: Point; text: string }) {
  return (
    <svg
      className={drafting.anchored}
      style={{ transform: anchorAt(at).transform }}
      aria-hidden="true"
      data-testid={text === "" ? "mark-cursor" : "mark-cross"}
    >
      <circle className={drafting.mark} r={7} />
      <path className={drafting.mark} d="M-12 0h24M0 -12v24" />
      {text !== "" && (
        <text className={drafting.figure} x={10} y={-10}>
          {text}
        </text>
      )}
    </svg>
  );
}
