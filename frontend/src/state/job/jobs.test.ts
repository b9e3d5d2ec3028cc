import { describe, expect, it } from "vitest";
import type { Job } from "../../api/jobs";
import {
  awaitsEnd,
  commandsOf,
  confirmationBefore,
  needsOperator,
  stateStyleOf,
  waitsAtMachine,
} from "./jobs";

const job = (change: Partial<Job>): Job =>
  ({ state: "ready", waiting_for: "", line: 0, lines: 100, copies: 1, ...change }) as Job;

describe("what the operator is offered", () => {
  it("is what the server allows", () => {
    expect(commandsOf(job({ actions: ["hold", "cancel"] }))).toEqual(["hold", "cancel"]);
    expect(commandsOf(job({ state: "interrupted", actions: ["finish", "scrap"] }))).toEqual([
      "finish",
      "scrap",
    ]);
    expect(
      commandsOf(job({ waiting_for: "compile", actions: ["release", "recompile", "cancel"] })),
    ).toEqual(["recompile", "cancel"]);
    expect(commandsOf(job({ actions: ["release", "recompile"] }))).toEqual(["release"]);
    expect(commandsOf(job({ actions: [] }))).toEqual([]);
  });

  it("is nothing that starts or continues the machine", () => {
    const waiting = job({
      state: "queued",
      waiting_for: "confirmation",
      actions: ["confirm", "cancel"],
    });
    expect(needsOperator(waiting)).toBe(true);
    expect(commandsOf(waiting)).toEqual(["cancel"]);
    const held = job({ state: "held", actions: ["confirm", "resume", "end", "cancel"] });
    expect(commandsOf(held)).toEqual(["cancel"]);
    expect(waitsAtMachine({ ...held, requested_action: "" })).toBe(true);
    expect(waitsAtMachine({ ...held, requested_action: "resume" })).toBe(false);
    expect(needsOperator(job({ state: "queued", waiting_for: "turn" }))).toBe(false);
  });

  it("names what is waited for instead of the state", () => {
    expect(stateStyleOf(job({ state: "queued", waiting_for: "confirmation" })).title).toBe(
      "Waiting for operator",
    );
    expect(stateStyleOf(job({ state: "held", waiting_for: "sheet" })).title).toBe(
      "Waiting for new sheet",
    );
    expect(stateStyleOf(job({ state: "queued", waiting_for: "turn" })).title).toBe("Queued");
  });
});

describe("what is asked before it is sent", () => {
  it("states what a cancel does while the board is on the table, and only then", () => {
    for (const state of ["running", "held"] as const) {
      const ask = confirmationBefore(job({ state }), "cancel");
      expect(ask?.text).toContain("stops, lifts the tool and releases its stations");
      expect(ask?.text).toContain("probably unusable");
    }
    expect(confirmationBefore(job({ state: "queued" }), "cancel")).toBeNull();
  });

  it("asks before an interrupted job is scrapped or declared finished", () => {
    const interrupted = job({ state: "interrupted", copies: 3 });
    expect(confirmationBefore(interrupted, "scrap")?.text).toContain(
      "Copies that are not made can be queued afterwards.",
    );
    expect(confirmationBefore(interrupted, "finish")?.text).toContain(
      "only if all 3 sheets are completely cut",
    );
    expect(confirmationBefore(interrupted, "requeue")).toBeNull();
  });

  it("sends hold, resume and the end of a program at once", () => {
    for (const word of ["hold", "resume", "end"] as const) {
      expect(confirmationBefore(job({ state: "running" }), word)).toBeNull();
    }
  });
});

it("only a job whose machine reports nothing waits for a person to confirm its end", () => {
  const message = {
    code: "waiting.for-end",
    arguments: { machine: "Plotter" },
    text: "",
    hint: "",
  };
  const waiting = job({ state: "held", message } as Partial<Job>);
  expect(awaitsEnd(waiting)).toBe(true);
  expect(stateStyleOf(waiting).title).toBe("Has the machine finished?");
  expect(awaitsEnd(job({ state: "held" }))).toBe(false);
  expect(awaitsEnd(job({ state: "running", message } as Partial<Job>))).toBe(false);
});
