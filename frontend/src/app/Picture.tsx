/** The canvas with its controls: connects the viewer to the store. */

import { useEffect, useRef, useState } from "react";
import type { Point } from "../geometry/records";
import { ColourBar } from "../panels/ColourBar";
import { EdgeTooltip } from "../panels/EdgeTooltip";
import { PathLegend } from "../panels/PathLegend";
import { Scrubber } from "../panels/Scrubber";
import { SelectionBar } from "../panels/SelectionBar";
import { ViewBar } from "../panels/ViewBar";
import { addCorner, cornerNear } from "../state/corners";
import { queries, queryClient, useDrawing } from "../state/queries";
import { useUiStore } from "../state/store";
import { NoWebGL, Viewer } from "../viewer/viewer";
import css from "./app.module.css";
import { VIEWER_COLOURS } from "./colours";
import { StatusBar } from "./StatusBar";
import type { PictureCommands } from "./shortcuts";
import { useViewerContents } from "./useViewerContents";
import { WebGlError } from "./WebGlError";
import { ZoomControls } from "./ZoomControls";

interface Props {
  onReady: (keys: PictureCommands | null) => void;
}

export function Picture({ onReady }: Props) {
  const host = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const [viewer, setViewer] = useState<Viewer | null>(null);
  const [failure, setFailure] = useState<string | null>(null);
  const [scale, setScale] = useState(1);
  const [cursor, setCursor] = useState<Point | null>(null);
  const { data: drawing } = useDrawing();
  const pin = useUiStore((ui) => ui.pin);
  const [box, setBox] = useState<{ from: Point; to: Point } | null>(null);

  useEffect(() => {
    if (host.current === null || canvas.current === null) return;
    const page = useUiStore.getState();
    let created: Viewer;
    try {
      created = new Viewer(host.current, canvas.current, VIEWER_COLOURS, {
        onHover: (row, moves, at) =>
          page.setHover(row === null && moves.length === 0 ? null : { row, moves, ...at }),
        onSelect: (rows, add, at) => selectAt(rows, add, at),
        onCursor: setCursor,
        onView: setScale,
        onBox: setBox,
      });
    } catch (cause) {
      if (!(cause instanceof NoWebGL)) throw cause;
      setFailure(cause.message);
      return;
    }
    setViewer(created);
    return () => {
      created.dispose();
      setViewer(null);
    };
  }, []);

  useViewerContents(viewer, onReady);

  if (failure !== null) return <WebGlError why={failure} />;
  return (
    <>
      <div
        ref={host}
        className={css.picture}
        data-testid="picture"
        data-pin={pin === null ? undefined : pin.join()}
        // biome-ignore lint/a11y/noNoninteractiveTabindex: the arrow keys pan it
        tabIndex={0}
        role="img"
        aria-label="The dieline and the path of the machine head. Arrow keys move the view, plus and minus zoom, the key F shows the whole drawing."
      >
        <canvas ref={canvas} data-testid="canvas" />
      </div>
      {box && <SelectionBox from={box.from} to={box.to} />}
      <EdgeTooltip
        width={host.current?.clientWidth ?? 0}
        height={host.current?.clientHeight ?? 0}
      />
      <div className={css.overTop}>
        <ViewBar />
        <ColourBar />
      </div>
      <div className={css.overBottom}>
        <SelectionBar />
        <PathLegend />
        <Scrubber />
      </div>
      <ZoomControls viewer={viewer} />
      <StatusBar scale={scale} cursor={cursor} unit={drawing?.unit === null ? "" : "mm"} />
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
