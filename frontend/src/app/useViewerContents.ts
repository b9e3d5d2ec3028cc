/** Passes the data of the store on to the viewer: edges, table, tool path, marks and the head. */

import { useEffect, useMemo, useRef } from "react";
import { boundsOf } from "../geometry/bounds";
import { type Box, type DrawnEdges, type Edges, isComplete } from "../geometry/records";
import { cornersOnDrawing, type Similarity } from "../geometry/similarity";
import { type Sweep, sweepOf } from "../geometry/sweep";
import { timeOf, totalSeconds } from "../geometry/timeline";
import { type TipOffset, tipOffset } from "../geometry/tip";
import { workedSpans } from "../geometry/workedSpans";
import { useScheme } from "../panels/shared/scheme";
import { coarseTolerance } from "../scene/dieline";
import { figureColours, stretchColours } from "../scene/figureColours";
import type { Tools } from "../scene/swept";
import type { PictureCommands } from "../state/commands/picture";
import { isDropped } from "../state/drawing/importReport";
import { shownEdges } from "../state/drawing/selecting";
import { verdictMapOf } from "../state/drawing/verdictMap";
import { isOnTable } from "../state/job/jobs";
import { bridgePlaces } from "../state/order/bridges";
import { chosenPlaces } from "../state/order/edgeOptions";
import { sheetBox } from "../state/order/sheet";
import {
  useBoardCaliper,
  useDrawing,
  useDrawnEdges,
  useJob,
  useKnownStation,
  useMachines,
  useTimeline,
  useVerdict,
  useVerdictColumns,
} from "../state/queries";
import { runAboveBoard } from "../state/station/station";
import { useUiStore } from "../state/store";
import type { Viewer } from "../viewer/viewer";
import { mapScale } from "./colours";

type MaybeViewer = Viewer | null;

export function useViewerContents(
  viewer: MaybeViewer,
  onReady: (commands: PictureCommands | null) => void,
): void {
  const open = useUiStore((ui) => ui.drawing);
  const known = useDrawnEdges();
  const drawn = open === null ? null : (known ?? null);
  const edges = drawn !== null && isComplete(drawn) ? drawn : null;
  const tools = useTools();
  useShownEdges(viewer, drawn, edges, tools);
  useFirstView(viewer, drawn);
  useShownTable(viewer);
  useShownPath(viewer, edges, tools);
  useShownMarks(viewer, edges);
  useShownHead(viewer);
  useCommands(viewer, onReady);
}

/** Machine of the open job, or the one selected for a new job. */
function useShownMachine() {
  const { data: job } = useJob();
  const { data: machines } = useMachines();
  const selected = useUiStore((ui) => ui.machine);
  return machines?.find(({ name }) => name === (job?.machine ?? selected));
}

function useTools(): Tools {
  const { data: job } = useJob();
  const stations = useShownMachine()?.stations;
  const caliper = useBoardCaliper(job?.board);
  return useMemo<Tools>(() => {
    const offsets = new Map<number, TipOffset>();
    const sweeps = new Map<number, Sweep>();
    for (const { number, tool } of stations ?? []) {
      offsets.set(number, tipOffset(tool.footprint));
      const sweep = sweepOf(tool.footprint);
      if (sweep !== null) sweeps.set(number, sweep);
    }
    return { offsets, sweeps, caliper };
  }, [stations, caliper]);
}

/** Colours of the edges and of stretches along them, in the current colour mode. */
function useFigureColours(edges: Edges | null) {
  const { data: verdict } = useVerdict();
  const { data: columns } = useVerdictColumns();
  const colourMode = useUiStore((ui) => ui.colourMode);
  const scheme = useScheme();
  const samples = columns?.samples;
  return useMemo(() => {
    const map = edges === null ? null : verdictMapOf(colourMode, verdict, edges.bulge.length);
    if (edges === null || map === null) return { colours: null, along: null };
    const scale = mapScale(scheme);
    const hasStretches = samples !== undefined && colourMode === "deviation";
    return {
      colours: figureColours(edges, map, scale),
      along: hasStretches ? stretchColours(edges, map, samples, scale) : null,
    };
  }, [edges, samples, colourMode, verdict, scheme]);
}

