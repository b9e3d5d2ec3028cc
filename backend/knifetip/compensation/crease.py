"""crease: stop the wheel before free ends, so that nothing is creased beyond them.

    Operation[CreaseWheel] -> Toolpath, one track along every path

A wheel of radius R pressed in by δ touches the board over ± s, s² = δ(2R − δ).  At a free end it
must stop s plus the board's end clearance before the end.

Source: Yang, Du, Shu & Qian, section 1 ("simple compensation of the tool based on the depth of the
indentation, in order to prevent the over-cutting"); s is our derivation.
"""

from __future__ import annotations

import numpy as np

from knifetip.compensation.tracks import Strokes, headings, raised
from knifetip.errors import EdgeTooShort
from knifetip.geometry.columns import F64, I32
from knifetip.geometry.path import point_along, taken, trimmed
from knifetip.geometry.tolerance import POINT
from knifetip.model.operation import End, Operation
from knifetip.model.tool import CreaseWheel
from knifetip.model.toolpath import Toolpath


def setback(depth: F64, wheel: CreaseWheel) -> F64:
    """Return s, half the contact length of the wheel (mm), for depths (mm).

    s = √(δ(2R − δ)): 3.4409 mm at R 15 mm and δ 0.4 mm.
    """
    result: F64 = np.sqrt(np.maximum(depth * (2.0 * wheel.radius - depth), 0.0))
    return result


def depth_that_fits(half: F64, wheel: CreaseWheel) -> F64:
    """Return the depth (mm) at which half the contact length is ``half`` (mm)."""
    reach = np.clip(half, 0.0, wheel.radius)
    result: F64 = wheel.radius - np.sqrt(wheel.radius**2 - reach**2)
    return result


def crease(operation: Operation) -> Toolpath:
    """Return the toolpath that creases every path, set back at its free ends.

    A path too short for the setback is pressed in place at a smaller depth, or refused; the board
    defines which.

    Raises
    ------
    EdgeTooShort
        A path is shorter than its end clearances, or shorter than the wheel's contact on a board
        that refuses short creases.
    """
    wheel = operation.tool
    assert isinstance(wheel, CreaseWheel)
    paths, depth = operation.paths, operation.depth[:, 0]
    length = paths.lengths
    clear = operation.end_clearance
    free_start, free_end = operation.start == End.FREE, operation.finish == End.FREE
    first, last = paths.first[:-1], paths.first[1:] - 1
    at_start = np.where(free_start, setback(depth[first], wheel) + clear, 0.0)
    at_end = np.where(free_end, setback(depth[last], wheel) + clear, 0.0)
    fits = length - at_start - at_end > 10.0 * POINT
    rolled = np.flatnonzero(fits).astype(np.int32)
    short = np.flatnonzero(~fits).astype(np.int32)

    way, rows = taken(paths, rolled)
    way, kept = trimmed(way, at_start[rolled], at_end[rolled])
    rows = rows[kept]
    c_start, c_end = headings(way)
    z = operation.caliper - depth[rows]
    begins = np.zeros(len(rows), np.bool_)
    begins[way.first[:-1]] = True
    height = operation.caliper + operation.clearance
    start_pose = np.column_stack([way.start, z, c_start])
    end_pose = np.column_stack([way.end, z, c_end])
    rolling = Strokes(
        start=start_pose,
        end=end_pose,
        bulge=way.bulge,
        down=begins,
        up=np.roll(begins, -1),
        track=rolled[way.path_of],
        source=operation.source[rows],
        above_start=raised(start_pose, height),
        above_end=raised(end_pose, height),
    )
    return rolling.merged_with(_presses(operation, wheel, short)).to_toolpath(operation)


def _presses(operation: Operation, wheel: CreaseWheel, short: I32) -> Strokes:
    """Return presses for short paths: midway between free ends, or at the continued end."""
    paths, _ = taken(operation.paths, short)
    free_start = operation.start[short] == End.FREE
    free_end = operation.finish[short] == End.FREE
    length = paths.lengths
    place = np.where(free_start & free_end, length / 2.0, np.where(free_start, length, 0.0))
    half = np.where(free_start & free_end, length / 2.0, length) - operation.end_clearance
    xy, heading, segment = point_along(paths, place)
    rows = operation.paths.first[:-1][short] + segment - paths.first[:-1]
    bad = np.flatnonzero((half <= POINT) | (operation.short_crease == "refuse"))
    if len(bad):
        listed = operation.source[rows[bad]]
        raise EdgeTooShort(
            "crease.too-short",
            edge=listed[0],
            length=length[bad[0]],
            radius=wheel.radius,
            clearance=operation.end_clearance,
            source=[str(row) for row in listed[:10]],
        )
    depth = np.minimum(depth_that_fits(half, wheel), operation.depth[rows, 0])
    pose = np.column_stack([xy, operation.caliper - depth, heading])
    once = np.ones(len(short), np.bool_)
    height = operation.caliper + operation.clearance
    start_pose = pose
    end_pose = pose
    return Strokes(
        start=start_pose,
        end=end_pose,
        bulge=np.zeros(len(short)),
        down=once,
        up=once,
        track=short,
        source=operation.source[rows],
        above_start=raised(start_pose, height),
        above_end=raised(end_pose, height),
    )
