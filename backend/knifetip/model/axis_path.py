"""axis_path: the moves of the axes that make a toolpath, on a machine whose axes are not square.

Lines stay lines.  With the angle γ between X and Y, a circle of the sheet with the radius r is an
ellipse of the axes.  To first order in ε = |cos γ|, it lies r (ε / 2) cos(2θ + φ) beside a circle.
A part that turns by 2 h is replaced by the circle through its ends and its middle, which takes up
all multiples of 1, cos θ and sin θ.  The remainder is that of an interpolation with these three
functions.  On them D³ + D is 0, and it turns cos(2θ + φ) into 6 sin(2θ + φ)::

    distance ≤ (ε / 2) r 6 max |θ - h sin θ / sin h| ≤ ε r h³ / 4       direction ≤ ε h²

for h ≤ 1.  So arcs are divided until both are small.  Headings are those on the sheet: the zero of
C is the direction of X, which lies along the x of the sheet.

Source: our derivation.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Final, NamedTuple

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.chords import split_moves
from knifetip.geometry.columns import F64, I64, hand_over
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Toolpath

#: Greatest distance of the arcs of the axes from the toolpath (mm); together with chords and digits
#: it is within what ``tolerance.FIT`` leaves of the tolerance.
DEVIATION: Final = 0.0004
#: Greatest difference of their directions (radians).
_DIRECTION: Final = math.radians(0.1)
#: Greatest half turn of an arc (radians); the bounds above hold for it.
_HALF_TURN: Final = 1.0


class AxisPath(NamedTuple):
    """Moves of the axes that make a toolpath."""

    path: Toolpath  #: m moves; X and Y of its poses are positions of the axes without offsets
    row: I64  #: (m,) row of the toolpath that each move makes


def axis_path(toolpath: Toolpath, machine: Machine) -> AxisPath:
    """Return the moves of the axes that make a toolpath.

    On a machine with square axes they are the toolpath itself.
    """
    if machine.is_square or len(toolpath) == 0:
        return AxisPath(toolpath, np.arange(len(toolpath)))
    pieces = _arc_counts(toolpath, abs(math.cos(math.radians(machine.squareness))))
    pose, row = split_moves(toolpath.pose, toolpath.bulge, pieces)
    pose = np.array(pose)
    # Ends of moves stay exactly where they are.
    pose[np.cumsum(pieces)] = toolpath.pose[1:]
    bulge = np.tan(np.arctan(toolpath.bulge) / pieces)[row]
    arcs = np.flatnonzero(bulge)
    start, end = pose[:-1, :2], pose[1:, :2]
    middle = arc.point_at(start[arcs], end[arcs], bulge[arcs], np.full(len(arcs), 0.5))
    middle = np.column_stack(machine.to_axes(*middle.T))
    pose[:, 0], pose[:, 1] = machine.to_axes(pose[:, 0], pose[:, 1])
    bulge[arcs] = _bulge_through(start[arcs], middle, end[arcs])
    divided = toolpath.with_moves(row, hand_over(pose))
    return AxisPath(
        replace(divided, bulge=bulge, one_way=toolpath.one_way, stages=toolpath.stages), row
    )


def _arc_counts(toolpath: Toolpath, skew: float) -> I64:
    """Return the number of arcs for each of n moves, (n,); ``skew`` is |cos γ|."""
    pieces = np.ones(len(toolpath), np.int64)
    arcs = np.flatnonzero(toolpath.bulge)
    start, end = toolpath.pose[arcs, :2], toolpath.pose[arcs + 1, :2]
    bulge = toolpath.bulge[arcs]
    radius = arc.radius(start, end, bulge)
    longest = np.cbrt(4.0 * DEVIATION / (skew * np.maximum(radius, 1e-9)))
    longest = np.minimum(longest, min(_HALF_TURN, math.sqrt(_DIRECTION / skew)))
    pieces[arcs] = np.ceil(np.abs(arc.sweep(bulge)) / (2.0 * longest)).astype(np.int64).clip(1)
    return pieces


def _bulge_through(start: F64, middle: F64, end: F64) -> F64:
    """Return the bulges of the arcs through three points each, (n, 2) mm.

    The chord to the middle and the chord from it turn by half the sweep of the arc.
    """
    (x, y), (u, v) = (middle - start).T, (end - middle).T
    result: F64 = np.tan(0.5 * np.arctan2(x * v - y * u, x * u + y * v))
    return result
