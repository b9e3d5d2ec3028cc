"""Find which dropped edges belong to loops beside a corner of the outline that remains.

Cleaning may drop edges that curl at a corner.  A group of dropped edges that touch each other is
such a loop if it is nowhere farther than ``LOOP`` from a corner at which two remaining edges of its
line type meet, and if this corner lies on the group.  So the remaining outline passes the loop, and
what is missing is narrower than any tool.  At the end of one remaining edge, nothing of the group
may be farther than ``END_LOOP``.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.model.cleaned import Stretches
from knifetip.model.dieline import Dieline
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.expectation.edges import JOIN_DISTANCE, TOUCH_DISTANCE, pairs_within
from knifetip.verification.expectation.outline import lowest_connected

#: Greatest distance of a loop from its corner, and greatest length of its edges (mm).
LOOP: Final = 0.3
#: Greatest distance of a loop from the end of the only edge that leads to it (mm).
END_LOOP: Final = 0.1


def are_corner_loops(drawn: Dieline, after: Dieline, parts: Stretches, dropped: I64) -> Bool:
    """Return the mask of the m dropped stretches that belong to loops at corners, (m,).

    Parameters
    ----------
    drawn, after
        Dieline before and after cleaning.
    parts, dropped
        Stretches of the drawn edges, and the indices of the m dropped ones.
    """
    result = np.zeros(len(dropped), np.bool_)
    whole = (parts.begin[dropped] == 0.0) & (parts.end[dropped] == 1.0)
    rows = parts.row[dropped].astype(np.int64)
    small = np.abs(drawn.bulge[rows]) <= 1.0 + 1e-9
    small &= np.hypot(*(drawn.ends[rows, 1] - drawn.ends[rows, 0]).T) <= LOOP
    chosen = np.flatnonzero(whole & small)
    if len(chosen) == 0:
        return result
    rows = rows[chosen]
    points = drawn.ends[rows].reshape(-1, 2)
    one, other = pairs_within(points, points, JOIN_DISTANCE)
    names = lowest_connected(one // 2, other // 2, len(rows))
    group = np.unique(names, return_inverse=True)[1].reshape(-1)
    count = int(group.max()) + 1
    types = np.zeros(count, np.uint8)
    types[group] = drawn.line_type[rows]
    right = np.ones(count, np.bool_)
    right[group[drawn.line_type[rows] != types[group]]] = False

    kept = after.ends.reshape(-1, 2)
    point, corner = pairs_within(points, kept, TOUCH_DISTANCE + JOIN_DISTANCE)
    owner = group[point // 2]
    alike = after.line_type[corner // 2] == types[owner]
    owner, corner = owner[alike], corner[alike]
    reach = np.full(count, np.inf)
    place = np.zeros((count, 2))
    limit = np.zeros(count)
    for own, end, greatest in (
        (owner, corner, END_LOOP),
        (*_where_two_meet(kept, owner, corner), LOOP),
    ):
        place[own], limit[own] = kept[end], greatest + TOUCH_DISTANCE
        reach[own] = 0.0
    np.maximum.at(reach, np.repeat(group, 2), np.hypot(*(points - place[np.repeat(group, 2)]).T))
    result[chosen] = (right & (reach <= limit))[group]
    return result


def _where_two_meet(kept: F64, owner: I64, corner: I64) -> tuple[I64, I64]:
    """Return the pairs of a group and an end at which another such end of the same group lies.

    ``kept`` (2k, 2) mm: ends of the remaining edges.
    ``owner``, ``corner`` (q,): pairs of a group of dropped edges and the index of an end beside it.
    """
    pairs = np.unique(np.column_stack([owner, corner]), axis=0)
    owner, corner = pairs[:, 0], pairs[:, 1]
    one, other = pairs_within(kept[corner], kept[corner], JOIN_DISTANCE)
    meet = (owner[one] == owner[other]) & (corner[one] // 2 != corner[other] // 2)
    found = np.unique(one[meet])
    return owner[found], corner[found]
