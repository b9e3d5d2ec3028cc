/**
 * WebGL layer of lines: one quad per segment, with a width in screen pixels.
 *
 * The fragment shader computes the distance to the segment, so that edges and round caps are
 * smooth without multisampling; dashes are measured along the line. Many lines can be drawn thin
 * instead: as solid lines of the graphics card, which cost a fraction.
 */

import {
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  GLSL3,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  LineSegments,
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

const THIN_VERTEX = /* glsl */ `
precision highp float;
uniform mat4 projectionMatrix;
uniform mat4 modelViewMatrix;
uniform float now;
uniform vec4 done;
uniform vec3 ground;
uniform float strength;
in vec2 place;
in vec4 colour;
in float time;
flat out vec4 ink;

void main() {
  vec4 hue = time <= now ? done : colour;
  ink = vec4(mix(ground, hue.rgb, strength), hue.a);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(place, 0.0, 1.0);
}
`;

const THIN_FRAGMENT = /* glsl */ `
precision mediump float;
flat in vec4 ink;
out vec4 paint;

void main() {
  paint = ink;
}
`;

/**
 * Up to this number of segments, each has four vertices of its own instead of one instance: drivers
 * without a graphics card set up every instance anew, which takes longer than to draw it.
 */
const MOST_REPEATED = 20_000;
/** Up to this number of segments, the lines of a layer always have a width. */
const FEW = 500;
const CORNERS = new Float32Array([0, -1, 1, -1, 1, 1, 0, 1]);
const TRIANGLES = [0, 1, 2, 0, 2, 3];

export class LineLayer {
  readonly objects: readonly [
    Mesh<BufferGeometry, RawShaderMaterial>,
    LineSegments<BufferGeometry, RawShaderMaterial>,
  ];
  visible = true;
  private readonly always: boolean;
  private lines: Lines | null = null;
  private width: number;
  private ratio = 1;
  private readonly uniforms = {
    viewport: { value: new Vector2(1, 1) },
    width: { value: 1 },
    ratio: { value: 1 },
    now: { value: -1 },
    done: { value: new Vector4(1, 1, 1, 1) },
    ground: { value: new Vector3(0, 0, 0) },
    strength: { value: 1 },
  };

  /** `width` in CSS pixels; "thin" for lines that are always thin. A larger `order` lies above. */
  constructor(width: number | "thin", order: number) {
    this.always = width === "thin";
    this.width = width === "thin" ? 1 : width;
    this.uniforms.width.value = this.width;
    const material = (vertexShader: string, fragmentShader: string) =>
      new RawShaderMaterial({
        glslVersion: GLSL3,
        vertexShader,
        fragmentShader,
        transparent: true,
        depthTest: false,
        depthWrite: false,
        uniforms: this.uniforms,
      });
    this.objects = [
      new Mesh(new BufferGeometry(), material(VERTEX, FRAGMENT)),
      new LineSegments(new BufferGeometry(), material(THIN_VERTEX, THIN_FRAGMENT)),
    ];
    for (const object of this.objects) object.frustumCulled = false;
    this.setOrder(order);
  }

  get count(): number {
    return this.visible ? (this.lines?.count ?? 0) : 0;
  }

  show(lines: Lines | null): void {
    if (lines === this.lines) return;
    this.lines = lines;
    this.clear();
  }

  setOrder(order: number): void {
    for (const object of this.objects) object.renderOrder = order;
  }

  /** Make ready for a frame; what a frame does not show is not sent to the graphics card. */
  prepare(thin: boolean): void {
    const { lines } = this;
    const [wide, narrow] = this.objects;
    const isThin = this.count > 0 && (this.always || (thin && this.count > FEW));
    wide.visible = this.count > 0 && !isThin;
    narrow.visible = isThin;
    if (lines === null) return;
    if (wide.visible && wide.geometry.getAttribute("ends") === undefined)
      wide.geometry = wideGeometry(lines);
    if (isThin && narrow.geometry.getAttribute("place") === undefined)
      fillThin(narrow.geometry, lines);
  }

  /** Lines before this time (s) are drawn in the colour `done`. */
  setDoneUntil(seconds: number, done: Rgba): void {
    this.uniforms.now.value = Math.min(seconds, NEVER / 2);
    this.uniforms.done.value.set(...done).divideScalar(255);
  }

  /** Set the width (pixels) and how much of its own colour a line keeps, mixed with `ground`. */
  setStyle(width: number, strength: number, ground: Rgba): void {
    this.width = width;
    this.uniforms.width.value = width * this.ratio;
    this.uniforms.strength.value = strength;
    const [red, green, blue] = ground;
    this.uniforms.ground.value.set(red, green, blue).divideScalar(255);
  }

  resize(width: number, height: number, ratio: number): void {
    this.uniforms.viewport.value.set(width * ratio, height * ratio);
    this.ratio = ratio;
    this.uniforms.width.value = this.width * ratio;
    this.uniforms.ratio.value = ratio;
  }

  dispose(): void {
    for (const { geometry, material } of this.objects) {
      geometry.dispose();
      material.dispose();
    }
  }

  private clear(): void {
    for (const object of this.objects) {
      if (Object.keys(object.geometry.attributes).length === 0) continue;
      object.geometry.dispose();
      object.geometry = new BufferGeometry();
    }
  }
}

function wideGeometry(lines: Lines): BufferGeometry {
  return lines.count <= MOST_REPEATED ? repeatedGeometry(lines) : instancedGeometry(lines);
}

/** Vertex attributes: values, count per segment, and whether bytes are normalised to 0 … 1. */
const attributesOf = ({ ends, colour, along, dash, time }: Lines) =>
  [
    ["ends", ends, 4, false],
    ["colour", colour, 4, true],
    ["along", along, 1, false],
    ["dash", Float32Array.from(dash), 1, false],
    ["time", time, 2, false],
  ] as const;

function instancedGeometry(lines: Lines): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute("corner", new BufferAttribute(CORNERS, 2));
  geometry.setIndex(TRIANGLES);
  for (const [name, values, size, normalised] of attributesOf(lines)) {
    const attribute = new InstancedBufferAttribute(values, size, normalised);
    attribute.setUsage(DynamicDrawUsage);
    geometry.setAttribute(name, attribute);
  }
  geometry.instanceCount = lines.count;
  return geometry;
}

