"""Find the ends of cuts ahead of which waste lies, so that a blade may run past them."""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.verification.columns import Bool
from knifetip.verification.curves.curve import azimuth_at
from knifetip.verification.curves.group_order import order_in_groups
from knifetip.verification.expectation.edges import TOUCH_DISTANCE, Edges, angle_between
from knifetip.verification.expectation.outline import find_divided_outlines

#: A cut that makes a smaller angle with an outline runs along it (degrees).
_ALONG_OUTLINE: Final = 5.0


def waste_ahead(edges: Edges, cuts: Edges) -> Bool:
    """Return the mask of the 2n ends of n edges ahead of which waste lies, (2n,).

    End 2i is the start of edge i, and end 2i + 1 is its end.

    At an end on an outline, the outline's curves leave the end in two or more directions.  Between
    neighbouring directions lies either board or waste; the side of the direction that is next
    clockwise decides.  Waste is the surroundings of the parts and the inside of holes.  No waste
    lies ahead of an end that touches no outline, or of a line that runs along one.

    Parameters
    ----------
    edges
        The n lines.
    cuts
        All cuts.
    """
    outlined = find_divided_outlines(cuts)
    ahead, curves = edges.outward, outlined.edges.curve
    touches = outlined.edges.touched_by_points(edges.ends, TOUCH_DISTANCE)
    keep = np.flatnonzero(outlined.closing[touches.edge])
    end, cut, place = touches.curve[keep], touches.edge[keep], touches.place[keep, 0]
    forward = azimuth_at(curves[cut], place)
    onward = curves[cut, 5] - place > TOUCH_DISTANCE
    back = place > TOUCH_DISTANCE
    # Beside a corner of the outline, an end may touch only the curve that ends there: beyond its
    # end, this curve is taken to continue.
    alone = np.bincount(end, onward.astype(np.int64) + back, minlength=len(ahead))[end] == 1
    onward |= alone
    back |= alone
    left = outlined.board_left[cut]
    at = np.concatenate([end[onward], end[back]])
    direction = np.concatenate([forward[onward], forward[back] + 180.0])
    board_left = np.concatenate([left[onward], ~left[back]])
    turn = (ahead[at] - direction) % 360.0
    # The last row of each end is the direction that is next clockwise.
    order = order_in_groups(at, -turn, turn)
    result = np.zeros(len(ahead), np.bool_)
    result[at[order]] = ~board_left[order]
    along = angle_between(ahead[at], direction) <= _ALONG_OUTLINE
    result[at[along]] = False
    return result
