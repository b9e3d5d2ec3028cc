/**
 * The canvas: dieline, tool path, table and head.
 *
 * A frame is rendered only after a change, so that an idle page costs nothing. Contents are set
 * through methods; user input is passed on through callbacks.
 */

import { Scene, WebGLRenderer } from "three";
import { boundsOf, unionBox } from "../geometry/bounds";
import { type Areas, type Box, type DrawnEdges, isComplete, type Point } from "../geometry/records";
import type { Timeline } from "../geometry/timeline";
import type { DielineStyle } from "../scene/dieline";
import type { Tools } from "../scene/swept";
import type { AreaTool } from "./areaSelection";
import { type Insets, PlaneCamera } from "./camera";
import { HeadClock } from "./clock";
import type { ViewerColours, ViewerEvents, VisibleLayers } from "./contract";
import { Detail } from "./detail";
import { DielineLayers, type EdgePreview } from "./dieline";
import { HeadMark } from "./head";
import { PathLayers } from "./pathLayers";
import { Picker } from "./picker";
import { listenToPointer } from "./pointer";
import { Surroundings } from "./surroundings";
import { ViewTransition } from "./viewTransition";

/** Raised if the browser has no WebGL. */
export class NoWebGL extends Error {
  override name = "NoWebGL";
}

export class Viewer {
  private readonly camera = new PlaneCamera();
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly surroundings: Surroundings;
  private readonly dieline: DielineLayers;
  private readonly travel: PathLayers;
  private readonly head: HeadMark;
  private readonly clock = new HeadClock();
  private readonly detail = new Detail();
  private readonly transition = new ViewTransition(this.camera);
  private readonly picker = new Picker(this.camera);
  private readonly watch: ResizeObserver;
  private readonly stopListening: () => void;

  /** Origin of all layers: the graphics card computes in single precision. */
  private origin: Point = { x: 0, y: 0 };
  private edges: DrawnEdges | null = null;
  private timeline: Timeline | null = null;
  private tools: Tools = { sweeps: new Map(), offsets: new Map(), caliper: 0 };
  private areas: Areas | null = null;
  private shown: VisibleLayers = {
    nominal: true,
    head: true,
    tip: false,
    rapids: false,
    swept: false,
    moves: false,
    uncut: true,
  };
  private frameRequest = 0;
  private measuring = false;
  private disposed = false;
  /** What a drag selects edges with; null: a drag moves the view. */
  areaTool: AreaTool | null = null;
  private hoverRow: number | null = null;
  private hoverMoves: readonly number[] = [];
  /** Box that the view was fitted to; null since the user has moved the view. */
  private framed: Box | null = null;

  constructor(
    private readonly host: HTMLElement,
    canvas: HTMLCanvasElement,
    colours: ViewerColours,
    private readonly events: ViewerEvents,
    /** Width of what covers the canvas at its sides (pixels). */
    private readonly insets: Insets,
  ) {
    try {
      this.renderer = new WebGLRenderer({ canvas, antialias: false, alpha: false });
    } catch (cause) {
      throw new NoWebGL("This browser cannot draw with WebGL, its graphics interface.", { cause });
    }
    this.renderer.autoClear = false;
    this.surroundings = new Surroundings(colours);
    this.dieline = new DielineLayers(colours);
    this.travel = new PathLayers(colours);
    this.head = new HeadMark(colours);
    for (const { mesh } of [this.surroundings.ground, ...this.travel.areas]) this.scene.add(mesh);
    for (const { objects } of this.layers) this.scene.add(...objects);

    this.watch = new ResizeObserver(() => this.resize());
    this.watch.observe(host);
    canvas.addEventListener("webglcontextrestored", () => this.draw());
    this.stopListening = listenToPointer(host, {
      pan: (dx, dy) => this.panBy(dx, dy),
      zoom: (factor, about) => this.zoom(factor, about),
      hover: (at) => this.setCursor(at),
      select: (at, mode) => {
        const row = this.picker.edgeAt(at, this.shown);
        events.onSelect(row === null ? [] : [row], mode, this.camera.toPlane(at));
      },
      areaTool: () => this.areaTool,
      area: (corners, mode) => {
        events.onArea(mode === null ? corners : null);
        if (mode !== null) events.onSelect(this.picker.edgesInside(corners), mode, null);
      },
      areaCancelled: () => events.onArea(null),
    });
    this.resize();
  }

