"""exact_nesting: find the face around each component of edges that meet exactly at their ends.

A vertical ray runs downwards from the lowest point of a component.  The first edge of another
component that it hits bounds the face that contains the component, or belongs to a component that
is in the same face.  Edges with one face on both sides, such as a slit that begins at an outline,
are hit by no ray, and a ray begins at them only if the component has no other edges: a slit that
reaches a little past another outline would place its whole component inside that one.

Outlines that touch may overlap by a rounding error, so that the first edge below a point is the top
of one outline although the point lies inside the other, whose bottom is a little lower.  A ray that
leaves a component therefore also looks for the bottoms of others within ``GAP`` below.

Edges are split into spans, which run from left to right, so that a vertical
ray meets each span at most once.  A tree of bounding boxes finds the spans that a ray can hit.

``graph_nesting`` does the same for a graph whose pieces meet only within a tolerance.
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.spatial_index.box_tree import (
    BoxTree,
    build_tree,
    new_stack,
    next_overlap,
    start_query,
)
from knifetip.geometry.spatial_index.morton import order_boxes
from knifetip.geometry.tolerance import BULGE, GAP
from knifetip.kernels import (
    F64_1,
    F64_2,
    I32_1,
    I64_1,
    Bool_1,
    OutF64_2,
    OutI64_1,
    OutI64_2,
    kernel,
)

#: By how much boxes are enlarged, for rounding; heights that differ by less are equal (mm).
_MARGIN: Final = 1e-6
#: Number of components that may touch at one place and overlap there.
_MOST_TOUCHING: Final = 10


class _Circle(NamedTuple):
    """The circle of a span; all values are 0 for a straight span."""

    x: float  #: x of the centre (mm)
    y: float  #: y of the centre (mm)
    radius: float  #: mm
    side: float  #: 1 for a span on the upper half of the circle, -1 on the lower half


class _Spans(NamedTuple):
    """k parts of edges that run from left to right, in no particular order."""

    #: (k, 8) x and y of the left and of the right end, and the four values of the ``_Circle``
    shape: F64_2
    owner: I32_1  #: (k,) component of each span, -1 for none
    inside: Bool_1  #: (k,) whether the face above each span is a bounded face
    boxes: F64_2  #: (k, 4) bounding boxes of the spans, sorted as ``BoxTree`` requires
    order: I64_1  #: (k,) index of the span of each box


def find_enclosing_faces(
    start: F64, end: F64, bulge: F64, face: I32, outer: Bool, component: I32
) -> tuple[I64, I64]:
    """Return for each component of n edges the bounded face around it, and its nesting depth.

    A component is a set of connected edges.

    Parameters
    ----------
    start, end : (n, 2) mm
        Start and end points of the edges.  Edges that meet have exactly equal end points, so that
        no ray passes between them.
    bulge : (n,)
        Bulges of the edges.
    face : (n, 2)
        Faces on the left and on the right of each edge.
    outer : (f,)
        Whether each face is the outer face of its component.
    component : (n,)
        Component of each edge, a number from 0 to c - 1.

    Returns
    -------
    enclosing : (c,)
        Bounded face that contains each component, -1 if there is none.
    depth : (c,)
        Number of other components around each component; 0 for a component that is inside no other.
    """
    count = int(component.max()) + 1
    if count == 1:
        return np.full(1, -1, np.int64), np.zeros(1, np.int64)
    spans, above = _spans_of_edges(start, end, bulge)
    divides = face[:, 0] != face[:, 1]
    # Components without an area have no other edges.
    divides_area = np.zeros(count, np.bool_)
    divides_area[component[divides]] = True
    bounds = divides | ~divides_area[component]
    own = bounds[above // 2]
    lowest = _lowest_points(
        start[bounds],
        end[bounds],
        component[bounds],
        spans[own],
        component[above[own] // 2],
        count,
    )
    hits = divides[above // 2]
    spans, above = spans[hits], above[hits]
    if len(spans) == 0:
        return np.full(count, -1, np.int64), np.zeros(count, np.int64)
    owner = component[above // 2]
    inside = ~outer[face.ravel()[above]]
    hit = _first_below(lowest, _with_boxes(spans, owner, inside), GAP)
    # A ray hits a component with a lower lowest point, whose enclosing face is known by then.
    order = np.argsort(lowest[:, 1], kind="stable")
    enclosing, depth = _follow_hits(order, hit, above, face.ravel(), outer, component)
    return enclosing, depth


def find_half_edges_below(points: F64, start: F64, end: F64, bulge: F64) -> I64:
    """Return the first half-edge below each of m points, (m,); -1 if there is no edge below.

    Half-edge 2 i is the left side of edge i, half-edge 2 i + 1 its right side.  The result is the
    side of the edge that faces upwards, so its face contains the point.

    Parameters
    ----------
    points : (m, 2) mm
        The points.
    start, end, bulge : (n, 2), (n, 2) mm and (n,)
        The edges.  Edges that meet have exactly equal end points.
    """
    spans, above = _spans_of_edges(start, end, bulge)
    if len(spans) == 0 or len(points) == 0:
        return np.full(len(points), -1, np.int64)
    # No span has an owner, so that none is left out.
    no_owner = np.full(len(spans), -1, np.int32)
    inside = np.ones(len(spans), np.bool_)
    points = np.ascontiguousarray(points)
    hit = _first_below(points, _with_boxes(spans, no_owner, inside), _MARGIN)
    result: I64 = np.where(hit < 0, -1, above[hit])
    return result


def _spans_of_edges(start: F64, end: F64, bulge: F64) -> tuple[F64, I64]:
    """Return the k spans of n edges, as ``_split_into_spans`` does, and the upper half-edges."""
    centre, radius = np.zeros((len(bulge), 2)), np.zeros(len(bulge))
    bent = np.flatnonzero(np.abs(bulge) >= BULGE)
    arcs = start[bent], end[bent], bulge[bent]
    centre[bent], radius[bent] = arc.centre(*arcs), arc.radius(*arcs)
    spans, above = _split_into_spans(start, end, bulge, centre, radius)
    return spans, above


def _with_boxes(shape: F64, owner: I32, inside: Bool) -> _Spans:
    boxes = _boxes_of_spans(shape)
    # The reversed order begins at the top, so that a search finds the span of a ray early.
    order = order_boxes(boxes)[::-1].copy()
    return _Spans(shape, owner, inside, boxes[order], order)


@kernel
def _follow_hits(
    order: I64_1, hit: I64_1, above: I64_1, face: I32_1, outer: Bool_1, component: I32_1
) -> Any:
    """Return the face around each of c components and the nesting depth of the component.

    A vertical ray runs downwards from the lowest point of each component.  A span is a part of an
    edge that runs from left to right.  A ray hits the first span of another component that it
    meets.

    ``order`` (c,): components, sorted by their lowest points from low to high.
    ``hit`` (c,): span that the ray of each component hits, -1 for none.
    ``above`` (k,): half-edge on the upper side of each span.
    ``face`` (2n,): face beside each half-edge.
    ``outer`` (f,): whether each face is the outer face of its component.
    ``component`` (n,): component of each edge.
    Returns ``enclosing`` (c,): bounded face that contains each component, -1 if there is none;
    ``depth`` (c,): number of other components around each component; 0 for a component that is
    inside no other.
    """
    enclosing = np.full(len(order), -1, np.int64)
    depth = np.zeros(len(order), np.int64)
    for c in order:
        if hit[c] < 0:
            continue
        half = above[hit[c]]
        hit_component = component[half // 2]
        if outer[face[half]]:
            enclosing[c], depth[c] = enclosing[hit_component], depth[hit_component]
        else:
            enclosing[c], depth[c] = face[half], depth[hit_component] + 1
    return enclosing, depth


@kernel
def _split_into_spans(start: F64_2, end: F64_2, bulge: F64_1, centre: F64_2, radius: F64_1) -> Any:
    """Return the k spans of n edges, and the half-edge on the upper side of each span, (k,).

    The spans, (k, 8), are the column ``shape`` of ``_Spans``.  Half-edge 2 i is the left side of
    edge i, half-edge 2 i + 1 its right side.

    ``start``, ``end``, ``bulge`` (n, 2), (n, 2) mm and (n,): the edges.
    ``centre``, ``radius`` (n, 2) and (n,) mm: centre and radius of each edge that is an arc.
    """
    spans = np.empty((3 * len(bulge), 8))
    above = np.empty(3 * len(bulge), np.int64)
    count = 0
    for i in range(len(bulge)):
        ax, ay, bx, by = start[i, 0], start[i, 1], end[i, 0], end[i, 1]
        if radius[i] == 0.0:
            line = _Circle(0.0, 0.0, 0.0, 0.0)
            count = _add_span(spans, above, count, i, (ax, ay), (bx, by), line)
            continue
        cx, cy, r = centre[i, 0], centre[i, 1], radius[i]
        first = math.atan2(ay - cy, ax - cx)
        sweep = 4.0 * math.atan(bulge[i])
        turn = 1.0 if sweep > 0.0 else -1.0
        # Arcs are split at the leftmost and the rightmost point of their circle.
        half = np.floor(first / math.pi) if turn > 0.0 else np.ceil(first / math.pi)
        x, y = ax, ay
        while True:
            until = (half + turn) * math.pi
            last = (until - first) * turn >= abs(sweep)
            nx = bx if last else cx + r * math.cos(until)
            ny = by if last else cy
            # Between two multiples of pi the sine keeps its sign.
            side = 1.0 if math.sin((half + 0.5 * turn) * math.pi) > 0.0 else -1.0
            count = _add_span(spans, above, count, i, (x, y), (nx, ny), _Circle(cx, cy, r, side))
            if last:
                break
            x, y = nx, ny
            half += turn
    return spans[:count].copy(), above[:count].copy()


@kernel
def _add_span(
    spans: OutF64_2,
    above: OutI64_1,
    count: int,
    edge: int,
    start: tuple[float, float],
    end: tuple[float, float],
    circle: _Circle,
) -> int:
    """Append a span to ``spans``, and return the new number of spans.

    The span is a part of ``edge`` from ``start`` to ``end``; its ends are stored from left to
    right, in row ``count``.  The half-edge on its upper side is written to ``above``.  A vertical
    span is not written.
    """
    if start[0] == end[0]:
        return count
    right = end[0] > start[0]
    spans[count, 0], spans[count, 1] = start if right else end
    spans[count, 2], spans[count, 3] = end if right else start
    spans[count, 4], spans[count, 5], spans[count, 6], spans[count, 7] = circle
    above[count] = 2 * edge if right else 2 * edge + 1
    return count + 1


@kernel(checks_division=True)
def _height_at(span: F64_1, x: float) -> float:
    """Return the y coordinate (mm) of a span, (8,), at the x coordinate ``x`` (mm)."""
    if x <= span[0]:
        return float(span[1])
    if x >= span[2]:
        return float(span[3])
    if span[7] == 0.0:
        return float(span[1] + (x - span[0]) / (span[2] - span[0]) * (span[3] - span[1]))
    return float(span[5] + span[7] * math.sqrt(max(span[6] ** 2 - (x - span[4]) ** 2, 0.0)))


@kernel(checks_division=True)
def _is_above(spans: F64_2, span_a: int, span_b: int) -> bool:
    """Return whether span ``span_a`` runs above span ``span_b``, which does not cross it.

    They are compared in the middle between the ends of their common range along X.  Spans that
    meet at an end differ by less than a rounding error beside it.  Of coincident spans, the one
    with the higher index is above.
    """
    left, right = max(spans[span_a, 0], spans[span_b, 0]), min(spans[span_a, 2], spans[span_b, 2])
    x = 0.5 * (left + right)
    rise = _height_at(spans[span_a], x) - _height_at(spans[span_b], x)
    return rise > 0.0 or (rise == 0.0 and span_a > span_b)


@kernel
def _lowest_points(
    start: F64_2, end: F64_2, component: I32_1, spans: F64_2, owner: I32_1, count: int
) -> Any:
    """Return the lowest point on the edges of each of ``count`` components, (count, 2) mm.

    ``start``, ``end`` (n, 2) mm: start and end points of the edges.
    ``component`` (n,): component of each edge.
    ``spans``, ``owner`` (k, 8) and (k,): spans, the parts of the edges that run from left to right,
    and the component of each span.
    """
    lowest = np.full((count, 2), math.inf)
    for i in range(len(component)):
        c = component[i]
        for point in (start[i], end[i]):
            if point[1] < lowest[c, 1]:
                lowest[c, 0], lowest[c, 1] = point[0], point[1]
    for i in range(len(spans)):
        c = owner[i]
        bottom = spans[i, 5] - spans[i, 6]
        if spans[i, 7] < 0.0 and spans[i, 0] < spans[i, 4] < spans[i, 2] and bottom < lowest[c, 1]:
            lowest[c, 0], lowest[c, 1] = spans[i, 4], bottom
    return lowest


@kernel
def _boxes_of_spans(spans: F64_2) -> Any:
    """Return the bounding box of each of k spans, (k, 8), enlarged for rounding, (k, 4)."""
    boxes = np.empty((len(spans), 4))
    for i in range(len(spans)):
        boxes[i, 0], boxes[i, 2] = spans[i, 0], spans[i, 2]
        y0, y1 = min(spans[i, 1], spans[i, 3]), max(spans[i, 1], spans[i, 3])
        if spans[i, 7] != 0.0 and spans[i, 0] < spans[i, 4] < spans[i, 2]:
            top = spans[i, 5] + spans[i, 7] * spans[i, 6]
            y0, y1 = min(y0, top), max(y1, top)
        boxes[i, 1], boxes[i, 3] = y0 - _MARGIN, y1 + _MARGIN
    return boxes


@kernel(checks_division=True)
def _first_below(lowest: F64_2, spans: _Spans, touch: float) -> Any:
    """Return the first span of another component below the lowest point of each component.

    A span at most ``touch`` mm above the lowest point counts as below it: the component touches it
    from above.  If the first span leaves its component, and another component is entered at most
    ``touch`` mm below and left nowhere between, its span is returned: the two components overlap.

    A span contains its left end but not its right end.  Of several spans at the same height below a
    point, the upper one is returned.

    ``lowest`` (c, 2): lowest point of each component.
    Returns ``hit`` (c,): index of the span, -1 if there is none.
    """
    shape, owner, inside, boxes, order = spans
    hit = np.full(len(lowest), -1, np.int64)
    tree, stack = build_tree(boxes), new_stack()
    for c in range(len(lowest)):
        x, y = lowest[c, 0], lowest[c, 1]
        best = -math.inf
        depth = start_query(tree, stack)
        while True:
            box = (x, best - _MARGIN, x, y + touch)
            at, depth = next_overlap(tree.boxes, tree.level, stack, depth, box, -1)
            if at < 0:
                break
            i = order[at]
            if owner[i] == c or not shape[i, 0] <= x < shape[i, 2]:
                continue
            height = _height_at(shape[i], x)
            if height > y + touch or height < best - _MARGIN:
                continue
            # Of two components that touch, only the one with the lower lowest point is below.
            if height >= y and owner[i] >= 0 and lowest[owner[i], 1] >= y:
                continue
            if height > best + _MARGIN or _is_above(shape, i, hit[c]):
                best, hit[c] = height, i
        if hit[c] >= 0 and not inside[hit[c]]:
            hit[c] = _entered_below(x, best, c, hit[c], spans, tree, stack, touch)
    return hit


@kernel(checks_division=True)
def _entered_below(
    x: float,
    best: float,
    own: int,
    left: int,
    spans: _Spans,
    tree: BoxTree,
    stack: OutI64_2,
    touch: float,
) -> int:
    """Return the highest span at most ``touch`` mm below the height ``best`` at which a ray enters
    a component that it leaves nowhere between; ``left`` if there is none.

    ``left`` is the span at the height ``best``, at which the ray leaves its component; ``own`` is
    the component at which the ray begins.  The other parameters are those of ``_first_below``.
    """
    shape, owner, inside, _, order = spans
    # Of each component, only the highest span counts.
    seen = np.empty(_MOST_TOUCHING, np.int64)
    seen[0], seen[1] = own, owner[left]
    limit = best
    for count in range(2, _MOST_TOUCHING):
        found, height = -1, best - touch
        depth = start_query(tree, stack)
        while True:
            at, depth = next_overlap(
                tree.boxes, tree.level, stack, depth, (x, height, x, limit), -1
            )
            if at < 0:
                break
            i = order[at]
            if not shape[i, 0] <= x < shape[i, 2] or (seen[:count] == owner[i]).any():
                continue
            y = _height_at(shape[i], x)
            if height <= y <= limit:
                found, height = i, y
        if found < 0:
            break
        if inside[found]:
            return int(found)
        seen[count], limit = owner[found], height
    return left
