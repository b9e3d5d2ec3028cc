/** WebGL layer of translucent areas; overlapping triangles do not add up. */

import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  GLSL3,
  LessDepth,
  Mesh,
  RawShaderMaterial,
} from "three";
import type { Bands } from "../scene/swept";

const VERTEX = /* glsl */ `
precision highp float;
uniform mat4 projectionMatrix;
uniform mat4 modelViewMatrix;
in vec2 corner;
in vec4 colour;
flat out vec4 ink;

void main() {
  ink = colour;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(corner, 0.0, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
flat in vec4 ink;
out vec4 paint;

void main() {
  paint = ink;
}
`;

export class BandLayer {
  readonly mesh: Mesh<BufferGeometry, RawShaderMaterial>;

  /** A larger `order` lies above. */
  constructor(order: number) {
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      transparent: true,
      side: DoubleSide,
      forceSinglePass: true,
      // All triangles have the same depth: LessDepth draws each pixel only once.
      depthTest: true,
      depthWrite: true,
      depthFunc: LessDepth,
    });
    this.mesh = new Mesh(new BufferGeometry(), material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = order;
    this.mesh.visible = false;
  }

  show(bands: Bands | null): void {
    this.mesh.geometry.dispose();
    this.mesh.geometry = new BufferGeometry();
    if (bands === null) return;
    this.mesh.geometry.setAttribute("corner", new BufferAttribute(bands.corners, 2));
    this.mesh.geometry.setAttribute("colour", new BufferAttribute(bands.colour, 4, true));
    // Without an attribute `position`, three.js cannot count the vertices.
    this.mesh.geometry.setDrawRange(0, bands.count * 3);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