  /**
   * Show a drawing: `visible` filters its edges, `style` sets their style.
   *
   * Edges can be selected once all of their columns have arrived.
   */
  showEdges(
    edges: DrawnEdges | null,
    visible: (row: number) => boolean,
    style: Omit<DielineStyle, "shown"> = {},
  ): void {
    const fresh = edges?.ends !== this.edges?.ends;
    this.edges = edges;
    this.picker.setVisible(visible);
    if (fresh) {
      this.detail.reset();
      const box = edges === null ? null : boundsOf(edges);
      this.origin =
        box === null ? { x: 0, y: 0 } : { x: (box[0] + box[2]) / 2, y: (box[1] + box[3]) / 2 };
      this.picker.setEdges(edges !== null && isComplete(edges) ? edges : null);
      this.hoverRow = null;
      this.dieline.highlight(null, this.origin, []);
      this.surroundings.updateTable(this.origin);
      this.updateTravel();
      this.travel.setAreas(this.areas, this.origin);
    }
    this.dieline.show(edges, this.origin, { ...style, shown: visible });
    this.draw();
  }

  showToolpath(timeline: Timeline | null, tools: Tools): void {
    if (timeline !== this.timeline) {
      this.clock.set(null);
      this.picker.setTimeline(timeline);
      this.hoverMoves = [];
    }
    this.timeline = timeline;
    this.tools = tools;
    this.updateTravel();
    this.draw();
  }

  /** Show areas that the tool cannot reach. */
  showAreas(areas: Areas | null): void {
    this.areas = areas;
    this.travel.setAreas(areas, this.origin);
    this.draw();
  }

  /** Show rings around corners that have a type of their own. */
  showCorners(places: readonly Point[]): void {
    this.surroundings.corners = places;
    this.draw();
  }

  /** Mark a box of the drawing with a pin; null removes the pin. */
  showPin(box: Box | null): void {
    this.surroundings.pin = box;
    this.draw();
  }

  /** Show the table, given by its corners in drawing coordinates; null hides it. */
  showTable(corners: readonly Point[] | null): void {
    this.surroundings.table = corners;
    this.surroundings.updateTable(this.origin);
    this.draw();
  }

  /** Show a rectangular sheet, given as a box in drawing coordinates; null hides it. */
  showSheet(box: Box | null): void {
    this.surroundings.sheet = box;
    this.surroundings.updateTable(this.origin);
    this.draw();
  }

  /** Show keep-out zones, given by their corners in drawing coordinates. */
  showZones(zones: readonly (readonly Point[])[]): void {
    this.surroundings.zones = zones;
    this.surroundings.updateTable(this.origin);
    this.draw();
  }

  showLayers(shown: VisibleLayers): void {
    this.shown = shown;
    if (shown.swept) this.travel.buildSwept(this.tools, this.origin);
    this.draw();
  }

  showChosen(rows: ReadonlySet<number>): void {
    this.dieline.select(this.edges, this.origin, rows);
    this.draw();
  }

  showRetypePreviews(retypePreviews: readonly EdgePreview[]): void {
    this.dieline.preview(this.edges, this.origin, retypePreviews);
    this.draw();
  }

  /** Highlight an edge, or some moves if `row` is null. */
  showHovered(row: number | null, moves: readonly number[] = []): void {
    this.hoverRow = row;
    this.hoverMoves = moves;
    if (row === null) this.dieline.highlight(this.picker.segments, this.origin, moves);
    else this.dieline.highlight(this.edges, this.origin, [row]);
    this.draw();
  }

  /** Show the head at a program time (s); null hides it. */
  moveHead(seconds: number | null): void {
    this.clock.set(seconds);
    this.draw();
  }

  /** Animate the head along its path to a program time, within `lasts` ms. */
  runHead(seconds: number, lasts: number): void {
    this.clock.travelTo(seconds, lasts, performance.now());
    this.draw();
  }

  /** Zoom to a box, or to the whole drawing. */
  fit(box?: Box | null, animate = true): void {
    const all = box ?? this.everything();
    if (all === null) return;
    this.framed = all;
    this.transition.start(this.camera.frameBox(all, this.insets), animate, performance.now());
    this.draw();
  }

  /** Zoom to the table, or to the whole drawing if there is none. */
  fitTable(): void {
    this.fit(this.surroundings.box);
  }

  /** Zoom to edges, with a margin. */
  fitRows(rows: Iterable<number>): void {
    if (this.edges === null) return;
    const box = boundsOf(this.edges, rows);
    if (box === null) return;
    const margin = Math.max(box[2] - box[0], box[3] - box[1], 8) * 0.6;
    this.fit([box[0] - margin, box[1] - margin, box[2] + margin, box[3] + margin]);
  }

