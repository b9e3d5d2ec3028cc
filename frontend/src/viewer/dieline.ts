/** The edges of the drawing, and what is said of them: chosen, pointed at, or about to change. */

import type { Edges, LineType, Point, Segments } from "../geometry/records";
import {
  type DielineStyle,
  dielineLines,
  highlightLines,
  retypePreviewLines,
} from "../scene/dieline";
import type { ViewerColours } from "./contract";
import { LineLayer } from "./layer";
import { ORDER } from "./order";

export interface Proposal {
  readonly rows: readonly number[];
  readonly type: LineType;
}

export class DielineLayers {
  /** Whether the colours of the edges are figures. */
  mapped = false;

  private readonly nominal = new LineLayer(1.75, ORDER.nominal);
  private readonly chosen = new LineLayer(10, ORDER.chosen);
  private readonly retypePreviews = new LineLayer(9, ORDER.retypePreviews);
  private readonly hovered = new LineLayer(3.5, ORDER.hovered);
  readonly layers = [this.nominal, this.chosen, this.retypePreviews, this.hovered];

  constructor(private readonly colours: ViewerColours) {}

  show(edges: Edges | null, origin: Point, looks: DielineStyle): void {
    const { palette } = this.colours;
    this.nominal.show(edges === null ? null : dielineLines(edges, origin, palette, looks));
    this.mapped = (looks.colours ?? null) !== null;
  }

  choose(edges: Edges | null, origin: Point, rows: ReadonlySet<number>): void {
    const { chosen } = this.colours;
    this.chosen.show(edges === null ? null : highlightLines(edges, origin, rows, chosen));
  }

  /** Lay under edges the colours of what they would become. */
  propose(edges: Edges | null, origin: Point, retypePreviews: readonly Proposal[]): void {
    const none = edges === null || retypePreviews.length === 0;
    this.retypePreviews.show(
      none ? null : retypePreviewLines(edges, origin, retypePreviews, this.colours.palette),
    );
  }

  /** Light edges, or moves of the head. */
  light(segments: Segments | null, origin: Point, rows: Iterable<number>): void {
    const { hover } = this.colours;
    this.hovered.show(segments === null ? null : highlightLines(segments, origin, rows, hover));
  }

  /** `under`: a path of the tool lies upon the edges. */
  draw(visible: boolean, under: boolean): void {
    const { ground } = this.colours;
    this.nominal.mesh.visible = visible;
    // Where the tool turns about its tip both paths are one: the nominal line becomes the wider
    // and fainter, so that it is seen on either side of the other.
    if (this.mapped) this.nominal.look(4, 1, ground);
    else if (under) this.nominal.look(4.5, 0.75, ground);
    else this.nominal.look(1.75, 1, ground);
    this.nominal.mesh.renderOrder = this.mapped ? ORDER.map : ORDER.nominal;
  }

  dispose(): void {
    for (const layer of this.layers) layer.dispose();
  }
}
