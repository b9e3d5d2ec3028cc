"""subdivision: the faces into which edges divide the plane, and which face holds which component.

    edges that meet only at their ends -> Subdivision

A *half-edge* is one side of an edge; its *face* is what lies on its left.  Half-edges that follow
one another round a face are found by turning clockwise at every vertex.  A *component* is a set of
edges that hang together; it is bounded from outside by one walk, whose area is not positive.  A ray
from the lowest point of a component downwards meets first the component that it lies in, or beside.

Linear in the number of edges but for sorting: the ray walks through a grid of cells.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, Final

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.chain import nodes, outward
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.sets import settle, unite
from knifetip.geometry.tolerance import BULGE
from knifetip.kernels import F64_1, F64_2, I32_1, I64_1, I64_2, Bool_1, OutF64_2, OutI64_1, kernel

#: A walk round less than this encloses nothing (mm²).
_NOTHING: Final = 1e-6
#: Columns of a span: its ends from left to right, centre, radius, and whether it is the upper half
#: of a circle (1), the lower (-1) or a line (0).
_SPAN: Final = 8
#: No cell list holds more than so many entries per span and direction.
_CROWDED: Final = 4.0


@dataclass(frozen=True, eq=False, slots=True)
class Subdivision:
    """n edges in c components, and f faces."""

    face: I64  #: (n, 2) on the left and on the right of each edge
    outside: Bool  #: (f,) the face is what lies round its component
    component: I64  #: (n,)
    holder: I64  #: (c,) the bounded face that each component lies in, -1 for none
    depth: I64  #: (c,) how many components lie round each

    @property
    def merged(self) -> I64:
        """(f,) For each face the one that it is part of: -1 for the plane round everything."""
        name = np.arange(len(self.outside))
        of = np.zeros(len(self.outside), np.int64)
        of[self.face] = self.component[:, None]
        result: I64 = np.where(self.outside, self.holder[of], name)
        return result


def subdivide(ends: F64, bulge: F64) -> Subdivision:
    """Return the faces between edges.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Edges of any order and direction.  Where they meet elsewhere than at ends, the faces beside
        that place are wrong.
    """
    count = len(ends)
    if count == 0:
        none = np.zeros(0, np.int64)
        return Subdivision(none.reshape(0, 2), np.zeros(0, np.bool_), none, none, none)
    node = nodes(ends.reshape(-1, 2)).astype(np.int64)
    first, twin, swapped = _twins(node.reshape(-1, 2), ends, bulge)
    if len(first) < count:
        # Of edges that lie on each other one divides the plane, and the others lie beside the same.
        found = subdivide(ends[first], bulge[first])
        face = found.face[twin]
        face[swapped] = face[swapped][:, ::-1]
        return replace(found, face=face, component=found.component[twin])
    face, faces = _walked(_onward(node, ends, bulge))
    # What hangs together meets in one point, so that no ray passes between.
    place = np.empty((int(node.max()) + 1, 2))
    place[node[::-1]] = ends.reshape(-1, 2)[::-1]
    start, end = place[node[::2]], place[node[1::2]]
    swept = _area(start, end, bulge)
    area = np.bincount(face, np.stack([swept, -swept], axis=1).ravel(), minlength=faces)
    outside: Bool = area < _NOTHING
    component = np.unique(_components(node.reshape(-1, 2)), return_inverse=True)[1]
    component = component.ravel().astype(np.int64)
    sides = face.reshape(-1, 2)
    holder, depth = _nested(start, end, bulge, sides, outside, component)
    return Subdivision(sides, outside, component, holder, depth)


def _twins(node: I64, ends: F64, bulge: F64) -> tuple[I64, I64, Bool]:
    """Return the first of the edges that lie on each other, (m,), and for each edge which, (n,).

    The third is whether an edge runs against the first one of its place, (n,).
    """
    middle = arc.point_at(ends[:, 0], ends[:, 1], bulge, np.full(len(bulge), 0.5))
    key = np.column_stack([node.min(axis=1), node.max(axis=1), nodes(middle)])
    _, first, twin = np.unique(key, axis=0, return_index=True, return_inverse=True)
    twin = twin.ravel()
    return first, twin, node[first[twin], 0] != node[:, 0]


def _onward(node: I64, ends: F64, bulge: F64) -> I64:
    """Return the half-edge that follows each half-edge round its face, (2n,)."""
    count = len(bulge)
    direction = outward(ends, bulge).reshape(-1, 2)
    # Arcs that leave a place in one direction are told apart by the side to which they bend.
    radius = arc.radius(ends[:, 0], ends[:, 1], bulge)
    bend = np.stack([np.sign(bulge) / radius, -np.sign(bulge) / radius], axis=1).ravel()
    angle = np.round(np.arctan2(direction[:, 1], direction[:, 0]), 9)
    angle[angle <= -round(math.pi, 9)] += 2.0 * round(math.pi, 9)
    ordered = np.lexsort((bend, angle, node))
    sorted_node = node[ordered]
    low = np.searchsorted(sorted_node, sorted_node, side="left")
    high = np.searchsorted(sorted_node, sorted_node, side="right")
    rank = np.empty(2 * count, np.int64)
    rank[ordered] = np.arange(2 * count)
    # Half-edge h leaves from end h; it arrives at h ^ 1 and goes on with the next end clockwise.
    arrived = rank[np.arange(2 * count) ^ 1]
    onward = np.where(arrived > low[arrived], arrived - 1, high[arrived] - 1)
    result: I64 = ordered[onward]
    return result


@kernel
def _walked(onward: I64_1) -> Any:
    """Number the cycles of a permutation: the one of each member, and how many there are."""
    cycle = np.full(len(onward), -1, np.int64)
    count = 0
    for begin in range(len(onward)):
        if cycle[begin] >= 0:
            continue
        at = begin
        while cycle[at] < 0:
            cycle[at] = count
            at = onward[at]
        count += 1
    return cycle, count


@kernel
def _components(node: I64_2) -> Any:
    """Return for edges between nodes, (n, 2), the least edge that each hangs together with."""
    parent = np.arange(len(node))
    seen = np.full(2 * len(node), -1)
    for edge in range(len(node)):
        for end in range(2):
            other = seen[node[edge, end]]
            if other < 0:
                seen[node[edge, end]] = edge
                continue
            unite(parent, edge, other)
    settle(parent)
    return parent


def _area(start: F64, end: F64, bulge: F64) -> F64:
    """Return twice the area that each edge sweeps about the middle of all (mm²)."""
    origin = (start.min(axis=0) + start.max(axis=0)) / 2.0
    a, b = start - origin, end - origin
    sweep = arc.sweep(bulge)
    radius = arc.radius(start, end, bulge)
    square = np.where(np.isfinite(radius), radius, 0.0) ** 2
    result: F64 = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0] + square * (sweep - np.sin(sweep))
    return result


def _nested(
    start: F64, end: F64, bulge: F64, face: I64, outside: Bool, component: I64
) -> tuple[I64, I64]:
    """Return for each component the bounded face that holds it, -1 for none, and its depth."""
    count = int(component.max()) + 1
    if count == 1:
        return np.full(1, -1, np.int64), np.zeros(1, np.int64)
    centre = np.where(np.abs(bulge)[:, None] < BULGE, 0.0, arc.centre(start, end, bulge))
    radius = arc.radius(start, end, bulge)
    spans, above = _spans(start, end, bulge, centre, np.where(np.isfinite(radius), radius, 0.0))
    if len(spans) == 0:
        return np.full(count, -1, np.int64), np.zeros(count, np.int64)
    owner = component[above // 2]
    low, size, shape = _laid_out(spans)
    probe = _lowest(start, end, component, spans, owner, count)
    first, listed = _cells(spans, low, size, shape)
    met = _below(probe, spans, owner, low, size, shape, first, listed)
    # The component that is met first begins lower down, so its holder is found before.
    order = np.argsort(probe[:, 1], kind="stable")
    holder, depth = _held(order, met, above, face.ravel(), outside, component)
    return holder, depth


@kernel
def _held(
    order: I64_1, met: I64_1, above: I64_1, face: I64_1, outside: Bool_1, component: I64_1
) -> Any:
    holder = np.full(len(order), -1, np.int64)
    depth = np.zeros(len(order), np.int64)
    for c in order:
        if met[c] < 0:
            continue
        half = above[met[c]]
        around = component[half // 2]
        if outside[face[half]]:
            holder[c], depth[c] = holder[around], depth[around]
        else:
            holder[c], depth[c] = face[half], depth[around] + 1
    return holder, depth


@kernel
def _spans(start: F64_2, end: F64_2, bulge: F64_1, centre: F64_2, radius: F64_1) -> Any:
    """Return the edges in pieces that run from left to right, and the half-edge above each."""
    spans = np.empty((3 * len(bulge), _SPAN))
    above = np.empty(3 * len(bulge), np.int64)
    count = 0
    for i in range(len(bulge)):
        ax, ay, bx, by = start[i, 0], start[i, 1], end[i, 0], end[i, 1]
        if radius[i] == 0.0:
            count = _span(spans, above, count, i, ax, ay, bx, by, 0.0, 0.0, 0.0, 0.0)
            continue
        cx, cy, r = centre[i, 0], centre[i, 1], radius[i]
        first = math.atan2(ay - cy, ax - cx)
        sweep = 4.0 * math.atan(bulge[i])
        turn = 1.0 if sweep > 0.0 else -1.0
        # The leftmost and rightmost points of the circle part an arc.
        half = np.floor(first / math.pi) if turn > 0.0 else np.ceil(first / math.pi)
        x, y = ax, ay
        while True:
            until = (half + turn) * math.pi
            last = (until - first) * turn >= abs(sweep)
            nx = bx if last else cx + r * math.cos(until)
            ny = by if last else cy
            # Between two multiples of pi the sine keeps its sign.
            side = 1.0 if math.sin((half + 0.5 * turn) * math.pi) > 0.0 else -1.0
            count = _span(spans, above, count, i, x, y, nx, ny, cx, cy, r, side)
            if last:
                break
            x, y = nx, ny
            half += turn
    return spans[:count].copy(), above[:count].copy()


@kernel
def _span(
    spans: OutF64_2, above: OutI64_1, count: int, edge: int,
    ax: float, ay: float, bx: float, by: float, cx: float, cy: float, r: float, side: float,
) -> int:  # fmt: skip
    """Write one span unless it is upright, and return how many there are."""
    if ax == bx:
        return count
    right = bx > ax
    spans[count, 0], spans[count, 1] = (ax, ay) if right else (bx, by)
    spans[count, 2], spans[count, 3] = (bx, by) if right else (ax, ay)
    spans[count, 4], spans[count, 5], spans[count, 6], spans[count, 7] = cx, cy, r, side
    above[count] = 2 * edge if right else 2 * edge + 1
    return count + 1


@kernel(checks_division=True)
def _height(span: F64_1, x: float) -> float:
    """Return the height of a span at x (mm)."""
    if x <= span[0]:
        return float(span[1])
    if x >= span[2]:
        return float(span[3])
    if span[7] == 0.0:
        return float(span[1] + (x - span[0]) / (span[2] - span[0]) * (span[3] - span[1]))
    return float(span[5] + span[7] * math.sqrt(max(span[6] ** 2 - (x - span[4]) ** 2, 0.0)))


@kernel(checks_division=True)
def _slope(span: F64_1, x: float) -> float:
    if span[7] == 0.0:
        return float((span[3] - span[1]) / (span[2] - span[0]))
    rise = math.sqrt(max(span[6] ** 2 - (x - span[4]) ** 2, 0.0))
    if rise == 0.0:
        return math.inf if (x < span[4]) == (span[7] > 0.0) else -math.inf
    return float(-span[7] * (x - span[4]) / rise)


@kernel
def _lowest(
    start: F64_2, end: F64_2, component: I64_1, spans: F64_2, owner: I64_1, count: int
) -> Any:
    """Return the lowest point of each component, (c, 2) mm."""
    probe = np.full((count, 2), math.inf)
    for i in range(len(component)):
        c = component[i]
        for point in (start[i], end[i]):
            if point[1] < probe[c, 1]:
                probe[c, 0], probe[c, 1] = point[0], point[1]
    for i in range(len(spans)):
        c = owner[i]
        bottom = spans[i, 5] - spans[i, 6]
        if spans[i, 7] < 0.0 and spans[i, 0] < spans[i, 4] < spans[i, 2] and bottom < probe[c, 1]:
            probe[c, 0], probe[c, 1] = spans[i, 4], bottom
    return probe


def _laid_out(spans: F64) -> tuple[F64, F64, I64]:
    """Return the corner, the cell size and the columns and rows of a grid over spans."""
    bow = np.where(spans[:, 7] == 0.0, 0.0, 2.0 * spans[:, 6])
    low = np.array([spans[:, 0].min(), (np.minimum(spans[:, 1], spans[:, 3]) - bow).min()])
    high = np.array([spans[:, 2].max(), (np.maximum(spans[:, 1], spans[:, 3]) + bow).max()])
    extent = np.maximum(high - low, 1e-6)
    # In how many columns and rows a span lies must not grow with their number.
    wide = (spans[:, 2] - spans[:, 0]).mean() / extent[0]
    tall = (np.abs(spans[:, 3] - spans[:, 1]) + bow).mean() / extent[1]
    most = np.array([_CROWDED / max(wide, 1e-9), _CROWDED / max(tall, 1e-9)])
    side = math.sqrt(len(spans))
    columns = max(1.0, min(side, most[0]))
    rows = max(1.0, min(len(spans) / columns, most[1]))
    columns = max(columns, min(len(spans) / rows, most[0]))
    shape = np.array([int(columns), int(rows)])
    return low, extent / shape, shape


@kernel(checks_division=True)
def _rows(span: F64_1, column: int, low: F64_1, size: F64_1, shape: I64_1) -> Any:
    """Return the first and last row that a span has in a column."""
    x0 = max(low[0] + column * size[0], span[0])
    x1 = min(low[0] + (column + 1) * size[0], span[2])
    a, b = _height(span, x0), _height(span, x1)
    y0, y1 = min(a, b), max(a, b)
    if span[7] != 0.0 and x0 < span[4] < x1:
        top = span[5] + span[7] * span[6]
        y0, y1 = min(y0, top), max(y1, top)
    # A hair more, for rounding.
    first = int((y0 - 1e-6 - low[1]) / size[1])
    last = int((y1 + 1e-6 - low[1]) / size[1])
    return min(max(first, 0), shape[1] - 1), min(max(last, 0), shape[1] - 1)


@kernel(checks_division=True)
def _column(x: float, low: F64_1, size: F64_1, shape: I64_1) -> int:
    return int(min(max(int((x - low[0]) / size[0]), 0), shape[0] - 1))


@kernel
def _cells(spans: F64_2, low: F64_1, size: F64_1, shape: I64_1) -> Any:
    """Return the spans in each cell: where the cell's begin, and their list."""
    first = np.zeros(shape[0] * shape[1] + 1, np.int64)
    listed = np.empty(0, np.int32)
    # Counted first, and then written where the counts say.
    for writes in range(2):
        for i in range(len(spans)):
            begin = _column(spans[i, 0] - 1e-6, low, size, shape)
            end = _column(spans[i, 2] + 1e-6, low, size, shape)
            for column in range(begin, end + 1):
                bottom, top = _rows(spans[i], column, low, size, shape)
                for row in range(bottom, top + 1):
                    cell = column * shape[1] + row
                    if writes:
                        first[cell] -= 1
                        listed[first[cell]] = i
                    else:
                        first[cell] += 1
        if not writes:
            for cell in range(len(first) - 1):
                first[cell + 1] += first[cell]
            listed = np.empty(first[-1], np.int32)
    return first, listed


