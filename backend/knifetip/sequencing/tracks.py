"""tracks: the tracks of a toolpath with their program lines, and the choice of those still to make.

A track is a path between two lifts: its program lines are made completely or not.  The executed
lines of a program divide its tracks into cut, begun and uncut ones.  A track that was begun is made
again from its start, because nothing tells how deep the tool was when the machine stopped.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry.columns import I32, I64, Bool
from knifetip.model.program import Program
from knifetip.model.toolpath import Toolpath


class TrackState(StrEnum):
    """How much of a track was made."""

    CUT = "cut"
    BEGUN = "begun"
    UNCUT = "uncut"
    UNKNOWN = "unknown"  #: nobody observed whether the machine has made it


@dataclass(frozen=True, eq=False, slots=True)
class Tracks:
    """The t tracks of a sequenced toolpath, in the order of the work."""

    first_row: I64  #: (t,) row of the first move in the toolpath
    last_row: I64  #: (t,)
    first_line: I64  #: (t,) first program line, from 1
    last_line: I64  #: (t,)
    station: I64  #: (t,) number of the station

    def __len__(self) -> int:
        return len(self.station)

    def states(self, executed: int, at_most: int | None = None) -> list[TrackState]:
        """Return the state of each track after the first ``executed`` lines of the program.

        Parameters
        ----------
        executed
            Number of executed lines.
        at_most
            Number of lines that may have been executed; None if it is ``executed``.
        """
        begun, cut = self.first_line <= executed, self.last_line <= executed
        names = (TrackState.UNCUT, TrackState.BEGUN, TrackState.CUT)
        states = [names[count] for count in begun.astype(int) + cut]
        for number in np.flatnonzero(self.unknown(executed, at_most)):
            states[number] = TrackState.UNKNOWN
        return states

    def unknown(self, executed: int, at_most: int | None) -> Bool:
        """Return the mask of tracks that may be made, (t,); the parameters are those of ``states``.

        A track whose lines were executed for certain is not among them.
        """
        most = executed if at_most is None or at_most <= executed else at_most
        if most == executed:
            return np.zeros(len(self), bool)
        return np.asarray((self.last_line > executed) & (self.first_line <= most))


@dataclass(frozen=True, slots=True)
class RestChoice:
    """The user's choice of the tracks that remain to be made.

    Without ``from_track`` and ``from_line``, the rest begins with the first track that is not cut,
    or with the first track of all if a station is chosen.
    """

    from_track: int | None = None  #: number of the first track, from 1
    from_line: int | None = None  #: program line; the rest begins with the track of this line
    station: int | None = None  #: only the tracks of this station
    #: the user has found all other tracks complete; or the numbers, from 1, of all complete tracks
    made: bool | tuple[int, ...] = False
    #: the user has found that the tracks which are made again have not cut through the board
    uncut: bool = False


@dataclass(frozen=True, eq=False, slots=True)
class RestSelection:
    """The tracks that remain to be made, and the program lines of those that are complete."""

    tracks: I64  #: (k,) numbers of the tracks, from 0, ascending
    made_lines: tuple[tuple[int, int], ...]  #: ranges of program lines: first and last, from 1
    #: ranges of executed lines of the tracks that are made again, unless they left the board uncut
    repeated_lines: tuple[tuple[int, int], ...]


def row_lines(program: Program, rows: int) -> I32:
    """Return for each row of a toolpath the last program line that makes it, (rows,).

    The lines are numbered from 1; a row without a program line has -1.
    """
    line = np.full(rows, -1, np.int32)
    numbers = np.arange(1, len(program) + 1, dtype=np.int32)
    moving = program.source >= 0
    np.maximum.at(line, program.source[moving], numbers[moving])
    return line


def first_row_lines(program: Program, rows: int) -> I32:
    """Return for each row of a toolpath the first program line that makes it, (rows,).

    The lines are numbered from 1; a row without a program line has -1.
    """
    line = np.full(rows, -1, np.int32)
    moving = np.flatnonzero(program.source >= 0)[::-1]
    # Of several values for one row, the last is kept: that of the first line.
    line[program.source[moving]] = moving + 1
    return line


def track_rows(toolpath: Toolpath) -> tuple[I64, I64]:
    """Return the first and the last row of each of the t tracks of a sequenced toolpath, (t,)."""
    rows = np.flatnonzero(toolpath.track >= 0)
    track = toolpath.track[rows]
    numbers = np.arange(int(track.max(initial=-1)) + 1)
    first = rows[np.searchsorted(track, numbers)]
    last = rows[np.searchsorted(track, numbers, side="right") - 1]
    return first, last


def find_tracks(toolpath: Toolpath, line: I32) -> Tracks:
    """Return the tracks of a sequenced toolpath; ``line``, (n,), is the line of each of its rows.

    A track begins with the line after that of the row before it, so that lines which lower the tool
    belong to it.
    """
    first, last = track_rows(toolpath)
    reached = np.maximum.accumulate(np.maximum(line, 0)).astype(np.int64)
    before = np.where(first > 0, reached[first - 1], 0)
    return Tracks(first, last, before + 1, reached[last], toolpath.tool[first].astype(np.int64))


def select_rest(
    tracks: Tracks, executed: int, choice: RestChoice, job: str = "", at_most: int | None = None
) -> RestSelection:
    """Return the tracks that remain to be made, and the lines whose work is complete.

    Parameters
    ----------
    tracks
        The tracks of the program that the rest continues.
    executed
        Number of its lines that were executed.
    choice
        The user's choice.
    job
        Id of the job, for messages.
    at_most
        Number of lines that may have been executed; None if it is ``executed``.

    Raises
    ------
    PlanError
        There is no such track, line or station, no track remains, or a track that was not executed
        is left out and the user has not found it complete; or it is not known which tracks are
        made, and the user has not stated it.
    """
    unknown = tracks.unknown(executed, at_most)
    if unknown.any() and isinstance(choice.made, bool):
        raise PlanError(
            "rest.statement-needed",
            job=job,
            executed=executed,
            most=at_most,
            tracks=int(unknown.sum()),
            track=int(np.argmax(unknown)) + 1,
        )
    kept = _kept_tracks(tracks, executed, choice)
    if choice.station is not None:
        if not (tracks.station == choice.station).any():
            raise PlanError("rest.no-such-station", station=choice.station)
        kept &= tracks.station == choice.station
    if not kept.any():
        raise PlanError("rest.no-tracks")
    missing = ~kept & (tracks.last_line > executed)
    if missing.any() and choice.made is False:
        raise PlanError(
            "rest.not-executed",
            count=int(missing.sum()),
            track=int(np.argmax(missing)) + 1,
            station=int(tracks.station[np.argmax(missing)]),
            executed=executed,
        )
    repeated: tuple[tuple[int, int], ...] = ()
    if not choice.uncut:
        ranges = _line_ranges(tracks, kept & (tracks.first_line <= executed))
        repeated = tuple((first, min(last, executed)) for first, last in ranges)
    return RestSelection(np.flatnonzero(kept), _line_ranges(tracks, ~kept), repeated)


def _kept_tracks(tracks: Tracks, executed: int, choice: RestChoice) -> Bool:
    """Return the mask of the tracks that the rest makes, of all stations, (t,)."""
    numbers = np.arange(len(tracks))
    if isinstance(choice.made, bool):
        return np.asarray(numbers >= _first_track(tracks, executed, choice))
    for number in choice.made:
        if not 1 <= number <= len(tracks):
            raise PlanError("rest.no-such-track", track=number, count=len(tracks))
    return ~np.isin(numbers + 1, choice.made)


def _first_track(tracks: Tracks, executed: int, choice: RestChoice) -> int:
    """Return the number, from 0, of the first track that may be in the rest."""
    if choice.from_track is not None:
        if not 1 <= choice.from_track <= len(tracks):
            raise PlanError("rest.no-such-track", track=choice.from_track, count=len(tracks))
        return choice.from_track - 1
    line = executed + 1
    if choice.from_line is not None:
        line = choice.from_line
    elif choice.station is not None:
        return 0
    return int(np.searchsorted(tracks.last_line, line))


def _line_ranges(tracks: Tracks, marked: Bool) -> tuple[tuple[int, int], ...]:
    """Return the ranges of program lines of marked tracks; neighbouring tracks are joined."""
    edges = np.diff(marked.astype(np.int8), prepend=0, append=0)
    first = tracks.first_line[np.flatnonzero(edges == 1)].tolist()
    last = tracks.last_line[np.flatnonzero(edges == -1) - 1].tolist()
    return tuple(zip(first, last, strict=True))
