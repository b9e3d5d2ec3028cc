/** Orthographic view of the drawing plane: centre and scale. */

import { OrthographicCamera } from "three";
import type { Box, Point } from "../geometry/records";

const LEAST_SCALE = 0.02;
const MOST_SCALE = 20_000;

export interface Insets {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** Screen coordinates: CSS pixels from the upper left corner; plane: mm of the drawing. */
export class PlaneCamera {
  readonly three = new OrthographicCamera(-1, 1, 1, -1, -10, 10);
  width = 1;
  height = 1;
  /** pixels per mm */
  scale = 1;
  centre: Point = { x: 0, y: 0 };

  resize(width: number, height: number): void {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
  }

  toScreen({ x, y }: Point): Point {
    return {
      x: this.width / 2 + (x - this.centre.x) * this.scale,
      y: this.height / 2 - (y - this.centre.y) * this.scale,
    };
  }

  toPlane({ x, y }: Point): Point {
    return {
      x: this.centre.x + (x - this.width / 2) / this.scale,
      y: this.centre.y - (y - this.height / 2) / this.scale,
    };
  }

  /** Pan by pixels. */
  pan(dx: number, dy: number): void {
    this.centre = {
      x: this.centre.x - dx / this.scale,
      y: this.centre.y + dy / this.scale,
    };
  }

  /** Zoom about a pixel, which keeps its position in the plane. */
  zoom(factor: number, about: Point): void {
    const before = this.toPlane(about);
    this.scale = Math.min(MOST_SCALE, Math.max(LEAST_SCALE, this.scale * factor));
    const after = this.toPlane(about);
    this.centre = {
      x: this.centre.x + before.x - after.x,
      y: this.centre.y + before.y - after.y,
    };
  }

  /** Centre and scale with which a box fills the part of the canvas inside the insets. */
  frameBox(box: Box, insets: Insets): { centre: Point; scale: number } {
    const wide = Math.max(1, this.width - insets.left - insets.right);
    const tall = Math.max(1, this.height - insets.top - insets.bottom);
    const scale = Math.min(
      MOST_SCALE,
      Math.max(
        LEAST_SCALE,
        Math.min(wide / Math.max(1e-3, box[2] - box[0]), tall / Math.max(1e-3, box[3] - box[1])),
      ),
    );
    return {
      scale,
      centre: {
        x: (box[0] + box[2]) / 2 - (insets.left - insets.right) / 2 / scale,
        y: (box[1] + box[3]) / 2 + (insets.top - insets.bottom) / 2 / scale,
      },
    };
  }

  /** Visible part of the plane (mm). */
  visibleBox(): Box {
    const low = this.toPlane({ x: 0, y: this.height });
    const high = this.toPlane({ x: this.width, y: 0 });
    return [low.x, low.y, high.x, high.y];
  }

  /** Set the camera of three.js, relative to the origin of the scene. */
  apply(origin: Point): void {
    const half = { x: this.width / 2 / this.scale, y: this.height / 2 / this.scale };
    const { three } = this;
    three.left = -half.x;
    three.right = half.x;
    three.top = half.y;
    three.bottom = -half.y;
    three.position.set(this.centre.x - origin.x, this.centre.y - origin.y, 0);
    three.updateProjectionMatrix();
    three.updateMatrixWorld();
  }
}
