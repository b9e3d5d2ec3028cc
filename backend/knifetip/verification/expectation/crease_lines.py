"""The crease lines that the wheel must make, derived from the drawn creases.

A cut through a crease splits it, and the wheel keeps its clearance on both sides of the cut.  Three
or more collinear dashes may be made as one crease; this is assumed if the path of the wheel covers
one of the gaps between them, or if the wheel must stop before all of them because cuts cross the
dashes.  On a board with double creases each drawn crease becomes two parallel
creases, one on each side of it, at half of the board's crease distance.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Final, NamedTuple

import numpy as np

from knifetip.model.dieline import LineType
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.curve import azimuth_at, line_curves, point_at
from knifetip.verification.curves.intervals import Overlaps
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.edge_paths import EdgePaths, edge_paths, link_ends
from knifetip.verification.expectation.edges import (
    JOIN_DISTANCE,
    LIMIT_SLACK,
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
#: Fraction by which a gap in which the wheel need not work may differ from the other gaps.
GAP_DIFFERENCE: Final = 0.25
#: Greatest distance of a cut that lies on a crease, and greatest overlap of a cut that crosses it
#: (mm).
ON_DISTANCE: Final = 1e-4
CROSSING_LENGTH: Final = 2.0 * ON_DISTANCE / math.sin(math.radians(STRAIGHT_ANGLE))


class CutCrossings(NamedTuple):
    """k points at which cuts cross creases."""

    points: F64  #: (k, 2) mm
    azimuth: F64  #: (k,) degrees, direction of the crease that is crossed there


def split_at_cuts(edges: Edges, cuts: Edges) -> tuple[Edges, CutCrossings]:
    """Return the creases ``edges``, split where cuts cross them, and these crossings.

    A crease has no part between two crossings that are at most ``TOUCH_DISTANCE`` apart.  It is not
    split at crossings up to this distance from its free end, where no other crease is linked to it.
    """
    crossing = _cut_crossings(edges, cuts)
    crossed = edges.curve[crossing.edge]
    crossings = CutCrossings(
        point_at(crossed, crossing.position), azimuth_at(crossed, crossing.position)
    )
    paths = crossing.paths
    length, path = paths.length[crossing.path], crossing.path
    closed = paths.first[path] < 0
    margin = TOUCH_DISTANCE + LIMIT_SLACK
    kept = closed | ((crossing.place > margin) & (crossing.place < length - margin))
    edge, position = crossing.edge[kept], crossing.position[kept]
    path, place = path[kept], crossing.place[kept]
    # A crossing at a joint splits none of the two edges.
    inside = (position > JOIN_DISTANCE) & (position < edges.curve[edge, 5] - JOIN_DISTANCE)
    row = np.concatenate([np.arange(len(edges)), edge[inside]])
    low = np.concatenate([np.zeros(len(edges)), position[inside]])
    order = np.lexsort((low, row))
    row, low = row[order], low[order]
    last = np.append(row[1:] != row[:-1], True)
    high = np.where(last, edges.curve[row, 5], np.append(low[1:], 0.0))
    middle = 0.5 * (low + high)
    middle = np.where(paths.flipped[row], edges.curve[row, 5] - middle, middle)
    gone = _between_crossings(path, place, paths.path[row], paths.begin[row] + middle)
    remains = (high - low > 1e-6) & ~gone
    return _sub_edges(edges, row[remains], low[remains], high[remains]), crossings


def _between_crossings(path: I64, place: F64, owner: I64, middle: F64) -> Bool:
    """Return whether each of m points lies between two neighbouring crossings that are at most
    ``TOUCH_DISTANCE`` apart, (m,).

    ``path``, ``place`` (k,) and (k,) mm: path of each crossing, and its distance from the start of
    the path.
    ``owner``, ``middle`` (m,) and (m,) mm: path of each point, and its distance from the start of
    the path.
    """
    if len(path) < 2:
        return np.zeros(len(owner), np.bool_)
    order = np.lexsort((place, path))
    path, place = path[order], place[order]
    close = (path[1:] == path[:-1]) & (np.diff(place) <= TOUCH_DISTANCE + LIMIT_SLACK)
    wide = float(max(place.max(), middle.max(initial=0.0))) + 1.0
    before = np.searchsorted(path * wide + place, owner * wide + middle) - 1
    between = (before >= 0) & (before < len(close))
    before = np.clip(before, 0, len(close) - 1)
    result: Bool = between & close[before] & (path[before] == owner)
    return result


@dataclass(frozen=True, eq=False, slots=True)
class _Crossings:
    """k points at which cuts cross creases, and the paths that the creases form."""

    edge: I64  #: (k,) index of the crease
    position: F64  #: (k,) mm from the start of the crease
    path: I64  #: (k,) path of the crease
    place: F64  #: (k,) mm from the start of the path
    paths: EdgePaths


def _cut_crossings(lines: Edges, cuts: Edges) -> _Crossings:
    """Return the points at which cuts cross lines and arcs.

    A cut crosses a line if the line meets the cut between the cut's ends, but not if it only
    touches the line, as the tangent of an arc does.  Cuts also cross a line if they end on the path
    of the line, leave the path on both sides, and their ends follow each other along the path at
    most ``TOUCH_DISTANCE`` apart.
    """
    limit = TOUCH_DISTANCE + LIMIT_SLACK
    link = link_ends(lines, STRAIGHT_ANGLE)[0]
    paths = edge_paths(lines, link)
    overlaps = cuts.find_overlaps(lines.curve, ON_DISTANCE)
    position, place = overlaps.along.mean(axis=1), overlaps.place.mean(axis=1)
    is_inner = (place > limit) & (place < cuts.curve[overlaps.edge, 5] - limit)
    is_inner &= np.diff(overlaps.along)[:, 0] < CROSSING_LENGTH
    touch = lines.touched_by_points(cuts.ends, limit)
    touch = touch.select(~_met_on_linked_edge(touch, cuts.ends, lines, link))
    row, touch_position = touch.edge.astype(np.int64), touch.place[:, 0]
    side = np.sin(
        np.radians(cuts.outward[touch.curve] + 180.0 - azimuth_at(lines.curve[row], touch_position))
    )
    across = math.sin(math.radians(STRAIGHT_ANGLE))
    leaves = np.abs(side) > across
    leaves &= np.abs(side) * cuts.curve[touch.curve // 2, 5] > limit
    row, touch_position = row[leaves], touch_position[leaves]
    on_left = (side[leaves] > 0.0) != paths.flipped[row]
    along = _places(lines, paths, row, touch_position)
    path = paths.path[row]
    order = np.lexsort((along, path))
    row, touch_position, on_left = row[order], touch_position[order], on_left[order]
    along, path = along[order], path[order]
    new = np.ones(len(row), np.bool_)
    new[1:] = (path[1:] != path[:-1]) | (np.diff(along) > limit)
    group = np.cumsum(new) - 1
    count = int(new.sum())
    left, right = (np.bincount(group[one], minlength=count) for one in (on_left, ~on_left))
    met = ((left > 0) & (right > 0))[group]
    edge = np.concatenate([overlaps.curve[is_inner].astype(np.int64), row[met]])
    position = np.concatenate([position[is_inner], touch_position[met]])
    return _Crossings(
        edge, position, paths.path[edge], _places(lines, paths, edge, position), paths
    )


def _met_on_linked_edge(touch: Overlaps, points: F64, lines: Edges, link: I64) -> Bool:
    """Return the mask of the k touches of points with edges to which a linked edge is nearer, (k,).

    Near a joint of two edges a point touches both, but it meets their path at one place only.

    ``touch``: touches of points with edges, as overlaps of curves of length 0.
    ``points`` (n, 2) mm: the points.
    ``lines``, ``link``: the edges, and the index of the end to which each of their 2m ends is
    linked, (2m,), or -1.
    """
    result = np.zeros(len(touch.curve), np.bool_)
    if len(result) == 0:
        return result
    point, edge = touch.curve.astype(np.int64), touch.edge.astype(np.int64)
    foot = point_at(lines.curve[edge], touch.place[:, 0])
    distance = np.hypot(*(foot - points[point]).T)
    key = point * len(lines) + edge
    order = np.argsort(key)
    for end in (2 * edge, 2 * edge + 1):
        wanted = point * len(lines) + link[end] // 2
        found = order[np.searchsorted(key, wanted, sorter=order).clip(max=len(key) - 1)]
        linked = (link[end] >= 0) & (key[found] == wanted)
        result |= linked & (distance[found] < distance - LIMIT_SLACK)
    return result


def _places(lines: Edges, paths: EdgePaths, edge: I64, position: F64) -> F64:
    """Return the distances of k points from the start of the path of their edge, (k,) mm.

    ``lines``, ``paths``: the edges, and the paths that they form.
    ``edge``, ``position`` (k,) and (k,) mm: edge of each point, and its distance from the start of
    the edge.
    """
    onward = np.where(paths.flipped[edge], lines.curve[edge, 5] - position, position)
    return paths.begin[edge] + onward


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


def creased_gaps(edges: Edges, cuts: Edges, wheel_paths: F64, limit: float, stop: F64) -> Edges:
    """Return the gaps between collinear dashes that were made as one crease, as edges.

    Each gap gets the row in the dieline of one of the two dashes beside it.  Collinear dashes count
    as one crease if the wheel has rolled or pressed a gap between them.  They also do if the wheel
    has touched only one of the dashes, since a short crease is pressed at a single point, and the
    gap is as wide as the other gaps.  A gap that the wheel has left out separates two creases if
    the wheel has worked on the dashes on both sides, or has stopped before the gap as before a free
    end, unless it is as wide as the other gaps and the wheel must stop before it in any case,
    because a cut crosses the dash beyond it.

    Parameters
    ----------
    edges
        The creases, some of which may be dashes.
    cuts
        The cuts.  A dash that touches a cut bounds a slot, not a gap.  So do two dashes that reach
        into a slot by less than its other part in total.  A cut through a gap separates the dashes
        on its two sides.
    wheel_paths : (n, 6)
        Paths of the wheel: lines and arcs as rows of six numbers (see ``curves.curve``).
    limit : mm
        Greatest distance of the wheel from the dashes.
    stop : (n,) mm
        Distance from a cut through each crease at which the wheel stops.
    """
    plain = np.flatnonzero((edges.curve[:, 0] == 0.0) & (edges.line_type == LineType.CREASE))
    dash = edges.select(plain)
    near, far = _facing_ends(dash)
    touched = np.zeros(len(dash.ends), np.bool_)
    touched[cuts.touched_by_points(dash.ends, TOUCH_DISTANCE).curve] = True
    near, far = near[~(touched[near] | touched[far])], far[~(touched[near] | touched[far])]
    unparted = np.ones(len(near), np.bool_)
    gaps = edges_from_curves(line_curves(dash.ends[near], dash.ends[far]))
    unparted[_cut_crossings(gaps, cuts).edge] = False
    to_cut = _distances_to_crossings(dash, cuts)
    unparted &= to_cut[near] + to_cut[far] >= gaps.curve[:, 5] - LIMIT_SLACK
    near, far = near[unparted], far[unparted]
    if len(near) == 0:
        return edges.select(np.zeros(0, np.int64))
    curve = line_curves(dash.ends[near], dash.ends[far])
    made, unworked = _gaps_made(dash, curve, wheel_paths, limit)
    met = np.isfinite(unworked[::2])
    # The wheel stops before a gap because of a cut beyond it.
    beyond = np.minimum(to_cut[near], to_cut[far])
    hidden = ~made & (beyond + curve[:, 5] <= stop[plain][near // 2] + LIMIT_SLACK)
    # A gap between two dashes that the wheel makes is made too, or separates two creases.  It also
    # separates them if the wheel stops before it as before a free end.
    apart = met[near // 2] & met[far // 2]
    for end in (near, far):
        apart |= met[end // 2] & (unworked[end] >= stop[plain][end // 2] - TOUCH_DISTANCE)
    joins = made | hidden | ~apart
    near, far, curve = near[joins], far[joins], curve[joins]
    made, hidden = made[joins], hidden[joins]
    name = _group_dashes(len(dash), near // 2, far // 2)
    joins = made | _are_alike(curve[:, 5], name[near // 2], made)
    near, far, curve = near[joins], far[joins], curve[joins]
    made, hidden = made[joins], hidden[joins]
    name = _group_dashes(len(dash), near // 2, far // 2)
    many = np.bincount(name, minlength=len(dash))
    total = np.bincount(name, dash.curve[:, 5], minlength=len(dash))
    widest = np.zeros(len(dash))
    np.maximum.at(widest, name[near // 2], curve[:, 5])
    run = name[near // 2]
    good = (many[run] >= 3) & (widest[run] * many[run] <= MAX_GAP_RATIO * total[run] + 1e-6)
    near, far, curve, made, run = near[good], far[good], curve[good], made[good], run[good]
    hidden = hidden[good]
    rolled = np.bincount(name[met], minlength=len(dash)) == 1
    rolled[run[made]] = True
    is_shown = np.bincount(run[~hidden], minlength=len(dash)) > 0
    rolled[run[hidden & ~is_shown[run]]] = True
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


def _distances_to_crossings(dash: Edges, cuts: Edges) -> F64:
    """Return the distance of each end of n dashes from the nearest cut across the dash, (2n,) mm.

    The distance is inf where no cut crosses the dash.
    """
    crossing = _cut_crossings(dash, cuts)
    nearest = np.full(2 * len(dash), np.inf)
    np.minimum.at(nearest, 2 * crossing.edge, crossing.position)
    np.minimum.at(nearest, 2 * crossing.edge + 1, dash.curve[crossing.edge, 5] - crossing.position)
    return nearest


def _are_alike(width: F64, run: I64, made: Bool) -> Bool:
    """Return the mask of the k gaps that are as wide as the other gaps of their run, (k,).

    ``width`` (k,) mm and ``run`` (k,) are the width of each gap and the number of its run, and
    ``made`` (k,) is whether the wheel has worked in it.  The gaps that are made are compared with,
    all gaps of a run if none is made.
    """
    count = int(run.max(initial=-1)) + 1
    counts = made | (np.bincount(run[made], minlength=count) == 0)[run]
    mean = np.bincount(run, width * counts, count) / np.maximum(np.bincount(run, counts, count), 1)
    return np.asarray(np.abs(width - mean[run]) <= GAP_DIFFERENCE * mean[run] + JOIN_DISTANCE)


def _gaps_made(dash: Edges, gaps: F64, wheel_paths: F64, limit: float) -> tuple[Bool, F64]:
    """Return the mask of the k gaps that the wheel rolls or presses, (k,), and the distance of each
    end of n dashes from the nearest work on the dash, (2n,) mm; inf if there is none.

    ``gaps`` and ``wheel_paths`` are lines and arcs as rows of six numbers (see ``curves.curve``).
    The wheel works on a gap or dash if it runs along it, or is pressed on it, within ``limit`` mm.
    """
    found = find_overlaps(wheel_paths, gaps, np.zeros(len(gaps)), gaps[:, 5], limit)
    length = np.abs(np.diff(found.place)[:, 0])
    is_press = wheel_paths[found.curve, 5] < 1e-6
    inside = (found.place.mean(axis=1) > limit) & (
        found.place.mean(axis=1) < gaps[found.edge, 5] - limit
    )
    made = np.zeros(len(gaps), np.bool_)
    made[found.edge[(length > JOIN_DISTANCE) | (is_press & inside)]] = True
    touched = dash.find_overlaps(wheel_paths, limit)
    along = np.abs(np.diff(touched.place)[:, 0]) >= 0.5 * np.diff(touched.along)[:, 0]
    edge, (low, high) = touched.edge[along].astype(np.int64), touched.place_range()
    unworked = np.full(2 * len(dash), np.inf)
    np.minimum.at(unworked, 2 * edge, low[along])
    np.minimum.at(unworked, 2 * edge + 1, dash.curve[edge, 5] - high[along])
    return made, unworked


def _group_dashes(count: int, dash_a: I64, dash_b: I64) -> I64:
    """Return the number of the group of each of ``count`` dashes, (count,).

    Dashes are in one group if pairs connect them: dash ``dash_a[i]`` and dash ``dash_b[i]``, (k,)
    each.
    """
    name = np.arange(count)
    for _ in range(count):
        least = name.copy()
        np.minimum.at(least, dash_a, name[dash_b])
        np.minimum.at(least, dash_b, name[dash_a])
        least = least[least]
        if np.array_equal(least, name):
            break
        name = least
    return name


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


def split_ends(edges: Edges, crossings: CutCrossings) -> Bool:
    """Return the mask of the 2n ends of n creases at which cuts cross a crease, (2n,).

    The ends of other creases at the same point, in another direction, are not marked.  End 2i is
    the start of edge i, and end 2i + 1 is its end.  A crossing lies at most ``JOIN_DISTANCE`` from
    an end that is linked to another crease, and at most ``TOUCH_DISTANCE`` from a free end.
    """
    end, crossing = pairs_within(edges.ends, crossings.points, TOUCH_DISTANCE + LIMIT_SLACK)
    linked = link_ends(edges, STRAIGHT_ANGLE)[0] >= 0
    distance = np.hypot(*(edges.ends[end] - crossings.points[crossing]).T)
    turn = angle_between(edges.outward[end], crossings.azimuth[crossing], 180.0)
    result = np.zeros(len(edges.ends), np.bool_)
    split = (~linked[end] | (distance <= JOIN_DISTANCE)) & (turn <= STRAIGHT_ANGLE)
    result[end[split]] = True
    return result
