/** Layers of the head marker and its shadow. */

import type { Point, Pose } from "../geometry/records";
import { poseAt, rowAt, type Timeline } from "../geometry/timeline";
import { NO_OFFSET } from "../geometry/tip";
import type { Rgba } from "../scene/lines";
import { headLines } from "../scene/overlays";
import type { Tools } from "../scene/swept";
import type { ViewerColours } from "./contract";
import { LineLayer } from "./layer";
import { ORDER } from "./order";

const SHADOW: Rgba = [8, 10, 14, 190];

export class HeadMark {
  private readonly mark = new LineLayer(2.25, ORDER.mark);
  private readonly halo = new LineLayer(5, ORDER.halo);
  readonly layers = [this.halo, this.mark];

  constructor(private readonly colours: ViewerColours) {}

  draw(
    timeline: Timeline | null,
    seconds: number | null,
    tools: Tools,
    origin: Point,
    scale: number,
  ): void {
    const pose = timeline === null || seconds === null ? null : poseAt(timeline, seconds);
    if (timeline === null || seconds === null || pose === null) {
      for (const layer of this.layers) layer.show(null);
      return;
    }
    const { placement, tool } = timeline.toolpath;
    const offset = tools.offsets.get(tool[rowAt(timeline, seconds)] ?? 0) ?? NO_OFFSET;
    const here: Pose = { ...pose, x: pose.x - placement[0], y: pose.y - placement[1] };
    const { mark, blade } = this.colours;
    this.halo.show(headLines(here, offset, origin, 1 / scale, SHADOW, SHADOW));
    this.mark.show(headLines(here, offset, origin, 1 / scale, mark, blade));
  }

  dispose(): void {
    for (const layer of this.layers) layer.dispose();
  }
}
