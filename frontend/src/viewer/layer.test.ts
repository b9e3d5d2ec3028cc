import { InstancedBufferGeometry } from "three";
import { expect, test } from "vitest";
import type { Lines } from "../scene/lines";
import { LineLayer } from "./layer";

const linesOf = (count: number): Lines => {
  const lines = {
    count,
    ends: new Float32Array(4 * count),
    colour: new Uint8Array(4 * count),
    along: new Float32Array(count),
    dash: new Uint8Array(count),
    time: new Float32Array(2 * count),
    row: new Int32Array(count),
  };
  for (let at = 0; at < count; at++) {
    lines.ends.set([at, 1, 2, 3], 4 * at);
    lines.colour.set([at % 256, 7, 8, 9], 4 * at);
    lines.time.set([at, at + 0.5], 2 * at);
  }
  return lines;
};

const shown = (count: number, thin = false) => {
  const layer = new LineLayer(2, 1);
  layer.show(linesOf(count));
  layer.prepare(thin);
  return { layer, wide: layer.objects[0], narrow: layer.objects[1] };
};

test("few segments have four vertices each, with the values of their segment", () => {
  const { wide } = shown(3);
  const { geometry } = wide;
  expect(geometry).not.toBeInstanceOf(InstancedBufferGeometry);
  expect(Array.from(geometry.getIndex()?.array ?? []).slice(6, 12)).toEqual([4, 5, 6, 4, 6, 7]);
  const ends = geometry.getAttribute("ends");
  expect(ends.count).toBe(12);
  for (const at of [4, 5, 6, 7]) {
    expect([ends.getX(at), ends.getY(at), ends.getZ(at), ends.getW(at)]).toEqual([1, 1, 2, 3]);
    expect(geometry.getAttribute("colour").array[4 * at]).toBe(1);
    expect(geometry.getAttribute("time").getY(at)).toBe(1.5);
  }
  expect([4, 5, 6, 7].map((at) => geometry.getAttribute("corner").getX(at))).toEqual([0, 1, 1, 0]);
});

test("many segments are instances, and other lines replace them", () => {
  const { layer, wide } = shown(20_001);
  expect(wide.geometry).toBeInstanceOf(InstancedBufferGeometry);
  layer.show(linesOf(2));
  layer.prepare(false);
  expect(wide.geometry.getAttribute("ends").count).toBe(8);
  layer.show(null);
  layer.prepare(false);
  expect(wide.visible).toBe(false);
});

test("a thin layer has no wide geometry", () => {
  const { wide, narrow } = shown(501, true);
  expect([wide.visible, narrow.visible]).toEqual([false, true]);
  expect(Object.keys(wide.geometry.attributes)).toEqual([]);
});
