"""Convert moves of the axes to moves on the sheet, for machines whose axes are not square.

With the unit vectors (1, 0) and (cos γ, sin γ) of the axes X and Y on the sheet, the head is at::

    x = X + Y cos γ        y = Y sin γ

A station's datum is subtracted before, since it is an offset of the axes, and added again after, so
that all checks find the positions of joints that a square machine would have.

An arc of a program with the radius R is an ellipse of the sheet, with the half axes R √(1 ± cos γ).
It is divided into arcs through three of its points.  The third derivative of the distance from the
centre decides how far such an arc, with the half turn h, lies beside the ellipse: |cos γ| R h³ / 4
at most, for h up to 1.  This distance is counted like a rounding of the path by the controller.
Nothing here is shared with the stage that writes programs.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Final, NamedTuple

import numpy as np

from knifetip.model.machine import Machine
from knifetip.verification.columns import F64, I64
from knifetip.verification.reading.moves import Moves

#: Greatest distance of the ellipse of an arc from the arcs that replace it (mm).
ELLIPSE: Final = 1e-4
#: Greatest half turn of one of these arcs (radians).
_HALF_TURN: Final = 0.5
#: Most arcs that replace one; only arcs that leave every table would need more.
_MOST_PARTS: Final = 1000
#: Arcs of a smaller sweep are lines (radians).
_STRAIGHT: Final = 1e-9


class SheetMoves(NamedTuple):
    """The n moves of a program as m moves on the sheet; an arc is several of them."""

    moves: Moves  #: m moves; the positions of all axes in them are those of the whole move
    move: I64  #: (m,) move of the program of each, ascending


def sheet_moves(axes: Moves, machine: Machine) -> SheetMoves:
    """Return the moves of a program on the sheet; the same moves for a machine with square axes.

    ``axes`` are the moves of the axes, as the program commands them.
    """
    if machine.squareness == 90.0:
        return SheetMoves(axes, np.arange(len(axes.line)))
    skew, rise = _direction_of_y(machine)
    datum = np.array([*((one.x, one.y) for one in machine.stations), (0.0, 0.0)])[axes.station]
    bent = axes.sweep != 0.0
    spoke = axes.start[:, :2] - axes.centre
    radius = np.where(bent, np.hypot(spoke[:, 0], spoke[:, 1]), 1.0)
    longest = np.cbrt(4.0 * ELLIPSE / (abs(skew) * np.maximum(radius, 1e-6)))
    longest = np.minimum(longest, _HALF_TURN)
    pieces = np.ceil(np.abs(axes.sweep) / (2.0 * longest)).astype(np.int64).clip(1, _MOST_PARTS)
    move = np.repeat(np.arange(len(pieces)), pieces)
    ordinal = np.arange(len(move)) - np.repeat(np.cumsum(pieces) - pieces, pieces)
    first = np.arctan2(spoke[:, 1], spoke[:, 0])

    def at(place: float) -> tuple[F64, F64]:
        """Return the joints, and the point of the arc, of each row: 0 at its start, 1 at its end.

        Both are on the sheet.  A line has no arc: its point is NaN.
        """
        part = (ordinal + place) / pieces[move]
        joints = np.where((part == 1.0)[:, None], axes.end[move], axes.start[move])
        inner = np.flatnonzero((part > 0.0) & (part < 1.0))
        travel = axes.end[move[inner]] - axes.start[move[inner]]
        joints[inner] += travel * part[inner, None]
        angle = first[move] + axes.sweep[move] * part
        round_ = np.stack([np.cos(angle), np.sin(angle)], axis=1) * radius[move, None]
        point = _lean(axes.centre[move] + round_, datum[move], skew, rise)
        joints[:, :2] = _lean(joints[:, :2], datum[move], skew, rise)
        joints[inner, :2] = point[inner]
        return joints, point

    start, begin = at(0.0)
    end, finish = at(1.0)
    centre, sweep = _arcs_through(begin, at(0.5)[1], finish)
    flat = ~bent[move] | (np.abs(sweep) < _STRAIGHT)
    centre[flat], sweep[flat] = np.nan, 0.0
    same = (
        "line", "code", "inverse", "station", "lowered", "oscillating", "extra", "stated",
        "waited", "axes_start", "axes_end",
    )  # fmt: skip
    columns = {name: getattr(axes, name)[move] for name in same}
    last = np.append(np.cumsum(pieces) - 1, -1)
    parts = replace(
        axes,
        **columns,
        start=start,
        end=end,
        centre=centre,
        sweep=sweep,
        # Inverse times are those of the parts.
        feed=np.where(axes.inverse, axes.feed * pieces, axes.feed)[move],
        blend=(axes.blend + np.where(bent, ELLIPSE, 0.0))[move],
        rested=axes.rested[move] & (ordinal == 0),
        switches=replace(axes.switches, move=last[axes.switches.move]),
    )
    return SheetMoves(parts, move)


def with_sheet_resolution(axes: Moves, machine: Machine) -> Moves:
    """Return moves whose resolution is that on the sheet: rounded axes shift a point farther."""
    if machine.squareness == 90.0:
        return axes
    skew, _ = _direction_of_y(machine)
    return replace(axes, resolution=axes.resolution * math.sqrt(1.0 + abs(skew)))


def _direction_of_y(machine: Machine) -> tuple[float, float]:
    """Return the unit vector of the axis Y on the sheet: its x and its y."""
    angle = machine.squareness * math.pi / 180.0
    return math.cos(angle), math.sin(angle)


def _lean(joints: F64, datum: F64, skew: float, rise: float) -> F64:
    """Return where positions of X and Y are on the sheet, (n, 2) mm; see ``_direction_of_y``."""
    x, y = (joints - datum).T
    result: F64 = np.stack([x + skew * y, rise * y], axis=1) + datum
    return result


def _arcs_through(start: F64, middle: F64, end: F64) -> tuple[F64, F64]:
    """Return the centres, (n, 2) mm, and signed sweeps, (n,) radians, of arcs through three points.

    The angle between the chords that meet in the middle is half the sweep.
    """
    first, second = middle - start, end - middle
    cross = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        half = np.arctan2(cross, (first * second).sum(axis=1))
        chord = end - start
        apothem = 0.5 / np.tan(half)
        left = np.stack([-chord[:, 1], chord[:, 0]], axis=1)
        centre = 0.5 * (start + end) + left * apothem[:, None]
    return centre, 2.0 * half
