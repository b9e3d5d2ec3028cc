/**
 * WebGL layer of lines: one quad per segment, with a width in screen pixels.
 *
 * The fragment shader computes the distance to the segment, so that edges and round caps are
 * smooth without multisampling; dashes are measured along the line.
 */

import {
  BufferAttribute,
  DynamicDrawUsage,
  GLSL3,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  Mesh,
  RawShaderMaterial,
  Vector2,
  Vector3,
  Vector4,
} from "three";
import { type Lines, NEVER, type Rgba } from "../scene/lines";

const VERTEX = /* glsl */ `
precision highp float;
uniform mat4 projectionMatrix;
uniform mat4 modelViewMatrix;
uniform vec2 viewport;
uniform float width;
in vec2 corner;
in vec4 ends;
in vec4 colour;
in vec2 time;
in float along;
in float dash;
out vec2 across;
out float run;
out float first;
flat out vec4 ink;
flat out vec2 clock;
flat out float pattern;

void main() {
  vec4 a = projectionMatrix * modelViewMatrix * vec4(ends.xy, 0.0, 1.0);
  vec4 b = projectionMatrix * modelViewMatrix * vec4(ends.zw, 0.0, 1.0);
  vec2 from = a.xy * viewport * 0.5;
  vec2 to = b.xy * viewport * 0.5;
  vec2 way = to - from;
  run = length(way);
  vec2 ahead = run > 1e-6 ? way / run : vec2(1.0, 0.0);
  vec2 side = vec2(-ahead.y, ahead.x);
  float reach = width * 0.5 + 1.0;
  across = vec2(corner.x * run + (corner.x * 2.0 - 1.0) * reach, corner.y * reach);
  vec2 place = from + ahead * across.x + side * across.y;
  first = along * viewport.x * 0.5 * projectionMatrix[0][0];
  ink = colour;
  clock = time;
  pattern = dash;
  gl_Position = vec4(place / (viewport * 0.5), 0.0, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
uniform float width;
uniform float ratio;
uniform float now;
uniform vec4 done;
uniform vec3 ground;
uniform float strength;
in vec2 across;
in float run;
in float first;
flat in vec4 ink;
flat in vec2 clock;
flat in float pattern;
out vec4 paint;

void main() {
  float past = max(max(-across.x, across.x - run), 0.0);
  float away = length(vec2(past, across.y));
  float cover = clamp(width * 0.5 + 0.5 - away, 0.0, 1.0);
  if (pattern > 0.5) {
    vec2 beat = pattern < 1.5 ? vec2(9.0, 5.0) : pattern < 2.5 ? vec2(2.5, 4.0) : vec2(16.0, 5.0);
    beat *= ratio;
    float period = beat.x + beat.y;
    float at = mod(first + clamp(across.x, 0.0, run), period);
    float gap = min(at, beat.x - at);
    cover *= clamp(gap + 0.5, 0.0, 1.0);
  }
  float part = run > 0.0 ? clamp(across.x / run, 0.0, 1.0) : 1.0;
  float when = mix(clock.x, clock.y, part);
  vec4 hue = when <= now ? done : ink;
  float opacity = cover * hue.a;
  if (opacity < 0.004) discard;
  // Mixed with the ground instead of translucent: overlapping caps stay invisible.
  paint = vec4(mix(ground, hue.rgb, strength), opacity);
}
`;

const CORNERS = new Float32Array([0, -1, 1, -1, 1, 1, 0, 1]);
const TRIANGLES = [0, 1, 2, 0, 2, 3];

export class LineLayer {
  readonly mesh: Mesh<InstancedBufferGeometry, RawShaderMaterial>;
  private width: number;
  private ratio = 1;

  /** `width` in CSS pixels; a larger `order` lies above. */
  constructor(width: number, order: number) {
    this.width = width;
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      transparent: true,
      depthTest: false,
      depthWrite: false,
      uniforms: {
        viewport: { value: new Vector2(1, 1) },
        width: { value: width },
        ratio: { value: 1 },
        now: { value: -1 },
        done: { value: new Vector4(1, 1, 1, 1) },
        ground: { value: new Vector3(0, 0, 0) },
        strength: { value: 1 },
      },
    });
    this.mesh = new Mesh(emptyGeometry(), material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = order;
    this.mesh.visible = false;
  }

  show(lines: Lines | null): void {
    this.mesh.geometry.dispose();
    this.mesh.geometry = emptyGeometry();
    this.mesh.visible = lines !== null && lines.count > 0;
    if (lines === null || lines.count === 0) return;
    const setAttribute = (
      name: string,
      values: Float32Array | Uint8Array,
      size: number,
      normalised = false,
    ) => {
      const attribute = new InstancedBufferAttribute(values, size, normalised);
      attribute.setUsage(DynamicDrawUsage);
      this.mesh.geometry.setAttribute(name, attribute);
    };
    setAttribute("ends", lines.ends, 4);
    setAttribute("colour", lines.colour, 4, true);
    setAttribute("along", lines.along, 1);
    setAttribute("dash", Float32Array.from(lines.dash), 1);
    setAttribute("time", lines.time, 2);
    this.mesh.geometry.instanceCount = lines.count;
  }

  /** Lines before this time (s) are drawn in the colour `done`. */
  setDoneUntil(seconds: number, done: Rgba): void {
    this.uniform("now").value = Math.min(seconds, NEVER / 2);
    (this.uniform("done").value as Vector4).set(...done).divideScalar(255);
  }

  /** Set the width (pixels) and how much of its own colour a line keeps, mixed with `ground`. */
  setStyle(width: number, strength: number, ground: Rgba): void {
    this.width = width;
    this.uniform("width").value = width * this.ratio;
    this.uniform("strength").value = strength;
    const [red, green, blue] = ground;
    (this.uniform("ground").value as Vector3).set(red, green, blue).divideScalar(255);
  }

  resize(width: number, height: number, ratio: number): void {
    (this.uniform("viewport").value as Vector2).set(width * ratio, height * ratio);
    this.ratio = ratio;
    this.uniform("width").value = this.width * ratio;
    this.uniform("ratio").value = ratio;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }

  private uniform(name: string): { value: unknown } {
    const found = this.mesh.material.uniforms[name];
    if (found === undefined)
      throw new Error(`The drawing cannot be displayed (shader without ${name}). Reload the page.`);
    return found;
  }
}

function emptyGeometry(): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute("corner", new BufferAttribute(CORNERS, 2));
  geometry.setIndex(TRIANGLES);
  geometry.instanceCount = 0;
  return geometry;
}
