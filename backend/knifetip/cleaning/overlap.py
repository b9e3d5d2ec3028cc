"""overlap: what is drawn on something else, whole or in part.

    edges of some line types -> pieces that lie on nothing else, and what each stretch lies on

Two lines lie on each other where, seen from the longer one, both ends of the shorter are within
``SAME`` of its line; two arcs, where ends and middle of the shorter are that near the circle of the
longer.  Edges are taken up by rank, then the longest first, and each gives up what lies on a piece
that stands already: so nothing is given up but beside something that stays.

Candidates come from a tree of boxes in which lines of one direction stand beside each other, laid
along that direction, so that their boxes are slim.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numba import njit

from knifetip.cleaning.rank import HIDES, RANK
from knifetip.errors import DrawingTooLarge
from knifetip.geometry import arc
from knifetip.geometry.boxes import STACK, next_near, tree, tree_size
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.geometry.distinct import distinct
from knifetip.geometry.tolerance import ANGLE, BULGE, POINT, SAME

#: Lines are laid beside those whose direction is the nearest of so many (degrees apart).
_FAN: Final = 2.0
_ARCS: Final = 90
#: So many edges that lie on one are looked at; where there are more, cleaning goes round again.
_CROWD: Final = 64
#: So many edges are looked at whether they lie on one: only where thousands cross at slants of a
#: degree or two are there more, and a drawing must not take forever.
_LOOKS: Final = 2048
#: More stretches than this, or than so many to an edge, are nothing that anybody has drawn: lines
#: of which each lies on hundreds of others come to the square of their number.
_STRETCHES: Final = 1_000_000
_TO_AN_EDGE: Final = 16


@dataclass(frozen=True, eq=False, slots=True)
class Pieces:
    """m pieces that lie on nothing else, and q stretches that cover all of the k edges."""

    ends: F64  #: (m, 2, 2) mm
    bulge: F64  #: (m,)
    owner: I32  #: (m,) the edge that each is a part of
    edge: I32  #: (q,) the edge of each stretch
    begin: F64  #: (q,) where it begins, 0 … 1 of the edge's length
    end: F64  #: (q,) where it ends
    piece: I32  #: (q,) the piece that it is or lies on
    given: Bool  #: (q,) whether it was given up, to lie on another one


def parted(ends: F64, bulge: F64, kind: U8) -> Pieces:
    """Return the pieces of edges (k, 2, 2) mm, (k,), of line types (k,), that are drawn once.

    Raises
    ------
    DrawingTooLarge
        So many edges lie on so many others that it would take forever.
    """
    count = len(bulge)
    twin = _twins(ends, bulge, kind)
    alone = np.flatnonzero(twin == np.arange(count))
    first, second = _pairs(ends[alone], bulge[alone])
    if len(first) == 0:
        number = np.full(count, -1, np.int32)
        number[alone] = np.arange(len(alone))
        every = np.arange(count, dtype=np.int32)
        return Pieces(
            ends[alone],
            bulge[alone],
            alone.astype(np.int32),
            every,
            np.zeros(count),
            np.ones(count),
            number[twin],
            twin != every,
        )
    size = np.round(arc.length(ends[alone, 0], ends[alone, 1], bulge[alone]) / POINT)
    # Of equal ones the first drawn stays.
    order = np.lexsort((np.arange(len(alone)), -size, -RANK[kind[alone]]))
    both = np.concatenate([first, second])
    other = np.concatenate([second, first])
    by_edge = np.argsort(both, kind="stable")
    bounds = np.searchsorted(both[by_edge], np.arange(len(alone) + 1))
    rows = np.column_stack([ends[alone].reshape(-1, 4), bulge[alone]])
    most = max(_STRETCHES, _TO_AN_EDGE * count)
    piece, owner, edge, begin, end, on, given = _given_up(
        rows, kind[alone].astype(np.int64), order, other[by_edge], bounds, HIDES, SAME, most
    )
    if len(edge) > most:
        raise DrawingTooLarge(
            f"{len(alone):,} edges lie on each other in more than {most:,} places.",
            "Delete from the drawing what is drawn many times over.",
        )
    # In the order of the drawing, pieces of one edge from its start to its end.
    straight = np.argsort(owner, kind="stable")
    number = np.empty(len(owner), np.int32)
    number[straight] = np.arange(len(owner))
    piece, owner, on = piece[straight], owner[straight], number[on]
    # A twin goes where the stretches of its first go.
    doubles = np.flatnonzero(twin != np.arange(count))
    of_first = np.argsort(edge, kind="stable")
    place = np.full(count, -1, np.int64)
    place[alone] = np.arange(len(alone))
    low = np.searchsorted(edge[of_first], place[twin[doubles]])
    high = np.searchsorted(edge[of_first], place[twin[doubles]] + 1)
    many = high - low
    double = np.repeat(doubles, many)
    offset = np.arange(len(double)) - np.repeat(np.cumsum(many) - many, many)
    like = of_first[np.repeat(low, many) + offset]
    back = _reversed(ends[double], ends[twin[double]])
    return Pieces(
        piece[:, :4].reshape(-1, 2, 2),
        piece[:, 4].copy(),
        alone[owner].astype(np.int32),
        np.concatenate([alone[edge], double]).astype(np.int32),
        np.concatenate([begin, np.where(back, 1.0 - end[like], begin[like])]),
        np.concatenate([end, np.where(back, 1.0 - begin[like], end[like])]),
        np.concatenate([on, on[like]]).astype(np.int32),
        np.concatenate([given, np.ones(len(double), np.bool_)]),
    )


def _reversed(ends: F64, others: F64) -> Bool:
    """Return whether edges run against others that are the same."""
    along = ((ends[:, 1] - ends[:, 0]) * (others[:, 1] - others[:, 0])).sum(axis=1)
    return np.asarray(along < 0.0)


def _twins(ends: F64, bulge: F64, kind: U8) -> I64:
    """Return for each edge the one that is the same line and hides it, or itself."""
    count = len(bulge)
    twin = np.arange(count)
    grid = np.round(ends.reshape(-1, 4) / POINT).astype(np.int64)
    turn = np.round(bulge / BULGE).astype(np.int64)
    back = (grid[:, 0] > grid[:, 2]) | ((grid[:, 0] == grid[:, 2]) & (grid[:, 1] > grid[:, 3]))
    grid = np.where(back[:, None], grid[:, [2, 3, 0, 1]], grid)
    left = np.arange(count)
    # A crease under a perforation is not hidden by it, but by another crease: hence twice.
    for _ in range(2):
        first, group = distinct(grid[left], np.where(back, -turn, turn)[left])
        if len(first) == len(left):
            break
        order = np.lexsort((left, -RANK[kind[left]], group))
        head = np.append(True, group[order][1:] != group[order][:-1])
        winner = left[order[head]][group[order]]
        rows = left[order]
        hidden = ~head & HIDES[kind[winner], kind[rows]]
        twin[rows[hidden]] = winner[hidden]
        left = np.sort(rows[~head & ~hidden])
    return twin


def _pairs(ends: F64, bulge: F64) -> tuple[I64, I64]:
    """Return the pairs of edges that lie on each other somewhere, each once."""
    none = np.zeros(0, np.int64)
    if len(bulge) < 2:
        return none, none
    low = ends.reshape(-1, 2).min(axis=0)
    moved = ends - low
    reach = 4.0 * (float(np.abs(moved).max()) + 1.0)
    rows = np.column_stack([moved.reshape(-1, 4), bulge])
    boxes, bucket, angle, width = _laid(rows, np.radians(_FAN), np.radians(ANGLE), SAME)
    shelf = np.floor(boxes[:, 1] / np.where(bucket == _ARCS, reach / 64.0, SAME))
    order = np.lexsort((boxes[:, 0], shelf, bucket))
    found = _overlapping(
        rows[order],
        boxes[order] + np.outer(bucket[order] * reach, [0.0, 1.0, 0.0, 1.0]),
        bucket[order],
        angle[order],
        width[order],
        reach,
        math.radians(_FAN),
        SAME,
    )
    one, two = order[found[:, 0]], order[found[:, 1]]
    # Sorted: in a crowd there are millions, of which numpy's ``unique`` makes a table of hashes.
    pair = np.sort(np.minimum(one, two) * len(bulge) + np.maximum(one, two))
    pair = pair[np.append(True, pair[1:] != pair[:-1])] if len(pair) else pair
    return pair // len(bulge), pair % len(bulge)


@njit(cache=True, error_model="numpy")
def _laid(rows: Any, fan: float, most: float, same: float) -> Any:
    """Boxes of edges, lines laid along the nearest direction of the fan, and which that is."""
    count = len(rows)
    boxes = np.empty((count, 4))
    bucket = np.empty(count, np.int64)
    angle = np.empty(count)
    width = np.empty(count)
    for i in range(count):
        x0, y0, x1, y1, b = rows[i, 0], rows[i, 1], rows[i, 2], rows[i, 3], rows[i, 4]
        if abs(b) >= BULGE:
            bucket[i] = _ARCS
            angle[i] = 0.0
            width[i] = 0.0
            rise_x = 0.5 * b * (y1 - y0)
            rise_y = 0.5 * b * (x0 - x1)
            boxes[i, 0] = min(x0, x1) + min(rise_x, 0.0) - same
            boxes[i, 1] = min(y0, y1) + min(rise_y, 0.0) - same
            boxes[i, 2] = max(x0, x1) + max(rise_x, 0.0) + same
            boxes[i, 3] = max(y0, y1) + max(rise_y, 0.0) + same
            continue
        theta = math.atan2(y1 - y0, x1 - x0) % math.pi
        number = round(theta / fan)
        bucket[i] = number % _ARCS
        angle[i] = theta
        length = math.hypot(x1 - x0, y1 - y0)
        width[i] = most if length < 2.0 * same else min(most, 2.2 * same / length)
        _box(rows, i, bucket[i] * fan, same, boxes, i)
    return boxes, bucket, angle, width


@njit(cache=True, error_model="numpy")
def _box(rows: Any, i: int, turn: float, same: float, boxes: Any, at: int) -> None:
    """The box of a line in a frame that is turned."""
    c, s = math.cos(turn), math.sin(turn)
    u0 = c * rows[i, 0] + s * rows[i, 1]
    u1 = c * rows[i, 2] + s * rows[i, 3]
    v0 = c * rows[i, 1] - s * rows[i, 0]
    v1 = c * rows[i, 3] - s * rows[i, 2]
    boxes[at, 0] = min(u0, u1)
    boxes[at, 1] = min(v0, v1) - same
    boxes[at, 2] = max(u0, u1)
    boxes[at, 3] = max(v0, v1) + same


@njit(cache=True, error_model="numpy")
def _overlapping(
    rows: Any,
    boxes: Any,
    bucket: Any,
    angle: Any,
    width: Any,
    reach: float,
    fan: float,
    same: float,
) -> Any:
    count = len(rows)
    nodes = np.empty((tree_size(count), 4))
    nodes[:count] = boxes
    level = np.empty(24, np.int64)
    height = tree(nodes, count, level)
    stack = np.empty((STACK, 2), np.int64)
    other = np.empty((1, 4))
    found = np.empty((64, 2), np.int64)
    size = 0
    for i in range(count):
        # Which direction's shelf to look on: the own one, and a neighbour's that is near enough.
        for look in range(-1, 2):
            after = i
            box = boxes[i]
            if look != 0:
                if bucket[i] == _ARCS:
                    continue
                off = (angle[i] - bucket[i] * fan + math.pi / 2.0) % math.pi - math.pi / 2.0
                if look * off < fan / 2.0 - width[i]:
                    continue
                shelf = (bucket[i] + look) % _ARCS
                _box(rows, i, shelf * fan, same, other, 0)
                other[0, 1] += shelf * reach
                other[0, 3] += shelf * reach
                box = other[0]
                after = -1
            stack[0, 0] = height
            stack[0, 1] = 0
            depth = 1
            partners = 0
            looks = 0
            while partners < _CROWD and looks < _LOOKS:
                looks += 1
                j, depth = next_near(
                    nodes, level, stack, depth, box[0], box[1], box[2], box[3], after
                )
                if j < 0:
                    break
                if i != j and _share(rows, i, j, same):
                    if size == len(found):
                        more = np.empty((2 * size, 2), np.int64)
                        more[:size] = found
                        found = more
                    found[size, 0] = i
                    found[size, 1] = j
                    size += 1
                    partners += 1
    return found[:size].copy()


@njit(cache=True, error_model="numpy")
def _share(rows: Any, i: int, j: int, same: float) -> bool:
    """Whether two edges lie on each other along more than ``same``."""
    if (abs(rows[i, 4]) >= BULGE) != (abs(rows[j, 4]) >= BULGE):
        return False
    if _size(rows, i) < _size(rows, j):
        i, j = j, i
    length = _size(rows, i)
    if abs(rows[i, 4]) < BULGE:
        dx = (rows[i, 2] - rows[i, 0]) / length
        dy = (rows[i, 3] - rows[i, 1]) / length
        wide = (rows[j, 3] - rows[j, 1]) * dx - (rows[j, 2] - rows[j, 0]) * dy
        if abs(wide) > _size(rows, j) * math.sin(math.radians(ANGLE)):
            return False
        for end in range(2):
            x = rows[j, 2 * end] - rows[i, 0]
            y = rows[j, 2 * end + 1] - rows[i, 1]
            if abs(y * dx - x * dy) > same:
                return False
    else:
        cx, cy, radius, _ = _circle(rows, i)
        mx, my = _middle(rows, j)
        for x, y in ((rows[j, 0], rows[j, 1]), (rows[j, 2], rows[j, 3]), (mx, my)):
            if abs(math.hypot(x - cx, y - cy) - radius) > same:
                return False
    low, high = _range(rows, i, rows[j])
    return (min(high, 1.0) - max(low, 0.0)) * length > same


@njit(cache=True, error_model="numpy")
def _circle(rows: Any, i: int) -> tuple[float, float, float, float]:
    """Centre, radius and sweep of an arc."""
    b = rows[i, 4]
    dx = rows[i, 2] - rows[i, 0]
    dy = rows[i, 3] - rows[i, 1]
    lean = (1.0 - b * b) / (4.0 * b)
    cx = 0.5 * (rows[i, 0] + rows[i, 2]) - lean * dy
    cy = 0.5 * (rows[i, 1] + rows[i, 3]) + lean * dx
    radius = math.hypot(dx, dy) * (1.0 + b * b) / (4.0 * abs(b))
    return cx, cy, radius, 4.0 * math.atan(b)


@njit(cache=True, error_model="numpy")
def _size(rows: Any, i: int) -> float:
    """Length of a line or an arc."""
    chord = math.hypot(rows[i, 2] - rows[i, 0], rows[i, 3] - rows[i, 1])
    b = abs(rows[i, 4])
    if b < BULGE:
        return chord
    return float(chord * (1.0 + b * b) * math.atan(b) / b)


@njit(cache=True, error_model="numpy")
def _middle(rows: Any, i: int) -> tuple[float, float]:
    """The middle of a line or an arc."""
    b = rows[i, 4]
    return (
        0.5 * (rows[i, 0] + rows[i, 2]) + 0.5 * b * (rows[i, 3] - rows[i, 1]),
        0.5 * (rows[i, 1] + rows[i, 3]) - 0.5 * b * (rows[i, 2] - rows[i, 0]),
    )


@njit(cache=True, error_model="numpy")
def _place(rows: Any, i: int, x: float, y: float) -> float:
    """How far along edge i a point lies beside it, in lengths of the edge; of an arc, to ± half
    the circle from its middle."""
    if abs(rows[i, 4]) < BULGE:
        dx = rows[i, 2] - rows[i, 0]
        dy = rows[i, 3] - rows[i, 1]
        return float(((x - rows[i, 0]) * dx + (y - rows[i, 1]) * dy) / (dx * dx + dy * dy))
    cx, cy, _, sweep = _circle(rows, i)
    mx, my = _middle(rows, i)
    mx -= cx
    my -= cy
    x -= cx
    y -= cy
    return 0.5 + math.atan2(mx * y - my * x, mx * x + my * y) / sweep


@njit(cache=True, error_model="numpy")
def _range(rows: Any, i: int, piece: Any) -> tuple[float, float]:
    """From where to where on edge i a piece lies, in lengths of the edge; not clipped."""
    if abs(rows[i, 4]) < BULGE:
        a = _place(rows, i, piece[0], piece[1])
        b = _place(rows, i, piece[2], piece[3])
        return min(a, b), max(a, b)
    sweep = 4.0 * math.atan(rows[i, 4])
    mx = 0.5 * (piece[0] + piece[2]) + 0.5 * piece[4] * (piece[3] - piece[1])
    my = 0.5 * (piece[1] + piece[3]) - 0.5 * piece[4] * (piece[2] - piece[0])
    middle = _place(rows, i, mx, my)
    round_ = abs(2.0 * math.pi / sweep)
    # Not by its sweep: a shallow arc that lies as near may have another radius.
    a = _place(rows, i, piece[0], piece[1]) - middle
    b = _place(rows, i, piece[2], piece[3]) - middle
    a -= round_ * round(a / round_)
    b -= round_ * round(b / round_)
    low, high = min(a, b), max(a, b)
    best = middle
    most = -np.inf
    for turn in range(-1, 2):
        at = middle + turn * round_
        common = min(at + high, 1.0) - max(at + low, 0.0)
        if common > most:
            most = common
            best = at
    return best + low, best + high


@njit(cache=True, error_model="numpy")
def _grown(table: Any, wanted: int) -> Any:
    if wanted <= len(table):
        return table
    more = np.empty((2 * wanted, table.shape[1]), table.dtype)
    more[: len(table)] = table
    return more


@njit(cache=True, error_model="numpy")
def _given_up(
    rows: Any, kind: Any, order: Any, near: Any, bounds: Any, hides: Any, same: float, most: int
) -> Any:
    """Take edges up in order; each gives up what lies on pieces that stand already.  Past ``most``
    stretches it stops."""
    count = len(rows)
    piece = np.empty((count + 64, 5))
    owner = np.empty((count + 64, 1), np.int64)
    cover = np.empty((2 * count + 64, 2))
    told = np.empty((2 * count + 64, 3), np.int64)  # edge, piece, given up
    claim = np.empty((64, 6))
    first = np.zeros(count, np.int64)
    last = np.zeros(count, np.int64)
    pieces = 0
    stretches = 0
    for e in order:
        if stretches > most:
            break
        first[e] = pieces
        length = _size(rows, e)
        claims = 0
        for at in range(bounds[e], bounds[e + 1]):
            f = near[at]
            if not hides[kind[f], kind[e]]:
                continue
            for p in range(first[f], last[f]):
                low, high = _range(rows, e, piece[p])
                # Beginnings and ends that all but meet are meant to.
                if low * length < same:
                    low = 0.0
                if (1.0 - high) * length < same:
                    high = 1.0
                if (high - low) * length <= same:
                    continue
                claim = _grown(claim, claims + 1)
                turned = _place(rows, e, piece[p, 0], piece[p, 1]) > _place(
                    rows, e, piece[p, 2], piece[p, 3]
                )
                if abs(rows[e, 4]) >= BULGE:
                    turned = (piece[p, 4] < 0.0) != (rows[e, 4] < 0.0)
                claim[claims, 0] = low
                claim[claims, 1] = high
                claim[claims, 2] = p
                claim[claims, 3] = 2 if turned else 0
                claims += 1
        piece = _grown(piece, pieces + claims + 1)
        owner = _grown(owner, pieces + claims + 1)
        cover = _grown(cover, stretches + 2 * claims + 1)
        told = _grown(told, stretches + 2 * claims + 1)
        if claims == 0:
            piece[pieces] = rows[e]
            owner[pieces, 0] = e
            cover[stretches, 0] = 0.0
            cover[stretches, 1] = 1.0
            told[stretches, 0] = e
            told[stretches, 1] = pieces
            told[stretches, 2] = 0
            stretches += 1
            pieces += 1
            last[e] = pieces
            continue
        here = 0.0
        x, y = rows[e, 0], rows[e, 1]
        sorted_ = np.argsort(claim[:claims, 0], kind="mergesort")
        for step in range(claims + 1):
            low, high = 1.0, 1.0
            ex, ey = rows[e, 2], rows[e, 3]
            p = -1
            if step < claims:
                row = sorted_[step]
                low, high = claim[row, 0], claim[row, 1]
                p = int(claim[row, 2])
                near_end = int(claim[row, 3])
                if low > 0.0:
                    ex, ey = piece[p, near_end], piece[p, near_end + 1]
                else:
                    ex, ey = rows[e, 0], rows[e, 1]
            if (low - here) * length > same and math.hypot(ex - x, ey - y) > same:
                piece[pieces, 0] = x
                piece[pieces, 1] = y
                piece[pieces, 2] = ex
                piece[pieces, 3] = ey
                piece[pieces, 4] = math.tan(math.atan(rows[e, 4]) * (low - here))
                owner[pieces, 0] = e
                cover[stretches, 0] = here
                cover[stretches, 1] = low
                told[stretches, 0] = e
                told[stretches, 1] = pieces
                told[stretches, 2] = 0
                stretches += 1
                pieces += 1
                here = low
            elif step == claims and here < 1.0 and stretches > 0:
                # What is left is less than the tolerance: it belongs to the stretch before.
                cover[stretches - 1, 1] = 1.0
            if step < claims and high > here:
                cover[stretches, 0] = here
                cover[stretches, 1] = min(high, 1.0)
                told[stretches, 0] = e
                told[stretches, 1] = p
                told[stretches, 2] = 1
                stretches += 1
                here = min(high, 1.0)
                far_end = 2 - int(claim[sorted_[step], 3])
                x, y = piece[p, far_end], piece[p, far_end + 1]
        last[e] = pieces
    return (
        piece[:pieces].copy(),
        owner[:pieces, 0].copy(),
        told[:stretches, 0].copy(),
        cover[:stretches, 0].copy(),
        cover[:stretches, 1].copy(),
        told[:stretches, 1].copy(),
        told[:stretches, 2].copy() == 1,
    )
