/** Animated transition of the camera to another view. */

import type { Point } from "../geometry/records";
import type { PlaneCamera } from "./camera";

interface View {
  readonly centre: Point;
  readonly scale: number;
}

/** ms */
const DURATION = 260;

export class ViewTransition {
  private transition: { from: View; to: View; began: number } | null = null;

  constructor(private readonly camera: PlaneCamera) {}

  get active(): boolean {
    return this.transition !== null;
  }

  stop(): void {
    this.transition = null;
  }

  /** Move the camera to a view; without animation if the user prefers reduced motion. */
  start(view: View, animate: boolean, now: number): void {
    const reducedMotion = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
    const { camera } = this;
    if (animate && !reducedMotion) {
      this.transition = {
        from: { centre: camera.centre, scale: camera.scale },
        to: view,
        began: now,
      };
      return;
    }
    this.transition = null;
    camera.centre = view.centre;
    camera.scale = view.scale;
  }

  tick(now: number): void {
    if (this.transition === null) return;
    const { from, to, began } = this.transition;
    const t = Math.min(1, Math.max(0, (now - began) / DURATION));
    const eased = 1 - (1 - t) ** 3;
    this.camera.scale = from.scale * (to.scale / from.scale) ** eased;
    this.camera.centre = {
      x: from.centre.x + (to.centre.x - from.centre.x) * eased,
      y: from.centre.y + (to.centre.y - from.centre.y) * eased,
    };
    if (t === 1) this.transition = null;
  }
}
