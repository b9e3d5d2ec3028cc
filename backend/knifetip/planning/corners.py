"""Corners: which corner of a contour is which of those that somebody chose a type for.

    Paths, side, Corners -> (n,) type and knob at the corner where each segment begins

A corner is where two segments of a path meet with a bend that is convex for the tool: round all
others there is only one way.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, U8, Bool
from knifetip.geometry.path import Paths
from knifetip.geometry.tolerance import JOIN
from knifetip.messages import Message
from knifetip.model.corners import AS_OTHERS, INTERFERENCES, TYPES, Corners

#: A place may be this far from the corner that it names (mm).
NEAR: Final = 0.5
#: Where the direction turns by less there is no corner (radians).
_STRAIGHT: Final = 1e-9
#: So many corners of the drawing are named to somebody who missed them all.
_NAMED: Final = 3


@dataclass(frozen=True, eq=False, slots=True)
class Bends:
    """Where the segments of contours begin, on the sheet."""

    place: F64  #: (n, 2) mm
    turn: F64  #: (n,) radians, > 0 convex for the tool; 0 where an open path begins


def bends(paths: Paths, side: int) -> Bends:
    """Return the bend at the beginning of every segment; ``side`` is +1 for a tool on the left."""
    ahead, arriving = arc.tangents(paths.start, paths.end, paths.bulge)
    first, last = paths.first[:-1], paths.first[1:] - 1
    before = np.roll(arriving, 1, axis=0)
    before[first] = np.where(paths.closed[:, None], arriving[last], ahead[first])
    cross = before[:, 0] * ahead[:, 1] - before[:, 1] * ahead[:, 0]
    turn: F64 = np.arctan2(-side * cross, (before * ahead).sum(axis=1))
    return Bends(paths.start, turn)


def check(corners: Corners) -> None:
    """Refuse a choice that is none.

    Raises
    ------
    PlanError
        A type, a knob, a place or what is to be done about interference makes no sense.
    """
    if corners.interference not in INTERFERENCES:
        raise PlanError("corner.bad-interference", interference=corners.interference)
    for kind, k, where in [(corners.type, corners.k, None)] + [
        (one.type, one.k, Message("corner.at", x=one.x, y=one.y)) for one in corners.at
    ]:
        if kind not in TYPES:
            raise PlanError("corner.unknown-type-at", type=str(kind)[:20], where=where)
        if k is not None and not 0.0 < k < 1.0:
            raise PlanError("corner.bad-k-at", where=where, k=f"{k:g}")
    for one in corners.at:
        if not np.isfinite([one.x, one.y]).all():
            raise PlanError("corner.bad-place", x=one.x, y=one.y)


def found(corners: Corners, contours: list[Bends]) -> F64:
    """Return how far from each chosen place its corner is, (len(at),) mm.

    Parameters
    ----------
    contours
        Of every operation that mills beside a line.

    Raises
    ------
    PlanError
        There is no corner within ``NEAR`` of a place; it names what is there instead.
    """
    place = np.concatenate([np.zeros((0, 2)), *(one.place for one in contours)])
    turn = np.concatenate([np.zeros(0), *(one.turn for one in contours)])
    convex = turn > _STRAIGHT
    nearest = np.full(len(corners.at), np.inf)
    for row, one in enumerate(corners.at):
        away = np.hypot(*(place - np.add((one.x, one.y), corners.placement)).T)
        nearest[row] = away[convex].min(initial=np.inf)
        if nearest[row] <= NEAR:
            continue
        if (away[turn < -_STRAIGHT] <= NEAR).any():
            raise PlanError("corner.inside", x=one.x, y=one.y)
        order = np.argsort(away[convex])[:_NAMED]
        known = [
            f"({x:.2f}, {y:.2f})" for x, y in place[convex][order] - np.array(corners.placement)
        ]
        if not known:
            raise PlanError("corner.no-contour", within=NEAR, x=one.x, y=one.y)
        raise PlanError(
            "corner.not-found",
            within=NEAR,
            x=one.x,
            y=one.y,
            distance=nearest[row],
            known=known,
        )
    return nearest


def chosen(corners: Corners, nearest: F64, contour: Bends) -> tuple[U8, F64]:
    """Return type and knob at the beginning of every segment, (n,): ``AS_OTHERS`` and NaN mostly.

    Corners in one place, as of two contours that touch there, are chosen together.
    """
    kind = np.full(len(contour.turn), AS_OTHERS, np.uint8)
    k = np.full(len(contour.turn), np.nan)
    for one, away in zip(corners.at, nearest, strict=True):
        off = np.hypot(*(contour.place - np.add((one.x, one.y), corners.placement)).T)
        here: Bool = (contour.turn > _STRAIGHT) & (off <= away + JOIN)
        kind[here] = TYPES.index(one.type)
        k[here] = np.nan if one.k is None else one.k
    return kind, k
