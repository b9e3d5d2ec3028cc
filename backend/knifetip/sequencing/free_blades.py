"""free_blades: turn blades that only travel in the board turns.

A free blade trails its axis by e and keeps its heading in the air.  It comes down with the heading
that it has, so that its tip is at the start of the track, and the axis then swings about the tip by
an arc of radius e until the blade has the heading in which the track starts.  The first track of a
program finds the blade with the park heading of the tool, and after the last track the axis swings
about the tip until the blade has this heading again.  So a further copy starts as the first did.

Source: our derivation.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from knifetip.geometry.azimuth import turn_angle
from knifetip.geometry.columns import F64, hand_over
from knifetip.messages import Message
from knifetip.model.machine import Machine, Station
from knifetip.model.tool import Knife
from knifetip.model.toolpath import Motion, Toolpath

#: A smaller turn needs no swing: programs round it away (degrees).
_LEAST_TURN = 0.05


class _Track(NamedTuple):
    """The moves of a track in the board: rows of its plunge and of its last lift."""

    plunge: int
    lift: int


class _Move(NamedTuple):
    """A move that is inserted before a row of a toolpath."""

    before: int  #: row
    pose: F64  #: (4,) pose at its end
    motion: Motion
    bulge: float = 0.0


def turn_free_blades(toolpath: Toolpath, machine: Machine) -> Toolpath:
    """Return the toolpath of a machine with the swings that turn its free blades.

    Without free blades, the toolpath is returned unchanged.  Every track in ``toolpath`` begins at
    the machine's clearance above the board.
    """
    for station in machine.stations:
        if isinstance(station.tool, Knife) and station.tool.free:
            toolpath = _BladeTurner(toolpath, station, station.tool, machine.clearance).turned()
    return toolpath


class _BladeTurner:
    """Turns the blade of one station."""

    def __init__(
        self, toolpath: Toolpath, station: Station, blade: Knife, clearance: float
    ) -> None:
        self._toolpath, self._station, self._blade = toolpath, station, blade
        self._clearance = clearance
        self._own = toolpath.tool == station.number
        self._pose = toolpath.pose.copy()
        self._inserted: list[_Move] = []
        self._top = 0.0  # height of the board's top face

    def turned(self) -> Toolpath:
        """Return the toolpath in which the blade has the heading of each track at its start."""
        tracks = self._tracks()
        if not tracks:
            return self._toolpath
        self._top = float(self._pose[tracks[0].plunge, 2]) - self._clearance
        park = self._blade.park_heading
        heading, free_from = park, 1
        for track in tracks:
            self._set_air_headings(free_from, track.plunge, heading)
            self._enter(track, heading, free_from)
            heading, free_from = float(self._pose[track.lift, 3]), track.lift + 2
        last = tracks[-1]
        self._leave(last, heading)
        self._set_air_headings(free_from, len(self._toolpath), park)
        note = Message("knife.park-heading", degrees=park, station=self._station.number)
        return replace(self._with_inserted(), notes=(*self._toolpath.notes, note))

    def _tracks(self) -> list[_Track]:
        """Return the tracks of the station, in their order."""
        works = self._own & (self._toolpath.motion != Motion.RAPID)
        edges = np.diff(works.astype(np.int8), prepend=0, append=0)
        first, last = np.flatnonzero(edges == 1), np.flatnonzero(edges == -1) - 1
        return [_Track(int(low), int(high)) for low, high in zip(first, last, strict=True)]

    def _set_air_headings(self, first: int, last: int, heading: float) -> None:
        """Set the heading of the station's poses from index ``first`` to ``last``."""
        rows = np.arange(first, last + 1)
        self._pose[rows[self._own[rows - 1]], 3] = heading

    def _enter(self, track: _Track, heading: float, free_from: int) -> None:
        """Let the blade come down with a heading, and turn it into that of the track.

        ``free_from`` is the first pose that may be moved.
        """
        pose = self._pose
        start = pose[track.plunge + 1].copy()
        turn = _turn(heading, float(start[3]))
        pose[track.plunge + 1 : track.lift + 2, 3] += heading + turn - start[3]
        start[3] = heading + turn
        if abs(turn) < _LEAST_TURN:
            return
        entry = self._turn_about_tip(start, heading)
        row = track.plunge
        above = pose[row, :2].copy()
        while row >= free_from and np.array_equal(pose[row, :2], above):
            pose[row, :2] = entry[:2]
            row -= 1
        height = self._swivel_height(float(start[2]))
        entry[2] = height
        pose[track.plunge + 1] = entry
        before = track.plunge + 1
        swung = np.array([start[0], start[1], height, start[3]])
        self._inserted.append(_Move(before, swung, Motion.FEED, _bulge(turn)))
        if height > start[2]:
            self._inserted.append(_Move(before, start, Motion.PLUNGE))

    def _leave(self, track: _Track, heading: float) -> None:
        """Turn the blade to its park heading before it is lifted at the end of a track."""
        turn = _turn(heading, self._blade.park_heading)
        if abs(turn) < _LEAST_TURN:
            return
        pose, row = self._pose, track.lift
        end = pose[row].copy()
        height = self._swivel_height(float(end[2]))
        end_above = np.array([end[0], end[1], height, end[3]])
        if height > end[2]:
            self._inserted.append(_Move(row, end_above, Motion.LIFT))
        parked = self._turn_about_tip(end_above, heading + turn)
        self._inserted.append(_Move(row, parked, Motion.FEED, _bulge(turn)))
        behind = row + 1
        while behind < len(pose) and np.array_equal(pose[behind, :2], end[:2]):
            pose[behind, :2] = parked[:2]
            behind += 1
        pose[row + 1, 3] = parked[3]

    def _swivel_height(self, cut: float) -> float:
        """Return the height of the tip in swings beside a cut at a height (mm)."""
        depth = self._blade.swivel_depth
        return max(cut, self._top - depth) if depth > 0.0 else cut

    def _turn_about_tip(self, pose: F64, heading: float) -> F64:
        """Return a pose with another heading and the tip at the same point."""
        here, there = math.radians(float(pose[3])), math.radians(heading)
        e = self._blade.trail
        return np.array(
            [
                pose[0] + e * (math.cos(there) - math.cos(here)),
                pose[1] + e * (math.sin(there) - math.sin(here)),
                pose[2],
                heading,
            ]
        )

    def _with_inserted(self) -> Toolpath:
        """Return the toolpath with the changed poses and the inserted moves."""
        moves, toolpath, blade = self._inserted, self._toolpath, self._blade
        before = np.array([move.before for move in moves], np.int64)
        like = before - 1
        bulge = np.array([move.bulge for move in moves])
        motion = np.array([move.motion for move in moves], np.uint8)
        feed = np.where(motion == Motion.FEED, blade.feed, blade.plunge)
        pose = np.insert(
            self._pose, before + 1, np.reshape([move.pose for move in moves], (-1, 4)), axis=0
        )
        columns: dict[str, NDArray[Any]] = {
            "bulge": np.insert(toolpath.bulge, before, bulge),
            "motion": np.insert(toolpath.motion, before, motion),
            "feed": np.insert(toolpath.feed, before, feed),
            **{
                name: np.insert(getattr(toolpath, name), before, getattr(toolpath, name)[like])
                for name in ("source", "tool", "track")
            },
        }
        return Toolpath.from_new({"pose": hand_over(pose), **columns}, toolpath.notes)


def _bulge(turn: float) -> float:
    """Return the bulge of an arc by its sweep (degrees)."""
    return math.tan(math.radians(turn) / 4.0)


def _turn(before: float, after: float) -> float:
    """Return the turn from one heading to another by the smaller angle (degrees)."""
    return float(turn_angle(np.array([before]), np.array([after]))[0])
