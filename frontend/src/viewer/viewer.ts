/**
 * The picture: the dieline, the path of the head, the table under it and the head upon it.
 *
 * It is drawn when something has changed and not otherwise: a page left open costs nothing.
 * What it is shown comes in through methods; what the user does goes out through callbacks.
 */

import { Mesh, MeshBasicMaterial, PlaneGeometry, Scene, WebGLRenderer } from "three";
import { boundsOf, joined } from "../geometry/bounds";
import { type PickIndex, pickIndex } from "../geometry/pick";
import type { Box, Edges, Point, Pose } from "../geometry/records";
import { poseAt, rowAt, type Timeline } from "../geometry/timeline";
import { type TipOffset, UNDER_THE_HEAD } from "../geometry/tip";
import { dielineLines, highlightLines, type Palette } from "../scene/dieline";
import { datumLines, frameLines, gridLines, headLines } from "../scene/furniture";
import type { Rgba } from "../scene/lines";
import { type TravelColours, travelLines } from "../scene/travel";
import { type Insets, PlaneCamera } from "./camera";
import { LineLayer } from "./layer";
import { listenToPointer } from "./pointer";

export interface ViewerColours extends TravelColours {
  readonly palette: Palette;
  readonly backdrop: string;
  readonly table: string;
  /** What a line that steps back comes near to. */
  readonly ground: Rgba;
  readonly tableEdge: Rgba;
  readonly gridMinor: Rgba;
  readonly gridMajor: Rgba;
  readonly axisX: Rgba;
  readonly axisY: Rgba;
  readonly hover: Rgba;
  readonly chosen: Rgba;
  readonly done: Rgba;
  readonly mark: Rgba;
  readonly blade: Rgba;
}

export interface ViewerEvents {
  onHover(row: number | null, at: Point): void;
  onChoose(rows: readonly number[], add: boolean): void;
  onCursor(at: Point | null): void;
  onView(pixelsPerMm: number): void;
  onBox(box: { from: Point; to: Point } | null): void;
}

export interface Shown {
  readonly nominal: boolean;
  readonly head: boolean;
  readonly tip: boolean;
  readonly rapids: boolean;
}

/** How near the cursor must come to an edge (pixels). */
const REACH = 7;
const GLIDE = 260;
/** A report this much behind the marker is no way back (s of the program). */
const SLACK = 1.5;

/** This browser has no WebGL. */
export class NoWebGL extends Error {
  override name = "NoWebGL";
}

export class Viewer {
  readonly camera = new PlaneCamera();
  insets: Insets = { left: 56, top: 68, right: 64, bottom: 104 };

  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly grid = new LineLayer(1, 1);
  private readonly frame = new LineLayer(1.25, 2);
  private readonly datum = new LineLayer(2, 3);
  private readonly chosen = new LineLayer(10, 4);
  private readonly nominal = new LineLayer(1.75, 5);
  private readonly rapids = new LineLayer(1, 6);
  private readonly head = new LineLayer(1.6, 7);
  private readonly tip = new LineLayer(1, 8);
  private readonly hovered = new LineLayer(3.5, 9);
  private readonly mark = new LineLayer(2.25, 11);
  private readonly halo = new LineLayer(5, 10);
  private readonly table: Mesh<PlaneGeometry, MeshBasicMaterial>;
  private readonly layers = [
    this.grid,
    this.frame,
    this.datum,
    this.chosen,
    this.nominal,
    this.rapids,
    this.head,
    this.tip,
    this.hovered,
    this.halo,
    this.mark,
  ];
  private readonly watch: ResizeObserver;
  private readonly stopListening: () => void;

  private origin: Point = { x: 0, y: 0 };
  private edges: Edges | null = null;
  private index: PickIndex | null = null;
  private visible: (row: number) => boolean = () => true;
  private timeline: Timeline | null = null;
  private offsets: ReadonlyMap<number, TipOffset> = new Map();
  private tableBox: Box | null = null;
  private shown: Shown = { nominal: true, head: true, tip: false, rapids: false };
  private seconds: number | null = null;
  private run: { from: number; to: number; began: number; lasts: number } | null = null;
  private glide: {
    from: { centre: Point; scale: number };
    to: { centre: Point; scale: number };
    began: number;
  } | null = null;
  private asked = 0;
  private ratio = 1;
  private hoverRow: number | null = null;

