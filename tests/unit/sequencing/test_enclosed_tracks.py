"""What a closed track encloses is milled before this track."""

from __future__ import annotations

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.library import load
from knifetip.messages import Message
from knifetip.model.tool import Tool
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.sequencing.enclosed_tracks import split_enclosed

NOTE = Message("lead.no-room", count=1, places=["X1 Y2"])


def tool(machine: str, name: str) -> Tool:
    return next(one.tool for one in load.machine(machine).stations if one.name == name)


CUTTER = tool("router-table", "Router")


def square(x: float, y: float, size: float) -> list[tuple[float, float]]:
    """Return the vertices of a closed square, clockwise as round a part."""
    return [(x, y), (x, y + size), (x + size, y + size), (x + size, y), (x, y)]


def toolpath_of(*tracks: list[tuple[float, float]]) -> Toolpath:
    """Return a toolpath that mills each track in two passes, at heights of 1 and 0 mm."""
    pose, motion, number = [(0.0, 0.0, 5.0, 0.0)], [], []
    for track, points in enumerate(tracks):
        (x, y), (last_x, last_y) = points[0], points[-1]
        moves = [(x, y, 5.0, Motion.RAPID)]
        for height in (1.0, 0.0):
            moves += [(x, y, height, Motion.PLUNGE)]
            moves += [(*point, height, Motion.FEED) for point in points[1:]]
            moves += [(last_x, last_y, 5.0, Motion.LIFT), (x, y, 5.0, Motion.RAPID)]
        del moves[-1]
        number += [-1] + [track] * (len(moves) - 1)
        pose += [(*move[:3], 0.0) for move in moves]
        motion += [move[3] for move in moves]
    count = len(motion)
    poses: F64 = np.array(pose)
    source = np.array(number, np.int32)
    return Toolpath(
        poses, np.zeros(count), np.array(motion, np.uint8), np.full(count, 9.0), source,
        np.ones(count, np.uint8), source, (NOTE,),
    )  # fmt: skip


def levels(*tracks: list[tuple[float, float]]) -> list[list[int]]:
    """Return the tracks of each toolpath into which a toolpath is split."""
    parts = split_enclosed(toolpath_of(*tracks), CUTTER)
    return [np.unique(part.track[part.track >= 0]).tolist() for part in parts]


def test_enclosed_tracks_come_first_the_innermost_of_all() -> None:
    outer, bay, part = square(0, 0, 100), square(20, 20, 60)[::-1], square(40, 40, 10)
    assert levels(outer, bay, part) == [[2], [1], [0]]
    other, inside = square(200, 0, 100), square(220, 20, 20)
    assert levels(outer, other, inside, bay, part) == [[4], [2, 3], [0, 1]]


def test_tracks_beside_each_other_stay_together() -> None:
    path = toolpath_of(square(0, 0, 100), square(200, 0, 100), square(0, 200, 30))
    assert split_enclosed(path, CUTTER) == [path]


def test_an_open_track_encloses_nothing_and_can_be_enclosed() -> None:
    outer = square(0, 0, 100)
    opened, slit = square(10, 10, 80)[:4], [(30.0, 50.0), (60.0, 50.0)]
    assert levels(opened, slit) == [[0, 1]]
    assert levels(outer, slit, opened) == [[1, 2], [0]]


def test_the_tracks_of_a_knife_are_not_split() -> None:
    path = toolpath_of(square(0, 0, 100), square(20, 20, 60))
    assert split_enclosed(path, tool("demo-table", "Oscillating knife")) == [path]


def test_each_part_has_the_moves_of_its_tracks() -> None:
    path = toolpath_of(square(0, 0, 100), square(20, 20, 60), square(30, 30, 10))
    parts = split_enclosed(path, CUTTER)
    assert sum(len(part) for part in parts) == len(path)
    assert [part.notes for part in parts] == [(NOTE,), (), ()]
    for part in parts:
        track = int(part.track.max())
        rows = np.flatnonzero(path.track == track)
        assert part.motion.tolist() == [Motion.RAPID, *path.motion[rows].tolist()]
        np.testing.assert_array_equal(part.pose[1], path.pose[rows[0]])
        np.testing.assert_array_equal(part.pose[2:], path.pose[rows + 1])
