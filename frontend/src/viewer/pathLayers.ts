/** Layers of the head path, the tip path, swept areas and unreachable areas. */

import type { Areas, Point } from "../geometry/records";
import type { Timeline } from "../geometry/timeline";
import { areaShapes } from "../scene/areas";
import { MARKED, type Marked, motionMarks } from "../scene/marks";
import { pathLines } from "../scene/pathLines";
import { sweptShapes, type Tools } from "../scene/swept";
import { BandLayer } from "./bands";
import type { ViewerColours, VisibleLayers } from "./contract";
import { LineLayer } from "./layer";
import { ORDER } from "./order";

/** Diameter of the dots that mark plunges, lifts and swivels (pixels) … */
const MARKS: Readonly<Record<Marked, number>> = { lift: 10, swivel: 7, plunge: 4 };
/** … at this scale and above (pixels per mm); below it, dots shrink to this fraction. */
const FULL_MARKS = 2;
const LEAST_MARKS = 0.4;

export class PathLayers {
  private readonly bands = new BandLayer(ORDER.bands);
  private readonly rims = new LineLayer(1.25, ORDER.rims);
  private readonly uncut = new BandLayer(ORDER.uncut);
  private readonly uncutRims = new LineLayer(1.5, ORDER.uncutRims);
  private readonly rapids = new LineLayer(1, ORDER.rapids);
  private readonly head = new LineLayer(1.6, ORDER.head);
  private readonly tip = new LineLayer(1, ORDER.tip);
  private readonly motions: Readonly<Record<Marked, LineLayer>> = {
    lift: new LineLayer(MARKS.lift, ORDER.lift),
    swivel: new LineLayer(MARKS.swivel, ORDER.swivel),
    plunge: new LineLayer(MARKS.plunge, ORDER.plunge),
  };
  readonly areas = [this.bands, this.uncut];
  readonly layers = [
    this.rims,
    this.uncutRims,
    this.rapids,
    this.head,
    this.tip,
    ...Object.values(this.motions),
  ];

  private timeline: Timeline | null = null;
  private hasAreas = false;
  /** Swept areas are expensive and built on first use. */
  private sweptBuilt = false;

  constructor(private readonly colours: ViewerColours) {}

  setTimeline(timeline: Timeline | null, tools: Tools, origin: Point): void {
    const { colours } = this;
    this.timeline = timeline;
    const lines = timeline === null ? null : pathLines(timeline, origin, colours, tools.offsets);
    this.head.show(lines?.head ?? null);
    this.tip.show(lines?.tip ?? null);
    this.rapids.show(lines?.rapids ?? null);
    const dots = timeline === null ? null : motionMarks(timeline.toolpath, origin, colours.marks);
    for (const word of MARKED) this.motions[word].show(dots?.[word] ?? null);
    this.sweptBuilt = false;
  }

  setAreas(areas: Areas | null, origin: Point): void {
    const { uncut, uncutRim } = this.colours;
    const shapes = areas === null ? null : areaShapes(areas, origin, uncut, uncutRim);
    this.uncut.show(shapes?.bands ?? null);
    this.uncutRims.show(shapes?.rims ?? null);
    this.hasAreas = areas !== null;
  }

  buildSwept(tools: Tools, origin: Point): void {
    if (this.sweptBuilt) return;
    this.sweptBuilt = true;
    const { timeline, colours } = this;
    const swept =
      timeline === null ? null : sweptShapes(timeline.toolpath, origin, tools, colours.swept);
    this.bands.show(swept?.bands ?? null);
    this.rims.show(swept?.rims ?? null);
  }

  /** Moves before `seconds` are drawn as done; `mapped` draws the paths faint. */
  draw(shown: VisibleLayers, scale: number, seconds: number | null, mapped: boolean): void {
    const has = this.timeline !== null;
    const { ground, done } = this.colours;
    this.head.setStyle(1.6, mapped ? 0.5 : 1, ground);
    this.tip.setStyle(1, mapped ? 0.4 : 1, ground);
    this.head.visible = shown.head && has;
    this.tip.visible = shown.tip && has;
    this.rapids.visible = shown.rapids && has;
    this.bands.mesh.visible = shown.swept && has;
    this.rims.visible = shown.swept && has;
    this.uncut.mesh.visible = shown.uncut && this.hasAreas;
    this.uncutRims.visible = shown.uncut && this.hasAreas;
    const near = Math.min(1, Math.max(LEAST_MARKS, scale / FULL_MARKS));
    for (const word of MARKED) {
      this.motions[word].visible = shown.moves && has;
      this.motions[word].setStyle(MARKS[word] * near, 1, ground);
    }
    for (const layer of [this.head, this.tip]) layer.setDoneUntil(seconds ?? -1, done);
  }

  dispose(): void {
    for (const layer of [...this.layers, ...this.areas]) layer.dispose();
  }
}
