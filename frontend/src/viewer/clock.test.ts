import { expect, test } from "vitest";
import { HeadClock } from "./clock";

const running = () => {
  const clock = new HeadClock();
  clock.put(10);
  clock.send(20, 1000, 0);
  return clock;
};

test("the head travels evenly, and stays where it was sent", () => {
  const clock = running();
  expect([0, 250, 1000, 5000].map((now) => clock.at(now))).toEqual([10, 12.5, 20, 20]);
  clock.tick(1000);
  expect(clock.running).toBe(false);
  expect(clock.at(9000)).toBe(20);
});

test("a report a little behind is no way back; one far behind is another place", () => {
  const clock = running();
  clock.send(14, 1000, 500); // it is at 15 by then
  expect(clock.at(1000)).toBe(20);
  clock.send(3, 1000, 500);
  expect(clock.at(500)).toBe(3);
  expect(clock.running).toBe(false);
});
