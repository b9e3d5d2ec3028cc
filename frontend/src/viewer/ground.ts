/** The area of a table that is turned against the drawing, as two triangles below everything. */

import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshBasicMaterial } from "three";
import type { Point } from "../geometry/records";

export class GroundLayer {
  readonly mesh: Mesh<BufferGeometry, MeshBasicMaterial>;

  /** A larger `order` lies above. */
  constructor(colour: string, order: number) {
    const material = new MeshBasicMaterial({
      color: colour,
      side: DoubleSide,
      // As all layers: drawn in the order of layers.
      transparent: true,
      depthTest: false,
      depthWrite: false,
    });
    this.mesh = new Mesh(new BufferGeometry(), material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = order;
    this.mesh.visible = false;
  }

  /** Show a rectangle by its four corners; null hides it. */
  show(corners: readonly Point[] | null, origin: Point): void {
    this.mesh.geometry.dispose();
    this.mesh.geometry = new BufferGeometry();
    this.mesh.visible = corners !== null;
    if (corners === null) return;
    const places = corners.flatMap(({ x, y }) => [x - origin.x, y - origin.y, 0]);
    this.mesh.geometry.setAttribute("position", new BufferAttribute(Float32Array.from(places), 3));
    this.mesh.geometry.setIndex([0, 1, 2, 0, 2, 3]);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
