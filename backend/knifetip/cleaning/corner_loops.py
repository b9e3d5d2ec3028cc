"""corner_loops: find loops of short edges at corners of outlines and at ends of cuts.

Some generators move each line outwards by half the width of a laser beam and connect the moved
lines with a curl of a tenth of a millimetre, which returns to the point at which it began.  No tool
can follow it, and the outline is complete without it.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.cleaning.end_points import connected_edges
from knifetip.geometry.columns import F64, I64, U8, Bool
from knifetip.geometry.tolerance import GAP

#: Edges shorter than this may belong to a loop (mm).
SHORT: Final = 0.25
#: Greatest diagonal of a loop through which an outline passes (mm).
_LOOP: Final = 0.3
#: Greatest diagonal of a loop at the end of a single edge (mm).
_END_LOOP: Final = 2.0 * GAP


def find_corner_loops(ends: F64, kind: U8, length: F64, drawn_length: F64, place: I64) -> Bool:
    """Return the mask of the edges that belong to loops at corners or ends, (k,).

    A loop consists of connected short edges of one line type that enclose something.  At least one
    longer edge of this type ends at it, and all longer edges that end at it do so within ``GAP`` of
    each other.  Its diagonal is at most 0.3 mm, or 0.1 mm if only one longer edge ends at it.

    Parameters
    ----------
    ends, kind : (k, 2, 2) mm and (k,)
        Ends and line types of the edges.
    length, drawn_length : (k,) mm
        Length of each edge, and of the longest drawn edge of which it is a part.
    place : (2k,)
        Point of each end, from ``find_end_points``.
    """
    result = np.zeros(len(kind), np.bool_)
    short = (length < SHORT) & (drawn_length < SHORT)
    rows = np.flatnonzero(short)
    if len(rows) == 0:
        return result
    at = place.reshape(-1, 2)[rows]
    points, numbers = np.unique(at, return_inverse=True)
    group = connected_edges(np.ascontiguousarray(numbers.reshape(-1), dtype=np.int64))
    names, group = np.unique(group, return_inverse=True)
    count = len(names)
    group_of_point = np.zeros(len(points), np.int64)
    group_of_point[numbers.reshape(-1)] = np.repeat(group, 2)
    edges = np.bincount(group, minlength=count)
    vertices = np.bincount(group_of_point, minlength=count)
    loops = edges >= vertices
    types = np.zeros(count, np.uint8)
    types[group] = kind[rows]
    mixed = np.zeros(count, np.bool_)
    mixed[group[kind[rows] != types[group]]] = True

    found = np.searchsorted(points, place)
    is_host = ~np.repeat(short, 2) & (found < len(points))
    is_host[is_host] = points[found[is_host]] == place[is_host]
    hosts = np.flatnonzero(is_host)
    host_group = group_of_point[found[hosts]]
    alike = kind[hosts // 2] == types[host_group]
    host_count = np.bincount(host_group[alike], minlength=count)
    largest = np.where(host_count > 1, _LOOP, _END_LOOP)
    loops &= ~mixed & (host_count > 0)
    loops &= _diagonals(ends[rows], np.repeat(group, 2), count) <= largest
    loops &= _diagonals(ends.reshape(-1, 2)[hosts], host_group, count) <= GAP
    result[rows] = loops[group]
    return result


def _diagonals(points: F64, group: I64, count: int) -> F64:
    """Return the diagonal of the rectangle around the points of each group, (count,) mm.

    ``points`` has q points in rows of two coordinates, and ``group`` is the group of each, (q,).
    """
    points = points.reshape(-1, 2)
    low, high = np.full((count, 2), np.inf), np.full((count, 2), -np.inf)
    np.minimum.at(low, group, points)
    np.maximum.at(high, group, points)
    diagonal: F64 = np.hypot(*(high - low).T)
    return diagonal
