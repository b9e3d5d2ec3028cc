"""trim_folds: drop the pieces of creases and V-grooves that surely lie in the waste.

Cuts divide a fold into pieces.  Contours are cuts that enclose an area.  A point inside an odd
number of contours lies on a panel, any other point in the waste: outside all outlines, or in a
hole.  Two kinds of pieces in the waste are dropped:

* an *overshoot*: the first or last piece of a fold, if it adjoins a piece on a panel, no other edge
  touches its free end, and it is at most ``OVERSHOOT`` long.  The overshoots that adjoin one piece
  must be shorter than that piece.
* a *passage*: a piece of any length between two pieces on panels, for example across a window.
  Neither of these two may have the form of an overshoot, otherwise the fold could belong to a panel
  inside the window and overshoot it on that side.

A piece stays if there is doubt whether it lies in the waste.  Folds in the waste that no cut
divides, and cuts in the waste that enclose nothing, are signs of a panel whose outline is open or
not drawn.  All pieces in the smallest upright rectangle around these signs stay.  A piece stays
also if a cut that does not divide it touches it between its ends.

The rule is in ``docs/contacts.md``.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import radians, sin
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.cleaning.remove_overlaps import Pieces
from knifetip.errors import PlanError
from knifetip.geometry import arc
from knifetip.geometry.azimuth import left_normal, unit_vectors
from knifetip.geometry.columns import F64, I64, U8, Bool
from knifetip.geometry.intersect import MAX_POINTS, intersect_rows
from knifetip.geometry.points_on_segments import find_points_on_segments
from knifetip.geometry.spatial_index.box_pairs import box_pairs
from knifetip.geometry.tolerance import ANGLE, CONTOUR_GAP, GAP, JOIN
from knifetip.kernels import F64_1, F64_2, I64_1, kernel
from knifetip.model.dieline import LineType
from knifetip.topology.contour_gaps import closing_links, find_dangling_ends
from knifetip.topology.noding import split_at_crossings
from knifetip.topology.subdivision import Subdivision, subdivide

#: Greatest length of an overshoot (mm): 20 mm and the tolerance of a contact.
OVERSHOOT: Final = 20.05
#: Gaps up to this are closed in the search for contours, and a cut up to this that is attached to a
#: contour is an overshoot (mm).
_NEAR: Final = 1.95
#: Line types of folds.
_FOLDS: Final = (LineType.CREASE, LineType.COMBI, LineType.V_GROOVE)
#: A cut at a smaller angle runs along a fold and does not divide it (sine of 1°).
_ACROSS: Final = sin(radians(ANGLE))


class _Parts(NamedTuple):
    """The q pieces into which cuts divide folds, sorted by fold and from its start to its end."""

    edge: I64  #: (q,) edge of each piece
    begin: F64  #: (q,) start of each piece, 0 … 1 of the edge
    end: F64  #: (q,) end of each piece


@dataclass(frozen=True, slots=True)
class _Contours:
    """The contours that cuts form, and the signs of panels whose outlines are open."""

    subdivision: Subdivision
    doubtful: F64  #: (4,) mm, rectangle around these signs: least x and y, greatest x and y

    def is_doubtful(self, points: F64) -> Bool:
        """Return the mask of the points near which the outline of a panel may be open, (m,).

        ``points`` is (m, 2) mm.
        """
        low, high = self.doubtful[:2], self.doubtful[2:]
        inside: Bool = np.all((points >= low) & (points <= high), axis=1)
        return inside


def trim_folds(ends: F64, bulge: F64, kind: U8) -> Pieces | None:
    """Return the pieces that remain of k edges after folds are trimmed to the panels.

    Dropped parts of folds have the piece -1.  Edges of other line types are pieces as they are.
    The result is None if nothing is dropped.

    Parameters
    ----------
    ends, bulge : (k, 2, 2) mm and (k,)
        Start and end points, and bulges, of the edges.
    kind : (k,)
        Line types of the edges.
    """
    is_fold = np.isin(kind, _FOLDS)
    cuts = np.flatnonzero(kind == LineType.CUT)
    parts = _divide_at_cuts(ends, bulge, np.flatnonzero(is_fold), cuts)
    if len(parts.edge) == 0:
        return None
    whole = is_fold.copy()
    whole[parts.edge] = False
    try:
        contours = _find_contours(ends[cuts], bulge[cuts], (ends[whole], bulge[whole]))
    except PlanError:
        # Too many cuts cross each other for a search of contours.
        return None
    middle = arc.point_at(
        ends[parts.edge, 0],
        ends[parts.edge, 1],
        bulge[parts.edge],
        0.5 * (parts.begin + parts.end),
    )
    on_panel, in_waste = _classify(middle, *contours)
    in_waste &= ~_are_touched(ends, bulge, parts, np.flatnonzero(in_waste), cuts)
    parts, on_panel, in_waste = _join_panel_parts(parts, on_panel, in_waste)
    dropped = _find_dropped(ends, bulge, parts, on_panel, in_waste)
    return _remaining_pieces(ends, bulge, parts, dropped) if dropped.any() else None


def _divide_at_cuts(ends: F64, bulge: F64, folds: I64, cuts: I64) -> _Parts:
    """Return the pieces into which cuts divide folds; folds that are not divided are left out.

    A cut that meets a fold at most ``JOIN`` from an end of the fold does not divide it.

    ``ends``, ``bulge`` (k, 2, 2) mm and (k,): the edges.
    ``folds``, ``cuts``: indices of the folds and of the cuts among the edges.
    """
    boxes = arc.bounding_boxes(ends[:, 0], ends[:, 1], bulge)
    one, other = box_pairs(boxes[folds], boxes[cuts], JOIN)
    edges = np.column_stack([ends.reshape(-1, 4), bulge])
    lengths = arc.length(ends[:, 0], ends[:, 1], bulge)
    (edge, cut), (fraction, on_cut) = _inner_contacts(edges, lengths, folds[one], cuts[other], JOIN)
    ahead = unit_vectors(arc.tangent_at(ends[edge, 0], ends[edge, 1], bulge[edge], fraction))
    along = unit_vectors(arc.tangent_at(ends[cut, 0], ends[cut, 1], bulge[cut], on_cut))
    length = lengths[edge]
    inner = np.abs((left_normal(ahead) * along).sum(axis=1)) > _ACROSS
    edge, fraction, length = edge[inner], fraction[inner], length[inner]
    cut, on_cut = cut[inner], on_cut[inner]
    cut_length = lengths[cut]
    through = (on_cut * cut_length > JOIN) & ((1.0 - on_cut) * cut_length > JOIN)
    if not through.any() and not _has_neighbours(edge, fraction * length):
        # Single cuts that end on a fold enclose nothing.
        none = np.zeros(0)
        return _Parts(none.astype(np.int64), none, none)
    divided = np.unique(edge)
    size = np.concatenate([np.full(len(divided), np.inf), length])
    edge = np.concatenate([divided, edge])
    begin = np.concatenate([np.zeros(len(divided)), fraction])
    order = np.lexsort((begin, edge))
    edge, begin, size = edge[order], begin[order], size[order]
    # Contacts with two cuts at one point divide the fold once.
    new = np.ones(len(edge), np.bool_)
    new[1:] = (np.diff(edge) > 0) | ~(np.diff(begin) * size[1:] <= JOIN)
    edge, begin = edge[new], begin[new]
    is_last = np.append(np.diff(edge) > 0, True)[: len(edge)]
    return _Parts(edge, begin, np.where(is_last, 1.0, np.roll(begin, -1)))


@kernel
def _inner_contacts(edges: F64_2, size: F64_1, fold: I64_1, cut: I64_1, margin: float) -> Any:
    """Return the c contacts of folds with cuts that are more than ``margin`` mm from the ends of
    the fold.

    ``edges``, ``size`` (k, 5) and (k,) mm: edges: x0, y0, x1, y1, bulge; and their lengths.
    ``fold``, ``cut`` (p,) and (p,): indices of the fold and the cut of each pair.
    Returns ``pair, fraction`` (2, c) and (2, c): the fold and the cut of each contact, and the
    parameters of the contact on the two, 0 … 1.
    """
    pair, fraction = np.empty((2, 16), np.int64), np.empty((2, 16))
    common = np.empty((MAX_POINTS, 4))
    found = 0
    for k in range(len(fold)):
        length = size[fold[k]]
        for at in range(intersect_rows(edges, fold[k], edges, cut[k], JOIN, common)):
            first = common[at, 2]
            if not (first * length > margin and (1.0 - first) * length > margin):
                continue
            if found == pair.shape[1]:
                pair = np.concatenate((pair, np.empty_like(pair)), axis=1)
                fraction = np.concatenate((fraction, np.empty_like(fraction)), axis=1)
            pair[0, found], pair[1, found] = fold[k], cut[k]
            fraction[0, found], fraction[1, found] = first, common[at, 3]
            found += 1
    return pair[:, :found].copy(), fraction[:, :found].copy()


def _has_neighbours(edge: I64, place: F64) -> bool:
    """Return whether two of k points on edges are at most ``JOIN`` from each other on one edge.

    ``edge`` and ``place`` are the edge of each point and its distance from the start of that edge
    (mm), (k,) each.
    """
    order = np.lexsort((place, edge))
    near = (np.diff(edge[order]) == 0) & (np.diff(place[order]) <= JOIN)
    return bool(near.any())


def _find_contours(ends: F64, bulge: F64, folds: tuple[F64, F64]) -> tuple[_Contours, _Contours]:
    """Return the contours of n cuts with small gaps closed, and the contours of the cuts alone.

    ``ends``, ``bulge`` (n, 2, 2) mm and (n,): the cuts.
    ``folds`` (m, 2, 2) mm and (m,): ends and bulges of the folds that no cut divides.
    Raises ``PlanError``: the bounding boxes of more than five million pairs of cuts overlap.
    """
    exact = _mark_doubtful_area(*split_at_crossings(ends, bulge)[:2], folds)
    links = closing_links(ends, bulge, find_dangling_ends(ends, bulge), CONTOUR_GAP)
    links = links[np.hypot(*(links[:, 1] - links[:, 0]).T) <= _NEAR]
    if len(links) == 0:
        return exact, exact
    pieces, bent, _ = split_at_crossings(
        np.concatenate([ends, links]), np.concatenate([bulge, np.zeros(len(links))])
    )
    return _mark_doubtful_area(pieces, bent, folds), exact


def _mark_doubtful_area(ends: F64, bulge: F64, folds: tuple[F64, F64]) -> _Contours:
    """Return the contours that pieces of cuts form, with the rectangle in which panels are
    doubtful.

    A short piece of a cut that is attached to a contour is an overshoot of that cut, and no sign of
    an open outline.

    ``ends``, ``bulge`` (p, 2, 2) mm and (p,): pieces of cuts, which meet only at their ends.
    ``folds`` (m, 2, 2) mm and (m,): ends and bulges of the folds that no cut divides.
    """
    subdivision = subdivide(ends, bulge)
    ends, bulge = np.stack([subdivision.start, subdivision.end], axis=1), subdivision.bulge
    closing, face = subdivision.closing, subdivision.face
    # A cut with the same face on both sides encloses nothing.
    enclosing = subdivision.depth[subdivision.component] + ~subdivision.outer[face[:, 0]]
    is_open = (face[:, 0] == face[:, 1]) & (enclosing % 2 == 0)
    short = is_open & (arc.length(ends[:, 0], ends[:, 1], bulge) <= _NEAR)
    if short.any():
        rows, vertices = np.flatnonzero(short), np.unique(ends[closing].reshape(-1, 2), axis=0)
        attached = np.isin(ends[rows].copy().view(np.complex128)[..., 0],
                           vertices.view(np.complex128)[:, 0])  # fmt: skip
        is_open[rows[attached.any(axis=1)]] = False
    middle = arc.point_at(folds[0][:, 0], folds[0][:, 1], folds[1], np.full(len(folds[1]), 0.5))
    is_lost = subdivision.count_enclosing(middle) % 2 == 0
    signs = np.concatenate([ends[is_open], folds[0][is_lost]])
    bent = np.concatenate([bulge[is_open], folds[1][is_lost]])
    boxes = arc.bounding_boxes(signs[:, 0], signs[:, 1], bent)
    low = boxes[:, :2].min(axis=0, initial=np.inf)
    high = boxes[:, 2:].max(axis=0, initial=-np.inf)
    return _Contours(subdivision, np.concatenate([low, high]))


def _classify(points: F64, linked: _Contours, exact: _Contours) -> tuple[Bool, Bool]:
    """Return which of m points lie on panels, (m,), and which lie surely in the waste, (m,).

    ``points`` (m, 2) mm: the points.
    ``linked``, ``exact``: the contours if small gaps between cuts are closed, and the contours that
    cuts alone form. A gap may be the end of a strip between two slits, so only contours without
    gaps are holes.
    """
    count = linked.subdivision.count_enclosing(points)
    on_panel = count % 2 == 1
    in_hole = (exact.subdivision.count_enclosing(points) % 2 == 0) & ~exact.is_doubtful(points)
    outside = (count == 0) & ~linked.is_doubtful(points)
    return on_panel, outside | (in_hole & (count > 0) & ~on_panel)


def _are_touched(ends: F64, bulge: F64, parts: _Parts, rows: I64, cuts: I64) -> Bool:
    """Return the mask of the pieces that a cut touches more than ``GAP`` from their ends, (q,).

    A cut does not divide a fold if it crosses it at less than 1°, or ends beside it and would meet
    it only farther on.  Either side of such a cut may be a panel.

    ``ends``, ``bulge`` (k, 2, 2) mm and (k,): all edges.
    ``parts``: the q pieces of folds.
    ``rows``: indices of the pieces that are searched.
    ``cuts``: indices of the cuts among the edges.
    """
    owner = parts.edge[rows]
    start, end, bent = arc.sub_arc(
        ends[owner, 0], ends[owner, 1], bulge[owner], parts.begin[rows], parts.end[rows]
    )
    size = arc.length(start, end, bent)
    pieces = np.column_stack([start, end, bent])
    edges = np.concatenate([pieces, np.column_stack([ends[cuts].reshape(-1, 4), bulge[cuts]])])
    boxes = arc.bounding_boxes(edges[:, :2], edges[:, 2:4], edges[:, 4])
    one, other = box_pairs(boxes[: len(rows)], boxes[len(rows) :], JOIN)
    touched = _inner_contacts(edges, size, one, other + len(rows), GAP)[0][0]
    tips, piece = ends[cuts[other]].reshape(-1, 2), np.repeat(one, 2)
    along = arc.nearest_fraction(start[piece], end[piece], bent[piece], tips)
    away = np.hypot(*(tips - arc.point_at(start[piece], end[piece], bent[piece], along)).T)
    near = (away <= JOIN) & (np.minimum(along, 1.0 - along) * size[piece] > GAP)
    result = np.zeros(len(parts.edge), np.bool_)
    result[rows[touched]] = True
    result[rows[piece[near]]] = True
    return result


def _join_panel_parts(parts: _Parts, on_panel: Bool, in_waste: Bool) -> tuple[_Parts, Bool, Bool]:
    """Join neighbouring pieces of a fold that lie on panels; return the pieces and their masks."""
    follows = np.zeros(len(on_panel), np.bool_)
    follows[1:] = (np.diff(parts.edge) == 0) & on_panel[1:] & on_panel[:-1]
    first = np.flatnonzero(~follows)
    last = np.append(first[1:], len(follows)) - 1
    joined = _Parts(parts.edge[first], parts.begin[first], parts.end[last])
    return joined, on_panel[first], in_waste[first]


def _find_dropped(ends: F64, bulge: F64, parts: _Parts, on_panel: Bool, in_waste: Bool) -> Bool:
    """Return the mask of the q pieces that are dropped, (q,).

    ``ends``, ``bulge`` (k, 2, 2) mm and (k,): all edges.
    ``parts``: the q pieces of folds.
    ``on_panel``, ``in_waste`` (q,): which pieces lie on panels, and which surely in the waste.
    """
    edge, begin, end = parts
    size = (end - begin) * arc.length(ends[edge, 0], ends[edge, 1], bulge[edge])
    is_first = np.append(True, np.diff(edge) > 0)
    is_last = np.append(is_first[1:], True)
    rows = np.concatenate([np.flatnonzero(is_first), np.flatnonzero(is_last)])
    side = np.repeat([0, 1], [is_first.sum(), is_last.sum()])
    touched = find_points_on_segments(
        ends[edge[rows], side], edge[rows].astype(np.int32), ends[:, 0], ends[:, 1], bulge, JOIN
    )
    # A fold that is no longer divided has no overshoot.
    shaped = np.zeros(len(edge), np.bool_)
    shaped[rows[~touched]] = True
    shaped &= (size <= OVERSHOOT) & (is_first != is_last)
    panel_before = ~is_first & np.roll(on_panel, 1)
    panel_after = ~is_last & np.roll(on_panel, -1)
    overshoot = in_waste & shaped & (panel_before | panel_after)
    waste = np.where(overshoot, size, 0.0)
    beside = np.where(~is_first, np.roll(waste, 1), 0.0) + np.where(
        ~is_last, np.roll(waste, -1), 0.0
    )
    short = beside >= size
    overshoot &= ~np.where(is_first, np.roll(short, -1), np.roll(short, 1))
    passage = in_waste & panel_before & panel_after
    return _without_doubtful_passages(ends, bulge, parts, overshoot, passage)


def _without_doubtful_passages(
    ends: F64, bulge: F64, parts: _Parts, overshoot: Bool, passage: Bool
) -> Bool:
    """Return the mask of the pieces to drop, (q,), without doubtful passages.  A passage is
    doubtful if it lies beside a remaining piece that looks like an overshoot.

    These are remaining pieces of folds that are short and have an end that no other piece touches.
    A passage that is not dropped may touch such ends of other folds, so they are searched again.

    ``overshoot`` and ``passage`` are the pieces to be dropped, (q,): overshoots, and passages
    between two pieces on panels.  The other arguments are those of ``_find_dropped``.
    """
    while passage.any():
        left = _remaining_pieces(ends, bulge, parts, overshoot | passage)
        start, end = left.ends[:, 0], left.ends[:, 1]
        piece = np.tile(np.arange(len(left.bulge), dtype=np.int32), 2)
        touched = find_points_on_segments(
            np.concatenate([start, end]), piece, start, end, left.bulge, JOIN
        )
        formed = ~touched.reshape(2, -1).all(axis=0)
        formed &= arc.length(start, end, left.bulge) <= OVERSHOOT
        # The pieces of folds, among the stretches of all edges.
        rows = np.flatnonzero(np.isin(left.edge, parts.edge))
        beside = formed[left.piece[rows]]
        doubtful = passage & (np.roll(beside, 1) | np.roll(beside, -1))
        if not doubtful.any():
            break
        passage = passage & ~doubtful
    return overshoot | passage


def _remaining_pieces(ends: F64, bulge: F64, parts: _Parts, dropped: Bool) -> Pieces:
    """Return the pieces of k edges that remain if pieces of folds are dropped.

    ``dropped`` is the mask of these pieces, (q,).  The other arguments are those of
    ``_find_dropped``.
    """
    others = np.setdiff1d(np.arange(len(bulge)), parts.edge)
    edge = np.concatenate([others, parts.edge])
    begin = np.concatenate([np.zeros(len(others)), parts.begin])
    end = np.concatenate([np.ones(len(others)), parts.end])
    kept = np.concatenate([np.ones(len(others), np.bool_), ~dropped])
    order = np.lexsort((begin, edge))
    edge, begin, end, kept = edge[order], begin[order], end[order], kept[order]
    # Neighbouring parts that are kept form one piece.
    follows = np.zeros(len(edge), np.bool_)
    follows[1:] = (np.diff(edge) == 0) & kept[1:] & kept[:-1]
    first = np.flatnonzero(kept & ~follows)
    last = np.flatnonzero(kept & ~np.append(follows[1:], False))
    number = np.cumsum(kept & ~follows) - 1
    owner, low, high = edge[first], begin[first], end[last]
    start, finish, bent = arc.sub_arc(ends[owner, 0], ends[owner, 1], bulge[owner], low, high)
    return Pieces(
        np.stack(
            [
                np.where((low == 0.0)[:, None], ends[owner, 0], start),
                np.where((high == 1.0)[:, None], ends[owner, 1], finish),
            ],
            axis=1,
        ),
        np.where((low == 0.0) & (high == 1.0), bulge[owner], bent),
        owner.astype(np.int32),
        edge.astype(np.int32),
        begin,
        end,
        np.where(kept, number, -1).astype(np.int32),
        np.zeros(len(edge), np.bool_),
        np.zeros(len(owner)),
    )