function repeatedGeometry(lines: Lines): BufferGeometry {
  const { count } = lines;
  const geometry = new BufferGeometry();
  const corners = new Float32Array(8 * count);
  const triangles = new Uint32Array(6 * count);
  for (let at = 0; at < count; at++) {
    corners.set(CORNERS, 8 * at);
    for (let one = 0; one < 6; one++) triangles[6 * at + one] = 4 * at + (TRIANGLES[one] as number);
  }
  geometry.setAttribute("corner", new BufferAttribute(corners, 2));
  geometry.setIndex(new BufferAttribute(triangles, 1));
  for (const [name, values, size, normalised] of attributesOf(lines))
    geometry.setAttribute(
      name,
      new BufferAttribute(repeated(values, size, count), size, normalised),
    );
  return geometry;
}

/** The values of each segment four times in succession. */
function repeated(values: Float32Array | Uint8Array, size: number, count: number) {
  const all =
    values instanceof Uint8Array
      ? new Uint8Array(4 * size * count)
      : new Float32Array(4 * size * count);
  for (let at = 0; at < 4 * count; at++)
    for (let one = 0; one < size; one++)
      all[at * size + one] = values[(at >> 2) * size + one] as number;
  return all;
}

/** Both ends of a segment are vertices; each needs the colour. */
function fillThin(geometry: BufferGeometry, { count, ends, colour, time }: Lines): void {
  const single = new Uint32Array(colour.buffer, colour.byteOffset, count);
  const twice = new Uint32Array(2 * count);
  for (let at = 0; at < count; at++) {
    twice[2 * at] = single[at] as number;
    twice[2 * at + 1] = single[at] as number;
  }
  geometry.setAttribute("place", new BufferAttribute(ends, 2));
  geometry.setAttribute("colour", new BufferAttribute(new Uint8Array(twice.buffer), 4, true));
  geometry.setAttribute("time", new BufferAttribute(time, 1));
  // Without an attribute `position`, three.js cannot count the vertices.
  geometry.setDrawRange(0, 2 * count);
}
