/** The canvas with its controls: connects the viewer to the store. */

import { useEffect, useRef, useState } from "react";
import type { Point } from "../geometry/records";
import type { SelectMode } from "../geometry/selection";
import { translate } from "../language/translate";
import { AreaBar } from "../panels/drafting/AreaBar";
import { DraftBar } from "../panels/drafting/DraftBar";
import { usePickedPoints } from "../panels/drafting/usePickedPoints";
import { ColourBar } from "../panels/drawing/ColourBar";
import { EdgeTooltip } from "../panels/drawing/EdgeTooltip";
import { PathLegend } from "../panels/drawing/PathLegend";
import { Scrubber } from "../panels/drawing/Scrubber";
import { SelectionBar } from "../panels/drawing/SelectionBar";
import { ViewBar } from "../panels/drawing/ViewBar";
import { useMarkPoints } from "../panels/order/useMarkPoints";
import type { PictureCommands } from "../state/commands/picture";
import { isAreaKind, useDrafting } from "../state/drafting/drafting";
import { bridgeNear, useBridgePicking } from "../state/order/bridges";
import { addCorner, cornerNear } from "../state/order/corners";
import { queries, queryClient, useDrawing } from "../state/queries";
import { useUiStore } from "../state/store";
import type { Insets } from "../viewer/camera";
import type { Viewer } from "../viewer/viewer";
import css from "./app.module.css";
import { Canvas } from "./Canvas";
import { DraftTools } from "./DraftTools";
import { StatusBar } from "./StatusBar";
import { ViewOverlays } from "./ViewOverlays";
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
  const tool = useDrafting((draft) => draft.tool);
  const areaMode = useDrafting((draft) => draft.areaMode);
  /** Called whenever the view changes. */
  const viewListeners = useRef(new Set<() => void>());
  const picked = usePickedPoints(scale);
  const marks = useMarkPoints(scale);
  // The canvas keeps the events of the first rendering.
  const points = useRef({ ...picked, ...marks });
  useEffect(() => {
    points.current = { ...picked, ...marks };
  });
  const [area, setArea] = useState<readonly Point[] | null>(null);
  useEffect(() => {
    if (shown !== null)
      shown.viewer.areaTool = isAreaKind(tool) ? { kind: tool, mode: areaMode } : null;
  }, [shown, tool, areaMode]);
  const unit = drawing?.unit === null ? "" : "mm";
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
          onSelect: (rows, mode, at) => {
            if (at !== null && (points.current.pickPoint(at) || points.current.pickMark(at)))
              return;
            selectAt(rows, mode, at);
          },
          onCursor: (at) => {
            setCursor(at);
            points.current.draftCursor(at);
            points.current.markCursor(at);
          },
          onView: (scale) => {
            setScale(scale);
            for (const listener of viewListeners.current) listener();
          },
          onArea: setArea,
        }}
        onReady={onReady}
        onViewer={(viewer, host) => setShown(viewer && host && { viewer, host })}
      />
      {shown !== null && (
        <>
          {area !== null && <SelectionArea corners={area} />}
          <EdgeTooltip width={shown.host.clientWidth} height={shown.host.clientHeight} />
          <div className={css.overTop}>
            <ViewBar />
            {step === "check" && <ColourBar />}
          </div>
          <ViewOverlays viewer={shown.viewer} listeners={viewListeners.current} unit={unit} />
          {step === "lines" && <DraftTools />}
          <div className={css.overBottom}>
            {step === "lines" && (
              <>
                <DraftBar />
                <AreaBar />
              </>
            )}
            <SelectionBar />
            <PathLegend />
            {step === "check" && <Scrubber />}
          </div>
          <ZoomControls viewer={shown.viewer} />
          <StatusBar scale={scale} cursor={cursor} unit={unit} />
        </>
      )}
    </>
  );
}

/** Handle a click or an area on the canvas: select edges, or place a corner or a bridge. */
function selectAt(rows: readonly number[], mode: SelectMode, at: Point | null): void {
  const { pickingCorners, drawing, corners, options, selectEdges, set } = useUiStore.getState();
  const { active: pickingBridges, width } = useBridgePicking.getState();
  if (!pickingCorners && !pickingBridges) {
    selectEdges(rows, mode);
    return;
  }
  const edges =
    drawing === null ? undefined : queryClient.getQueryData(queries.edges(drawing).queryKey);
  const [row] = rows;
  if (edges === undefined || row === undefined || at === null) return;
  if (pickingBridges) {
    const bridge = bridgeNear(edges, row, at, width);
    if (bridge !== null) set({ options: { ...options, bridges: [...options.bridges, bridge] } });
    return;
  }
  const place = cornerNear(edges, row, at);
  if (place !== null) set({ corners: addCorner(corners, place) });
}

/** The area that is being drawn; its corners are pixels. */
function SelectionArea({ corners }: { corners: readonly Point[] }) {
  return (
    <svg className={css.area} aria-hidden="true">
      <polygon points={corners.map(({ x, y }) => `${x},${y}`).join(" ")} />
    </svg>
  );
}
