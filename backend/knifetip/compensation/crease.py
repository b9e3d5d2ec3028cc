"""crease: stop a crease wheel before free ends, so that it creases nothing beyond them.

A wheel of radius R pressed into the board by δ touches it over a length of 2 s, s² = δ(2R − δ).
At a free end it must stop by s plus the end clearance of the board before the end.

Source: Yang, Du, Shu & Qian, "Study on tool compensation of NC carton samplemaker", section 1
("simple compensation of the tool based on the depth of the indentation, in order to prevent the
over-cutting"); s is our derivation.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.compensation.tracks import Strokes, at_height, headings
from knifetip.geometry.columns import F64, I32
from knifetip.geometry.path import point_along, select_paths, trim_ends
from knifetip.model.operation import End, Operation
from knifetip.model.tool import CreaseWheel
from knifetip.model.toolpath import Toolpath

#: On a shorter length the wheel does not roll (mm).
_LEAST_LENGTH: Final = 1e-5
#: Least depth at which the wheel is pressed (mm): controllers round heights to up to 0.0025 mm.
_LEAST_DEPTH: Final = 0.01


def half_contact_length(depth: F64, wheel: CreaseWheel) -> F64:
    """Return s, half the contact length of a wheel with the board, for depths δ (mm).

    The result has the shape of ``depth``.

    s = √(δ(2R − δ)) with R the radius of the wheel: 3.4409 mm for R 15 mm and δ 0.4 mm.
    """
    result: F64 = np.sqrt(np.maximum(depth * (2.0 * wheel.radius - depth), 0.0))
    return result


def depth_at_contact(half_length: F64, wheel: CreaseWheel) -> F64:
    """Return the depths at which a wheel touches the board over given lengths, (n,) mm.

    δ = R − √(R² − s²) with R the radius of the wheel and s = ``half_length`` (n,), half the length
    of each contact in mm.
    """
    reach = np.clip(half_length, 0.0, wheel.radius)
    result: F64 = wheel.radius - np.sqrt(wheel.radius**2 - reach**2)
    return result


def crease_toolpath(operation: Operation) -> Toolpath:
    """Return the toolpath of a crease wheel along every path, set back at free ends.

    A free end is one at which no other path continues, so that the wheel must not crease beyond it.
    A path too short for the setback is pressed in one position at a smaller depth.  A path that is
    shorter than its end clearances or would be pressed by less than 0.01 mm is not made, nor is a
    short path on a board that refuses short creases (``short_crease``).  The verifier reports such
    a path as a shortfall.
    """
    wheel = operation.tool
    assert isinstance(wheel, CreaseWheel)
    paths, depth = operation.paths, operation.depth[:, 0]
    length = paths.lengths
    clear = operation.end_clearance
    free_start, free_end = operation.start == End.FREE, operation.finish == End.FREE
    contact = half_contact_length(operation.end_depth, wheel)
    at_start = np.where(free_start, contact[:, 0] + clear, 0.0)
    at_end = np.where(free_end, contact[:, 1] + clear, 0.0)
    fits = length - at_start - at_end > _LEAST_LENGTH
    rolled = np.flatnonzero(fits).astype(np.int32)
    short_paths = np.flatnonzero(~fits).astype(np.int32)

    rolled_paths, rows = select_paths(paths, rolled)
    rolled_paths, kept = trim_ends(rolled_paths, at_start[rolled], at_end[rolled])
    rows = rows[kept]
    c_start, c_end = headings(rolled_paths)
    z = operation.caliper - depth[rows]
    begins = np.zeros(len(rows), np.bool_)
    begins[rolled_paths.first[:-1]] = True
    height = operation.caliper + operation.clearance
    start_pose = np.column_stack([rolled_paths.start, z, c_start])
    end_pose = np.column_stack([rolled_paths.end, z, c_end])
    rolling = Strokes(
        start=start_pose,
        end=end_pose,
        bulge=rolled_paths.bulge,
        down=begins,
        up=np.roll(begins, -1),
        track=rolled[rolled_paths.path_of],
        source=operation.source[rows],
        above_start=at_height(start_pose, height),
        above_end=at_height(end_pose, height),
    )
    return rolling.merged_with(_presses(operation, wheel, short_paths)).to_toolpath(operation)


def _presses(operation: Operation, wheel: CreaseWheel, short_paths: I32) -> Strokes:
    """Return one press of the wheel for each short path on which the wheel can be pressed.

    A press lowers and lifts the wheel without travel.  If other paths continue the path at one end,
    the wheel is pressed at this end, because it may crease beyond it.  If both ends are free, it is
    pressed midway between them.

    ``short_paths``: indices of the short paths in the operation.
    """
    lengths = operation.paths.lengths[short_paths]
    both_free = (operation.start[short_paths] == End.FREE) & (
        operation.finish[short_paths] == End.FREE
    )
    half = np.where(both_free, lengths / 2.0, lengths) - operation.end_clearance
    possible = (half > 0.0) & (depth_at_contact(half, wheel) > _LEAST_DEPTH)
    possible &= operation.short_crease != "refuse"
    short_paths, half = short_paths[possible], half[possible]
    paths, _ = select_paths(operation.paths, short_paths)
    free_start = operation.start[short_paths] == End.FREE
    free_end = operation.finish[short_paths] == End.FREE
    length = paths.lengths
    position = np.where(free_start & free_end, length / 2.0, np.where(free_start, length, 0.0))
    xy, heading, segment = point_along(paths, position)
    rows = operation.paths.first[:-1][short_paths] + segment - paths.first[:-1]
    depth = np.minimum(depth_at_contact(half, wheel), operation.depth[rows, 0])
    pose = np.column_stack([xy, operation.caliper - depth, heading])
    once = np.ones(len(short_paths), np.bool_)
    height = operation.caliper + operation.clearance
    start_pose = pose
    end_pose = pose
    return Strokes(
        start=start_pose,
        end=end_pose,
        bulge=np.zeros(len(short_paths)),
        down=once,
        up=once,
        track=short_paths,
        source=operation.source[rows],
        above_start=at_height(start_pose, height),
        above_end=at_height(end_pose, height),
    )
