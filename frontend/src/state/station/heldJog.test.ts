import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { HeldJog, type JogCommands } from "./heldJog";

/** Commands that take 100 ms, and what was sent. */
function machine(id: string | null = "jog", renewals = Number.POSITIVE_INFINITY) {
  const log: string[] = [];
  const later = <T>(value: T): Promise<T> =>
    new Promise((resolve) => setTimeout(() => resolve(value), 100));
  const commands: JogCommands = {
    begin: () => {
      log.push("begin");
      return later(id);
    },
    renew: (of) => {
      log.push(`renew ${of}`);
      return later(renewals-- > 0);
    },
    stop: async () => {
      log.push("stop");
    },
  };
  return { log, commands };
}

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

test("states every 300 ms that the button is held, until it is released", async () => {
  const { log, commands } = machine();
  const jog = new HeldJog(commands);
  const ended = jog.hold();
  await vi.advanceTimersByTimeAsync(1050);
  expect(log).toEqual(["begin", "renew jog", "renew jog", "renew jog"]);
  jog.release();
  await vi.advanceTimersByTimeAsync(5000);
  await ended;
  expect(log).toEqual(["begin", "renew jog", "renew jog", "renew jog", "stop"]);
});

test("a release while the move is on its way stops it again once it has arrived", async () => {
  const { log, commands } = machine();
  const jog = new HeldJog(commands);
  const ended = jog.hold();
  await vi.advanceTimersByTimeAsync(20);
  jog.release();
  await vi.advanceTimersByTimeAsync(500);
  await ended;
  expect(log).toEqual(["begin", "stop", "stop"]);
});

test("a move that is refused is not held", async () => {
  const { log, commands } = machine(null);
  const jog = new HeldJog(commands);
  const ended = jog.hold();
  await vi.advanceTimersByTimeAsync(5000);
  await ended;
  jog.release();
  expect(log).toEqual(["begin"]);
});

test("a move that has ended is not renewed any more", async () => {
  const { log, commands } = machine("jog", 1);
  const ended = new HeldJog(commands).hold();
  await vi.advanceTimersByTimeAsync(5000);
  await ended;
  expect(log).toEqual(["begin", "renew jog", "renew jog"]);
});
