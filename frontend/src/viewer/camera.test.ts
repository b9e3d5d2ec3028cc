import { expect, test } from "vitest";
import { PlaneCamera } from "./camera";

const camera = () => {
  const made = new PlaneCamera();
  made.resize(800, 600);
  made.centre = { x: 100, y: 50 };
  made.scale = 2;
  return made;
};

test("the middle of the screen is the middle of the view, up is up", () => {
  expect(camera().toPlane({ x: 400, y: 300 })).toEqual({ x: 100, y: 50 });
  expect(camera().toPlane({ x: 400, y: 200 })).toEqual({ x: 100, y: 100 });
  expect(camera().toScreen({ x: 110, y: 50 })).toEqual({ x: 420, y: 300 });
});

test("zooming keeps the millimetre under the cursor", () => {
  const made = camera();
  const cursor = { x: 123, y: 456 };
  const before = made.toPlane(cursor);
  made.zoom(3.7, cursor);
  expect(made.toPlane(cursor).x).toBeCloseTo(before.x, 9);
  expect(made.toPlane(cursor).y).toBeCloseTo(before.y, 9);
  expect(made.scale).toBeCloseTo(7.4, 9);
});

test("panning keeps the grabbed point under the cursor", () => {
  const made = camera();
  const before = made.toPlane({ x: 10, y: 10 });
  made.pan(30, -20);
  expect(made.toPlane({ x: 40, y: -10 })).toEqual(before);
});

test("a box is framed between the insets", () => {
  const made = camera();
  const { centre, scale } = made.frameBox([0, 0, 100, 100], {
    left: 100,
    top: 0,
    right: 0,
    bottom: 100,
  });
  made.centre = centre;
  made.scale = scale;
  // 700 × 500 are free, so the square is 500 pixels high and starts at the top.
  expect(scale).toBe(5);
  expect(made.toScreen({ x: 50, y: 100 })).toEqual({ x: 450, y: 0 });
  expect(made.toScreen({ x: 50, y: 0 })).toEqual({ x: 450, y: 500 });
});

test("a box without extent does not zoom to infinity", () => {
  const insets = { left: 0, top: 0, right: 0, bottom: 0 };
  expect(Number.isFinite(camera().frameBox([5, 5, 5, 5], insets).scale)).toBe(true);
});
