"""head: air moves of the head between the tracks of a toolpath, to other stations and to parking.

The head travels at the machine's travel height when the next track needs another tool.  If the next
tool is on another carriage of the gantry, the carriage that was in use is parked first, so that at
most one carriage is away from its parking position.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np

from knifetip.geometry.columns import F64, I32, U8
from knifetip.messages import Message
from knifetip.model.machine import Machine, Station
from knifetip.model.toolpath import Motion, Toolpath


@dataclass(frozen=True, eq=False, slots=True)
class MoveColumns:
    """n moves in columns.

    The columns are those of ``Toolpath``, except that ``pose``, (n, 4), contains only the pose at
    the end of each move.
    """

    pose: F64
    bulge: F64
    motion: U8
    feed: F64
    source: I32
    tool: U8
    track: I32


def single_move(
    pose: F64, station: Station, motion: Motion, *, source: int = -1, track: int = -1
) -> MoveColumns:
    """Return one straight move to ``pose``, (4,).

    A move that is not a rapid has the feed of plunges of the station's tool.
    """
    feed = 0.0 if motion is Motion.RAPID else station.tool.plunge
    return MoveColumns(
        pose=pose[None],
        bulge=np.zeros(1),
        motion=np.array([motion], np.uint8),
        feed=np.array([feed]),
        source=np.array([source], np.int32),
        tool=np.array([station.number], np.uint8),
        track=np.array([track], np.int32),
    )


def join_moves(
    start: F64, parts: Sequence[MoveColumns], notes: tuple[Message, ...] = ()
) -> Toolpath:
    """Return the toolpath of all moves, which begins at the pose ``start``, (4,)."""
    columns = {
        field.name: np.concatenate([getattr(part, field.name) for part in parts])
        for field in fields(MoveColumns)
    }
    columns["pose"] = np.concatenate([start[None], columns["pose"]])
    return Toolpath.from_new(columns, notes)


class Head:
    """The head while a toolpath is put together: its station, its pose, and its air moves.

    It starts at the parking pose of a station.  The methods return air moves and update the pose;
    a caller that adds other moves sets ``pose`` to their last pose.
    """

    def __init__(self, station: Station, machine: Machine) -> None:
        self.pose = parking_pose(station, machine)  #: (4,)
        self._station, self._machine = station, machine
        #: heading of C of each carriage while it is parked, without the datum of its station
        self._turned = dict.fromkeys(range(1, 1 + len(machine.carriages)), 0.0)

    def change_station(self, station: Station) -> list[MoveColumns]:
        """Return the air moves before the work of a station; none if it is in use."""
        previous, machine = self._station, self._machine
        if station.number == previous.number:
            return []
        parts = [self._travel(at_height(self.pose, machine.travel_z))]
        if previous.carriage != station.carriage:
            self._turned[previous.carriage] = float(self.pose[3]) + previous.c
            parked = _park_pose(self.pose, previous, machine)
            parts.append(self._travel(at_height(parked, _idle_height(previous, machine))))
            pose = _next_pose(self.pose, previous, station, machine)
            pose[3] = self._turned[station.carriage] - station.c
            self._station = station
            parts.append(self._travel(pose))
        self._station = station
        return parts

    def rise(self) -> list[MoveColumns]:
        """Return the air move straight up to the travel height; none if the head is there."""
        if self.pose[2] == self._machine.travel_z:
            return []
        return [self._travel(at_height(self.pose, self._machine.travel_z))]

    def move_above(self, pose: F64) -> list[MoveColumns]:
        """Return the air move to the travel height above a pose; none if the head is lower."""
        if self.pose[2] != self._machine.travel_z:
            return []
        return [self._travel(at_height(pose, self._machine.travel_z))]

    def park(self) -> list[MoveColumns]:
        """Return the air moves at travel height to the parking pose of the station."""
        up = self._travel(at_height(self.pose, self._machine.travel_z))
        return [up, self._travel(parking_pose(self._station, self._machine))]

    def _travel(self, pose: F64) -> MoveColumns:
        """Return one rapid of the station to ``pose``, (4,)."""
        self.pose = pose
        return single_move(pose, self._station, Motion.RAPID)


def at_height(pose: F64, height: float) -> F64:
    """Return a copy of a pose, (4,), with its z set to ``height`` (mm)."""
    raised = pose.copy()
    raised[2] = height
    return raised


def parking_pose(station: Station, machine: Machine) -> F64:
    """Return the parking pose of a station, (4,), at travel height with C at 0.

    It is the position nearest to X 0, Y 0 that the station can reach.  If the machine has several
    carriages, Y is the parking position of the carriage of the station.
    """
    x, y = machine.carriage_of(station).axes[:2]
    place = machine.to_sheet(
        min(max(0.0, x.low - station.x), x.high - station.x),
        min(max(0.0, y.low - station.y), y.high - station.y),
    )
    pose = np.array([*place, machine.travel_z, 0.0])
    return _park_pose(pose, station, machine) if machine.gantry else pose


def _park_pose(pose: F64, station: Station, machine: Machine) -> F64:
    """Return a pose of a station, (4,), with the station's carriage at its parking position."""
    parked = pose.copy()
    parked[1] = machine.carriage_of(station).park - station.y
    return parked


def _idle_height(station: Station, machine: Machine) -> float:
    """Return the height of the tip of a station while its carriage is not in use (mm).

    If the carriages have different Z axes, the carriage rises until all its stations are at travel
    height.  If they share one, the next carriage moves it to the travel height of its own station.
    """
    letters = [carriage.letters[2] for carriage in machine.carriages]
    if len(set(letters)) == 1:
        return machine.travel_z
    z = machine.carriage_of(station).axes[2]
    letter = letters[station.carriage - 1]
    datum = [one.z for one in machine.stations if letters[one.carriage - 1] == letter]
    return min(machine.travel_z + max(datum), z.high) - station.z


def _next_pose(pose: F64, previous: Station, station: Station, machine: Machine) -> F64:
    """Return the pose of the next station, (4,), whose carriage is still parked.

    ``pose`` is the pose of the station ``previous`` on another carriage.  The gantry remains at its
    position along X, unless the next station cannot be at that position.
    """
    x = machine.carriage_of(station).axes[0]
    result = at_height(_park_pose(pose, station, machine), machine.travel_z)
    result[0] = min(max(pose[0] + previous.x, x.low), x.high) - station.x
    return result
