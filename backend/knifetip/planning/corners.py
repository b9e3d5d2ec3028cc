"""corners: find the corners of contours for which the user has chosen a corner type.

A corner is a joint of two segments of a path whose bend is convex for the tool.  At a concave bend
the tool can move in only one way, so there is nothing to choose.
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

#: Greatest distance of a chosen position from its corner (mm).
NEAR: Final = 0.5
#: Bends by less than this are no corners (radians).
_STRAIGHT: Final = 1e-9
#: Number of nearby corners that an error lists.
_LISTED: Final = 3


@dataclass(frozen=True, eq=False, slots=True)
class Bends:
    """Positions and angles of the bends at the starts of n segments of contours.

    The positions are in sheet coordinates.
    """

    position: F64  #: (n, 2) mm
    turn: F64  #: (n,) radians, > 0 if convex for the tool; 0 at the start of an open path


def find_bends(paths: Paths, side: int) -> Bends:
    """Return the bend between every segment of the paths and the segment before it.

    ``side`` is +1 if the tool is on the left of the paths, and -1 if it is on the right.
    """
    ahead, arriving = arc.tangents(paths.start, paths.end, paths.bulge)
    first, last = paths.first[:-1], paths.first[1:] - 1
    before = np.roll(arriving, 1, axis=0)
    before[first] = np.where(paths.closed[:, None], arriving[last], ahead[first])
    cross = before[:, 0] * ahead[:, 1] - before[:, 1] * ahead[:, 0]
    turn: F64 = np.arctan2(-side * cross, (before * ahead).sum(axis=1))
    return Bends(paths.start, turn)


def check_choices(corners: Corners) -> None:
    """Raise ``PlanError`` if the corner type, parameter k, position or interference mode that the
    user chose for a corner is invalid.
    """
    if corners.interference not in INTERFERENCES:
        raise PlanError("corner.bad-interference", interference=corners.interference)
    for kind, k, location in [(corners.type, corners.k, None)] + [
        (choice.type, choice.k, Message("corner.at", x=choice.x, y=choice.y))
        for choice in corners.at
    ]:
        if kind not in TYPES:
            raise PlanError("corner.unknown-type-at", type=str(kind)[:20], where=location)
        if k is not None and not 0.0 < k < 1.0:
            raise PlanError("corner.bad-k-at", where=location, k=f"{k:g}")
    for choice in corners.at:
        if not np.isfinite([choice.x, choice.y]).all():
            raise PlanError("corner.bad-place", x=choice.x, y=choice.y)


def distances_to_corners(corners: Corners, contours: list[Bends]) -> F64:
    """Return the distance (mm) from each position that the user chose to the nearest corner, (m,).

    The m positions are those in ``corners.at``.  Corners concave for the tool are left out.

    Parameters
    ----------
    corners
        Corner types that the user chose; ``at`` contains the choices for single positions.
    contours
        Bends of the contours, for every operation in which the cutter mills contours.

    Raises
    ------
    PlanError
        There is no corner within ``NEAR`` mm of a position; the error lists the nearest corners.
    """
    position = np.concatenate([np.zeros((0, 2)), *(bends.position for bends in contours)])
    turn = np.concatenate([np.zeros(0), *(bends.turn for bends in contours)])
    convex = turn > _STRAIGHT
    nearest = np.full(len(corners.at), np.inf)
    for row, choice in enumerate(corners.at):
        distance = np.hypot(*(position - np.add((choice.x, choice.y), corners.placement)).T)
        nearest[row] = distance[convex].min(initial=np.inf)
        if nearest[row] <= NEAR:
            continue
        if (distance[turn < -_STRAIGHT] <= NEAR).any():
            raise PlanError("corner.inside", x=choice.x, y=choice.y)
        order = np.argsort(distance[convex])[:_LISTED]
        nearby = [
            f"({x:.2f}, {y:.2f})" for x, y in position[convex][order] - np.array(corners.placement)
        ]
        if not nearby:
            raise PlanError("corner.no-contour", within=NEAR, x=choice.x, y=choice.y)
        raise PlanError(
            "corner.not-found",
            within=NEAR,
            x=choice.x,
            y=choice.y,
            distance=nearest[row],
            known=nearby,
        )
    return nearest


def choices_at_bends(corners: Corners, nearest: F64, bends: Bends) -> tuple[U8, F64]:
    """Return the corner type and its parameter k that the user chose for each bend, (n,) each.

    Bend i is at the start of segment i.  For a bend without a choice, the returned type is
    ``AS_OTHERS``, which means the type that the user set for all corners, and the returned k is
    NaN.  k is also NaN if the user gave no k.  The choice for a position applies to all bends
    at the distance from this position that ``nearest`` states: several bends if, for instance, two
    contours touch at the corner.

    Parameters
    ----------
    corners
        Corner types that the user chose; ``at`` contains the choices for single positions.
    nearest : (m,) mm
        Distance between each of m positions in ``corners.at`` and the nearest corner.
    bends
        Bends of one operation, one for each of n segments.
    """
    kind = np.full(len(bends.turn), AS_OTHERS, np.uint8)
    k = np.full(len(bends.turn), np.nan)
    for choice, corner_distance in zip(corners.at, nearest, strict=True):
        distance = np.hypot(*(bends.position - np.add((choice.x, choice.y), corners.placement)).T)
        here: Bool = (bends.turn > _STRAIGHT) & (distance <= corner_distance + JOIN)
        kind[here] = TYPES.index(choice.type)
        k[here] = np.nan if choice.k is None else choice.k
    return kind, k
