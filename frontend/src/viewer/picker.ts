/** Finds the edge and the moves under the cursor. */

import { rowsInside } from "../geometry/lasso";
import { moveSegments } from "../geometry/moves";
import { buildPickIndex, type PickIndex } from "../geometry/pick";
import { type Box, type Edges, MOTIONS, type Point, type Segments } from "../geometry/records";
import type { Timeline } from "../geometry/timeline";
import type { PlaneCamera } from "./camera";
import type { VisibleLayers } from "./contract";

/** Maximum distance of the cursor from an edge (pixels). */
const REACH = 7;
/** Moves farther than the nearest one by at most this are picked with it (pixels). */
const TOLERANCE = 1.5;

export class Picker {
  /** Built on first use. */
  private moves: { segments: Segments; index: PickIndex } | null = null;
  private timeline: Timeline | null = null;
  private edges: Edges | null = null;
  /** Built on first use, after the first picture. */
  private index: PickIndex | null = null;
  private visible: (row: number) => boolean = () => true;

  constructor(private readonly camera: PlaneCamera) {}

  setEdges(edges: Edges | null): void {
    this.edges = edges;
    this.index = null;
  }

  setVisible(visible: (row: number) => boolean): void {
    this.visible = visible;
  }

  setTimeline(timeline: Timeline | null): void {
    this.timeline = timeline;
    this.moves = null;
  }

  /** The moves as segments, if they were built. */
  get segments(): Segments | null {
    return this.moves?.segments ?? null;
  }

  edgeAt(at: Point, shown: VisibleLayers): number | null {
    const index = this.edgeIndex();
    if (index === null || !shown.nominal) return null;
    const place = this.camera.toPlane(at);
    return index.at(place.x, place.y, REACH / this.camera.scale, this.visible);
  }

  movesAt(at: Point, shown: VisibleLayers): readonly number[] {
    if (this.timeline === null || !(shown.head || shown.rapids)) return [];
    const { toolpath } = this.timeline;
    if (this.moves === null) {
      const segments = moveSegments(toolpath);
      this.moves = { segments, index: buildPickIndex(segments) };
    }
    const place = this.camera.toPlane(at);
    const pixel = 1 / this.camera.scale;
    return this.moves.index.near(place.x, place.y, REACH * pixel, TOLERANCE * pixel, (row) =>
      MOTIONS[toolpath.motion[row] ?? 0] === "rapid" ? shown.rapids : shown.head,
    );
  }

  /** Edges inside a polygon of points of the screen. */
  edgesInside(corners: readonly Point[]): readonly number[] {
    const index = this.edgeIndex();
    if (index === null || this.edges === null) return [];
    const polygon = corners.map((corner) => this.camera.toPlane(corner));
    const xs = polygon.map(({ x }) => x);
    const ys = polygon.map(({ y }) => y);
    const box: Box = [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
    return rowsInside(this.edges, index.inside(box).filter(this.visible), polygon);
  }

  private edgeIndex(): PickIndex | null {
    if (this.index === null && this.edges !== null) this.index = buildPickIndex(this.edges);
    return this.index;
  }
}
