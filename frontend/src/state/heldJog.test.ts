import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { HeldJog, type JogCommands } from "./heldJog";
import type { Outcome } from "./station";

const outcome = (state: Outcome["state"]): Outcome => ({ label: "X", state, text: "", hint: "" });

/** A machine that moves for one second after each move. */
function machine(answer: Outcome["state"] = "done", moves = Number.POSITIVE_INFINITY) {
  const log: string[] = [];
  let until = 0;
  const commands: JogCommands = {
    move: () => {
      if (moves-- <= 0) return null;
      log.push("move");
      until = Date.now() + 1000;
      return new Promise((resolve) => setTimeout(() => resolve(outcome(answer)), 100));
    },
    stop: async () => {
      log.push("stop");
      until = 0;
    },
    isAtRest: () => Date.now() >= until,
  };
  return { log, commands };
}

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

test("moves one short move after another until it is released", async () => {
  const { log, commands } = machine();
  const jog = new HeldJog(commands);
  const ended = jog.hold();
  await vi.advanceTimersByTimeAsync(2500);
  expect(log).toEqual(["move", "move", "move"]);
  jog.release();
  await vi.advanceTimersByTimeAsync(5000);
  await ended;
  expect(log).toEqual(["move", "move", "move", "stop"]);
});

test("a release while the move is on its way stops it again once it has arrived", async () => {
  const { log, commands } = machine();
  const jog = new HeldJog(commands);
  const ended = jog.hold();
  await vi.advanceTimersByTimeAsync(20);
  jog.release();
  await vi.advanceTimersByTimeAsync(500);
  await ended;
  expect(log).toEqual(["move", "stop", "stop"]);
});

test.each(["refused", "expired"] as const)("a move that is %s is not repeated", async (state) => {
  const { log, commands } = machine(state);
  const ended = new HeldJog(commands).hold();
  await vi.advanceTimersByTimeAsync(5000);
  await ended;
  expect(log).toEqual(["move"]);
});

test("the limit of the travel ends it", async () => {
  const { log, commands } = machine("done", 1);
  const jog = new HeldJog(commands);
  const ended = jog.hold();
  await vi.advanceTimersByTimeAsync(5000);
  await ended;
  jog.release();
  expect(log).toEqual(["move"]);
});
