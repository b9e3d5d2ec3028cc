import { expect, test } from "vitest";
import { Detail } from "./detail";

const MANY = 100_000;

test("few lines always have a width", () => {
  const detail = new Detail();
  expect(detail.isThin(100)).toBe(false);
  expect(detail.learn(100, 1000)).toBe(false);
  expect(detail.isThin(100)).toBe(false);
});

test("many lines get their width after a quick frame", () => {
  const detail = new Detail();
  expect(detail.isThin(MANY)).toBe(true);
  expect(detail.learn(MANY, 200)).toBe(false);
  expect(detail.isThin(MANY)).toBe(true);
  expect(detail.learn(MANY, 17)).toBe(true);
  expect(detail.isThin(MANY)).toBe(false);
});

test("two slow frames in succession make them thin for good", () => {
  const detail = new Detail();
  detail.learn(MANY, 17);
  detail.learn(MANY, 500);
  detail.learn(MANY, 17);
  expect(detail.learn(MANY, 500)).toBe(false);
  expect(detail.learn(MANY, 500)).toBe(true);
  expect(detail.learn(MANY, 17)).toBe(false);
  expect(detail.isThin(MANY)).toBe(true);
  detail.reset();
  expect(detail.learn(MANY, 17)).toBe(true);
});