  constructor(
    private readonly host: HTMLElement,
    canvas: HTMLCanvasElement,
    private readonly colours: ViewerColours,
    private readonly events: ViewerEvents,
  ) {
    try {
      this.renderer = new WebGLRenderer({ canvas, antialias: false, alpha: false });
    } catch (cause) {
      throw new NoWebGL("This browser cannot draw with WebGL.", { cause });
    }
    this.renderer.setClearColor(colours.backdrop);
    this.table = new Mesh(
      new PlaneGeometry(1, 1),
      new MeshBasicMaterial({ color: colours.table, depthTest: false, depthWrite: false }),
    );
    this.table.visible = false;
    this.table.frustumCulled = false;
    this.scene.add(this.table);
    for (const layer of this.layers) this.scene.add(layer.mesh);

    this.watch = new ResizeObserver(() => this.resize());
    this.watch.observe(host);
    canvas.addEventListener("webglcontextrestored", () => this.draw());
    this.stopListening = listenToPointer(host, {
      pan: (dx, dy) => {
        this.glide = null;
        this.camera.pan(dx, dy);
        this.draw();
      },
      zoom: (factor, about) => {
        this.glide = null;
        this.camera.zoom(factor, about);
        this.draw();
      },
      point: (at) => this.point(at),
      choose: (at, add) => {
        const row = this.pick(at);
        events.onChoose(row === null ? [] : [row], add);
      },
      box: (from, to, final) => {
        events.onBox(final ? null : { from, to });
        if (!final || this.index === null) return;
        const a = this.camera.toPlane(from);
        const b = this.camera.toPlane(to);
        const inside = this.index.inside([
          Math.min(a.x, b.x),
          Math.min(a.y, b.y),
          Math.max(a.x, b.x),
          Math.max(a.y, b.y),
        ]);
        events.onChoose(inside.filter(this.visible), true);
      },
    });
    this.resize();
  }

  /** Show a drawing; `visible` says which of its edges. */
  showEdges(edges: Edges | null, visible: (row: number) => boolean): void {
    const fresh = edges?.ends !== this.edges?.ends;
    this.edges = edges;
    this.visible = visible;
    if (fresh) {
      const box = edges === null ? null : boundsOf(edges);
      this.origin =
        box === null ? { x: 0, y: 0 } : { x: (box[0] + box[2]) / 2, y: (box[1] + box[3]) / 2 };
      this.index = edges === null ? null : pickIndex(edges);
      this.hoverRow = null;
      this.hovered.show(null);
      this.placeTable();
      this.layTravel();
    }
    this.nominal.show(
      edges === null ? null : dielineLines(edges, this.origin, this.colours.palette, visible),
    );
    this.draw();
  }

  showTravel(timeline: Timeline | null, offsets: ReadonlyMap<number, TipOffset>): void {
    if (timeline !== this.timeline) {
      this.seconds = null;
      this.run = null;
    }
    this.timeline = timeline;
    this.offsets = offsets;
    this.layTravel();
    this.draw();
  }

  /** The table, in the drawing's coordinates. */
  showTable(box: Box | null): void {
    this.tableBox = box;
    this.placeTable();
    this.draw();
  }

  showLayers(shown: Shown): void {
    this.shown = shown;
    this.draw();
  }

  showChosen(rows: ReadonlySet<number>): void {
    this.chosen.show(
      this.edges === null
        ? null
        : highlightLines(this.edges, this.origin, rows, this.colours.chosen),
    );
    this.draw();
  }

  showHovered(row: number | null): void {
    this.hoverRow = row;
    this.hovered.show(
      this.edges === null || row === null
        ? null
        : highlightLines(this.edges, this.origin, [row], this.colours.hover),
    );
    this.draw();
  }

  /** Put the head where it is after so many seconds of the program; null takes it off. */
  moveHead(seconds: number | null): void {
    this.run = null;
    this.seconds = seconds;
    this.draw();
  }

  /** Let the head travel there along its path, in `lasts` ms. */
  runHead(seconds: number, lasts: number): void {
    const from = this.headSeconds(performance.now());
    // The report may be a little behind where the marker has come to: let it catch up.
    if (from !== null && seconds < from && from - seconds < SLACK) return;
    // Far back is a new copy, or another place altogether: be there at once.
    if (from === null || seconds < from) {
      this.moveHead(seconds);
      return;
    }
    this.run = { from, to: seconds, began: performance.now(), lasts: Math.max(1, lasts) };
    this.draw();
  }

  get headTime(): number | null {
    return this.headSeconds(performance.now());
  }

  /** Bring a box, or all there is, into view. */
  fit(box?: Box | null, gently = true): void {
    const all = box ?? this.everything();
    if (all === null) return;
    const to = this.camera.framing(all, this.insets);
    const from = { centre: this.camera.centre, scale: this.camera.scale };
    const still = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (!gently || still) {
      this.camera.centre = to.centre;
      this.camera.scale = to.scale;
    } else this.glide = { from, to, began: performance.now() };
    this.draw();
  }

  /** Bring the table into view, or all there is where there is none. */
  fitTable(): void {
    this.fit(this.tableBox);
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
    this.glide = null;
    this.camera.zoom(factor, { x: this.camera.width / 2, y: this.camera.height / 2 });
    this.draw();
  }

  panBy(dx: number, dy: number): void {
    this.camera.pan(dx, dy);
    this.draw();
  }

  dispose(): void {
    cancelAnimationFrame(this.asked);
    this.watch.disconnect();
    this.stopListening();
    for (const layer of this.layers) layer.dispose();
    this.table.geometry.dispose();
    this.table.material.dispose();
    this.renderer.dispose();
  }

