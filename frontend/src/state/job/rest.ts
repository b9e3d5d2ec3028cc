/** The rest of a sheet: which tracks of a program a new job makes, and their outlines. */

import type { Job, RestChoice, Track } from "../../api/jobs";
import { MOTIONS, type Toolpath } from "../../geometry/records";
import { segmentData } from "../../geometry/svgPath";
import { translate } from "../../language/translate";

/** What the new job makes: all tracks from one on, those of its tool, or the whole program. */
export type RestMode = "from" | "tool" | "whole";

/** Another job may continue the work of this one. */
export const canContinue = (job: Job): boolean => job.actions.includes("rest");

/** The first track that is not cut; the first of all if every track is cut. */
export const proposedTrack = (tracks: readonly Track[]): number =>
  (tracks.find(({ state }) => state !== "cut") ?? tracks[0])?.number ?? 1;

/** Number of the track with which the rest from a program line begins; null behind the last. */
export const trackOfLine = (tracks: readonly Track[], line: number): number | null =>
  tracks.find(({ last_line }) => last_line >= line)?.number ?? null;

/** Tracks that the new job makes. */
export function chosenTracks(
  tracks: readonly Track[],
  mode: RestMode,
  first: number,
): readonly Track[] {
  if (mode === "whole") return tracks;
  const station = tracks.find(({ number }) => number === first)?.station;
  return tracks.filter(
    (track) => track.number >= first && (mode === "from" || track.station === station),
  );
}

/** Tracks that the new job leaves out although the machine has not reported them as executed. */
export function unconfirmedTracks(
  tracks: readonly Track[],
  mode: RestMode,
  first: number,
): readonly Track[] {
  const chosen = new Set(chosenTracks(tracks, mode, first));
  return tracks.filter((track) => track.state !== "cut" && !chosen.has(track));
}

/**
 * The request for a mode. `made` states that all tracks left out are complete on the sheet, `uncut`
 * that those made again have not cut through the board.
 */
export function restChoice(
  tracks: readonly Track[],
  mode: RestMode,
  first: number,
  made: boolean,
  uncut = false,
): RestChoice {
  const rest = {
    whole: mode === "whole",
    remaining: false,
    made,
    uncut,
    copies: 1,
    release: true,
  };
  if (mode === "whole") return { ...rest, made: false, uncut: false };
  const station = tracks.find(({ number }) => number === first)?.station ?? null;
  return { ...rest, from_track: first, station: mode === "tool" ? station : null };
}

/** What the person has found of tracks that are not known: made or not, by number. */
export type Statement = Readonly<Record<number, boolean>>;

/** Numbers of the tracks for which an answer is missing. */
export const openTracks = (tracks: readonly Track[], stated: Statement): readonly number[] =>
  tracks
    .filter(({ state, number }) => state === "unknown" && stated[number] === undefined)
    .map(({ number }) => number);

/** Numbers of the tracks that are made: those cut for certain, and those that the person found. */
export const madeTracks = (tracks: readonly Track[], stated: Statement): readonly number[] =>
  tracks
    .filter(({ state, number }) => state === "cut" || stated[number] === true)
    .map(({ number }) => number);

/** How many tracks of a sheet are left; a range while it is not known of all whether they are cut. */
export function tracksLeft(tracks: readonly Track[]): string {
  const unknown = tracks.filter(({ state }) => state === "unknown").length;
  const most = tracks.filter(({ state }) => state !== "cut").length;
  return unknown === 0
    ? translate("rest.tracks", { most })
    : translate("rest.tracksBetween", { least: most - unknown, most });
}

/** The request for a rest that makes all tracks but those that are made. */
export const statedChoice = (made: readonly number[]): RestChoice => ({
  whole: false,
  remaining: false,
  made: [...made],
  uncut: false,
  copies: 1,
  release: true,
});

/** The request for the copies of a stopped batch that no job makes. */
export const REMAINING_COPIES: RestChoice = {
  whole: false,
  remaining: true,
  made: false,
  uncut: false,
  copies: 1,
  release: true,
};

/** What remains of a stopped batch, and what to do about it. */
export function remainingText({ remaining_copies: count, state }: Job): string {
  return state === "interrupted"
    ? translate("rest.copiesNotMade", { count })
    : translate("rest.copiesNotQueued", { count });
}

/** Track numbers as text: "3", "3 and 4", "3 … 7", "3, 4, 9". */
export function trackNumbers(tracks: readonly Track[]): string {
  const numbers = tracks.map(({ number }) => number);
  const [low, high] = [numbers[0] ?? 0, numbers.at(-1) ?? 0];
  if (numbers.length > 2 && high - low === numbers.length - 1) return `${low} … ${high}`;
  if (numbers.length > 6)
    return translate("rest.andMore", {
      numbers: numbers.slice(0, 5).join(", "),
      more: numbers.length - 5,
    });
  return numbers.length === 2 ? translate("rest.and", { low, high }) : numbers.join(", ");
}

const RAPID = MOTIONS.indexOf("rapid");

/** Outline of each track as data of an SVG path, in coordinates of the sheet with Y up. */
export function trackOutlines(toolpath: Toolpath, tracks: readonly Track[]): readonly string[] {
  const parts: string[][] = tracks.map(() => []);
  let track = 0;
  let open = -1;
  for (let row = 0; row < toolpath.motion.length; row++) {
    const line = toolpath.line[row] ?? -1;
    while (line >= 0 && track < tracks.length && line > (tracks[track]?.last_line ?? 0)) track++;
    const inside = line >= (tracks[track]?.first_line ?? Number.POSITIVE_INFINITY);
    if (!inside || toolpath.motion[row] === RAPID) {
      open = -1;
      continue;
    }
    const part = parts[track] ?? [];
    const x = toolpath.pose[4 * row + 4] ?? 0;
    const y = toolpath.pose[4 * row + 5] ?? 0;
    const [x0, y0] = [toolpath.pose[4 * row] ?? 0, toolpath.pose[4 * row + 1] ?? 0];
    if (open !== track) part.push(`M${x0} ${y0}`);
    part.push(segmentData(x0, y0, x, y, toolpath.bulge[row] ?? 0));
    open = track;
  }
  return parts.map((part) => part.join(""));
}

/** Box of all positions of the head at work: x, y, width and height (mm). */
export function workBox(tracks: readonly Track[], toolpath: Toolpath) {
  let [left, low, right, high] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let row = 0; row < toolpath.motion.length; row++) {
    if (toolpath.motion[row] === RAPID) continue;
    for (const at of [4 * row, 4 * row + 4]) {
      const [x, y] = [toolpath.pose[at] ?? 0, toolpath.pose[at + 1] ?? 0];
      [left, right] = [Math.min(left, x), Math.max(right, x)];
      [low, high] = [Math.min(low, y), Math.max(high, y)];
    }
  }
  if (tracks.length === 0 || left > right) return { x: 0, y: 0, width: 1, height: 1 };
  return { x: left, y: low, width: Math.max(right - left, 1), height: Math.max(high - low, 1) };
}
