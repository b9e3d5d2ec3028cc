import { describe, expect, test } from "vitest";
import type { Job } from "../../api/jobs";
import type { Machine, Station } from "../../api/machines";
import {
  ageText,
  jogDistance,
  jogFeed,
  moves,
  overrideSteps,
  reasonAgainst,
  stopOf,
  titleOf,
  turnsTools,
} from "./station";

const axis = (low: number, high: number, velocity: number) => ({ low, high, velocity });
const MACHINE = {
  travel_z: 20,
  axes: {
    x: axis(0, 1000, 500),
    y: axis(-5, 800, 20),
    z: axis(-5, 60, 100),
    c: axis(-360, 360, 90),
  },
  carriages: [{ number: 1, letters: "XYZC", park: 0 }],
} as unknown as Machine;

const station = (part: Partial<Station>): Station => ({
  machine: "table",
  gateway: "gw",
  connected: true,
  state: "idle",
  alarm: null,
  obstacle: null,
  position: [10, 10, 20, 0],
  outputs: [],
  outputs_known: true,
  operations: ["unlock", "home", "jog", "stop_jog", "zero", "park", "switch"],
  spindle: null,
  override: null,
  activity: null,
  notices: [],
  job: "",
  seen_seconds_ago: 0.1,
  ...part,
});
const ALARM = { code: "stored.text", arguments: {}, text: "limit", hint: "" } as Station["alarm"];

const job = (part: Partial<Job>): Job =>
  ({
    id: "j",
    state: "running",
    actions: [],
    waiting_for: "",
    requested_action: "",
    ...part,
  }) as Job;

describe("title", () => {
  test("an alarm comes before the state of the job", () => {
    expect(titleOf(station({ alarm: ALARM }), job({})).title).toBe("Alarm");
  });
  test("a job on the table comes before the state of the controller", () => {
    expect(titleOf(station({ state: "run" }), job({ state: "held" })).title).toBe("Paused");
  });
  test("an open safety door comes before the job, which does not move", () => {
    expect(titleOf(station({ state: "door" }), job({})).title).toBe("Safety door open");
  });
  test("a finished job leaves the state of the controller", () => {
    expect(titleOf(station({ state: "jog" }), job({ state: "done" })).title).toBe("Moving by hand");
  });
  test("a job that is out of date asks for the person", () => {
    const outdated = job({ state: "queued", waiting_for: "compile" });
    expect(titleOf(station({}), outdated).title).toBe("Out of date");
  });
  test("a silent gateway is not at rest", () => {
    expect(titleOf(station({ gateway: "", state: "" }), undefined).title).toBe(
      "Machine not connected",
    );
  });
});

describe("a machine that is held without a job", () => {
  const obstacle = { ...ALARM, code: "obstacle.door-closed" } as Station["obstacle"];
  const held = (part: Partial<Station>) =>
    station({ state: "hold", operations: ["release", "jog", "home"], obstacle, ...part });
  test("is released, also between two copies", () => {
    expect(reasonAgainst("release", held({}), MACHINE, undefined)).toBeNull();
    const sheet = job({ state: "held", waiting_for: "sheet" });
    expect(reasonAgainst("release", held({}), MACHINE, sheet)).toBeNull();
    expect(reasonAgainst("release", held({}), MACHINE, job({ state: "held" }))).toContain("held");
    expect(reasonAgainst("jog", held({}), MACHINE, undefined, "Z")).toContain("Release it first");
  });
  test("is not released before its door is closed", () => {
    expect(reasonAgainst("release", held({ state: "door" }), MACHINE, undefined)).toContain("door");
  });
  test("holds nothing at rest", () => {
    const free = held({ state: "idle", obstacle: null });
    expect(reasonAgainst("release", free, MACHINE, undefined)).toBe("No program is on hold.");
  });
  test("names the age of an old report", () => {
    expect(ageText(station({}))).toBe("");
    expect(ageText(station({ seen_seconds_ago: 4.2 }))).toBe("4 s ago");
  });
});

