"""The depth of a crease, which depends on its direction to the grain of the board.

A crease in the direction φ from the grain is a + (b - a) sin² φ deep, with the board's depths a
along and b across the grain.  Along an arc φ is the direction of the tangent.
"""

from __future__ import annotations

import numpy as np

from knifetip.model.board import Board
from knifetip.verification.columns import F64
from knifetip.verification.curves.curve import azimuth_at


def depth_towards(direction: F64, board: Board) -> F64:
    """Return the depths of creases with the directions ``direction`` (degrees), in mm.

    The result has the shape of ``direction``.
    """
    mean = 0.5 * (board.crease_along + board.crease_across)
    half = 0.5 * (board.crease_along - board.crease_across)
    result: F64 = mean + half * np.cos(np.radians(2.0 * (direction - board.grain)))
    return result


def with_chosen(depth: F64, chosen: F64) -> F64:
    """Return depths of creases, (n,) mm, where none is chosen, and else the chosen ones.

    ``chosen`` (n,) mm: depths that the user has chosen, NaN for none.
    """
    return np.where(np.isnan(chosen), depth, chosen)


def depth_range(curve: F64, place: F64, board: Board) -> tuple[F64, F64]:
    """Return the least and the greatest depth along parts of creases, (k,) mm each.

    Along an arc the depth has its extremes at the ends of the part, and where the tangent is along
    or across the grain.

    Parameters
    ----------
    curve : (k, 6)
        Lines and arcs as rows of six numbers (see ``curves.curve``).
    place : (k, 2) mm
        Positions on each curve at which the part starts and ends, in either order.
    """
    direction = np.stack([azimuth_at(curve, place[:, side]) for side in range(2)], axis=1)
    ends = depth_towards(direction, board)
    low, high = ends.min(axis=1), ends.max(axis=1)
    # Quarter turns from the grain: even numbers are along it, odd numbers across.
    quarter = np.sort(direction - board.grain, axis=1) / 90.0
    for parity, depth in ((0.0, board.crease_along), (1.0, board.crease_across)):
        # The first quarter turn of this parity that does not lie before the part.
        following = 2.0 * np.ceil((quarter[:, 0] - parity) / 2.0) + parity
        is_passed = following <= quarter[:, 1]
        low = np.where(is_passed, np.minimum(low, depth), low)
        high = np.where(is_passed, np.maximum(high, depth), high)
    return low, high
