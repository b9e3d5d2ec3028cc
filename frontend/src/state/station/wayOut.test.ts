/** The way out of every state of a controller: the table is also that of the gateway's tests. */

import { readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import type { Job } from "../../api/jobs";
import type { Machine, Station } from "../../api/machines";
import { messageText } from "../../messages/translateMessage";
import { reasonAgainst, stopOf, titleOf } from "./station";
import { headingOf, reasonAgainstResume, reasonAgainstStart, waysOut } from "./wayOut";

interface Cell {
  readonly code: string;
  readonly ways: readonly string[];
}

interface Row {
  readonly name: string;
  readonly controller: string;
  readonly state: Station["state"];
  readonly title: string;
  readonly free: Cell;
  readonly cut: Cell | "ends";
}

const TABLE = new URL("../../../../tests/support/controller_states.json", import.meta.url);
const ROWS: readonly Row[] = JSON.parse(readFileSync(TABLE, "utf8"));
const NAMED = ROWS.map((row) => [`${row.controller} ${row.name}`, row] as const);

const MACHINE = { travel_z: 20, axes: {} } as unknown as Machine;
const message = (code: string) =>
  ({ code, arguments: {}, text: `text of ${code}`, hint: "" }) as unknown as Station["alarm"];

function stationIn({ state }: Row, { code }: Cell): Station {
  const alarm = state === "alarm";
  return {
    machine: "table",
    gateway: "gw",
    connected: true,
    state,
    alarm: alarm ? message(code) : null,
    obstacle: !alarm && code !== "" ? message(code) : null,
    position: [0, 0, 20, 0],
    outputs: [],
    outputs_known: true,
    operations: ["unlock", "home", "release", "lift", "jog", "stop_jog"],
    spindle: null,
    override: null,
    activity: null,
    notices: [],
    job: "",
    seen_seconds_ago: 0.1,
  };
}

const job = (part: Partial<Job>): Job =>
  ({ id: "j", actions: [], waiting_for: "", requested_action: "", ...part }) as Job;

/** What a job is in each situation, and how the server lets it be started. */
const FREE: readonly (readonly [string, Job | undefined])[] = [
  ["no job", undefined],
  [
    "a job that waits for its confirmation",
    job({ state: "queued", waiting_for: "confirmation", actions: ["confirm", "cancel"] }),
  ],
  [
    "a job between two copies",
    job({ state: "held", waiting_for: "sheet", actions: ["confirm", "cancel"] }),
  ],
];

describe.each(NAMED)("%s", (_, row) => {
  describe.each(FREE)("with %s", (_, waiting) => {
    const station = stationIn(row, row.free);
    test("shows the operations that lead out, and they can be pressed", () => {
      const pressable = waysOut(station, waiting)
        .map(({ operation }) => operation)
        .filter((operation) => reasonAgainst(operation, station, MACHINE, waiting) === null);
      expect(pressable).toEqual(row.free.ways);
    });
    test("names the state unless nothing is in the way", () => {
      if (row.free.code === "") return;
      if (row.state !== "idle") expect(titleOf(station, waiting).title).toBe(row.title);
      expect(headingOf(station, waiting)).toMatch(/^(Alarm|The machine cannot take a job)$/);
    });
    test("starts nothing before the machine is free", () => {
      if (waiting === undefined) return;
      const said = station.alarm ?? station.obstacle;
      expect(reasonAgainstStart(waiting, station)).toBe(said === null ? null : messageText(said));
    });
  });

  test("in a cut: the job is resumed or stopped, or has ended", () => {
    if (row.cut === "ends") {
      const ended = job({ state: "interrupted", actions: ["rest", "requeue", "scrap"] });
      const station = stationIn(row, row.free);
      for (const { operation } of waysOut(station, ended))
        expect(reasonAgainst(operation, station, MACHINE, ended)).toBeNull();
      expect(waysOut(station, ended).map(({ operation }) => operation)).toEqual(row.free.ways);
      return;
    }
    const held = row.state !== "idle";
    const cut = job({
      state: held ? "held" : "running",
      actions: held ? ["resume", "cancel"] : ["hold", "cancel"],
    });
    const station = stationIn(row, row.cut);
    const ways = [
      ...waysOut(station, cut).map(({ operation }) => operation),
      ...(cut.actions.includes("hold") ? ["hold"] : []),
      ...(reasonAgainstResume(cut, station) === null ? ["resume"] : []),
      ...(stopOf(station, cut)?.act === "cancel" ? ["stop"] : []),
    ];
    expect(ways).toEqual(row.cut.ways);
    if (row.cut.code !== "") {
      expect(titleOf(station, cut).title).toBe(row.title);
      expect(headingOf(station, cut)).toBe("The job cannot continue");
    }
  });
});

test("an open door is closed before anything is released or resumed", () => {
  const row = ROWS.find(({ name }) => name === "door 1");
  if (row === undefined) throw new Error("the table has no open door");
  const station = stationIn(row, row.free);
  expect(reasonAgainst("release", station, MACHINE, undefined)).toMatch(/Close the safety door/);
  expect(reasonAgainstResume(job({ state: "held", actions: ["resume"] }), station)).toMatch(
    /Close the safety door/,
  );
});
