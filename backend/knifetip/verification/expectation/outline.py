"""The outlines of blanks and holes that cuts form, and the side of each cut on which the part lies.

Cuts with common ends enclose faces.  Each cut is two half-edges, one in each direction.  A cycle of
half-edges with its face on the left runs anticlockwise round a bounded face, and clockwise round
the outside of a component (a set of connected cuts).  The sign of its area therefore identifies the
outside.  A component inside another component is a hole, or a part in a hole.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from knifetip.kernels import F64_1, F64_2, I64_1, inline_kernel, kernel
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.curve import point_at
from knifetip.verification.curves.group_order import order_in_groups
from knifetip.verification.expectation.edge_pieces import divide_at_contacts
from knifetip.verification.expectation.edges import (
    JOIN_DISTANCE,
    Edges,
)

#: A cycle that encloses less than this has no inside (mm²).
_MIN_AREA: Final = 1e-6
#: Edges at a common end are sorted by the directions of their chords to the point this far along
#: (mm), and of an edge shorter than twice that by the chord to its middle.
_CHORD: Final = 10.0 * JOIN_DISTANCE
#: Shifts along Y of the rays by which contours are counted (mm).  A ray may pass between two ends
#: of cuts that are joined although they are not at the same height, so the median of three rays
#: counts.  The rays are farther apart than such ends, so no two of them pass between the same ends.
_RAY_SHIFTS: Final = (0.0, 2.3 * JOIN_DISTANCE, -2.6 * JOIN_DISTANCE)


@dataclass(frozen=True, eq=False, slots=True)
class CutOutlines:
    """The outlines that n cuts form, and the side of each cut on which the part lies."""

    edges: Edges
    closing: Bool  #: (n,) the edge separates a face from the outside of its component
    depth: I64  #: (n,) number of components that enclose the edge's component
    board_left: Bool  #: (n,) the part lies on the left of a closing edge
    component: I64  #: (n,) number of the connected component
    loose: Bool  #: (n,) the edge has one face on both sides, so it encloses nothing

    @property
    def outer(self) -> Bool:
        """Mask of the n cuts on the outer contour of a blank, or of a part inside a hole, shape
        (n,).
        """
        result: Bool = self.closing & (self.depth % 2 == 0)
        return result


def find_outlines(edges: Edges) -> CutOutlines:
    """Return the outlines that the cuts ``edges`` form, and on which side of each cut the part
    lies.
    """
    return edges.compute_once("outlines", lambda: _find_outlines(edges))


def find_divided_outlines(edges: Edges) -> CutOutlines:
    """Return the outlines that the cuts ``edges`` form, with contours divided where they meet.

    Where two contours touch or cross between their vertices, or one contour crosses itself, the
    part changes sides there.  The contours that meet are one component, and all its faces are
    panels.  The record contains the pieces of contours, or all ``edges`` if no contours meet.
    """
    return edges.compute_once(
        "divided outlines",
        lambda: find_outlines(divide_at_contacts(edges, find_outlines(edges).closing)),
    )


def _find_outlines(edges: Edges) -> CutOutlines:
    """Return the result of ``find_outlines``."""
    count = len(edges)
    if count == 0:
        none = np.zeros(0, np.bool_)
        no_numbers = np.zeros(0, np.int64)
        return CutOutlines(edges, none, no_numbers, none, no_numbers, none)
    cycle, swept, component = face_cycles(edges)
    # A cycle that is clockwise or has no area borders the outside of its component.
    outside = (swept < _MIN_AREA)[cycle].reshape(-1, 2)
    closing = outside[:, 0] != outside[:, 1]
    depth = _nesting_depths(edges.curve, closing, component)[component]
    # Half-edge 0 has its face on the edge's left.  The part round a hole lies outside of it.
    left = ~outside[:, 0] ^ (depth % 2 == 1)
    return CutOutlines(edges, closing, depth, left, component, cycle[::2] == cycle[1::2])


def face_cycles(edges: Edges) -> tuple[I64, F64, I64]:
    """Return the cycles of half-edges round the faces between n edges.

    Returns
    -------
    cycle : (2n,)
        Index of the cycle of each half-edge.  Entry 2i is the half-edge from the start to the end
        of edge i, and entry 2i + 1 is the half-edge back.  Each half-edge has the face of its cycle
        on its left.
    swept : (w,)
        Twice the signed area of each of w cycles (mm²); not positive for a cycle round the outside
        of a component.
    component : (n,)
        Index of the connected component of each edge.
    """
    return edges.compute_once("face cycles", lambda: _find_face_cycles(edges))


def _find_face_cycles(edges: Edges) -> tuple[I64, F64, I64]:
    """Return the result of ``face_cycles``."""
    count = len(edges)
    a, b = edges.near_ends(JOIN_DISTANCE)
    node = lowest_connected(a, b, 2 * count)
    curve = np.repeat(edges.curve, 2, axis=0)
    back = np.tile([False, True], count)
    straight = curve[:, 0] == 0.0
    bend = np.where(straight, 0.0, curve[:, 0] / np.where(straight, 1.0, curve[:, 3]))
    bend = np.where(back, -bend, bend)
    # The direction of a chord, because edges that touch each other leave in the same direction, or
    # in one that differs by the distance of their ends.
    chord = np.minimum(_CHORD, 0.5 * curve[:, 5])
    leaves = np.radians(edges.outward + 180.0) + 0.5 * chord * bend
    leaves = np.round(leaves % (2.0 * math.pi), 9)
    order = order_in_groups(node, leaves, bend)
    cycle, swept = _trace_cycles(order, node[order], swept_areas(edges, node))
    component = lowest_connected(
        np.concatenate([node, np.arange(2 * count)]),
        np.concatenate([np.arange(2 * count), np.arange(2 * count) ^ 1]),
        2 * count,
    )[::2]
    # The lowest end of a component is the start of an edge.
    number = np.cumsum(component == 2 * np.arange(count)) - 1
    return cycle, swept, number[component // 2]


def lowest_connected(index_a: I64, index_b: I64, count: int) -> I64:
    """For each of the indices 0 to ``count`` - 1, return the lowest index connected to it,
    (count,).

    ``index_a`` and ``index_b`` are the two indices of each of k connected pairs, (k,) each.
    Indices may also be connected through other indices; an index without pairs is its own result.
    """
    result: I64 = _lowest_names(index_a, index_b, count)
    return result


@kernel
def _lowest_names(index_a: I64_1, index_b: I64_1, count: int) -> Any:
    """Return the lowest index of each set of connected indices, (count,); see
    ``lowest_connected``.
    """
    name = np.arange(count)
    for k in range(len(index_a)):
        a, b = index_a[k], index_b[k]
        while name[a] != a:
            name[a] = name[name[a]]
            a = name[a]
        while name[b] != b:
            name[b] = name[name[b]]
            b = name[b]
        if a < b:
            name[b] = a
        else:
            name[a] = b
    for index in range(count):
        # The index with the name is lower, so its name is final.
        name[index] = name[name[index]]
    return name


def swept_areas(edges: Edges, node: I64) -> F64:
    """Return twice the signed area between each of n edges and a common origin, (n,) mm².

    The area is swept by the straight line from the origin to a point that moves along the edge.  It
    is positive for an anticlockwise sweep.  The origin is the start of the first edge.

    ``node`` is the lowest of the ends that are joined with each end, (2n,).  Joined ends get the
    position of this end: a gap between them, however small, would add an area that is proportional
    to its distance from the origin.
    """
    curve = edges.curve
    ends = edges.ends[node] - edges.ends[0]
    start, end = ends[::2], ends[1::2]
    straight = curve[:, 0] == 0.0
    radius = np.where(straight, 0.0, curve[:, 3])
    sweep = curve[:, 0] * curve[:, 5] / np.where(straight, 1.0, radius)
    bulge = radius**2 * (sweep - np.sin(sweep))
    result: F64 = start[:, 0] * end[:, 1] - start[:, 1] * end[:, 0] + bulge
    return result


@kernel
def _trace_cycles(order: I64_1, node: I64_1, swept: F64_1) -> Any:
    """Return the index of the cycle of each half-edge (2n,), and twice each cycle's area (w,) mm².

    The area is signed: positive for an anticlockwise cycle.  Half-edge 2i runs from the start to
    the end of edge i, and half-edge 2i + 1 runs back.

    ``order`` (2n,): indices of the half-edges, sorted by start vertex and then anticlockwise about
    it.
    ``node`` (2n,): index of the start vertex of each half-edge, in the order of ``order``.
    ``swept`` (n,): twice the signed area between each edge and a common origin (mm²).
    """
    count = len(order)
    rank = np.empty(count, np.int64)
    for place in range(count):
        rank[order[place]] = place
    last = np.empty(count, np.int64)
    for place in range(count - 1, -1, -1):
        same = place + 1 < count and node[place + 1] == node[place]
        last[place] = last[place + 1] if same else place
    cycle = np.full(count, -1, np.int64)
    area = np.zeros(count)
    cycles = 0
    for begin in range(count):
        half = begin
        while cycle[half] < 0:
            cycle[half] = cycles
            area[cycles] += swept[half // 2] if half % 2 == 0 else -swept[half // 2]
            # The next half-edge clockwise from the twin keeps the face on the left.
            place = rank[half ^ 1]
            first = place == 0 or node[place - 1] != node[place]
            half = order[last[place] if first else place - 1]
        if cycle[begin] == cycles:
            cycles += 1
    return cycle, area[:cycles]


def _nesting_depths(curve: F64, closing: Bool, component: I64) -> I64:
    """Return the number of other components that enclose each of c components of cuts, (c,).

    ``curve`` (n, 6): the n cuts: lines and arcs as rows of six numbers (see ``curves.curve``).
    ``closing`` (n,): mask of the cuts that form the outline of their component.
    ``component`` (n,): index of the connected component of each cut.
    """
    rows = np.flatnonzero(closing)
    rows = rows[np.argsort(component[rows], kind="stable")]
    count = int(component.max()) + 1
    first = np.searchsorted(component[rows], np.arange(count + 1))
    probe = np.zeros((count, 2))
    middle = point_at(curve, 0.5 * curve[:, 5])
    # A point on the outline, if there is one: a slit may reach past another outline.
    for on in (np.arange(len(curve)), rows):
        probe[component[on[::-1]]] = middle[on[::-1]]
    outlines = curve[rows]
    boxes = _bounding_boxes(outlines, first)
    return _count_by_rays(probe, outlines, first, boxes, own=True)


def count_enclosing(points: F64, outlined: CutOutlines) -> I64:
    """Return the number of components of cuts that enclose each of n points, (n,).

    ``points`` is (n, 2) mm, and ``outlined`` contains the outlines of the components.
    """
    rows = np.flatnonzero(outlined.closing)
    rows = rows[np.argsort(outlined.component[rows], kind="stable")]
    outlines = outlined.edges.curve[rows]
    count = int(outlined.component.max(initial=-1)) + 1
    first = np.searchsorted(outlined.component[rows], np.arange(count + 1))
    return _count_by_rays(points, outlines, first, _bounding_boxes(outlines, first), own=False)


def _count_by_rays(points: F64, outlines: F64, first: I64, boxes: F64, *, own: bool) -> I64:
    """Return the number of outlines that contain each of n points, (n,), by the median of three
    rays.

    For the parameters see ``_count_containing``.
    """
    result: I64 = _count_containing(
        np.ascontiguousarray(points), outlines, first, boxes, np.array(_RAY_SHIFTS), own
    )
    return result


def _bounding_boxes(outlines: F64, first: I64) -> F64:
    straight = outlines[:, 0] == 0.0
    reach = np.where(straight, 0.0, outlines[:, 3])
    end = outlines[:, 1:3].copy()
    end[straight] = point_at(outlines[straight], outlines[straight, 5])
    boxes = np.empty((len(first) - 1, 4))
    filled = np.flatnonzero(first[1:] > first[:-1])
    boxes[:, :2], boxes[:, 2:] = np.inf, -np.inf
    for axis in range(2):
        start, stop = outlines[:, 1 + axis], end[:, axis]
        if len(filled):
            low, high = np.minimum(start, stop) - reach, np.maximum(start, stop) + reach
            boxes[filled, axis] = np.minimum.reduceat(low, first[filled])
            boxes[filled, 2 + axis] = np.maximum.reduceat(high, first[filled])
    return boxes


@kernel
def _count_containing(
    points: F64_2, outlines: F64_2, first: I64_1, boxes: F64_2, shifts: F64_1, own: bool
) -> Any:
    """Return the number of outlines that contain each of n points, shape (n,).

    A point is inside if a ray along +X crosses the outline an odd number of times.  Three rays are
    counted, and the median of the three numbers is returned.

    ``points`` (n, 2) mm: the points.
    ``outlines`` (k, 6): the k curves of all c outlines, outline by outline: lines and arcs as rows
    of six numbers (see ``curves.curve``).
    ``first`` (c + 1,): index of the first curve of each outline, followed by k.
    ``boxes`` (c, 4) mm: bounding box of each outline: least x, least y, greatest x, greatest y.
    ``shifts`` (3,) mm: shift of each ray along Y.
    ``own``: if True, point i belongs to outline i, and this outline is not counted for it.
    """
    depth = np.zeros(len(points), np.int64)
    low, width, begin, listed = _list_in_bands(boxes)
    least, most = shifts.min(), shifts.max()
    counts = np.zeros(3, np.int64)
    for i in range(len(points)):
        x, y = points[i, 0], points[i, 1]
        counts[:] = 0
        band = _band_at(y + least, low, width, len(begin) - 1)
        last = _band_at(y + most, low, width, len(begin) - 1)
        # An outline in two bands is counted in the first of them.
        for place in range(band, last + 1):
            for entry in range(begin[place], begin[place + 1]):
                j = listed[entry]
                if own and i == j:
                    continue
                if x < boxes[j, 0] or x > boxes[j, 2]:
                    continue
                if y + most < boxes[j, 1] or y + least > boxes[j, 3]:
                    continue
                if place > band and _band_at(boxes[j, 1], low, width, len(begin) - 1) < place:
                    continue
                for ray in range(3):
                    ray_y = y + shifts[ray]
                    if ray_y < boxes[j, 1] or ray_y > boxes[j, 3]:
                        continue
                    crossed = 0
                    for row in range(first[j], first[j + 1]):
                        crossed += ray_crossings(outlines[row], x, ray_y)
                    counts[ray] += crossed % 2
        a, b, c = counts[0], counts[1], counts[2]
        depth[i] = max(min(a, b), min(max(a, b), c))
    return depth


@inline_kernel
def _band_at(y: float, low: float, width: float, bands: int) -> int:
    return min(max(int((y - low) / width), 0), bands - 1)


@kernel(checks_division=True)
def _list_in_bands(boxes: F64_2) -> Any:
    """Return horizontal bands of equal width, and the boxes in each of them.

    There are about as many bands as boxes, but fewer if the boxes are so high that each would be in
    many bands.  ``boxes`` are (c, 4); see ``_count_containing``.  A box without curves has its
    least y above its greatest y, and is in no band.

    Returns least y of the lowest band and width of a band (mm); index of the first box of each
    band, followed by the number of all entries; and the boxes of the bands, band by band.
    """
    low, high, heights = math.inf, -math.inf, 0.0
    for j in range(len(boxes)):
        if boxes[j, 1] <= boxes[j, 3]:
            low, high = min(low, boxes[j, 1]), max(high, boxes[j, 3])
            heights += boxes[j, 3] - boxes[j, 1]
    if not high > low:
        low, high = 0.0, 1.0
    bands = max(int(4.0 * len(boxes) / (1.0 + heights / (high - low))), 1)
    bands = min(bands, len(boxes) + 1)
    width = (high - low) / bands
    first = np.zeros(bands + 1, np.int64)
    for j in range(len(boxes)):
        if boxes[j, 1] <= boxes[j, 3]:
            top = _band_at(boxes[j, 3], low, width, bands)
            for band in range(_band_at(boxes[j, 1], low, width, bands), top + 1):
                first[band + 1] += 1
    first = np.cumsum(first)
    free = first.copy()
    listed = np.empty(first[bands], np.int64)
    for j in range(len(boxes)):
        if boxes[j, 1] <= boxes[j, 3]:
            top = _band_at(boxes[j, 3], low, width, bands)
            for band in range(_band_at(boxes[j, 1], low, width, bands), top + 1):
                listed[free[band]] = j
                free[band] += 1
    return low, width, first, listed


@kernel(allocates=False, checks_division=True)
def ray_crossings(curve: F64_1, x: float, y: float) -> int:
    """Return how often a line or arc crosses the ray from the point (x, y) along +X.

    ``curve`` is the line or arc as six numbers (see ``curves.curve``), (6,).  It is divided into
    pieces that only rise or only fall.  A piece crosses the ray's line if one of its ends is above
    y and the other is not (half-open rule).
    """
    if curve[0] == 0.0:
        y0 = curve[2]
        y1 = curve[2] + curve[4] * curve[5]
        if (y0 > y) == (y1 > y):
            return 0
        crossing_x = curve[1] + (y - y0) / (y1 - y0) * curve[3] * curve[5]
        return 1 if crossing_x > x else 0
    radius = curve[3]
    first = curve[4]
    last = curve[4] + curve[0] * curve[5] / radius
    low = min(first, last)
    high = max(first, last)
    crossed = 0
    # Between its highest and lowest points an arc is monotonic in y.
    piece = math.floor(low / math.pi - 0.5)
    begin = low
    while begin < high:
        end = min((piece + 1.5) * math.pi, high)
        if end > begin:
            y0 = curve[2] + radius * math.sin(begin)
            y1 = curve[2] + radius * math.sin(end)
            if (y0 > y) != (y1 > y):
                half = math.sqrt(max(radius * radius - (y - curve[2]) ** 2, 0.0))
                side = 1.0 if math.cos(0.5 * (begin + end)) > 0.0 else -1.0
                if curve[1] + side * half > x:
                    crossed += 1
            begin = end
        piece += 1
    return crossed
