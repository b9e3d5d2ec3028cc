import { expect, test } from "vitest";
import { HeadClock } from "./clock";

const running = () => {
  const clock = new HeadClock();
  clock.set(10);
  clock.travelTo(20, 1000, 0);
  return clock;
};

test("the head travels evenly, and stays where it was sent", () => {
  const clock = running();
  expect([0, 250, 1000, 5000].map((now) => clock.timeAt(now))).toEqual([10, 12.5, 20, 20]);
  clock.tick(1000);
  expect(clock.running).toBe(false);
  expect(clock.timeAt(9000)).toBe(20);
});

test("a report slightly behind is ignored; one far behind is jumped to", () => {
  const clock = running();
  clock.travelTo(14, 1000, 500); // it is at 15 by then
  expect(clock.timeAt(1000)).toBe(20);
  clock.travelTo(3, 1000, 500);
  expect(clock.timeAt(500)).toBe(3);
  expect(clock.running).toBe(false);
});