  private everything(): Box | null {
    const drawing = this.edges === null ? null : boundsOf(this.edges);
    if (drawing === null) return this.tableBox;
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

  private pick(at: Point): number | null {
    if (this.index === null || !this.shown.nominal) return null;
    const place = this.camera.toPlane(at);
    return this.index.at(place.x, place.y, REACH / this.camera.scale, this.visible);
  }

  private point(at: Point | null): void {
    this.events.onCursor(at === null ? null : this.camera.toPlane(at));
    const row = at === null ? null : this.pick(at);
    if (row !== null || this.hoverRow !== null) {
      this.host.style.cursor = row === null ? "" : "pointer";
      this.events.onHover(row, at ?? { x: 0, y: 0 });
    }
  }

  private placeTable(): void {
    const box = this.tableBox;
    this.table.visible = box !== null;
    this.frame.show(box === null ? null : frameLines(box, this.origin, this.colours.tableEdge));
    if (box === null) return;
    this.table.scale.set(box[2] - box[0], box[3] - box[1], 1);
    this.table.position.set(
      (box[0] + box[2]) / 2 - this.origin.x,
      (box[1] + box[3]) / 2 - this.origin.y,
      0,
    );
  }

  private layTravel(): void {
    const { timeline } = this;
    const lines =
      timeline === null ? null : travelLines(timeline, this.origin, this.colours, this.offsets);
    this.head.show(lines?.head ?? null);
    this.tip.show(lines?.tip ?? null);
    this.rapids.show(lines?.rapids ?? null);
  }

  private resize(): void {
    const width = this.host.clientWidth;
    const height = this.host.clientHeight;
    if (width === 0 || height === 0) return;
    this.ratio = Math.min(window.devicePixelRatio, 3);
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(width, height, false);
    this.camera.resize(width, height);
    for (const layer of this.layers) layer.resize(width, height, this.ratio);
    // A canvas that changed its size is empty until it is drawn: not a frame later.
    cancelAnimationFrame(this.asked);
    this.asked = 0;
    this.render(performance.now());
  }

  private draw(): void {
    if (this.asked === 0) this.asked = requestAnimationFrame((now) => this.render(now));
  }

  private headSeconds(now: number): number | null {
    if (this.run === null) return this.seconds;
    const { from, to, began, lasts } = this.run;
    return from + (to - from) * Math.min(1, Math.max(0, (now - began) / lasts));
  }

  private render(now: number): void {
    this.asked = 0;
    const { camera, origin } = this;
    if (this.glide !== null) {
      const { from, to, began } = this.glide;
      const t = Math.min(1, Math.max(0, (now - began) / GLIDE));
      const eased = 1 - (1 - t) ** 3;
      camera.scale = from.scale * (to.scale / from.scale) ** eased;
      camera.centre = {
        x: from.centre.x + (to.centre.x - from.centre.x) * eased,
        y: from.centre.y + (to.centre.y - from.centre.y) * eased,
      };
      if (t === 1) this.glide = null;
    }
    this.seconds = this.headSeconds(now);
    if (this.run !== null && now >= this.run.began + this.run.lasts) this.run = null;

    this.grid.show(
      gridLines(
        camera.seen(),
        origin,
        camera.scale,
        this.colours.gridMinor,
        this.colours.gridMajor,
      ),
    );
    const datum = this.tableBox;
    this.datum.show(
      datum === null
        ? null
        : datumLines(
            { x: datum[0], y: datum[1] },
            origin,
            36 / camera.scale,
            this.colours.axisX,
            this.colours.axisY,
          ),
    );
    this.markHead();

    const has = this.timeline !== null;
    const { shown } = this;
    this.nominal.mesh.visible = shown.nominal && this.edges !== null;
    // Where the tool turns about its tip both paths are one: the nominal line becomes the wider
    // and fainter, so that it is seen on either side of the other.
    if (has && (shown.head || shown.tip)) this.nominal.look(4.5, 0.75, this.colours.ground);
    else this.nominal.look(1.75, 1, this.colours.ground);
    this.head.mesh.visible = shown.head && has;
    this.tip.mesh.visible = shown.tip && has;
    this.rapids.mesh.visible = shown.rapids && has;
    for (const layer of [this.head, this.tip]) layer.until(this.seconds ?? -1, this.colours.done);
    camera.apply(origin);
    this.renderer.render(this.scene, camera.three);
    this.events.onView(camera.scale);
    if (this.glide !== null || this.run !== null) this.draw();
  }

  private markHead(): void {
    const { timeline, seconds } = this;
    const pose: Pose | null =
      timeline === null || seconds === null ? null : poseAt(timeline, seconds);
    if (timeline === null || seconds === null || pose === null) {
      this.mark.show(null);
      this.halo.show(null);
      return;
    }
    const { placement, tool } = timeline.toolpath;
    const offset = this.offsets.get(tool[rowAt(timeline, seconds)] ?? 0) ?? UNDER_THE_HEAD;
    const here: Pose = { ...pose, x: pose.x - placement[0], y: pose.y - placement[1] };
    const pixel = 1 / this.camera.scale;
    const { mark, blade } = this.colours;
    const shadow: Rgba = [8, 10, 14, 190];
    this.halo.show(headLines(here, offset, this.origin, pixel, shadow, shadow));
    this.mark.show(headLines(here, offset, this.origin, pixel, mark, blade));
  }
}
