/** Layers around the drawing: grid, table, datum and marks. */

import { Mesh, MeshBasicMaterial, PlaneGeometry } from "three";
import type { Box, Point } from "../geometry/records";
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
import { LineLayer } from "./layer";
import { ORDER } from "./order";

/** Radius of the ring about a corner, and length of the datum axes (pixels). */
const RING = 9;
const ARM = 36;

export class Surroundings {
  readonly table: Mesh<PlaneGeometry, MeshBasicMaterial>;
  /** The table as a box in drawing coordinates. */
  box: Box | null = null;
  /** A rectangular sheet as a box in drawing coordinates. */
  sheet: Box | null = null;
  /** Keep-out zones as boxes in drawing coordinates. */
  zones: readonly Box[] = [];
  /** Corners that have a type of their own. */
  corners: readonly Point[] = [];
  /** The box that a pin marks. */
  pin: Box | null = null;

  private readonly gridLayer = new LineLayer(1, ORDER.grid);
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
    this.table = new Mesh(
      new PlaneGeometry(1, 1),
      new MeshBasicMaterial({ color: colours.table, depthTest: false, depthWrite: false }),
    );
    this.table.visible = false;
    this.table.frustumCulled = false;
  }

  /** Rebuild the table after a change of the table or of the origin. */
  updateTable(origin: Point): void {
    const { box, sheet, zones } = this;
    const { zone } = this.colours;
    this.zoneLayer.show(zones.length === 0 ? null : zoneLines(zones, origin, zone));
    this.sheetLayer.show(sheet === null ? null : frameLines(sheet, origin, this.colours.sheetEdge));
    this.table.visible = box !== null;
    this.frameLayer.show(box === null ? null : frameLines(box, origin, this.colours.tableEdge));
    if (box === null) return;
    const [x0, y0, x1, y1] = box;
    this.table.scale.set(x1 - x0, y1 - y0, 1);
    this.table.position.set((x0 + x1) / 2 - origin.x, (y0 + y1) / 2 - origin.y, 0);
  }

  /** Rebuild the layers that have a fixed size on the screen. */
  draw(camera: PlaneCamera, origin: Point): void {
    const { box, pin, colours } = this;
    const pixel = 1 / camera.scale;
    const { gridMinor, gridMajor, axisX, axisY } = colours;
    this.gridLayer.show(gridLines(camera.visibleBox(), origin, camera.scale, gridMinor, gridMajor));
    const datum = box === null ? null : { x: box[0], y: box[1] };
    this.datumLayer.show(
      datum === null ? null : datumLines(datum, origin, ARM * pixel, axisX, axisY),
    );
    this.cornerLayer.show(ringLines(this.corners, origin, RING * pixel, colours.corner));
    this.pinLayer.show(pin === null ? null : pinLines(pin, origin, pixel, colours.pin));
  }

  dispose(): void {
    for (const layer of this.layers) layer.dispose();
    this.table.geometry.dispose();
    this.table.material.dispose();
  }
}
