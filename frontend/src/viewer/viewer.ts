/**
 * The picture: the dieline, the path of the head, the table under it and the head upon it.
 *
 * It is drawn when something has changed and not otherwise: a page left open costs nothing.
 * What it is shown comes in through methods; what the user does goes out through callbacks.
 */

import { Mesh, MeshBasicMaterial, PlaneGeometry, Scene, WebGLRenderer } from "three";
import { boundsOf, joined } from "../geometry/bounds";
import { movesOf } from "../geometry/moves";
import { type PickIndex, pickIndex } from "../geometry/pick";
import {
  type Areas,
  type Box,
  type Edges,
  type LineType,
  MOTIONS,
  type Point,
  type Pose,
  type Segments,
} from "../geometry/records";
import { poseAt, rowAt, type Timeline } from "../geometry/timeline";
import { UNDER_THE_HEAD } from "../geometry/tip";
import { areaShapes } from "../scene/areas";
import {
  type DielineLooks,
  dielineLines,
  highlightLines,
  type Palette,
  proposedLines,
} from "../scene/dieline";
import { datumLines, frameLines, gridLines, headLines, ringLines } from "../scene/furniture";
import type { Rgba } from "../scene/lines";
import { MARKED, type Marked, motionMarks } from "../scene/marks";
import { type SweptColours, sweptShapes, type Tools } from "../scene/swept";
import { type TravelColours, travelLines } from "../scene/travel";
import { BandLayer } from "./bands";
import { type Insets, PlaneCamera } from "./camera";
import { LineLayer } from "./layer";
import { listenToPointer } from "./pointer";

export interface ViewerColours extends TravelColours {
  readonly palette: Palette;
  readonly swept: SweptColours;
  readonly marks: Readonly<Record<Marked, Rgba>>;
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
  readonly uncut: Rgba;
  readonly uncutRim: Rgba;
  /** Of the ring about a corner that was chosen. */
  readonly corner: Rgba;
}

export interface ViewerEvents {
  /** An edge, and the moves of the head that are there: both may be none. */
  onHover(row: number | null, moves: readonly number[], at: Point): void;
  /** Edges, and where in the drawing it was clicked; nowhere for a box. */
  onChoose(rows: readonly number[], add: boolean, at: Point | null): void;
  onCursor(at: Point | null): void;
  onView(pixelsPerMm: number): void;
  onBox(box: { from: Point; to: Point } | null): void;
}

export interface Shown {
  readonly nominal: boolean;
  readonly head: boolean;
  readonly tip: boolean;
  readonly rapids: boolean;
  readonly swept: boolean;
  readonly moves: boolean;
  readonly uncut: boolean;
}

/** How near the cursor must come to an edge (pixels). */
const REACH = 7;
/** Moves this much farther than the nearest one are pointed at with it (pixels). */
const TOGETHER = 1.5;
/** About a corner that was chosen (pixels). */
const CORNER_RING = 9;
const GLIDE = 260;
const NOMINAL_ORDER = 5;
/** Above the paths, under what is pointed at. */
const MAP_ORDER = 8.5;
/** How wide the dots of the moves are (pixels) … */
const MARKS: Readonly<Record<Marked, number>> = { lift: 10, swivel: 7, plunge: 4 };
/** … where a millimetre is at least this large; smaller from farther away, to this part of it. */
const FULL_MARKS = 2;
const LEAST_MARKS = 0.4;
/** A report this much behind the marker is no way back (s of the program). */
const SLACK = 1.5;

/** This browser has no WebGL. */
export class NoWebGL extends Error {
  override name = "NoWebGL";
}

