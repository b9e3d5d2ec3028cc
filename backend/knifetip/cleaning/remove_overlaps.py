"""remove_overlaps: keep one edge where several edges overlap, and shorten the other edges.

Edges are processed in the order of the priority of their line types; edges of equal priority are
processed from the longest to the shortest.  An edge that is processed later loses the parts that
overlap an earlier edge, if the line type of the earlier edge makes them superfluous: for example, a
cut makes a crease superfluous.  The module ``priority`` contains these rules.  A part is removed
only at a position at which another edge remains.

Edges overlap if they are within ``SAME``.  In a second pass, those that nearly coincide, within
``GAP``, are treated alike: no part of them is moved by more than ``GAP``, and what lies beyond the
end of the other edge is dropped if it is at most as long as ``GAP``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.cleaning.deviation import distance_to_edge, point_on_edge
from knifetip.cleaning.edge_parameter import part_beside, place_of, range_of, size_of
from knifetip.cleaning.overlapping import find_overlapping
from knifetip.cleaning.priority import COVERS, PRIORITY
from knifetip.errors import DrawingTooLarge
from knifetip.geometry import arc
from knifetip.geometry.capacity import reserve_f64_2, reserve_i64_2
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.geometry.tolerance import BULGE, GAP, POINT, SAME
from knifetip.geometry.unique_rows import unique_rows
from knifetip.kernels import (
    F64_2,
    I64_1,
    Bool_1,
    Bool_2,
    OutF64_1,
    OutF64_2,
    OutI64_2,
    inline_kernel,
    kernel,
)

#: Limits of stretches, in total and per edge: if each edge overlaps hundreds of others, their
#: number grows with the square of that of edges.
_STRETCHES: Final = 1_000_000
_TO_AN_EDGE: Final = 16
#: Chains of edges whose lengths differ by less than about this fraction are alike.
_ALIKE: Final = 0.01
#: Of a chain whose edges are shorter on average (mm), the chain beside it remains.
_ROUNDED: Final = 0.02


@dataclass(frozen=True, eq=False, slots=True)
class Pieces:
    """The m pieces without overlaps that remain of k edges.

    Each edge is divided into stretches, q in total.  Each stretch is coincident with one piece, a
    piece of the same edge or of an edge that overlaps it.
    """

    ends: F64  #: (m, 2, 2) mm
    bulge: F64  #: (m,) one per piece
    owner: I32  #: (m,) edge of which each piece is a part
    edge: I32  #: (q,) edge of each stretch
    begin: F64  #: (q,) start of each stretch, 0 … 1 of the length of its edge
    end: F64  #: (q,) end of each stretch, 0 … 1
    piece: I32  #: (q,) piece that covers each stretch; -1 if it is dropped
    is_foreign: Bool  #: (q,) whether that piece belongs to another edge
    moved: F64  #: (m,) distance by which an end of the piece was moved to another edge (mm)
    has_near: bool = False  #: whether edges nearly coincide that do not overlap


class NearEdges(NamedTuple):
    """How k edges that nearly coincide are merged.

    A whole chain of connected edges is processed before the next one, so that the edges of two
    copies do not alternate: the longest first, of nearly equal ones that with the fewest edges, and
    chains of very short edges last.
    """

    chain_of: I64  #: (k,) number of the chain of each edge
    is_fixed: Bool  #: (k,) whether the edge remains although it nearly coincides with another


class _Edges(NamedTuple):
    """k edges, and which of them overlap."""

    rows: F64_2  #: (k, 5) x0, y0, x1, y1, bulge
    kind: I64_1  #: (k,) LineType
    is_fixed: Bool_1  #: (k,) whether no stretch of the edge is removed
    partners: I64_1  #: the edges that overlap each edge, edge by edge
    bounds: I64_1  #: (k + 1,) index in ``partners`` of the first one of each edge


def remove_overlaps(ends: F64, bulge: F64, kind: U8, near: NearEdges | None = None) -> Pieces:
    """Return the pieces of k edges that remain after overlaps are removed.

    Parameters
    ----------
    ends : (k, 2, 2)
        Start and end points of the edges (mm).
    bulge, kind : (k,)
        Bulges and line types of the edges.
    near, optional
        If it is given, edges that nearly coincide are merged, too.

    Raises
    ------
    DrawingTooLarge
        Too many edges overlap.
    """
    count = len(bulge)
    is_near = near is not None
    twin = _duplicates(ends, bulge, kind)
    every = np.arange(count, dtype=np.int32)
    alone = np.flatnonzero(twin == every)
    if len(alone) == count:
        first, second, has_near = find_overlapping(ends, bulge, is_near=is_near)
    else:
        first, second, has_near = find_overlapping(ends[alone], bulge[alone], is_near=is_near)
    if len(first) == 0:
        number = np.full(count, -1, np.int32)
        number[alone] = np.arange(len(alone))
        return Pieces(
            ends[alone],
            bulge[alone],
            alone.astype(np.int32),
            every,
            np.zeros(count),
            np.ones(count),
            number[twin],
            twin != every,
            np.zeros(len(alone)),
            has_near,
        )
    size = np.round(arc.length(ends[alone, 0], ends[alone, 1], bulge[alone]) / POINT)
    # Of equal edges the first drawn remains.
    keys = [np.arange(len(alone)), -size, -PRIORITY[kind[alone]].astype(np.float64)]
    is_fixed = np.zeros(len(alone), np.bool_)
    if near is not None:
        chain_of, is_fixed = near.chain_of[alone], near.is_fixed[alone]
        total = np.bincount(chain_of, size)
        count_of = np.bincount(chain_of)
        # Of chains of nearly equal length, a circle goes before the polygon beside it.
        scale = np.round(np.log(np.maximum(total, 1.0)) / _ALIKE)
        keys[2:2] = [
            chain_of,
            -np.round(total * POINT / SAME)[chain_of],
            count_of[chain_of],
            -scale[chain_of],
            # The directions of very short edges are those of rounded coordinates.
            (total * POINT < _ROUNDED * count_of)[chain_of].astype(np.float64),
        ]
    order = np.lexsort(keys)
    both = np.concatenate([first, second])
    other = np.concatenate([second, first])
    by_edge = np.argsort(both, kind="stable")
    bounds = np.searchsorted(both[by_edge], np.arange(len(alone) + 1))
    rows = np.column_stack([ends[alone].reshape(-1, 4), bulge[alone]])
    max_stretches = max(_STRETCHES, _TO_AN_EDGE * count)
    edges = _Edges(rows, kind[alone].astype(np.int64), is_fixed, other[by_edge], bounds)
    piece, owner, edge, begin, end, on, is_foreign = _remove(
        edges, order, COVERS, GAP if is_near else SAME, is_near, max_stretches
    )
    if len(edge) > max_stretches:
        raise DrawingTooLarge("edge.too-many-overlaps", edges=len(alone), limit=max_stretches)
    # In the order of the drawing, pieces of one edge from its start to its end.
    straight = np.argsort(owner, kind="stable")
    number = np.empty(len(owner), np.int32)
    number[straight] = np.arange(len(owner))
    piece, owner, on = piece[straight], owner[straight], np.where(on < 0, -1, number[on])
    # A duplicate is covered like the edge it duplicates.
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
    back = _are_reversed(ends[double], ends[twin[double]])
    return Pieces(
        piece[:, :4].reshape(-1, 2, 2),
        piece[:, 4].copy(),
        alone[owner].astype(np.int32),
        np.concatenate([alone[edge], double]).astype(np.int32),
        np.concatenate([begin, np.where(back, 1.0 - end[like], begin[like])]),
        np.concatenate([end, np.where(back, 1.0 - begin[like], end[like])]),
        np.concatenate([on, on[like]]).astype(np.int32),
        np.concatenate([is_foreign, np.ones(len(double), np.bool_)]),
        piece[:, 5].copy(),
        has_near,
    )


def _are_reversed(ends: F64, others: F64) -> Bool:
    """Return the mask of the pairs of duplicate edges that have opposite directions, shape (d,).

    ``ends`` and ``others``, (d, 2, 2), contain the two edges of each pair.
    """
    along = ((ends[:, 1] - ends[:, 0]) * (others[:, 1] - others[:, 0])).sum(axis=1)
    return np.asarray(along < 0.0)


def _duplicates(ends: F64, bulge: F64, kind: U8) -> I64:
    """Return for each of k edges the edge with equal geometry that replaces it, (k,).

    The entry is the edge itself if the edge is not replaced.  ``ends`` (k, 2, 2) mm, ``bulge`` and
    ``kind`` (k,) are end points, bulges and line types of the edges.
    """
    count = len(bulge)
    twin = np.arange(count)
    grid = np.round(ends.reshape(-1, 4) / POINT).astype(np.int64)
    turn = np.round(bulge / BULGE).astype(np.int64)
    back = (grid[:, 0] > grid[:, 2]) | ((grid[:, 0] == grid[:, 2]) & (grid[:, 1] > grid[:, 3]))
    grid = np.where(back[:, None], grid[:, [2, 3, 0, 1]], grid)
    left = np.arange(count)
    # A crease is not covered by a perforation, but by another crease: hence two passes.
    for _ in range(2):
        first, group = unique_rows(grid[left], np.where(back, -turn, turn)[left])
        if len(first) == len(left):
            break
        order = np.lexsort((left, -PRIORITY[kind[left]], group))
        head = np.append(True, group[order][1:] != group[order][:-1])
        winner = left[order[head]][group[order]]
        rows = left[order]
        hidden = ~head & COVERS[kind[winner], kind[rows]]
        twin[rows[hidden]] = winner[hidden]
        left = np.sort(rows[~head & ~hidden])
    return twin


@inline_kernel
def _find_covered_stretch(
    rows: F64_2,
    e: int,
    piece: F64_2,
    p: int,
    length: float,
    same: float,
    is_near: bool,
    out: OutF64_1,
) -> int:
    """Find the stretch of an edge that a piece covers; return 1 if there is one, else 0.

    The edge is ``rows[e]`` and the piece is ``piece[p]``, both x0, y0, x1, y1, bulge.  The piece is
    coincident with a part of the edge.

    ``length``: length of the edge (mm).
    ``same``: a stretch that is not longer than this is neglected (mm).
    ``is_near``: whether the piece may be as far as ``same`` from the edge, and what is beyond its
    ends remains.
    ``out``: if a stretch is found, its start and its end (0 … 1 of the edge) are written into
    entries 0 and 1, and ``p`` into entry 2.  Entry 3 becomes 0 if the piece has the direction of
    the edge, and 2 if it has the opposite direction.  Entry 4 becomes the distance of the piece
    from the stretch (mm), 0 without ``is_near``.
    """
    back = False
    # A short arc within the tolerance may have another radius than the longer one.
    is_bent = min(abs(rows[e, 4]), abs(piece[p, 4])) >= BULGE
    is_longer = (is_near or is_bent) and size_of(piece, p) > length
    if is_longer:
        low, high, back = part_beside(rows[e : e + 1], piece[p : p + 1])
    else:
        low, high = range_of(rows, e, piece[p])
    # Ends within the tolerance are equal.
    if low * length < same and not is_near:
        low = 0.0
    if (1.0 - high) * length < same and not is_near:
        high = 1.0
    low, high = max(low, 0.0), min(high, 1.0)
    least = same
    if (abs(rows[e, 4]) < BULGE) != (abs(piece[p, 4]) < BULGE):
        # The chords of a curve may be shorter than the distance.
        least = min(same, 0.5 * length, 0.5 * size_of(piece, p))
    if (high - low) * length <= least:
        return 0
    out[4] = 0.0
    if is_near:
        for place in (low, 0.5 * (low + high), high):
            x, y = point_on_edge(rows[e], place)
            out[4] = max(out[4], distance_to_edge(piece[p], x, y))
        if out[4] > same - POINT:
            return 0
    reversed_ = place_of(rows, e, piece[p, 0], piece[p, 1]) > place_of(
        rows, e, piece[p, 2], piece[p, 3]
    )
    if is_longer:
        reversed_ = back
    elif is_bent:
        reversed_ = (piece[p, 4] < 0.0) != (rows[e, 4] < 0.0)
    out[0], out[1], out[2], out[3] = low, high, p, 2 if reversed_ else 0
    return 1


@inline_kernel
def _add_stretch(
    cover: OutF64_2,
    source: OutI64_2,
    count: int,
    begin: float,
    end: float,
    edge: int,
    piece: int,
    is_foreign: bool,
) -> int:
    """Append a stretch of an edge to two lists, and return the new number of stretches.

    ``cover``: list of the start and the end of each stretch, 0 … 1 of the length of its edge.
    ``source``: list of the edge of each stretch, the piece that covers it, and ``is_foreign``.
    ``begin``, ``end``, ``edge``, ``piece``: values of the new stretch for these lists.
    ``is_foreign``: whether the piece belongs to another edge.
    """
    cover[count, 0], cover[count, 1] = begin, end
    source[count, 0], source[count, 1], source[count, 2] = edge, piece, is_foreign
    return count + 1


@inline_kernel
def _length_beyond_end(apart: float, same: float) -> float:
    """Return how far an edge that runs ``apart`` mm beside another edge continues past the end of
    that edge before it is more than ``same`` mm away from this end (mm).
    """
    return math.sqrt(max(same * same - apart * apart, 0.0))


@kernel
def _remove(
    edges: _Edges, order: I64_1, hides: Bool_2, same: float, is_near: bool, max_stretches: int
) -> Any:
    """Remove from each edge the stretches that overlap pieces of edges processed before it.

    ``order`` (k,): order in which the edges are processed.
    ``hides``: ``hides[a, b]``: whether an edge of line type a removes a stretch of line type b.
    ``same``: length up to which stretches are neglected (mm).
    ``is_near``: whether the edges only nearly coincide, within ``same``.
    ``max_stretches``: limit of the number q of stretches.  The function may stop early if the limit
    is exceeded, so the caller must reject a result with more stretches than this.
    Returns piece, owner: the m pieces that remain (x0, y0, x1, y1, bulge, displacement of an end),
    (m, 6), and the edge of each, (m,); edge, begin, end, piece, is_foreign: for each of q
    stretches, (q,): its edge, its start and end (0 … 1 of the edge), the index of the piece that is
    coincident with it (-1 if it is dropped), and whether this piece belongs to another edge.
    """
    rows, kind, is_fixed, partners, bounds = edges
    count = len(rows)
    piece = np.zeros((count + 64, 6))
    owner = np.empty((count + 64, 1), np.int64)
    cover = np.empty((2 * count + 64, 2))
    source = np.empty((2 * count + 64, 3), np.int64)
    claim = np.empty((64, 6))
    first = np.zeros(count, np.int64)
    last = np.zeros(count, np.int64)
    pieces = 0
    stretches = 0
    for e in order:
        if stretches > max_stretches:
            break
        first[e] = pieces
        length = size_of(rows, e)
        claims = 0
        for at in range(bounds[e], bounds[e + 1]):
            f = partners[at]
            if is_fixed[e] or not hides[kind[f], kind[e]]:
                continue
            for p in range(first[f], last[f]):
                claim = reserve_f64_2(claim, claims + 1)
                claims += _find_covered_stretch(
                    rows, e, piece, p, length, same, is_near, claim[claims]
                )
        piece = reserve_f64_2(piece, pieces + claims + 1)
        owner = reserve_i64_2(owner, pieces + claims + 1)
        cover = reserve_f64_2(cover, stretches + 2 * claims + 3)
        source = reserve_i64_2(source, stretches + 2 * claims + 3)
        if claims == 0:
            piece[pieces, :5] = rows[e]
            piece[pieces, 5] = 0.0
            owner[pieces, 0] = e
            stretches = _add_stretch(cover, source, stretches, 0.0, 1.0, e, pieces, False)
            pieces += 1
            last[e] = pieces
            continue
        here = 0.0
        moved = 0.0
        x, y = rows[e, 0], rows[e, 1]
        sorted_ = np.argsort(claim[:claims, 0], kind="mergesort")
        for step in range(claims + 1):
            low, high = 1.0, 1.0
            ex, ey = rows[e, 2], rows[e, 3]
            p = -1
            apart = 0.0
            if step < claims:
                row = sorted_[step]
                low, high = claim[row, 0], claim[row, 1]
                p = int(claim[row, 2])
                near_end = int(claim[row, 3])
                apart = claim[row, 4]
                if low > 0.0:
                    ex, ey = piece[p, near_end], piece[p, near_end + 1]
                else:
                    ex, ey = rows[e, 0], rows[e, 1]
            neglected = same
            if is_near and here > 0.0 and step < claims:
                neglected = _length_beyond_end(apart, same)
            if (low - here) * length > neglected and math.hypot(ex - x, ey - y) > neglected:
                piece[pieces, 0] = x
                piece[pieces, 1] = y
                piece[pieces, 2] = ex
                piece[pieces, 3] = ey
                piece[pieces, 4] = math.tan(math.atan(rows[e, 4]) * (low - here))
                piece[pieces, 5] = max(moved, apart if low > 0.0 else 0.0)
                owner[pieces, 0] = e
                stretches = _add_stretch(cover, source, stretches, here, low, e, pieces, False)
                pieces += 1
                here = low
            elif step == claims and here < 1.0 and stretches > 0:
                # A remainder below the tolerance is added to the previous stretch.
                reached = 1.0
                if is_near:
                    reached = min(1.0, here + _length_beyond_end(moved, same) / length)
                cover[stretches - 1, 1] = reached
                if (1.0 - reached) * length > POINT:
                    stretches = _add_stretch(cover, source, stretches, reached, 1.0, e, -1, True)
                else:
                    cover[stretches - 1, 1] = 1.0
            if step < claims and high > here:
                high = min(high, 1.0)
                if is_near and here == 0.0 and low > 0.0:
                    begin = max(0.0, low - _length_beyond_end(apart, same) / length)
                    if begin * length > POINT:
                        stretches = _add_stretch(cover, source, stretches, 0.0, begin, e, -1, True)
                        here = begin
                stretches = _add_stretch(cover, source, stretches, here, high, e, p, True)
                here = high
                moved = apart
                far_end = 2 - int(claim[sorted_[step], 3])
                x, y = piece[p, far_end], piece[p, far_end + 1]
        last[e] = pieces
    return (
        piece[:pieces].copy(),
        owner[:pieces, 0].copy(),
        source[:stretches, 0].copy(),
        cover[:stretches, 0].copy(),
        cover[:stretches, 1].copy(),
        source[:stretches, 1].copy(),
        source[:stretches, 2].copy() == 1,
    )