describe("a run above the board", () => {
  const above = (state: "running" | "held" | "done") =>
    station({
      state: "run",
      operations: ["dry_run", "hold", "resume", "stop_jog", "jog"],
      activity: {
        kind: "dry_run",
        job: "j",
        state,
        line: 3,
        progress: 0.5,
        seconds_left: 4,
        position: null,
        station: null,
        message: null,
      },
    });
  const waits = job({ state: "queued", waiting_for: "confirmation", actions: ["cancel"] });

  test("is the title of the page while it lasts", () => {
    expect(titleOf(above("running"), waits).title).toBe("Dry run");
    expect(titleOf(above("held"), waits).title).toBe("Dry run paused");
    expect(titleOf(above("done"), waits).title).toBe("Waiting for operator");
  });
  test("is stopped without ending the job", () => {
    expect(stopOf(above("running"), waits)).toEqual({ act: "stop_jog", asks: false });
    expect(stopOf(above("done"), waits)?.act).toBe("cancel");
  });
  test("is held and resumed, and hinders everything else", () => {
    const reason = (word: "hold" | "resume" | "jog", state: "running" | "held") =>
      reasonAgainst(word, above(state), MACHINE, waits);
    expect([reason("hold", "running"), reason("resume", "running")]).toEqual([
      null,
      "No program is on hold.",
    ]);
    expect([reason("hold", "held"), reason("resume", "held")]).toEqual(["No program runs.", null]);
    expect(reason("jog", "running")).toContain("above the board");
  });
});

describe("stop", () => {
  test("a running job is stopped at once", () => {
    expect(stopOf(station({ state: "run" }), job({ actions: ["cancel"] }))).toEqual({
      act: "cancel",
      asks: false,
    });
  });
  test.each(["held", "queued"] as const)("a job that is %s and at rest is asked about", (state) => {
    const waiting = job({ state, actions: ["cancel"], waiting_for: "confirmation" });
    expect(stopOf(station({}), waiting)).toEqual({ act: "cancel", asks: true });
  });
  test("a held job is stopped at once while the machine still moves", () => {
    const held = job({ state: "held", actions: ["cancel"] });
    expect(stopOf(station({ state: "run" }), held)?.asks).toBe(false);
    expect(stopOf(station({}), { ...held, requested_action: "resume" })?.asks).toBe(false);
  });
  test("a jog and a homing cycle are stopped, and a machine at rest is not", () => {
    const stop = { act: "stop_jog", asks: false };
    expect(stopOf(station({ state: "jog" }), undefined)).toEqual(stop);
    expect(stopOf(station({ state: "home" }), undefined)).toEqual(stop);
    expect(stopOf(station({}), undefined)).toBeNull();
  });
  test.each(["jog", "home"] as const)("a machine in state %s stops, its job waits", (state) => {
    const waiting = job({ state: "queued", actions: ["cancel"], waiting_for: "confirmation" });
    expect(stopOf(station({ state }), waiting)).toEqual({ act: "stop_jog", asks: false });
    expect(stopOf(station({ state }), job({ actions: ["cancel"] }))?.act).toBe("cancel");
  });
  test("a job between two sheets does not move", () => {
    expect(moves(station({}), job({ waiting_for: "sheet" }))).toBe(false);
  });
});

