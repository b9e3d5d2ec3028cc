/** Layers around the drawing: grid, table, datum and marks. */

import type { WebGLRenderer } from "three";
import type { Box, Point } from "../geometry/records";
import { cornersOnDrawing, type Similarity } from "../geometry/similarity";
import {
  datumLines,
  frameLines,
  gridLines,
  pinLines,
  ringLines,
  zoneLines,
} from "../scene/overlays";
import type { PlaneCamera } from "./camera";
import type { ViewerColours } from "./contract";
import { GroundLayer } from "./ground";
import { LineLayer } from "./layer";
import { ORDER } from "./order";

/** Radius of the ring about a corner, and length of the datum axes (pixels). */
const RING = 9;
const ARM = 36;
const AS_DRAWN: Similarity = [1, 0, 0, 0];

const boundsOfPoints = (points: readonly Point[]): Box => {
  const [xs, ys] = [points.map(({ x }) => x), points.map(({ y }) => y)];
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
};

/** Whether the first side of a rectangle is not parallel to X. */
const isTurned = ([first, second]: readonly Point[]): boolean => first?.y !== second?.y;

export class Surroundings {
  /** Corners of the table in drawing coordinates; the first is the datum. */
  table: readonly Point[] | null = null;
  /** A rectangular sheet as a box in drawing coordinates. */
  sheet: Box | null = null;
  /** Corners of each keep-out zone in drawing coordinates. */
  zones: readonly (readonly Point[])[] = [];
  /** Corners that have a type of their own. */
  corners: readonly Point[] = [];
  /** The box that a pin marks. */
  pin: Box | null = null;

  /** The table where it is turned against the drawing. */
  readonly ground: GroundLayer;
  private readonly gridLayer = new LineLayer("thin", ORDER.grid);
  private readonly frameLayer = new LineLayer(1.25, ORDER.frame);
  private readonly sheetLayer = new LineLayer(1.5, ORDER.sheet);
  private readonly zoneLayer = new LineLayer(1.5, ORDER.zones);
  private readonly datumLayer = new LineLayer(2, ORDER.datum);
  private readonly cornerLayer = new LineLayer(2, ORDER.corners);
  private readonly pinLayer = new LineLayer(2.5, ORDER.pin);
  readonly layers = [
    this.gridLayer,
    this.frameLayer,
    this.sheetLayer,
    this.zoneLayer,
    this.datumLayer,
    this.cornerLayer,
    this.pinLayer,
  ];

  constructor(private readonly colours: ViewerColours) {
    this.ground = new GroundLayer(colours.table, ORDER.ground);
  }

  /** Bounding box of the table in drawing coordinates. */
  get box(): Box | null {
    return this.table === null ? null : boundsOfPoints(this.table);
  }

  /** Fill the frame with the backdrop and the table: to clear a rectangle is cheaper than to draw it. */
  paintGround(renderer: WebGLRenderer, camera: PlaneCamera): void {
    const { box, colours } = this;
    renderer.setScissorTest(false);
    renderer.setClearColor(colours.backdrop);
    renderer.clear();
    // A turned table is a mesh.
    if (box === null || this.ground.mesh.visible) return;
    const low = camera.toScreen({ x: box[0], y: box[1] });
    const high = camera.toScreen({ x: box[2], y: box[3] });
    const left = Math.max(0, low.x);
    const top = Math.max(0, high.y);
    const right = Math.min(camera.width, high.x);
    const bottom = Math.min(camera.height, low.y);
    if (left >= right || top >= bottom) return;
    renderer.setScissorTest(true);
    renderer.setScissor(left, camera.height - bottom, right - left, bottom - top);
    renderer.setClearColor(colours.table);
    renderer.clear();
    renderer.setScissorTest(false);
  }

  /** Rebuild the table after a change of the table or of the origin. */
  updateTable(origin: Point): void {
    const { table, sheet, zones } = this;
    const { zone } = this.colours;
    this.ground.show(table !== null && isTurned(table) ? table : null, origin);
    this.zoneLayer.show(zones.length === 0 ? null : zoneLines(zones, origin, zone));
    this.sheetLayer.show(
      sheet === null
        ? null
        : frameLines(cornersOnDrawing(sheet, AS_DRAWN), origin, this.colours.sheetEdge),
    );
    this.frameLayer.show(table === null ? null : frameLines(table, origin, this.colours.tableEdge));
  }

  /** Rebuild the layers that have a fixed size on the screen. */
  draw(camera: PlaneCamera, origin: Point): void {
    const { table, pin, colours } = this;
    const pixel = 1 / camera.scale;
    const { gridMinor, gridMajor, axisX, axisY } = colours;
    this.gridLayer.show(gridLines(camera.visibleBox(), origin, camera.scale, gridMinor, gridMajor));
    this.datumLayer.show(
      table === null ? null : datumLines(table, origin, ARM * pixel, axisX, axisY),
    );
    this.cornerLayer.show(ringLines(this.corners, origin, RING * pixel, colours.corner));
    this.pinLayer.show(pin === null ? null : pinLines(pin, origin, pixel, colours.pin));
  }

  dispose(): void {
    for (const layer of [...this.layers, this.ground]) layer.dispose();
  }
}
