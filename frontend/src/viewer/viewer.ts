/**
 * The picture: the dieline, the path of the head, the table under it and the head upon it.
 *
 * It is drawn when something has changed and not otherwise: a page left open costs nothing.
 * What it is shown comes in through methods; what the user does goes out through callbacks.
 */

import { Scene, WebGLRenderer } from "three";
import { boundsOf, joined } from "../geometry/bounds";
import type { Areas, Box, Edges, Point } from "../geometry/records";
import type { Timeline } from "../geometry/timeline";
import type { DielineStyle } from "../scene/dieline";
import type { Tools } from "../scene/swept";
import { type Insets, PlaneCamera } from "./camera";
import { HeadClock } from "./clock";
import type { Shown, ViewerColours, ViewerEvents } from "./contract";
import { DielineLayers, type Proposal } from "./dieline";
import { HeadMark } from "./head";
import { Picker } from "./picker";
import { listenToPointer } from "./pointer";
import { Surroundings } from "./surroundings";
import { TravelLayers } from "./travel";
import { ViewTransition } from "./viewTransition";

/** What floats over the picture, at its sides (pixels). */
const INSETS: Insets = { left: 56, top: 108, right: 64, bottom: 104 };

/** This browser has no WebGL. */
export class NoWebGL extends Error {
  override name = "NoWebGL";
}

export class Viewer {
  private readonly camera = new PlaneCamera();
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly around: Surroundings;
  private readonly dieline: DielineLayers;
  private readonly travel: TravelLayers;
  private readonly head: HeadMark;
  private readonly clock = new HeadClock();
  private readonly glide = new ViewTransition(this.camera);
  private readonly picker = new Picker(this.camera);
  private readonly watch: ResizeObserver;
  private readonly stopListening: () => void;

  /** All is laid about it: the graphics card counts in single precision. */
  private origin: Point = { x: 0, y: 0 };
  private edges: Edges | null = null;
  private timeline: Timeline | null = null;
  private tools: Tools = { sweeps: new Map(), offsets: new Map(), caliper: 0 };
  private areas: Areas | null = null;
  private shown: Shown = {
    nominal: true,
    head: true,
    tip: false,
    rapids: false,
    swept: false,
    moves: false,
    uncut: true,
  };
  private asked = 0;
  private hoverRow: number | null = null;
  private hoverMoves: readonly number[] = [];

  constructor(
    private readonly host: HTMLElement,
    canvas: HTMLCanvasElement,
    colours: ViewerColours,
    private readonly events: ViewerEvents,
  ) {
    try {
      this.renderer = new WebGLRenderer({ canvas, antialias: false, alpha: false });
    } catch (cause) {
      throw new NoWebGL("This browser cannot draw with WebGL.", { cause });
    }
    this.renderer.setClearColor(colours.backdrop);
    this.around = new Surroundings(colours);
    this.dieline = new DielineLayers(colours);
    this.travel = new TravelLayers(colours);
    this.head = new HeadMark(colours);
    this.scene.add(this.around.table);
    for (const { mesh } of [...this.travel.areas, ...this.layers]) this.scene.add(mesh);

    this.watch = new ResizeObserver(() => this.resize());
    this.watch.observe(host);
    canvas.addEventListener("webglcontextrestored", () => this.draw());
    this.stopListening = listenToPointer(host, {
      pan: (dx, dy) => this.panBy(dx, dy),
      zoom: (factor, about) => this.zoom(factor, about),
      point: (at) => this.point(at),
      choose: (at, add) => {
        const row = this.picker.edge(at, this.shown);
        events.onChoose(row === null ? [] : [row], add, this.camera.toPlane(at));
      },
      box: (from, to, final) => {
        events.onBox(final ? null : { from, to });
        if (final && this.edges !== null) {
          events.onChoose(this.picker.between(from, to), true, null);
        }
      },
    });
    this.resize();
  }

  /** Show a drawing; `visible` says which of its edges, `looks` how they are told apart. */
  showEdges(
    edges: Edges | null,
    visible: (row: number) => boolean,
    looks: Omit<DielineStyle, "shown"> = {},
  ): void {
    const fresh = edges?.ends !== this.edges?.ends;
    this.edges = edges;
    this.picker.takeVisible(visible);
    if (fresh) {
      const box = edges === null ? null : boundsOf(edges);
      this.origin =
        box === null ? { x: 0, y: 0 } : { x: (box[0] + box[2]) / 2, y: (box[1] + box[3]) / 2 };
      this.picker.takeEdges(edges);
      this.hoverRow = null;
      this.dieline.light(null, this.origin, []);
      this.around.place(this.origin);
      this.layTravel();
      this.travel.layAreas(this.areas, this.origin);
    }
    this.dieline.show(edges, this.origin, { ...looks, shown: visible });
    this.draw();
  }

  showTravel(timeline: Timeline | null, tools: Tools): void {
    if (timeline !== this.timeline) {
      this.clock.put(null);
      this.picker.takeTravel(timeline);
      this.hoverMoves = [];
    }
    this.timeline = timeline;
    this.tools = tools;
    this.layTravel();
    this.draw();
  }

  /** Where no cutter gets to. */
  showAreas(areas: Areas | null): void {
    this.areas = areas;
    this.travel.layAreas(areas, this.origin);
    this.draw();
  }

  /** Corners that were chosen. */
  showCorners(places: readonly Point[]): void {
    this.around.corners = places;
    this.draw();
  }

  /** What is meant, where no edge is. */
  showPin(box: Box | null): void {
    this.around.pin = box;
    this.draw();
  }