/** `edges`: all columns of `drawn`; null while they are not there. */
function useShownEdges(
  viewer: MaybeViewer,
  drawn: DrawnEdges | null,
  edges: Edges | null,
  tools: Tools,
): void {
  const { data: timeline } = useTimeline();
  const { data: verdict } = useVerdict();
  const hiddenTypes = useUiStore((ui) => ui.hiddenTypes);
  const hiddenLayers = useUiStore((ui) => ui.hiddenLayers);
  const figures = useFigureColours(edges);
  const toolpath = timeline?.toolpath;
  const worked = useMemo(
    () =>
      edges === null || toolpath === undefined || verdict === undefined
        ? null
        : workedSpans(edges, toolpath, tools.offsets, verdict.edge_setback),
    [edges, toolpath, verdict, tools],
  );
  useEffect(() => {
    const isVisible = drawn === null ? () => false : shownEdges(drawn, hiddenTypes, hiddenLayers);
    const dropped = (row: number) => drawn !== null && isDropped(drawn, row);
    const box = drawn === null || edges !== null ? null : boundsOf(drawn);
    const arcs = box === null ? {} : { tolerance: coarseTolerance(box) };
    viewer?.showEdges(drawn, isVisible, { ...figures, ...arcs, worked, dropped });
  }, [viewer, drawn, edges, hiddenTypes, hiddenLayers, figures, worked]);
}

/** Differences of this part of a drawing's size are those of single precision. */
const SAME_SIZE = 1e-5;

const isSameBox = (one: Box, other: Box): boolean => {
  const slack = SAME_SIZE * Math.max(one[2] - one[0], one[3] - one[1]);
  return one.every((value, at) => Math.abs(value - (other[at] as number)) <= slack);
};

