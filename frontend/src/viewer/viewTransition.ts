/** The view on its way from one place to another. */

import type { Point } from "../geometry/records";
import type { PlaneCamera } from "./camera";

interface View {
  readonly centre: Point;
  readonly scale: number;
}

const LASTS = 260; // ms

export class ViewTransition {
  private way: { from: View; to: View; began: number } | null = null;

  constructor(private readonly camera: PlaneCamera) {}

  get gliding(): boolean {
    return this.way !== null;
  }

  stop(): void {
    this.way = null;
  }

  /** Go there; at once where the user wants nothing to move. */
  to(view: View, gently: boolean, now: number): void {
    const still = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
    const { camera } = this;
    if (gently && !still) {
      this.way = { from: { centre: camera.centre, scale: camera.scale }, to: view, began: now };
      return;
    }
    this.way = null;
    camera.centre = view.centre;
    camera.scale = view.scale;
  }

  tick(now: number): void {
    if (this.way === null) return;
    const { from, to, began } = this.way;
    const t = Math.min(1, Math.max(0, (now - began) / LASTS));
    const eased = 1 - (1 - t) ** 3;
    this.camera.scale = from.scale * (to.scale / from.scale) ** eased;
    this.camera.centre = {
      x: from.centre.x + (to.centre.x - from.centre.x) * eased,
      y: from.centre.y + (to.centre.y - from.centre.y) * eased,
    };
    if (t === 1) this.way = null;
  }
}