  /** The table, in the drawing's coordinates. */
  showTable(box: Box | null): void {
    this.around.box = box;
    this.around.place(this.origin);
    this.draw();
  }

  showLayers(shown: Shown): void {
    this.shown = shown;
    if (shown.swept) this.travel.laySwept(this.tools, this.origin);
    this.draw();
  }

  showChosen(rows: ReadonlySet<number>): void {
    this.dieline.choose(this.edges, this.origin, rows);
    this.draw();
  }

  showRetypePreviews(retypePreviews: readonly Proposal[]): void {
    this.dieline.propose(this.edges, this.origin, retypePreviews);
    this.draw();
  }

  /** Light an edge, or the moves where there is none. */
  showHovered(row: number | null, moves: readonly number[] = []): void {
    this.hoverRow = row;
    this.hoverMoves = moves;
    if (row === null) this.dieline.light(this.picker.segments, this.origin, moves);
    else this.dieline.light(this.edges, this.origin, [row]);
    this.draw();
  }

  /** Put the head where it is after so many seconds of the program; null takes it off. */
  moveHead(seconds: number | null): void {
    this.clock.put(seconds);
    this.draw();
  }

  /** Let the head travel there along its path, in `lasts` ms. */
  runHead(seconds: number, lasts: number): void {
    this.clock.send(seconds, lasts, performance.now());
    this.draw();
  }

  /** Bring a box, or all there is, into view. */
  fit(box?: Box | null, gently = true): void {
    const all = box ?? this.everything();
    if (all === null) return;
    this.glide.to(this.camera.framing(all, INSETS), gently, performance.now());
    this.draw();
  }

  /** Bring the table into view, or all there is where there is none. */
  fitTable(): void {
    this.fit(this.around.box);
  }

  /** Bring some edges into view, with what surrounds them. */
  fitRows(rows: Iterable<number>): void {
    if (this.edges === null) return;
    const box = boundsOf(this.edges, rows);
    if (box === null) return;
    const margin = Math.max(box[2] - box[0], box[3] - box[1], 8) * 0.6;
    this.fit([box[0] - margin, box[1] - margin, box[2] + margin, box[3] + margin]);
  }

  zoomBy(factor: number): void {
    this.zoom(factor, { x: this.camera.width / 2, y: this.camera.height / 2 });
  }

  panBy(dx: number, dy: number): void {
    this.glide.stop();
    this.camera.pan(dx, dy);
    this.draw();
  }

  dispose(): void {
    cancelAnimationFrame(this.asked);
    this.watch.disconnect();
    this.stopListening();
    for (const part of [this.around, this.dieline, this.travel, this.head]) part.dispose();
    this.renderer.dispose();
  }

  private get layers() {
    return [this.around, this.dieline, this.travel, this.head].flatMap(({ layers }) => layers);
  }

  private zoom(factor: number, about: Point): void {
    this.glide.stop();
    this.camera.zoom(factor, about);
    this.draw();
  }

  private everything(): Box | null {
    const drawing = this.edges === null ? null : boundsOf(this.edges);
    if (drawing === null) return this.around.box;
    const { timeline } = this;
    if (timeline === null || !this.shown.head) return drawing;
    let box = drawing;
    const { pose, placement, motion } = timeline.toolpath;
    for (let row = 0; row < motion.length; row++) {
      if (motion[row] === 0) continue;
      const x = (pose[row * 4] as number) - placement[0];
      const y = (pose[row * 4 + 1] as number) - placement[1];
      box = joined(box, [x, y, x, y]);
    }
    return box;
  }

  private point(at: Point | null): void {
    this.events.onCursor(at === null ? null : this.camera.toPlane(at));
    const row = at === null ? null : this.picker.edge(at, this.shown);
    const moves = at === null ? [] : this.picker.movesAt(at, this.shown);
    const was = this.hoverRow !== null || this.hoverMoves.length > 0;
    if (row !== null || moves.length > 0 || was) {
      this.host.style.cursor = row === null ? "" : "pointer";
      this.events.onHover(row, moves, at ?? { x: 0, y: 0 });
    }
  }

  private layTravel(): void {
    this.travel.lay(this.timeline, this.tools, this.origin);
    if (this.shown.swept) this.travel.laySwept(this.tools, this.origin);
  }

  private resize(): void {
    const width = this.host.clientWidth;
    const height = this.host.clientHeight;
    if (width === 0 || height === 0) return;
    const ratio = Math.min(window.devicePixelRatio, 3);
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.camera.resize(width, height);
    for (const layer of this.layers) layer.resize(width, height, ratio);
    // A canvas that changed its size is empty until it is drawn: not a frame later.
    cancelAnimationFrame(this.asked);
    this.render(performance.now());
  }

  private draw(): void {
    if (this.asked === 0) this.asked = requestAnimationFrame((now) => this.render(now));
  }

  private render(now: number): void {
    this.asked = 0;
    const { camera, origin, shown, timeline } = this;
    this.glide.tick(now);
    const seconds = this.clock.tick(now);
    const under = timeline !== null && (shown.head || shown.tip);
    this.around.draw(camera, origin);
    this.dieline.draw(shown.nominal && this.edges !== null, under);
    this.travel.draw(shown, camera.scale, seconds, this.dieline.mapped);
    this.head.draw(timeline, seconds, this.tools, origin, camera.scale);
    camera.apply(origin);
    this.renderer.render(this.scene, camera.three);
    this.events.onView(camera.scale);
    if (this.glide.gliding || this.clock.running) this.draw();
  }
}