export class Viewer {
  readonly camera = new PlaneCamera();
  insets: Insets = { left: 56, top: 108, right: 64, bottom: 104 };

  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly grid = new LineLayer(1, 1);
  private readonly frame = new LineLayer(1.25, 2);
  private readonly datum = new LineLayer(2, 3);
  private readonly chosen = new LineLayer(10, 4);
  private readonly proposed = new LineLayer(9, 4.2);
  private readonly bands = new BandLayer(4.5);
  private readonly rims = new LineLayer(1.25, 4.6);
  private readonly uncut = new BandLayer(5.4);
  private readonly uncutRims = new LineLayer(1.5, 5.5);
  private readonly corners = new LineLayer(2, 9.5);
  private readonly nominal = new LineLayer(1.75, NOMINAL_ORDER);
  private readonly rapids = new LineLayer(1, 6);
  private readonly head = new LineLayer(1.6, 7);
  private readonly tip = new LineLayer(1, 8);
  private readonly hovered = new LineLayer(3.5, 9);
  // One within the other, so that all are seen where a tool is lifted, turned and set down.
  private readonly motions = {
    lift: new LineLayer(MARKS.lift, 9.1),
    swivel: new LineLayer(MARKS.swivel, 9.2),
    plunge: new LineLayer(MARKS.plunge, 9.3),
  };
  private readonly mark = new LineLayer(2.25, 11);
  private readonly halo = new LineLayer(5, 10);
  private readonly table: Mesh<PlaneGeometry, MeshBasicMaterial>;
  private readonly layers = [
    this.grid,
    this.frame,
    this.datum,
    this.chosen,
    this.proposed,
    this.rims,
    this.uncutRims,
    this.corners,
    this.nominal,
    this.rapids,
    this.head,
    this.tip,
    this.hovered,
    ...Object.values(this.motions),
    this.halo,
    this.mark,
  ];
  private readonly watch: ResizeObserver;
  private readonly stopListening: () => void;

