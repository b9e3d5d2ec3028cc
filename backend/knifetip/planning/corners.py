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
        raise PlanError(
            f"{corners.interference!r} is nothing to do where the cutter does not fit.",
            "Say trim or refuse.",
        )
    for kind, k, where in [(corners.type, corners.k, "")] + [
        (one.type, one.k, f" at ({one.x:g}, {one.y:g})") for one in corners.at
    ]:
        if kind not in TYPES:
            raise PlanError(
                f"There is no corner type {str(kind)[:20]!r}{where}.", "There are B, C, D and auto."
            )
        if k is not None and not 0.0 < k < 1.0:
            raise PlanError(
                f"The knob k{where} is {k:g}, and a D corner has one between 0 and 1.",
                "Choose B instead of 0, and C instead of 1.",
            )
    for one in corners.at:
        if not np.isfinite([one.x, one.y]).all():
            raise PlanError(
                f"A corner is said to be at ({one.x}, {one.y}), which is no place.",
                "Give X and Y in the drawing's millimetres.",
            )


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
            raise PlanError(
                f"The corner at ({one.x:g}, {one.y:g}) is an inside corner for the cutter, which "
                "goes round it in one way only.",
                "Choose types for corners that stand out towards the cutter.",
            )
        order = np.argsort(away[convex])[:_NAMED]
        known = ", ".join(
            f"({x:.2f}, {y:.2f})" for x, y in place[convex][order] - np.array(corners.placement)
        )
        raise PlanError(
            f"No corner of a milled contour is within {NEAR:g} mm of ({one.x:g}, {one.y:g})"
            + (f": the nearest is {nearest[row]:.2f} mm away." if known else "."),
            f"Give its X and Y in the drawing's millimetres: the nearest are {known}."
            if known
            else "This drawing has no contour that the cutter mills round corners.",
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
