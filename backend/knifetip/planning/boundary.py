"""Boundary: which grooves end on the board's edge, and how far they must run out over it.

    ends of paths, outer cuts -> Boundary

A tool of width W has its corners at ± W/2 beside the line.  It has left the board when both are
outside: past a straight edge with the outward normal m after (W/2) |n·m| / (u·m), u the direction
in which the groove leaves and n square to it.  Where the edge is round, its sagitta comes on top.
At an outer corner of the outline it is enough to be past one neighbour.  In a notch, an inner
corner, one half of the groove meets board: such an end lies inside, and nothing is run out.

Source: the turning paper, section 1 (run-out and back-up); the corner and the arc are ours.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import radians, sin

import numpy as np

from knifetip.errors import FlankOutside
from knifetip.geometry import arc
from knifetip.geometry.azimuth import left, unit
from knifetip.geometry.columns import F64, I8, I32, I64, Bool
from knifetip.geometry.tolerance import BULGE, GAP
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
    leaving = square > _ALONG
    _refuse_along(met, square, source)
    safe = np.where(leaving, square, 1.0)
    sagitta = np.minimum(width / 2.0 / safe, met.radius) ** 2 / (2.0 * met.radius)
    short = np.maximum((met.gap * m).sum(axis=1), 0.0)
    beside = width / 2.0 * (left(u) * m).sum(axis=1)

    count = len(points)
    many = np.bincount(met.end, minlength=count)
    out = np.bincount(met.end[leaving], minlength=count)
    # Round an outer corner it is enough to leave by one side; in a notch half of it never leaves.
    turn = _corners(met, count)
    corner = turn < -1e-6
    on_edge: Bool = (many > 0) & (out >= np.where(corner, 1, many)) & (turn < 1e-6)
    size = np.zeros(count)
    for flank in (beside, -beside):
        extra = (sagitta + short - flank) / safe
        farthest, nearest = np.zeros(count), np.full(count, np.inf)
        np.maximum.at(farthest, met.end[leaving], extra[leaving])
        np.minimum.at(nearest, met.end[leaving], extra[leaving])
        size = np.maximum(size, np.where(corner, nearest, farthest))
    return np.where(on_edge, size, 0.0), on_edge


def _refuse_along(met: _Meetings, square: F64, source: I32) -> None:
    alone = np.bincount(met.end, minlength=len(source)) == 1
    along = np.flatnonzero((square > 1e-9) & (square <= _ALONG) & alone[met.end])
    if len(along):
        edge = int(source[met.end[along[0]]])
        angle = np.degrees(np.arcsin(square[along[0]]))
        raise FlankOutside(
            f"The V-groove at edge {edge} meets the board's edge at {angle:.1f}°, almost along it, "
            "so its flanks would not leave the board.",
            "Let it end before the edge, or meet it at 5° or more.",
            [str(edge)],
        )


def _meetings(points: F64, outline: Outline) -> _Meetings:
    boxes = arc.bounds(outline.start, outline.end, outline.bulge)
    end, cut = near(np.hstack([points, points]), boxes, GAP)
    start, finish, bulge = outline.start[cut], outline.end[cut], outline.bulge[cut]
    straight = np.abs(bulge) < BULGE
    point = points[end]
    chord = finish - start
    along = ((point - start) * chord).sum(axis=1) / (chord**2).sum(axis=1)
    theta = arc.sweep(bulge)
    radius = arc.radius(start, finish, bulge)
    if not straight.all():
        middle = arc.centre(start, finish, bulge)
        spoke, first = point - middle, start - middle
        turned = np.arctan2(
            first[:, 0] * spoke[:, 1] - first[:, 1] * spoke[:, 0], (first * spoke).sum(axis=1)
        )
        # Measured from the arc's middle, so that a point beside either end is nearest to that end.
        turned = (turned - theta / 2.0 + np.pi) % (2.0 * np.pi) - np.pi
        share = 0.5 + turned / np.where(straight, 1.0, theta)
        along = np.where(straight, along, share)
    along = np.clip(along, 0.0, 1.0)
    place = arc.point_at(start, finish, bulge, along)
    gap = place - point
    touch = np.hypot(gap[:, 0], gap[:, 1]) <= GAP
    half = theta * (along - 0.5)
    cos, sine = np.cos(half)[:, None], np.sin(half)[:, None]
    tangent = unit(chord * cos + left(chord) * sine)
    near_end = np.hypot(*(finish - point).T) <= GAP
    near_start = np.hypot(*(start - point).T) <= GAP
    return _Meetings(
        end[touch],
        left(tangent)[touch],
        tangent[touch],
        gap[touch],
        radius[touch],
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