  private origin: Point = { x: 0, y: 0 };
  private edges: Edges | null = null;
  private index: PickIndex | null = null;
  private visible: (row: number) => boolean = () => true;
  private mapped = false;
  private timeline: Timeline | null = null;
  private moves: { segments: Segments; index: PickIndex } | null = null;
  private tools: Tools = { sweeps: new Map(), offsets: new Map(), caliper: 0 };
  /** What is swept costs more to lay than a line: it is laid when it is first asked for. */
  private sweptLaid = false;
  private tableBox: Box | null = null;
  private shown: Shown = {
    nominal: true,
    head: true,
    tip: false,
    rapids: false,
    swept: false,
    moves: false,
    uncut: true,
  };
  private areas: Areas | null = null;
  private cornerPlaces: readonly Point[] = [];
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
  private hoverMoves: readonly number[] = [];

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
    for (const layer of [this.bands, this.uncut, ...this.layers]) this.scene.add(layer.mesh);

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
        events.onChoose(row === null ? [] : [row], add, this.camera.toPlane(at));
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
        events.onChoose(inside.filter(this.visible), true, null);
      },
    });
    this.resize();
  }

  /** Show a drawing; `visible` says which of its edges, `looks` how they are told apart. */
  showEdges(
    edges: Edges | null,
    visible: (row: number) => boolean,
    looks: Omit<DielineLooks, "shown"> = {},
  ): void {
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
      this.layAreas();
    }
    this.nominal.show(
      edges === null
        ? null
        : dielineLines(edges, this.origin, this.colours.palette, { ...looks, shown: visible }),
    );
    this.mapped = (looks.colours ?? null) !== null;
    this.draw();
  }

  showTravel(timeline: Timeline | null, tools: Tools): void {
    if (timeline !== this.timeline) {
      this.seconds = null;
      this.run = null;
      this.moves = null;
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
    this.layAreas();
    this.draw();
  }

  /** Corners that were chosen. */
  showCorners(places: readonly Point[]): void {
    this.cornerPlaces = places;
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
    this.laySwept();
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

  /** Lay under edges the colours of what they would become. */
  showProposed(
    proposed: readonly { readonly rows: readonly number[]; readonly type: LineType }[],
  ): void {
    const { edges, origin, colours } = this;
    this.proposed.show(
      edges === null || proposed.length === 0
        ? null
        : proposedLines(edges, origin, proposed, colours.palette),
    );
    this.draw();
  }

  /** Light an edge, or the moves where there is none. */
  showHovered(row: number | null, moves: readonly number[] = []): void {
    this.hoverRow = row;
    this.hoverMoves = moves;
    const { edges, origin, colours } = this;
    const [lit, rows] = row === null ? [this.moves?.segments, moves] : [edges, [row]];
    this.hovered.show(
      lit === null || lit === undefined ? null : highlightLines(lit, origin, rows, colours.hover),
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
    for (const layer of [this.bands, this.uncut, ...this.layers]) layer.dispose();
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

  /** The moves of the head that are seen at a place. */
  private pickMoves(at: Point): readonly number[] {
    const { timeline, shown } = this;
    if (timeline === null || !(shown.head || shown.rapids)) return [];
    const { toolpath } = timeline;
    if (this.moves === null) {
      const segments = movesOf(toolpath);
      this.moves = { segments, index: pickIndex(segments) };
    }
    const place = this.camera.toPlane(at);
    const pixel = 1 / this.camera.scale;
    return this.moves.index.near(place.x, place.y, REACH * pixel, TOGETHER * pixel, (row) =>
      MOTIONS[toolpath.motion[row] ?? 0] === "rapid" ? shown.rapids : shown.head,
    );
  }

  private point(at: Point | null): void {
    this.events.onCursor(at === null ? null : this.camera.toPlane(at));
    const row = at === null ? null : this.pick(at);
    const moves = at === null ? [] : this.pickMoves(at);
    const was = this.hoverRow !== null || this.hoverMoves.length > 0;
    if (row !== null || moves.length > 0 || was) {
      this.host.style.cursor = row === null ? "" : "pointer";
      this.events.onHover(row, moves, at ?? { x: 0, y: 0 });
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
      timeline === null
        ? null
        : travelLines(timeline, this.origin, this.colours, this.tools.offsets);
    this.head.show(lines?.head ?? null);
    this.tip.show(lines?.tip ?? null);
    this.rapids.show(lines?.rapids ?? null);
    const dots =
      timeline === null ? null : motionMarks(timeline.toolpath, this.origin, this.colours.marks);
    this.motions.plunge.show(dots?.plunge ?? null);
    this.motions.lift.show(dots?.lift ?? null);
    this.motions.swivel.show(dots?.swivel ?? null);
    this.sweptLaid = false;
    this.laySwept();
  }

  private layAreas(): void {
    const { areas, origin, colours } = this;
    const shapes =
      areas === null ? null : areaShapes(areas, origin, colours.uncut, colours.uncutRim);
    this.uncut.show(shapes?.bands ?? null);
    this.uncutRims.show(shapes?.rims ?? null);
  }

  private laySwept(): void {
    if (this.sweptLaid || !this.shown.swept) return;
    this.sweptLaid = true;
    const { timeline, origin, tools, colours } = this;
    const swept =
      timeline === null ? null : sweptShapes(timeline.toolpath, origin, tools, colours.swept);
    this.bands.show(swept?.bands ?? null);
    this.rims.show(swept?.rims ?? null);
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
    const { ground } = this.colours;
    if (this.mapped) this.nominal.look(4, 1, ground);
    else if (has && (shown.head || shown.tip)) this.nominal.look(4.5, 0.75, ground);
    else this.nominal.look(1.75, 1, ground);
    // A map is what is looked at: the paths step back, and under it.
    this.nominal.mesh.renderOrder = this.mapped ? MAP_ORDER : NOMINAL_ORDER;
    this.head.look(1.6, this.mapped ? 0.5 : 1, ground);
    this.tip.look(1, this.mapped ? 0.4 : 1, ground);
    this.head.mesh.visible = shown.head && has;
    this.tip.mesh.visible = shown.tip && has;
    this.rapids.mesh.visible = shown.rapids && has;
    this.bands.mesh.visible = shown.swept && has;
    this.uncut.mesh.visible = shown.uncut && this.areas !== null;
    this.uncutRims.mesh.visible = shown.uncut && this.areas !== null;
    this.corners.show(
      ringLines(this.cornerPlaces, origin, CORNER_RING / camera.scale, this.colours.corner),
    );
    this.rims.mesh.visible = shown.swept && has;
    const near = Math.min(1, Math.max(LEAST_MARKS, camera.scale / FULL_MARKS));
    for (const word of MARKED) {
      this.motions[word].mesh.visible = shown.moves && has;
      this.motions[word].look(MARKS[word] * near, 1, ground);
    }
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
    const offset = this.tools.offsets.get(tool[rowAt(timeline, seconds)] ?? 0) ?? UNDER_THE_HEAD;
    const here: Pose = { ...pose, x: pose.x - placement[0], y: pose.y - placement[1] };
    const pixel = 1 / this.camera.scale;
    const { mark, blade } = this.colours;
    const shadow: Rgba = [8, 10, 14, 190];
    this.halo.show(headLines(here, offset, this.origin, pixel, shadow, shadow));
    this.mark.show(headLines(here, offset, this.origin, pixel, mark, blade));
  }
}