  /** Pixel of a point of the drawing, from the upper left corner of the canvas. */
  toScreen(place: Point): Point {
    return this.camera.toScreen(place);
  }

  zoomBy(factor: number): void {
    this.zoom(factor, { x: this.camera.width / 2, y: this.camera.height / 2 });
  }

  panBy(dx: number, dy: number): void {
    this.framed = null;
    this.transition.stop();
    this.camera.pan(dx, dy);
    this.draw();
  }

  dispose(): void {
    this.disposed = true;
    cancelAnimationFrame(this.frameRequest);
    this.watch.disconnect();
    this.stopListening();
    for (const part of [this.surroundings, this.dieline, this.travel, this.head]) part.dispose();
    this.renderer.dispose();
  }

  private get layers() {
    return [this.surroundings, this.dieline, this.travel, this.head].flatMap(
      ({ layers }) => layers,
    );
  }

  private zoom(factor: number, about: Point): void {
    this.framed = null;
    this.transition.stop();
    this.camera.zoom(factor, about);
    this.draw();
  }

  private everything(): Box | null {
    const drawing = this.edges === null ? null : boundsOf(this.edges);
    if (drawing === null) return this.surroundings.box;
    const { timeline } = this;
    if (timeline === null || !this.shown.head) return drawing;
    let box = drawing;
    const { pose, placement, motion } = timeline.toolpath;
    for (let row = 0; row < motion.length; row++) {
      if (motion[row] === 0) continue;
      const x = (pose[row * 4] as number) - placement[0];
      const y = (pose[row * 4 + 1] as number) - placement[1];
      box = unionBox(box, [x, y, x, y]);
    }
    return box;
  }

  private setCursor(at: Point | null): void {
    this.events.onCursor(at === null ? null : this.camera.toPlane(at));
    const row = at === null ? null : this.picker.edgeAt(at, this.shown);
    const moves = at === null ? [] : this.picker.movesAt(at, this.shown);
    const was = this.hoverRow !== null || this.hoverMoves.length > 0;
    if (row !== null || moves.length > 0 || was) {
      this.host.style.cursor = row === null ? "" : "pointer";
      this.events.onHover(row, moves, at ?? { x: 0, y: 0 });
    }
  }

  private updateTravel(): void {
    this.travel.setTimeline(this.timeline, this.tools, this.origin);
    if (this.shown.swept) this.travel.buildSwept(this.tools, this.origin);
  }

  private resize(): void {
    const width = this.host.clientWidth;
    const height = this.host.clientHeight;
    if (width === 0 || height === 0) return;
    const ratio = Math.min(window.devicePixelRatio, 3);
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.camera.resize(width, height);
    // What was in view stays in view when the window or a panel changes its size.
    if (this.framed !== null) {
      const view = this.camera.frameBox(this.framed, this.insets);
      this.transition.start(view, false, performance.now());
    }
    for (const layer of this.layers) layer.resize(width, height, ratio);
    // A resized canvas is empty: render now, not in the next frame.
    cancelAnimationFrame(this.frameRequest);
    this.render(performance.now());
  }

  private draw(): void {
    if (this.frameRequest === 0)
      this.frameRequest = requestAnimationFrame((now) => this.render(now));
  }

  private render(now: number): void {
    this.frameRequest = 0;
    const { camera, origin, shown, timeline } = this;
    this.transition.tick(now);
    const seconds = this.clock.tick(now);
    const under = timeline !== null && (shown.head || shown.tip);
    this.surroundings.draw(camera, origin);
    this.dieline.draw(shown.nominal && this.edges !== null, under);
    this.travel.draw(shown, camera.scale, seconds, this.dieline.showsFigures);
    this.head.draw(timeline, seconds, this.tools, origin, camera.scale);
    camera.apply(origin);
    const count = this.layers.reduce((sum, layer) => sum + layer.count, 0);
    const thin = this.detail.isThin(count);
    for (const layer of this.layers) layer.prepare(thin);
    this.surroundings.paintGround(this.renderer, camera);
    this.renderer.render(this.scene, camera.three);
    this.measure(count);
    this.events.onView(camera.scale);
    if (this.transition.active || this.clock.running) this.draw();
  }

  /** Learn how long a frame takes: the browser asks for the next but one when it is on the screen. */
  private measure(count: number): void {
    if (this.measuring || document.hidden) return;
    this.measuring = true;
    const begin = performance.now();
    requestAnimationFrame(() =>
      requestAnimationFrame(() => {
        this.measuring = false;
        if (this.disposed || document.hidden) return;
        if (this.detail.learn(count, (performance.now() - begin) / 2)) this.draw();
      }),
    );
  }
}