describe("reason against an operation", () => {
  const why = (part: Partial<Station>, operation: Parameters<typeof reasonAgainst>[0]) =>
    reasonAgainst(operation, station(part), MACHINE, undefined);

  test("none at rest", () => {
    expect(why({}, "jog")).toBeNull();
    expect(why({}, "park")).toBeNull();
  });
  test("a job runs or is held", () => {
    expect(reasonAgainst("home", station({}), MACHINE, job({}))).toMatch(/A job runs/);
    expect(reasonAgainst("home", station({}), MACHINE, job({ state: "held" }))).toMatch(/is held/);
  });
  test("an alarm between two copies: the job cannot be resumed, so it must be stopped", () => {
    const alarm = station({ alarm: ALARM, state: "alarm" });
    const reason = reasonAgainst("unlock", alarm, MACHINE, job({ state: "held" }));
    expect(reason).toBe("A job is on this machine. Stop it first.");
  });
  test("an alarm leaves homing and unlocking", () => {
    expect(why({ alarm: ALARM, state: "alarm" }, "jog")).toMatch(/alarm locks/);
    expect(why({ alarm: ALARM, state: "alarm" }, "home")).toBeNull();
    expect(why({ alarm: ALARM, state: "alarm" }, "unlock")).toBeNull();
    expect(why({}, "unlock")).toMatch(/no alarm/);
  });
  test("a lowered tool moves up only", () => {
    const down = station({ position: [10, 10, 3, 0] });
    expect(reasonAgainst("jog", down, MACHINE, undefined, "X")).toMatch(/Raise Z to 20/);
    expect(reasonAgainst("jog", down, MACHINE, undefined, "Z")).toBeNull();
    expect(reasonAgainst("switch", down, MACHINE, undefined)).toMatch(/Raise Z/);
  });
  test("a moving machine takes only the end of a jog", () => {
    expect(why({ state: "jog" }, "park")).toMatch(/moves/);
    expect(why({ state: "jog" }, "stop_jog")).toBeNull();
  });
  test("what the controller cannot do", () => {
    expect(why({ operations: ["jog"] }, "home")).toMatch(/cannot do this/);
  });
});

describe("jog", () => {
  test("ends inside the travel", () => {
    expect(jogDistance(MACHINE, [995, 0, 0, 0], "X", 10)).toBeCloseTo(5);
    expect(jogDistance(MACHINE, [1000, 0, 0, 0], "X", 10)).toBe(0);
    expect(jogDistance(MACHINE, [1000, 0, 0, 0], "X", -10)).toBe(-10);
    expect(jogDistance(MACHINE, [0, 0, 0, 0], "Y", -10)).toBe(-5);
  });
  test("of the heading is limited by its axis, whatever its letter", () => {
    const { c, ...linear } = MACHINE.axes;
    const lettered = {
      ...MACHINE,
      axes: { ...linear, a: c },
      carriages: [{ number: 1, letters: "XYZA", park: 0 }],
    } as unknown as Machine;
    expect(jogDistance(lettered, [0, 0, 0, 355], "C", 10)).toBe(5);
    expect(turnsTools(lettered)).toBe(true);
    const without = { ...lettered, axes: linear, carriages: [{ number: 1, letters: "XYZ" }] };
    expect(turnsTools(without as unknown as Machine)).toBe(false);
  });
  test("from beyond the travel only leads back", () => {
    expect(jogDistance(MACHINE, [1010, 0, 0, 0], "X", 5)).toBe(0);
    expect(jogDistance(MACHINE, [1010, 0, 0, 0], "X", -5)).toBe(-10);
  });
  test("is not faster than its axis", () => {
    expect(jogFeed(MACHINE, "X")).toBe(3000);
    expect(jogFeed(MACHINE, "Y")).toBe(1200);
  });
});

describe("the feed override", () => {
  const limited = { ...MACHINE, feed_override: [50, 110] } as Machine;
  const able = { operations: ["feed_override"] as Station["operations"], override: 100 };
  const percents = (part: Partial<Station>, on: Partial<Job> = {}) =>
    overrideSteps(limited, station(part), job(on))?.map(({ percent, enabled }) =>
      enabled ? percent : null,
    ) ?? null;

  test("steps by 10 % within the limits of the machine", () => {
    expect(percents({ ...able })).toEqual([90, null, 110]);
    expect(percents({ ...able, override: 105 })).toEqual([95, 100, 110]);
    expect(percents({ ...able, override: 110 })).toEqual([100, 100, null]);
    expect(percents({ ...able, override: 50 })).toEqual([null, 100, 60]);
  });

  test("is shown only while a job runs, on a controller that has one", () => {
    expect(percents({ ...able }, { state: "done" })).toBeNull();
    expect(percents({ ...able, override: null })).toBeNull();
    expect(percents({ ...able, operations: [] })).toBeNull();
    expect(percents({ ...able, connected: false })).toBeNull();
  });
});
