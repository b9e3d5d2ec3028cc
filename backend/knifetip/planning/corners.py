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
from knifetip.model.corners import AS_OTHERS, TYPES, CornerAt, Corners

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


def distances_to_corners(
    corners: Corners, placement: tuple[float, float], contours: list[Bends]
) -> F64:
    """Return the distance (mm) from each position that the user chose to the nearest corner, (m,).

    The m positions are those in ``corners.at``.  Corners concave for the tool are left out.

    Parameters
    ----------
    corners
        Corner types that the user chose; ``at`` contains the choices for single positions.
    placement : mm
        Position of the origin of the drawing on the sheet.
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
        distance = np.hypot(*(position - np.add((choice.x, choice.y), placement)).T)
        nearest[row] = distance[convex].min(initial=np.inf)
        if nearest[row] <= NEAR:
            continue
        if (distance[turn < -_STRAIGHT] <= NEAR).any():
            raise PlanError("corner.inside", x=choice.x, y=choice.y)
        order = np.argsort(distance[convex])[:_LISTED]
        nearby = [f"({x:.2f}, {y:.2f})" for x, y in position[convex][order] - np.array(placement)]
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


def match_choices_to_bends(
    corners: Corners, placement: tuple[float, float], nearest: F64, bends: Bends
) -> tuple[U8, F64]:
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
    placement : mm
        Position of the origin of the drawing on the sheet.
    nearest : (m,) mm
        Distance between each of m positions in ``corners.at`` and the nearest corner.
    bends
        Bends of one operation, one for each of n segments.
    """
    kind = np.full(len(bends.turn), AS_OTHERS, np.uint8)
    k = np.full(len(bends.turn), np.nan)
    for choice, corner_distance in zip(corners.at, nearest, strict=True):
        distance = _distances(choice, placement, bends.position)
        here: Bool = (bends.turn > _STRAIGHT) & (distance <= corner_distance + JOIN)
        kind[here] = TYPES.index(choice.type)
        k[here] = np.nan if choice.k is None else choice.k
    return kind, k


def _distances(choice: CornerAt, placement: tuple[float, float], position: F64) -> F64:
    """Return the distances of positions on the sheet, (n, 2) mm, from a chosen one, (n,) mm."""
    result: F64 = np.hypot(*(position - np.add((choice.x, choice.y), placement)).T)
    return result