/** Zoom to a drawing when it is opened or its size changes, not when line types change. */
function useFirstView(viewer: MaybeViewer, drawn: DrawnEdges | null): void {
  const open = useUiStore((ui) => ui.drawing);
  const last = useRef<Box | null>(null);
  const extent = useMemo(() => {
    const box = drawn === null ? null : boundsOf(drawn);
    if (box === null || last.current === null || !isSameBox(last.current, box)) last.current = box;
    return last.current;
  }, [drawn]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: `open` triggers the zoom
  useEffect(() => {
    if (extent !== null) viewer?.fit(null, false);
  }, [viewer, open, extent]);
}

function useShownTable(viewer: MaybeViewer): void {
  const { data: drawing } = useDrawing();
  const { data: timeline } = useTimeline();
  const open = useUiStore((ui) => ui.drawing);
  const machine = useShownMachine();
  const sheet = useUiStore((ui) => ui.sheet);
  const placement = timeline?.toolpath.placement;
  const measured = timeline?.toolpath.similarity;
  useEffect(() => {
    if (machine === undefined || drawing === undefined || open === null) {
      viewer?.showTable(null);
      viewer?.showSheet(null);
      viewer?.showZones([]);
      return;
    }
    const x = placement?.[0] ?? machine.origin[0] - drawing.bounds[0];
    const y = placement?.[1] ?? machine.origin[1] - drawing.bounds[1];
    // A sheet whose marks have been measured is shown as drawn, and the table turned about it.
    const lies: Similarity = measured ?? [1, 0, x, y];
    viewer?.showTable(cornersOnDrawing([0, 0, machine.width, machine.height], lies));
    const corner = { x: machine.origin[0] - x, y: machine.origin[1] - y };
    const drawn = { x: drawing.bounds[0], y: drawing.bounds[1] };
    viewer?.showSheet(sheetBox(sheet, measured == null ? corner : drawn));
    viewer?.showZones(
      machine.zones.map((zone) =>
        cornersOnDrawing([zone.x, zone.y, zone.x + zone.width, zone.y + zone.height], lies),
      ),
    );
  }, [viewer, machine, drawing, placement, measured, sheet, open]);
}

function useShownPath(viewer: MaybeViewer, edges: Edges | null, tools: Tools): void {
  const { data: job } = useJob();
  const { data: timeline } = useTimeline();
  const { data: columns } = useVerdictColumns();
  const layers = useUiStore((ui) => ui.layers);
  const open = useUiStore((ui) => ui.drawing);
  useEffect(() => viewer?.showToolpath(timeline ?? null, tools), [viewer, timeline, tools]);
  useEffect(() => viewer?.showLayers(layers), [viewer, layers]);
  const areas = open === null || job === undefined ? null : (columns?.areas ?? null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: the origin depends on the edges
  useEffect(() => viewer?.showAreas(areas), [viewer, areas, edges]);
}

function useShownMarks(viewer: MaybeViewer, edges: Edges | null): void {
  const { data: machines } = useMachines();
  const selected = useUiStore((ui) => ui.machine);
  const corners = useUiStore((ui) => ui.corners);
  const options = useUiStore((ui) => ui.options);
  const selection = useUiStore((ui) => ui.selection);
  const retypePreviews = useUiStore((ui) => ui.retypePreviews);
  const hovered = useUiStore((ui) => ui.hover?.row ?? null);
  const hoveredMoves = useUiStore((ui) => ui.hover?.moves);
  const pin = useUiStore((ui) => ui.pin);
  const zoomRequest = useUiStore((ui) => ui.zoomRequest);
  const hasCorners = machines?.find(({ name }) => name === selected)?.offset_cuts === true;
  useEffect(
    () =>
      viewer?.showCorners([
        ...(hasCorners ? corners.at : []),
        ...chosenPlaces(options, edges),
        ...bridgePlaces(options.bridges, edges),
      ]),
    [viewer, corners, hasCorners, options, edges],
  );
  // biome-ignore lint/correctness/useExhaustiveDependencies: the rows refer to the edges
  useEffect(() => viewer?.showChosen(selection), [viewer, selection, edges]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: the rows refer to the edges
  useEffect(() => viewer?.showRetypePreviews(retypePreviews), [viewer, retypePreviews, edges]);
  useEffect(
    () => viewer?.showHovered(hovered, hoveredMoves ?? []),
    [viewer, hovered, hoveredMoves],
  );
  // biome-ignore lint/correctness/useExhaustiveDependencies: the place refers to the edges
  useEffect(() => viewer?.showPin(pin), [viewer, pin, edges]);
  useEffect(() => {
    if (zoomRequest.count === 0) return;
    if (zoomRequest.box === null) viewer?.fitRows(zoomRequest.rows);
    else viewer?.fit(zoomRequest.box);
  }, [viewer, zoomRequest]);
}

function useShownHead(viewer: MaybeViewer): void {
  const { data: job } = useJob();
  const { data: timeline } = useTimeline();
  const previewTime = useUiStore((ui) => ui.previewTime);
  const run = runAboveBoard(useKnownStation(job?.machine ?? ""));
  const dryRun = run !== null && run.kind === "dry_run" && run.job === job?.id ? run : null;
  const lastReport = useRef(0);
  useEffect(() => {
    if (viewer === null || timeline === undefined || job === undefined) return;
    const shown = isOnTable(job) ? job : dryRun;
    if (shown !== null) {
      const now = performance.now();
      // Assume that the next report takes as long as the last one.
      const interval = Math.min(1500, Math.max(80, now - lastReport.current));
      lastReport.current = now;
      viewer.runHead(timeOf(timeline, shown.line, shown.position, shown === job), interval * 1.1);
    } else if (previewTime !== null) viewer.moveHead(previewTime);
    else if (job.state === "done") viewer.moveHead(totalSeconds(timeline));
    else if (job.stopped_at !== null)
      viewer.moveHead(timeOf(timeline, job.stopped_at.line, job.stopped_at.position));
    else viewer.moveHead(null);
  }, [viewer, timeline, job, dryRun, previewTime]);
}

function useCommands(
  viewer: MaybeViewer,
  onReady: (commands: PictureCommands | null) => void,
): void {
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
