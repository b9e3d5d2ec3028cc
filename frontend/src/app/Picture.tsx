/** Joins the store to the viewer: what is open is shown, what is pointed at is known. */

import { ActionIcon, Button, Tooltip } from "@mantine/core";
import { IconFocusCentered, IconMinus, IconPlus } from "@tabler/icons-react";
import { useEffect, useMemo, useRef, useState } from "react";
import { boundsOf } from "../geometry/bounds";
import { type Edges, lineTypeOf, type Point } from "../geometry/records";
import { type Sweep, sweepOf } from "../geometry/sweep";
import { timeOf, totalSeconds } from "../geometry/timeline";
import { tipOffset } from "../geometry/tip";
import { workedSpans } from "../geometry/workedSpans";
import { ColourBar } from "../panels/ColourBar";
import { EdgeTooltip } from "../panels/EdgeTooltip";
import overCss from "../panels/over.module.css";
import { PathLegend } from "../panels/PathLegend";
import { Scrubber } from "../panels/Scrubber";
import { SelectionBar } from "../panels/SelectionBar";
import { ViewBar } from "../panels/ViewBar";
import { figureColours, stretchColours } from "../scene/figureColours";
import type { Tools } from "../scene/swept";
import { addCorner, cornerNear } from "../state/corners";
import { isDropped } from "../state/importReport";
import { isOnTable } from "../state/jobs";
import {
  queries,
  queryClient,
  useBoards,
  useDrawing,
  useEdges,
  useJob,
  useMachines,
  useTimeline,
  useVerdict,
  useVerdictColumns,
} from "../state/queries";
import { layerKey, layerOf } from "../state/rows";
import { useUiStore } from "../state/store";
import { verdictMapOf } from "../state/verdictMap";
import { NoWebGL, Viewer } from "../viewer/viewer";
import css from "./app.module.css";
import { MAP_SCALE, VIEWER_COLOURS } from "./colours";
import type { PictureCommands } from "./shortcuts";

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
    let made: Viewer;
    try {
      made = new Viewer(host.current, canvas.current, VIEWER_COLOURS, {
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
    setViewer(made);
    return () => {
      made.dispose();
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
        aria-label="The dieline and the path of the head. Arrow keys pan, plus and minus zoom, F fits."
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
      <div className={`${overCss.float} ${css.zoom}`}>
        <ZoomButton label="Zoom in (+)" act={() => viewer?.zoomBy(1.4)}>
          <IconPlus size={16} />
        </ZoomButton>
        <ZoomButton label="Zoom out (−)" act={() => viewer?.zoomBy(1 / 1.4)}>
          <IconMinus size={16} />
        </ZoomButton>
        <ZoomButton label="Fit (F)" act={() => viewer?.fit()}>
          <IconFocusCentered size={16} />
        </ZoomButton>
      </div>
      <Status scale={scale} cursor={cursor} unit={drawing?.unit === null ? "" : "mm"} />
    </>
  );
}

/** A click or a box in the picture: edges as a rule, a corner while one is wanted. */
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

function ZoomButton(props: { label: string; act: () => void; children: React.ReactNode }) {
  return (
    <Tooltip label={props.label} position="left">
      <ActionIcon variant="subtle" color="gray" aria-label={props.label} onClick={props.act}>
        {props.children}
      </ActionIcon>
    </Tooltip>
  );
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

/** A round length whose bar is 60 to 150 pixels long. */
function barLength(pixelsPerMm: number): number {
  const least = 60 / pixelsPerMm;
  const power = 10 ** Math.floor(Math.log10(least));
  return power * ([1, 2, 5, 10].find((step) => step * power >= least) ?? 10);
}

interface StatusProps {
  scale: number;
  cursor: Point | null;
  /** Empty while nobody knows the unit of the file. */
  unit: "mm" | "";
}

function Status({ scale, cursor, unit }: StatusProps) {
  const bar = barLength(scale);
  const digits = scale > 50 ? 3 : scale > 5 ? 2 : 1;
  return (
    <div className={css.status}>
      <span className={css.scale} data-testid="scale-bar">
        <span className={css.scaleBar} style={{ width: bar * scale }} />
        {bar >= 1000 && unit === "mm"
          ? `${bar / 1000} m`
          : `${Number(bar.toPrecision(2))} ${unit || "file units"}`}
      </span>
      <span style={{ flex: 1 }} />
      {cursor && (
        <span data-testid="cursor">
          X {cursor.x.toFixed(digits)}&ensp; Y {cursor.y.toFixed(digits)} {unit}
        </span>
      )}
    </div>
  );
}

function WebGlError({ why }: { why: string }) {
  return (
    <div className={css.centre} role="alert">
      <div className={css.welcome} data-testid="no-webgl">
        <h1>The picture cannot be drawn</h1>
        <p>
          {why} Turn on hardware acceleration in the browser's settings, or open this page in a
          current Firefox, Chrome, Edge or Safari. Everything else on this page works.
        </p>
        <Button variant="default" onClick={() => window.location.reload()}>
          Try again
        </Button>
      </div>
    </div>
  );
}

/** Everything that the viewer is shown. */
function useViewerContents(
  viewer: Viewer | null,
  onReady: (keys: PictureCommands | null) => void,
): void {
  const { data: edges } = useEdges();
  const { data: drawing } = useDrawing();
  const { data: job } = useJob();
  const { data: line } = useTimeline();
  const { data: machines } = useMachines();
  const { data: boards } = useBoards();
  const { data: verdict } = useVerdict();
  const { data: along } = useVerdictColumns();
  const corners = useUiStore((ui) => ui.corners);
  const colourMode = useUiStore((ui) => ui.colourMode);
  const hiddenTypes = useUiStore((ui) => ui.hiddenTypes);
  const hiddenLayers = useUiStore((ui) => ui.hiddenLayers);
  const layers = useUiStore((ui) => ui.layers);
  const selection = useUiStore((ui) => ui.selection);
  const hovered = useUiStore((ui) => ui.hover?.row ?? null);
  const hoveredMoves = useUiStore((ui) => ui.hover?.moves);
  const zoomRequest = useUiStore((ui) => ui.zoomRequest);
  const pin = useUiStore((ui) => ui.pin);
  const retypePreviews = useUiStore((ui) => ui.retypePreviews);
  const previewTime = useUiStore((ui) => ui.previewTime);
  const chosenMachine = useUiStore((ui) => ui.machine);
  const open = useUiStore((ui) => ui.drawing);

  const machine = machines?.find(({ name }) => name === (job?.machine ?? chosenMachine));
  const stations = machine?.stations;
  const caliper = boards?.find(({ name }) => name === job?.board)?.caliper ?? 0;
  const tools = useMemo<Tools>(() => {
    const offsets = new Map();
    const sweeps = new Map<number, Sweep>();
    for (const { number, tool } of stations ?? []) {
      offsets.set(number, tipOffset(tool.footprint));
      const sweep = sweepOf(tool.footprint);
      if (sweep !== null) sweeps.set(number, sweep);
    }
    return { offsets, sweeps, caliper };
  }, [stations, caliper]);

  const shown: Edges | null = open === null ? null : (edges ?? null);
  const colours = useMemo(() => {
    const map = shown === null ? null : verdictMapOf(colourMode, verdict, shown.bulge.length);
    return shown === null || map === null ? null : figureColours(shown, map, MAP_SCALE);
  }, [shown, colourMode, verdict]);
  const samples = along?.samples;
  const stretches = useMemo(() => {
    if (shown === null || samples === undefined || colourMode !== "deviation") return null;
    const map = verdictMapOf(colourMode, verdict, shown.bulge.length);
    return map === null ? null : stretchColours(shown, map, samples, MAP_SCALE);
  }, [shown, samples, colourMode, verdict]);
  const toolpath = line?.toolpath;
  const worked = useMemo(
    () =>
      shown === null || toolpath === undefined || verdict === undefined
        ? null
        : workedSpans(shown, toolpath, tools.offsets, verdict.edge_setback),
    [shown, toolpath, verdict, tools],
  );
  useEffect(() => {
    const isShown = (row: number) => {
      if (shown === null || hiddenTypes.has(lineTypeOf(shown.lineType[row]))) return false;
      return !hiddenLayers.has(layerKey(layerOf(shown, row), shown.colour[row] ?? 0));
    };
    const dropped = (row: number) => shown !== null && isDropped(shown, row);
    viewer?.showEdges(shown, isShown, { colours, worked, along: stretches, dropped });
  }, [viewer, shown, hiddenTypes, hiddenLayers, colours, worked, stretches]);

  // A drawing that is opened, or has another size now, is brought into view; a new type is not.
  const extent = useMemo(() => (shown === null ? "" : String(boundsOf(shown))), [shown]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: these are when, not what
  useEffect(() => {
    if (extent !== "") viewer?.fit(null, false);
  }, [viewer, open, extent]);

  const placement = line?.toolpath.placement;
  useEffect(() => {
    if (machine === undefined || drawing === undefined || open === null) {
      viewer?.showTable(null);
      return;
    }
    const x = placement?.[0] ?? machine.origin[0] - drawing.bounds[0];
    const y = placement?.[1] ?? machine.origin[1] - drawing.bounds[1];
    viewer?.showTable([-x, -y, machine.width - x, machine.height - y]);
  }, [viewer, machine, drawing, placement, open]);

  useEffect(() => viewer?.showTravel(line ?? null, tools), [viewer, line, tools]);
  useEffect(() => viewer?.showLayers(layers), [viewer, layers]);
  const areas = open === null || job === undefined ? null : (along?.areas ?? null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: laid about the middle of these edges
  useEffect(() => viewer?.showAreas(areas), [viewer, areas, shown]);
  const milled = machines?.find(({ name }) => name === chosenMachine)?.offset_cuts === true;
  useEffect(() => viewer?.showCorners(milled ? corners.at : []), [viewer, corners, milled]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: the rows are those of these edges
  useEffect(() => viewer?.showChosen(selection), [viewer, selection, shown]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: the rows are those of these edges
  useEffect(() => viewer?.showRetypePreviews(retypePreviews), [viewer, retypePreviews, shown]);
  useEffect(
    () => viewer?.showHovered(hovered, hoveredMoves ?? []),
    [viewer, hovered, hoveredMoves],
  );
  // biome-ignore lint/correctness/useExhaustiveDependencies: the place is that of these edges
  useEffect(() => viewer?.showPin(pin), [viewer, pin, shown]);
  useEffect(() => {
    if (zoomRequest.count === 0) return;
    if (zoomRequest.box === null) viewer?.fitRows(zoomRequest.rows);
    else viewer?.fit(zoomRequest.box);
  }, [viewer, zoomRequest]);

  const before = useRef(0);
  useEffect(() => {
    if (viewer === null || line === undefined || job === undefined) return;
    if (isOnTable(job)) {
      const now = performance.now();
      // As long as the last report took to come, the next one will.
      const lasts = Math.min(1500, Math.max(80, now - before.current));
      before.current = now;
      viewer.runHead(timeOf(line, job.line, job.position), lasts * 1.1);
    } else if (previewTime !== null) viewer.moveHead(previewTime);
    else if (job.state === "done") viewer.moveHead(totalSeconds(line));
    else if (job.state === "interrupted") viewer.moveHead(timeOf(line, job.line, job.position));
    else viewer.moveHead(null);
  }, [viewer, line, job, previewTime]);

  useEffect(() => {
    if (viewer === null) return;
    onReady({
      fit: () => viewer.fit(),
      fitTable: () => viewer.fitTable(),
      zoom: (factor) => viewer.zoomBy(factor),
      pan: (dx, dy) => viewer.panBy(dx, dy),
    });
    return () => onReady(null);
  }, [viewer, onReady]);
}
