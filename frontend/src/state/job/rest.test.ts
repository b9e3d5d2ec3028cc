import { describe, expect, it } from "vitest";
import type { Job, Track } from "../../api/jobs";
import type { Toolpath } from "../../geometry/records";
import {
  chosenTracks,
  madeTracks,
  openTracks,
  proposedTrack,
  remainingText,
  restChoice,
  statedChoice,
  trackNumbers,
  trackOfLine,
  trackOutlines,
  tracksLeft,
  unconfirmedTracks,
  workBox,
} from "./rest";

const track = (number: number, station: number, state: Track["state"]): Track => ({
  number,
  station,
  stage: 1,
  first_line: 10 * number,
  last_line: 10 * number + 5,
  edges: [number],
  start: [0, 0],
  end: [0, 0],
  state,
});
const TRACKS = [
  track(1, 2, "cut"),
  track(2, 2, "cut"),
  track(3, 1, "begun"),
  track(4, 1, "uncut"),
  track(5, 2, "uncut"),
];
const numbers = (tracks: readonly Track[]) => tracks.map(({ number }) => number);

describe("the tracks that are left", () => {
  it("are counted, those that were begun too", () => {
    expect(tracksLeft(TRACKS)).toBe("3 tracks");
    expect(tracksLeft(TRACKS.slice(0, 3))).toBe("1 track");
  });
  it("are a range while it is not known what was cut", () => {
    const unknown = [track(1, 1, "cut"), track(2, 1, "unknown"), track(3, 1, "unknown")];
    expect(tracksLeft([...unknown, track(4, 1, "uncut")])).toBe("1 to 3 tracks");
  });
});

describe("the copies after a stopped sheet", () => {
  it("are named, and ordered after the sheet is continued or scrapped", () => {
    const job = { remaining_copies: 3, state: "done" } as Job;
    expect(remainingText(job)).toContain("3 copies of the batch are neither made nor queued");
    expect(remainingText({ ...job, state: "interrupted" })).toContain("this sheet first");
    expect(remainingText({ ...job, remaining_copies: 1 })).toContain("1 copy of the batch is");
  });
});

describe("the rest of a sheet", () => {
  it("begins with the track that was begun", () => {
    expect(proposedTrack(TRACKS)).toBe(3);
    expect(proposedTrack(TRACKS.slice(0, 2))).toBe(1);
  });

  it("begins with the track of a program line, or with the next one", () => {
    expect(trackOfLine(TRACKS, 1)).toBe(1);
    expect(trackOfLine(TRACKS, 25)).toBe(2);
    expect(trackOfLine(TRACKS, 26)).toBe(3);
    expect(trackOfLine(TRACKS, 56)).toBeNull();
  });

  it("has all tracks from one on, those of its tool, or all", () => {
    expect(numbers(chosenTracks(TRACKS, "from", 2))).toEqual([2, 3, 4, 5]);
    expect(numbers(chosenTracks(TRACKS, "tool", 2))).toEqual([2, 5]);
    expect(numbers(chosenTracks(TRACKS, "whole", 4))).toEqual([1, 2, 3, 4, 5]);
  });

  it("asks about tracks that it leaves out and that were not reported", () => {
    expect(unconfirmedTracks(TRACKS, "from", 3)).toEqual([]);
    expect(numbers(unconfirmedTracks(TRACKS, "from", 5))).toEqual([3, 4]);
    expect(numbers(unconfirmedTracks(TRACKS, "tool", 3))).toEqual([5]);
  });

  it("becomes a request", () => {
    const common = { uncut: false, copies: 1, release: true, remaining: false };
    expect(restChoice(TRACKS, "from", 3, false)).toEqual({
      ...common,
      whole: false,
      made: false,
      from_track: 3,
      station: null,
    });
    expect(restChoice(TRACKS, "tool", 3, true)).toMatchObject({
      from_track: 3,
      station: 1,
      made: true,
    });
    expect(restChoice(TRACKS, "whole", 3, true)).toEqual({ ...common, whole: true, made: false });
  });

  it("names tracks briefly", () => {
    expect(trackNumbers(TRACKS)).toBe("1 … 5");
    expect(trackNumbers(TRACKS.slice(1, 3))).toBe("2 and 3");
    expect(trackNumbers([TRACKS[0], TRACKS[2], TRACKS[4]] as Track[])).toBe("1, 3, 5");
  });
});

const PATH: Toolpath = {
  // Air, plunge, line, half circle, lift, air, plunge, line.
  pose: new Float64Array(
    [
      [0, 0, 20, 0],
      [10, 0, 20, 0],
      [10, 0, 0, 0],
      [30, 0, 0, 0],
      [30, 10, 0, 180],
      [30, 10, 20, 180],
      [50, 50, 20, 0],
      [50, 50, 0, 0],
      [60, 50, 0, 0],
    ].flat(),
  ),
  bulge: new Float64Array([0, 0, 0, 1, 0, 0, 0, 0]),
  motion: new Uint8Array([0, 1, 3, 3, 6, 0, 1, 3]),
  feed: new Float64Array(8),
  source: new Int32Array(8),
  tool: new Uint8Array(8),
  line: new Int32Array([9, 10, 11, 15, 15, 17, 20, 25]),
  placement: [0, 0],
};

describe("the picture", () => {
  it("draws the lines and arcs of each track, and no air moves", () => {
    const [first, second] = trackOutlines(PATH, TRACKS.slice(0, 2));
    expect(first).toBe("M10 0L10 0L30 0A5 5 0 0 1 30 10L30 10");
    expect(second).toBe("M50 50L50 50L60 50");
  });

  it("shows all work", () => {
    expect(workBox(TRACKS, PATH)).toEqual({ x: 10, y: 0, width: 50, height: 50 });
  });
});

describe("a sheet of which nobody saw how far the machine went", () => {
  const sheet = [track(1, 2, "cut"), track(2, 2, "unknown"), track(3, 1, "unknown")];

  it("needs an answer for each track that is not known", () => {
    expect(openTracks(sheet, {})).toEqual([2, 3]);
    expect(openTracks(sheet, { 2: false })).toEqual([3]);
    expect(openTracks(sheet, { 2: false, 3: true })).toEqual([]);
  });

  it("is continued with all tracks but those that are made", () => {
    const made = madeTracks(sheet, { 2: false, 3: true });
    expect(made).toEqual([1, 3]);
    expect(statedChoice(made)).toMatchObject({ made: [1, 3], release: true });
    expect(madeTracks(sheet, {})).toEqual([1]);
  });
});
