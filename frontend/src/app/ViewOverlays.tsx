/** What lies over the canvas at places of the drawing: rendered anew whenever the view changes. */

import { useEffect, useReducer } from "react";
import type { Point } from "../geometry/records";
import { DimensionOverlay } from "../panels/drafting/DimensionOverlay";
import { DraftOverlay } from "../panels/drafting/DraftOverlay";
import { MarkOverlay } from "../panels/order/MarkOverlay";
import { OrderNumbers } from "../panels/order/OrderNumbers";
import { useUiStore } from "../state/store";
import type { Viewer } from "../viewer/viewer";

interface Props {
  readonly viewer: Viewer;
  /** Functions that are called whenever the view changes. */
  readonly listeners: Set<() => void>;
  readonly unit: "mm" | "";
}

export function ViewOverlays({ viewer, listeners, unit }: Props) {
  const [, redraw] = useReducer((count: number) => count + 1, 0);
  useEffect(() => {
    listeners.add(redraw);
    return () => {
      listeners.delete(redraw);
    };
  }, [listeners]);
  const step = useUiStore((ui) => ui.step);
  const toScreen = (place: Point): Point => viewer.toScreen(place);
  if (step === "process") return <OrderNumbers toScreen={toScreen} />;
  if (step === "sheet") return <MarkOverlay toScreen={toScreen} />;
  if (step !== "lines") return null;
  return (
    <>
      <DimensionOverlay toScreen={toScreen} unit={unit} />
      <DraftOverlay toScreen={toScreen} />
    </>
  );
}
