/** Finds the edge and the moves under the cursor. */

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
  private index: PickIndex | null = null;
  private visible: (row: number) => boolean = () => true;

  constructor(private readonly camera: PlaneCamera) {}

  setEdges(edges: Edges | null): void {
    this.index = edges === null ? null : buildPickIndex(edges);
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
    if (this.index === null || !shown.nominal) return null;
    const place = this.camera.toPlane(at);
    return this.index.at(place.x, place.y, REACH / this.camera.scale, this.visible);
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

  /** Edges inside the box between two points of the screen. */
  edgesBetween(from: Point, to: Point): readonly number[] {
    const a = this.camera.toPlane(from);
    const b = this.camera.toPlane(to);
    const box: Box = [
      Math.min(a.x, b.x),
      Math.min(a.y, b.y),
      Math.max(a.x, b.x),
      Math.max(a.y, b.y),
    ];
    return this.index === null ? [] : this.index.inside(box).filter(this.visible);
  }
}
