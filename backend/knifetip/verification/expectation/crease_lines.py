"""The crease lines that the wheel must make, derived from the drawn creases.

A cut through a crease splits it, and the wheel keeps its clearance on both sides of the cut.  Three
or more collinear dashes may be made as one crease; this is assumed if the path of the wheel covers
one of the gaps between them.  On a board with double creases each drawn crease becomes two parallel
creases, one on each side of it, at half of the board's crease distance.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Final

import numpy as np

from knifetip.model.dieline import LineType
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.curve import azimuth_at, line_curves, point_at
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.edges import (
    JOIN_DISTANCE,
    STRAIGHT_ANGLE,
    TOUCH_DISTANCE,
    Edges,
    angle_between,
    edges_from_curves,
    pairs_within,
)

#: Greatest gap between dashes: mm, and ratio to their mean length.
MAX_DASH_GAP: Final = 12.0
MAX_GAP_RATIO: Final = 1.5
#: Greatest distance of a cut that lies on a crease, and greatest overlap of a cut that crosses it
#: (mm).
ON_DISTANCE: Final = 1e-4
CROSSING_LENGTH: Final = 0.01


def split_at_cuts(edges: Edges, cuts: Edges) -> tuple[Edges, F64]:
    """Return the creases ``edges``, split where cuts cross them, and the crossing points, (k, 2)
    mm.
    """
    crease, position = _cut_crossings(edges, cuts)
    crossings = point_at(edges.curve[crease], position)
    is_inner = (position > TOUCH_DISTANCE) & (position < edges.curve[crease, 5] - TOUCH_DISTANCE)
    crease, position = crease[is_inner], position[is_inner]
    count = len(edges)
    row = np.concatenate([np.arange(count), crease])
    low = np.concatenate([np.zeros(count), position])
    order = np.lexsort((low, row))
    row, low = row[order], low[order]
    last = np.append(row[1:] != row[:-1], True)
    high = np.where(last, edges.curve[row, 5], np.append(low[1:], 0.0))
    long_enough = high - low > 1e-6
    return _sub_edges(edges, row[long_enough], low[long_enough], high[long_enough]), crossings


def _cut_crossings(lines: Edges, cuts: Edges) -> tuple[I64, F64]:
    """Return the k points at which cuts cross lines and arcs.

    The result is the index of the line of each point, (k,), and the position of the point along
    that line, (k,) mm.  A cut crosses a line if the line meets the cut between the cut's ends.
    Cuts that end on a line at one point cross it there if they leave the line on both sides.
    """
    overlaps = cuts.find_overlaps(lines.curve, ON_DISTANCE)
    position, place = overlaps.along.mean(axis=1), overlaps.place.mean(axis=1)
    is_inner = (place > TOUCH_DISTANCE) & (place < cuts.curve[overlaps.edge, 5] - TOUCH_DISTANCE)
    is_inner &= np.diff(overlaps.along)[:, 0] < CROSSING_LENGTH
    touch = lines.touched_by_points(cuts.ends, TOUCH_DISTANCE)
    row, touch_position = touch.edge.astype(np.int64), touch.place[:, 0]
    side = np.sin(
        np.radians(cuts.outward[touch.curve] + 180.0 - azimuth_at(lines.curve[row], touch_position))
    )
    side[np.abs(side) * cuts.curve[touch.curve // 2, 5] <= TOUCH_DISTANCE] = 0.0
    order = np.lexsort((touch_position, row))
    row, touch_position, side = row[order], touch_position[order], side[order]
    new = np.ones(len(row), np.bool_)
    new[1:] = (row[1:] != row[:-1]) | (np.diff(touch_position) > TOUCH_DISTANCE)
    group = np.cumsum(new) - 1
    across = math.sin(math.radians(STRAIGHT_ANGLE))
    both = np.zeros((int(new.sum()), 2), np.bool_)
    both[group[side > across], 0] = True
    both[group[side < -across], 1] = True
    met = np.flatnonzero(new)[both.all(axis=1)]
    return (
        np.concatenate([overlaps.curve[is_inner].astype(np.int64), row[met]]),
        np.concatenate([position[is_inner], touch_position[met]]),
    )


def _sub_edges(edges: Edges, row: I64, low: F64, high: F64) -> Edges:
    """Return k parts of edges, as edges.

    Part i reaches from position ``low[i]`` to position ``high[i]`` (mm) on the edge with index
    ``row[i]``.
    """
    curve = edges.curve[row].copy()
    start, end = point_at(curve, low), point_at(curve, high)
    outward = np.stack([azimuth_at(curve, low) + 180.0, azimuth_at(curve, high)], axis=1)
    straight = curve[:, 0] == 0.0
    curve[straight, 1:3] = start[straight]
    bent = ~straight
    curve[bent, 4] += curve[bent, 0] * low[bent] / curve[bent, 3]
    curve[:, 5] = high - low
    return Edges(
        edges.row[row],
        curve,
        edges.line_type[row],
        np.stack([start, end], axis=1).reshape(-1, 2),
        outward.ravel(),
        np.degrees(np.arctan2(*(end - start).T[::-1])),
    )


def creased_gaps(edges: Edges, cuts: Edges, wheel_paths: F64, limit: float) -> Edges:
    """Return the gaps between collinear dashes that were made as one crease, as edges.

    Each gap gets the row in the dieline of one of the two dashes beside it.  Collinear dashes count
    as one crease if the wheel has creased a gap between them.  They also do if the wheel has
    touched only one of the dashes: a short crease is pressed at a single point.

    Parameters
    ----------
    edges
        The creases, some of which may be dashes.
    cuts
        The cuts.  A dash that touches a cut bounds a slot, not a gap.  A cut through a gap
        separates the dashes on its two sides.
    wheel_paths : (n, 6)
        Paths of the wheel: lines and arcs as rows of six numbers (see ``curves.curve``).
    limit : mm
        Greatest distance of the wheel from the dashes.
    """
    plain = np.flatnonzero((edges.curve[:, 0] == 0.0) & (edges.line_type == LineType.CREASE))
    dash = edges.select(plain)
    near, far = _facing_ends(dash)
    touched = np.zeros(len(dash.ends), np.bool_)
    touched[cuts.touched_by_points(dash.ends, TOUCH_DISTANCE).curve] = True
    near, far = near[~(touched[near] | touched[far])], far[~(touched[near] | touched[far])]
    unparted = np.ones(len(near), np.bool_)
    gaps = edges_from_curves(line_curves(dash.ends[near], dash.ends[far]))
    unparted[_cut_crossings(gaps, cuts)[0]] = False
    near, far = near[unparted], far[unparted]
    if len(near) == 0:
        return edges.select(np.zeros(0, np.int64))
    gap = np.hypot(*(dash.ends[near] - dash.ends[far]).T)
    # Group the dashes that gaps connect.
    name = np.arange(len(dash))
    for _ in range(len(dash)):
        least = name.copy()
        np.minimum.at(least, near // 2, name[far // 2])
        np.minimum.at(least, far // 2, name[near // 2])
        least = least[least]
        if np.array_equal(least, name):
            break
        name = least
    many = np.bincount(name, minlength=len(dash))
    total = np.bincount(name, dash.curve[:, 5], minlength=len(dash))
    widest = np.zeros(len(dash))
    np.maximum.at(widest, name[near // 2], gap)
    row_ = name[near // 2]
    good = (many[row_] >= 3) & (widest[row_] * many[row_] <= MAX_GAP_RATIO * total[row_] + 1e-6)
    near, far = near[good], far[good]
    curve = line_curves(dash.ends[near], dash.ends[far])
    overlaps = find_overlaps(wheel_paths, curve, np.zeros(len(curve)), curve[:, 5], limit)
    follows = np.abs(np.diff(overlaps.place)[:, 0]) > JOIN_DISTANCE
    run = name[near // 2]
    rolled = np.zeros(len(dash), np.bool_)
    rolled[run[overlaps.edge[follows]]] = True
    met = dash.find_overlaps(wheel_paths, limit).edge
    rolled |= np.bincount(name[np.unique(met)], minlength=len(dash)) == 1
    near, far, curve = near[rolled[run]], far[rolled[run]], curve[rolled[run]]
    heading = azimuth_at(curve, np.zeros(len(curve)))
    return Edges(
        dash.row[near // 2],
        curve,
        dash.line_type[near // 2],
        np.stack([dash.ends[near], dash.ends[far]], axis=1).reshape(-1, 2),
        np.stack([heading + 180.0, heading], axis=1).ravel(),
        heading,
    )


def _facing_ends(dash: Edges) -> tuple[I64, I64]:
    """Return the k pairs of ends of dashes that face each other across a gap.

    Returns the indices of the two ends of each pair, (k,) each: 2i is the start and 2i + 1 the end
    of dash i.  Each pair occurs once.
    """
    ahead = np.radians(dash.outward)
    step = (MAX_DASH_GAP + 1.0) * np.stack([np.cos(ahead), np.sin(ahead)], axis=1)
    overlaps = dash.find_overlaps(line_curves(dash.ends, dash.ends + step), TOUCH_DISTANCE)
    end = overlaps.curve.astype(np.int64)
    turn = angle_between(dash.outward[end], dash.chord[overlaps.edge], 180.0)
    distance = overlaps.along[:, 0]
    good = (
        (overlaps.edge != end // 2)
        & (turn <= STRAIGHT_ANGLE)
        & (np.diff(overlaps.along)[:, 0] > 0.0)
    )
    end, edge, distance, place = (
        end[good],
        overlaps.edge[good],
        distance[good],
        overlaps.place[good, 0],
    )
    order = np.lexsort((distance, end))
    first = order[np.unique(end[order], return_index=True)[1]]
    end, edge, distance, place = end[first], edge[first], distance[first], place[first]
    other = 2 * edge.astype(np.int64) + (place > 0.5 * dash.curve[edge, 5])
    faced = np.full(2 * len(dash), -1, np.int64)
    gap = (distance > JOIN_DISTANCE) & (distance <= MAX_DASH_GAP)
    faced[end[gap]] = other[gap]
    mutual = (faced >= 0) & (faced[np.maximum(faced, 0)] == np.arange(2 * len(dash)))
    one = np.flatnonzero(mutual & (np.arange(2 * len(dash)) < faced))
    return one, faced[one]


def concatenate_edges(edges: Edges, more: Edges) -> Edges:
    """Return one record that contains all edges of ``edges``, followed by all edges of ``more``."""
    if len(more) == 0:
        return edges
    return Edges(
        *(
            np.concatenate([getattr(edges, name), getattr(more, name)])
            for name in ("row", "curve", "line_type", "ends", "outward", "chord")
        )
    )


def double_lines(edges: Edges, distance: float) -> Edges:
    """Return two parallels of each edge, half of ``distance`` (mm) to its left and to its right.

    The left parallels of all edges come first, then the right parallels.
    """
    sides = []
    for half in (0.5 * distance, -0.5 * distance):
        curve = edges.curve.copy()
        straight = curve[:, 0] == 0.0
        left = np.stack([-curve[:, 4], curve[:, 3]], axis=1)
        curve[straight, 1:3] += half * left[straight]
        bent = ~straight
        radius = curve[bent, 3] - curve[bent, 0] * half
        curve[bent, 5] *= radius / curve[bent, 3]
        curve[bent, 3] = radius
        ends = np.stack(
            [point_at(curve, np.zeros(len(curve))), point_at(curve, curve[:, 5])], axis=1
        )
        sides.append(replace(edges, curve=curve, ends=ends.reshape(-1, 2)))
    return concatenate_edges(*sides)


def ends_at(edges: Edges, points: F64) -> Bool:
    """Return the mask of the 2n ends of n edges that touch one of the points ``points``, (2n,).

    ``points`` is (k, 2) mm.  End 2i is the start of edge i, and end 2i + 1 is its end.
    """
    result = np.zeros(len(edges.ends), np.bool_)
    result[pairs_within(edges.ends, points, TOUCH_DISTANCE)[0]] = True
    return result
