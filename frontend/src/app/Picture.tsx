/** The canvas with its controls: connects the viewer to the store. */

import { useEffect, useReducer, useRef, useState } from "react";
import type { Point } from "../geometry/records";
import { translate } from "../language/translate";
import { DraftBar } from "../panels/drafting/DraftBar";
import { DraftOverlay } from "../panels/drafting/DraftOverlay";
import { usePickedPoints } from "../panels/drafting/usePickedPoints";
import { ColourBar } from "../panels/drawing/ColourBar";
import { EdgeTooltip } from "../panels/drawing/EdgeTooltip";
import { PathLegend } from "../panels/drawing/PathLegend";
import { Scrubber } from "../panels/drawing/Scrubber";
import { SelectionBar } from "../panels/drawing/SelectionBar";
import { ViewBar } from "../panels/drawing/ViewBar";
import { useDrafting } from "../state/drafting/drafting";
import { addCorner, cornerNear } from "../state/order/corners";
import { queries, queryClient, useDrawing } from "../state/queries";
import { useUiStore } from "../state/store";
import type { Insets } from "../viewer/camera";
import type { Viewer } from "../viewer/viewer";
import css from "./app.module.css";
import { Canvas } from "./Canvas";
import { DraftTools } from "./DraftTools";
import { StatusBar } from "./StatusBar";
import type { PictureCommands } from "./shortcuts";
import { ZoomControls } from "./ZoomControls";

interface Props {
  onReady: (keys: PictureCommands | null) => void;
}

interface Shown {
  readonly viewer: Viewer;
  readonly host: HTMLElement;
}

/** Width of the controls above the canvas, at its sides (pixels). */
const INSETS: Insets = { left: 56, top: 108, right: 64, bottom: 104 };

const LABEL = translate("picture.theDielineAndThePath");

export function Picture({ onReady }: Props) {
  const [shown, setShown] = useState<Shown | null>(null);
  const [scale, setScale] = useState(1);
  const [cursor, setCursor] = useState<Point | null>(null);
  const { data: drawing } = useDrawing();
  const step = useUiStore((ui) => ui.step);
  const [, redrawDraft] = useReducer((count: number) => count + 1, 0);
  const picked = usePickedPoints(scale);
  // The canvas keeps the events of the first rendering.
  const points = useRef(picked);
  useEffect(() => {
    points.current = picked;
  });
  const [box, setBox] = useState<{ from: Point; to: Point } | null>(null);
  return (
    <>
      <Canvas
        label={LABEL}
        insets={INSETS}
        events={{
          onHover: (row, moves, at) =>
            useUiStore
              .getState()
              .setHover(row === null && moves.length === 0 ? null : { row, moves, ...at }),
          onSelect: (rows, add, at) => {
            if (at === null || !points.current.pickPoint(at)) selectAt(rows, add, at);
          },
          onCursor: (at) => {
            setCursor(at);
            points.current.draftCursor(at);
          },
          onView: (scale) => {
            setScale(scale);
            if (useDrafting.getState().tool !== null) redrawDraft();
          },
          onBox: setBox,
        }}
        onReady={onReady}
        onViewer={(viewer, host) => setShown(viewer && host && { viewer, host })}
      />
      {shown !== null && (
        <>
          {box && <SelectionBox from={box.from} to={box.to} />}
          <EdgeTooltip width={shown.host.clientWidth} height={shown.host.clientHeight} />
          <div className={css.overTop}>
            <ViewBar />
            {step === "check" && <ColourBar />}
          </div>
          {step === "lines" && (
            <>
              <DraftOverlay toScreen={(place) => shown.viewer.toScreen(place)} />
              <DraftTools />
            </>
          )}
          <div className={css.overBottom}>
            {step === "lines" && <DraftBar />}
            <SelectionBar />
            <PathLegend />
            {step === "check" && <Scrubber />}
          </div>
          <ZoomControls viewer={shown.viewer} />
          <StatusBar scale={scale} cursor={cursor} unit={drawing?.unit === null ? "" : "mm"} />
        </>
      )}
    </>
  );
}

/** Handle a click or a box on the canvas: select edges, or a corner while corners are picked. */
function selectAt(rows: readonly number[], add: boolean, at: Point | null): void {
  const { pickingCorners, drawing, corners, selectEdges, set } = useUiStore.getState();
  if (!pickingCorners) {
    selectEdges(rows, add);
    return;
  }
  const edges =
    drawing === null ? undefined : queryClient.getQueryData(queries.edges(drawing).queryKey);
  const [row] = rows;
  if (edges === undefined || row === undefined || at === null) return;
  const place = cornerNear(edges, row, at);
  if (place !== null) set({ corners: addCorner(corners, place) });
}

function SelectionBox({ from, to }: { from: Point; to: Point }) {
  return (
    <div
      className={css.box}
      style={{
        left: Math.min(from.x, to.x),
        top: Math.min(from.y, to.y),
        width: Math.abs(to.x - from.x),
        height: Math.abs(to.y - from.y),
      }}
    />
  );
}
