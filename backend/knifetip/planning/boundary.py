"""Boundary: which grooves end on the board's edge, and how far they must run out over it.

    ends of paths, outer cuts -> Boundary

A tool of width W has its corners at ± W/2 beside the line.  It has left the board when both are
outside: past a straight edge with the outward normal m after (W/2) |n·m| / (u·m), u the direction
in which the groove leaves and n square to it.  Where the edge is round, its sagitta comes on top.
At an outer corner of the outline it is enough to be past one neighbour.  In a notch, an inner
corner, each half must be past both, and leaves if the groove points into the notch.  Where it goes
on into the board, or within 5° along it, it stops: such an end lies inside, its blade's overcut is
reported as one, and limited by the board.

Source: the turning paper, section 1 (run-out and back-up); the corner and the arc are ours.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import radians, sin

import numpy as np

from knifetip.errors import FlankOutside
from knifetip.geometry import arc, leaving
from knifetip.geometry.azimuth import left, unit
from knifetip.geometry.columns import F64, I8, I32, I64, Bool
from knifetip.geometry.path import Paths
from knifetip.geometry.tolerance import GAP
from knifetip.planning.creases import crossings
from knifetip.planning.near import near

#: A groove that meets the edge at a smaller angle runs along it (sine).
_ALONG = sin(radians(5.0))


@dataclass(frozen=True, eq=False, slots=True)
class Outline:
    """n outer cuts, each travelled so that the waste is on its left."""

    start: F64  #: (n, 2) mm
    end: F64  #: (n, 2) mm
    bulge: F64  #: (n,)

    @classmethod
    def of(cls, ends: F64, bulge: F64, side: I8) -> Outline:
        """Return the outline among cuts, (n, 2, 2) mm and (n,), whose waste lies on ``side``."""
        rows = np.flatnonzero(side)
        back = (side[rows] < 0)[:, None]
        start, end = ends[rows, 0], ends[rows, 1]
        bent = np.where(back[:, 0], -bulge[rows], bulge[rows])
        return cls(np.where(back, end, start), np.where(back, start, end), bent)


@dataclass(frozen=True, eq=False, slots=True)
class _Meetings:
    """Every outer cut that an end lies on."""

    end: I64  #: (k,) the end
    cut: I64  #: (k,) the outer cut
    normal: F64  #: (k, 2) outward, where they meet
    tangent: F64  #: (k, 2) of the cut there, the waste on its left
    gap: F64  #: (k, 2) mm from the end to the cut
    radius: F64  #: (k,) of the cut, infinite for a line (mm)
    arrives: Bool  #: (k,) the cut ends there
    leaves: Bool  #: (k,) it begins there


def run_out(
    points: F64, ahead: F64, width: float, outline: Outline, source: I32
) -> tuple[F64, Bool]:
    """Return how far past each end the tool must go, (n,) mm, and whether it lies on the edge.

    Parameters
    ----------
    points, ahead : (n, 2) mm and (n, 2)
        The ends, and the unit directions in which the paths leave the board there.
    width : mm
        W, of the tool or of what it leaves.
    source : (n,)
        The edge of each end, for the error.

    Raises
    ------
    FlankOutside
        A path meets the edge at less than 5°.
    """
    met = _meetings(points, outline)
    u, m = ahead[met.end], met.normal
    square = (u * m).sum(axis=1)
    leaves = np.flatnonzero(square > _ALONG)
    _refuse_along(met, square, source)
    end, u, m, radius = met.end[leaves], u[leaves], m[leaves], met.radius[leaves]
    sagitta = np.minimum(width / 2.0 / square[leaves], radius) ** 2 / (2.0 * radius)
    short = np.maximum((met.gap[leaves] * m).sum(axis=1), 0.0)
    further = leaving.run_out(u, m, width, sagitta + short)

    count = len(points)
    many = np.bincount(met.end, minlength=count)
    out = np.bincount(end, minlength=count)
    # Round an outer corner it is enough to leave by one side; in a notch it takes both.
    corner = _corners(met, count) < -1e-6
    on_edge: Bool = (many > 0) & (out >= np.where(corner, 1, many))
    farthest, nearest = np.zeros((count, 2)), np.full((count, 2), np.inf)
    np.maximum.at(farthest, end, further)
    np.minimum.at(nearest, end, further)
    either = np.where(corner[:, None], nearest, farthest).max(axis=1)
    size = np.where(on_edge, np.maximum(either, 0.0), 0.0)
    _refuse_beyond(points, ahead, size, width, met, outline, source)
    return size, on_edge


def _refuse_beyond(
    points: F64,
    ahead: F64,
    size: F64,
    width: float,
    met: _Meetings,
    outline: Outline,
    source: I32,
) -> None:
    """Refuse grooves that would run out into board again: over a slot, or into a neighbour."""
    rows = np.flatnonzero(size > GAP)
    start, end = points[rows], points[rows] + size[rows, None] * ahead[rows]
    # Where the tool stops, a hair within its corners: the later one stands on the edge it has left.
    half = 0.499 * width * left(ahead[rows])
    ways = Paths(
        np.concatenate([start, end + half]),
        np.concatenate([end, end - half]),
        np.zeros(2 * len(rows)),
        np.arange(2 * len(rows) + 1, dtype=np.int32),
    )
    way, cut, _ = crossings(ways, np.stack([outline.start, outline.end], axis=1), outline.bulge)
    row = np.tile(rows, 2)[way]
    count = len(outline.bulge)
    again = np.flatnonzero(~np.isin(row * count + cut, met.end * count + met.cut))
    if len(again):
        edge = int(source[row[again[0]]])
        raise FlankOutside(
            "groove.runs-out", edge=edge, distance=size[row[again[0]]], source=[str(edge)]
        )


def _refuse_along(met: _Meetings, square: F64, source: I32) -> None:
    alone = np.bincount(met.end, minlength=len(source)) == 1
    along = np.flatnonzero((square > 1e-9) & (square <= _ALONG) & alone[met.end])
    if len(along):
        edge = int(source[met.end[along[0]]])
        angle = np.degrees(np.arcsin(square[along[0]]))
        raise FlankOutside("groove.along-edge", edge=edge, angle=angle, source=[str(edge)])


def _meetings(points: F64, outline: Outline) -> _Meetings:
    boxes = arc.bounds(outline.start, outline.end, outline.bulge)
    end, cut = near(np.hstack([points, points]), boxes, GAP)
    start, finish, bulge = outline.start[cut], outline.end[cut], outline.bulge[cut]
    point = points[end]
    along = arc.nearest(start, finish, bulge, point)
    place = arc.point_at(start, finish, bulge, along)
    gap = place - point
    touch = np.hypot(gap[:, 0], gap[:, 1]) <= GAP
    tangent = unit(arc.tangent_at(start, finish, bulge, along))
    near_end = np.hypot(*(finish - point).T) <= GAP
    near_start = np.hypot(*(start - point).T) <= GAP
    return _Meetings(
        end[touch],
        cut[touch],
        left(tangent)[touch],
        tangent[touch],
        gap[touch],
        arc.radius(start, finish, bulge)[touch],
        near_end[touch],
        near_start[touch],
    )


def _corners(met: _Meetings, count: int) -> F64:
    """Return for each end how the outline turns there: the sine, > 0 in a notch, 0 if it does not.

    With the waste on the left an outer corner is a right turn.
    """
    arriving, leaving = np.zeros((count, 2)), np.zeros((count, 2))
    arriving[met.end[met.arrives]] = met.tangent[met.arrives]
    leaving[met.end[met.leaves]] = met.tangent[met.leaves]
    two = np.bincount(met.end, minlength=count) == 2
    turn = arriving[:, 0] * leaving[:, 1] - arriving[:, 1] * leaving[:, 0]
    return np.where(two, turn, 0.0)