@kernel(checks_division=True)
def _below(
    probe: F64_2,
    spans: F64_2,
    owner: I64_1,
    low: F64_1,
    size: F64_1,
    shape: I64_1,
    first: I64_1,
    listed: I32_1,
) -> Any:
    """Return the span of another component that lies first below each point, -1 for none.

    The ray stands a hair to the right of the point: spans that begin there are met, and of two that
    begin in one place the steeper one is the upper.
    """
    met = np.full(len(probe), -1, np.int64)
    for c in range(len(probe)):
        x, y = probe[c, 0], probe[c, 1]
        column = _column(x, low, size, shape)
        row = min(max(int((y - low[1]) / size[1]), 0), shape[1] - 1)
        best, steep = -math.inf, -math.inf
        while row >= 0:
            cell = column * shape[1] + row
            for k in range(first[cell], first[cell + 1]):
                i = listed[k]
                if owner[i] == c or not spans[i, 0] <= x < spans[i, 2]:
                    continue
                height = _height(spans[i], x)
                if height >= y or height < best:
                    continue
                slope = _slope(spans[i], x)
                if height > best or slope > steep:
                    best, steep = height, slope
                    met[c] = i
            if met[c] >= 0 and best >= low[1] + row * size[1]:
                break
            row -= 1
    return met
