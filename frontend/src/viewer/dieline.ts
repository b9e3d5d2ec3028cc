/** Layers of the edges: drawing, selection, hover and previews of line types. */

import type { DrawnEdges, LineType, Point, Segments } from "../geometry/records";
import {
  type DielineStyle,
  dielineLines,
  highlightLines,
  retypePreviewLines,
} from "../scene/dieline";
import type { ViewerColours } from "./contract";
import { LineLayer } from "./layer";
import { ORDER } from "./order";

export interface EdgePreview {
  readonly rows: readonly number[];
  readonly type: LineType;
}

export class DielineLayers {
  /** Whether the edges are coloured by a figure. */
  showsFigures = false;

  private readonly nominal = new LineLayer(1.75, ORDER.nominal);
  private readonly chosen = new LineLayer(10, ORDER.chosen);
  private readonly retypePreviews = new LineLayer(9, ORDER.retypePreviews);
  private readonly hovered = new LineLayer(3.5, ORDER.hovered);
  readonly layers = [this.nominal, this.chosen, this.retypePreviews, this.hovered];

  constructor(private readonly colours: ViewerColours) {}

  show(edges: DrawnEdges | null, origin: Point, looks: DielineStyle): void {
    const { palette } = this.colours;
    this.nominal.show(edges === null ? null : dielineLines(edges, origin, palette, looks));
    this.showsFigures = (looks.colours ?? null) !== null;
  }

  select(edges: DrawnEdges | null, origin: Point, rows: ReadonlySet<number>): void {
    const { chosen } = this.colours;
    this.chosen.show(edges === null ? null : highlightLines(edges, origin, rows, chosen));
  }

  /** Show edges in the line types that they would get. */
  preview(edges: DrawnEdges | null, origin: Point, retypePreviews: readonly EdgePreview[]): void {
    const none = edges === null || retypePreviews.length === 0;
    this.retypePreviews.show(
      none ? null : retypePreviewLines(edges, origin, retypePreviews, this.colours.palette),
    );
  }

  /** Highlight edges or moves. */
  highlight(segments: Segments | null, origin: Point, rows: Iterable<number>): void {
    const { hover } = this.colours;
    this.hovered.show(segments === null ? null : highlightLines(segments, origin, rows, hover));
  }

  /** `under`: a tool path is drawn above the edges. */
  draw(visible: boolean, under: boolean): void {
    const { ground } = this.colours;
    this.nominal.visible = visible;
    // Tool path and edge may coincide: a wider and fainter edge stays visible on both sides.
    if (this.showsFigures) this.nominal.setStyle(4, 1, ground);
    else if (under) this.nominal.setStyle(4.5, 0.75, ground);
    else this.nominal.setStyle(1.75, 1, ground);
    this.nominal.setOrder(this.showsFigures ? ORDER.map : ORDER.nominal);
  }

  dispose(): void {
    for (const layer of this.layers) layer.dispose();
  }
}
