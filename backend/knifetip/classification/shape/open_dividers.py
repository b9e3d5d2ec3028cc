"""open_dividers: distinguish lines between panels of which shape does not show that they are folds.

A carton has a slit beside each flap, which lies between two panels as a fold does.  Where the file
does not distinguish the two, the user decides.  Lines that are all slits, or all folds, should be
asked about together, so they are divided by what their ends show.
"""

from __future__ import annotations

import math
from enum import IntEnum
from typing import Any, Final

import numpy as np

from knifetip.classification.shape.roles import Role
from knifetip.geometry.columns import F64, I64, U8, Bool
from knifetip.kernels import (
    I32_1,
    I64_1,
    U8_1,
    OutI64_1,
    OutI64_2,
    kernel,
)
from knifetip.topology.faces import Faces
from knifetip.topology.planar_graph import GraphPieces, PlanarGraph


class DividerKind(IntEnum):
    """What the ends of a line show that may be a slit or a fold."""

    OTHER = 0  #: nothing, or the edge must be a fold or is no divider
    CORNERS = 1  #: it turns a corner at both ends, without another line
    SLOT_SIDE = 2  #: it is a side of a slot at a fold, or of a splinter
    FOLD_END = 3  #: it lies between a fold of the same two panels and the outline
    PART_OF_SIDE = 4  #: the side of one of the panels goes on beyond it, on the outline
    THROUGH = 5  #: it passes a point inside the blank at which others end
    RING_SLIT = 6  #: it ends at three folds inside the blank, or is parallel to such a line
    RING_FOLD = 7  #: it meets lines that end at three folds
    ALONG = 8  #: it meets others inside the blank, and is parallel to the longest of them
    PERPENDICULAR = 9  #: it meets others inside the blank, perpendicular to the longest of them
    OBLIQUE = 10  #: it meets others inside the blank, at another angle to the longest of them
    SHARED = 11  #: it may be a common cut of equal blanks that touch
    OPEN_FLAP = 12  #: it closes an outline, and a flap beside it may be open


#: Cosine of the least angle by which the lines at a corner deviate from one straight line.
_CORNER: Final = math.cos(math.radians(45.0))
#: Sine of the greatest angle between parallel lines, and between lines that continue each other.
_PARALLEL: Final = math.sin(math.radians(2.0))
#: Greatest length of a slit at the end of a fold, as a fraction of the length of the fold.
_MAX_LOCK: Final = 0.25
#: Greatest deviation of an angle from a right angle (radians).
_RIGHT: Final = math.radians(2.0)
#: Least length of the rest of a panel's side, as a fraction of the length of the line on it.
_MIN_REST: Final = 0.2
_DIVIDER, _OUTLINE, _SLIT = int(Role.DIVIDER), int(Role.OUTLINE), int(Role.SLIT)


def find_divider_kinds(
    graph: PlanarGraph,
    faces: Faces,
    role: U8,
    is_slot: Bool,
    shared: Bool,
    must_fold: Bool,
    length: F64,
) -> U8:
    """Return the DividerKind of each of n edges, (n,).

    Parameters
    ----------
    graph, faces
        Planar graph of the edges, with p pieces, and its f faces.
    role, length : (p,)
        Role and length of each piece.
    is_slot : (f,)
        Whether each face is a slot at a fold, or a splinter.
    shared : (p,)
        Whether each piece may be a common cut of equal blanks.
    must_fold : (n,)
        Whether each edge must be a fold.
    """
    count = len(must_fold)
    kind = np.zeros(count, np.uint8)
    folded = (role == Role.DIVIDER) & (graph.edge >= 0)
    rows = np.flatnonzero(folded)
    rows = rows[~must_fold[graph.edge[rows]]]
    if len(rows) == 0:
        return kind
    folded[rows] = False
    edge = graph.edge[rows]
    whole: F64 = np.bincount(edge, length[rows], count).astype(np.float64)
    beside_slot = is_slot[faces.left[rows]] | is_slot[faces.right[rows]]
    on_slot = np.bincount(edge, length[rows] * beside_slot, count)
    start, end = (graph.end_vertex.reshape(-1, 2)[:, at] for at in (0, 1))
    pieces = graph.pieces
    corner, inner, on_rim = _examine_vertices(pieces, role)
    corners = corner[graph.start[rows]].astype(np.int64) + corner[graph.end[rows]]
    turns = np.bincount(edge, corners, count) >= 2
    beside_hole = rows[turns[edge]]
    inner[graph.start[beside_hole]] = inner[graph.end[beside_hole]] = False
    meets = inner[start] | inner[end]
    through = np.zeros(count, np.bool_)
    passed = inner[graph.start[rows]] & (graph.start[rows] != start[edge])
    through[edge[passed & (graph.start[rows] != end[edge])]] = True
    goes_on = _mark_parts_of_sides(pieces, role, faces.left, faces.right, rows)
    at_rim = on_rim[graph.start[rows]] | on_rim[graph.end[rows]]
    is_short = _is_short_beside(faces, rows, np.flatnonzero(folded), length, whole[edge])
    folded[rows[through[edge]]] = True
    ring = _ends_at_folds(graph, rows[~through[edge]], inner, folded)
    for mask, one in (
        (edge[meets[edge]], DividerKind.ALONG),
        (ring, DividerKind.RING_SLIT),
        (edge[goes_on & meets[edge]], DividerKind.PART_OF_SIDE),
        (np.flatnonzero(through), DividerKind.THROUGH),
        (edge[at_rim & is_short & ~meets[edge]], DividerKind.FOLD_END),
        (np.flatnonzero(turns), DividerKind.CORNERS),
        (np.flatnonzero((on_slot > 0.9 * whole) & (whole > 0.0)), DividerKind.SLOT_SIDE),
        (edge[shared[rows]], DividerKind.SHARED),
    ):
        kind[mask] = one
    _mark_folds_beside_slits(graph, rows, kind)
    _divide_by_direction(graph, rows, whole, kind)
    return kind


def _mark_folds_beside_slits(graph: PlanarGraph, rows: I64, kind: U8) -> None:
    """Give the kind RING_FOLD to edges of the kind ALONG that meet edges of PART_OF_SIDE.

    ``rows`` (k,) are the pieces of all edges that may be slits or folds, and ``kind`` (n,) are the
    kinds of the edges.
    """
    edge = graph.edge[rows]
    beside = np.zeros(len(graph.vertex), np.bool_)
    slit = rows[kind[edge] == DividerKind.PART_OF_SIDE]
    beside[graph.start[slit]] = beside[graph.end[slit]] = True
    meeting = rows[kind[edge] == DividerKind.ALONG]
    touches = beside[graph.start[meeting]] | beside[graph.end[meeting]]
    kind[graph.edge[meeting[touches]]] = DividerKind.RING_FOLD


def _is_short_beside(faces: Faces, rows: I64, folds: I64, length: F64, whole: F64) -> Bool:
    """Return the mask of pieces that are short beside a fold of the same two faces, (k,).

    ``faces``: faces beside the p pieces.
    ``rows``, ``folds``: the k pieces, and those of folds.
    ``length`` (p,): length of each piece.
    ``whole`` (k,): length of the edge of each of the k pieces.
    """
    low = np.minimum(faces.left, faces.right).astype(np.int64)
    key = low * len(faces.area) + np.maximum(faces.left, faces.right)
    known, number = np.unique(key[folds], return_inverse=True)
    if len(known) == 0:
        return np.zeros(len(rows), np.bool_)
    fold = np.bincount(number, length[folds])
    at = np.minimum(np.searchsorted(known, key[rows]), len(known) - 1)
    mask: Bool = (known[at] == key[rows]) & (whole <= _MAX_LOCK * fold[at])
    return mask


def _ends_at_folds(graph: PlanarGraph, rows: I64, inner: Bool, folded: Bool) -> I64:
    """Return the edges that end at three folds at a right-angled cross inside a blank.

    Four folds at one vertex cannot all be bent at right angles.

    ``graph``: planar graph with p pieces and q vertices.
    ``rows`` (k,): pieces of the edges.
    ``inner`` (q,): whether each vertex lies inside a blank.
    ``folded`` (p,): whether each piece is a fold.
    """
    own = np.flatnonzero(graph.twin_piece == np.arange(len(graph.twin_piece)))
    ends = np.concatenate([graph.start[own], graph.end[own]])
    degree = np.bincount(ends, minlength=len(graph.vertex))
    run = graph.vertex[graph.end[own]] - graph.vertex[graph.start[own]]
    # Four times the angle is the same for all lines of a right-angled cross.
    angle = np.tile(4.0 * np.arctan2(run[:, 1], run[:, 0]), 2)
    x, y = (np.bincount(ends, of, len(graph.vertex)) for of in (np.cos(angle), np.sin(angle)))
    cross = inner & (degree == 4) & (np.hypot(x, y) >= 4.0 * math.cos(4.0 * _RIGHT))
    is_fold = np.concatenate([folded[own], folded[own]])
    folds = np.bincount(ends[is_fold], minlength=len(graph.vertex))
    fourth = cross & (folds == 3)
    edges: I64 = graph.edge[rows[fourth[graph.start[rows]] | fourth[graph.end[rows]]]].astype(
        np.int64
    )
    return edges


def _divide_by_direction(graph: PlanarGraph, rows: I64, whole: F64, kind: U8) -> None:
    """Divide the kind ALONG by the directions of its lines, in ``kind``, (n,).

    ``graph``: planar graph of the n edges, with p pieces.
    ``rows`` (k,): pieces of all edges that may be slits or folds.
    ``whole`` (n,): length of each edge between panels.
    """
    meeting = np.isin(kind[graph.edge[rows]], (DividerKind.ALONG, DividerKind.RING_SLIT))
    rows = rows[meeting]
    edge, component = graph.edge[rows], graph.component[rows]
    run = graph.vertex[graph.end[rows]] - graph.vertex[graph.start[rows]]
    run /= np.maximum(np.hypot(*run.T), 1e-12)[:, None]
    slit = kind[edge] == DividerKind.RING_SLIT
    order = np.lexsort((whole[edge], slit, component))
    reference = np.zeros((len(graph.leftmost), 2))
    reference[component[order]] = run[order]
    has_slit = np.zeros(len(graph.leftmost), np.bool_)
    has_slit[component[slit]] = True
    other = reference[component]
    sine = np.abs(run[:, 0] * other[:, 1] - run[:, 1] * other[:, 0])
    parallel, across = sine <= _PARALLEL, np.abs((run * other).sum(axis=1)) <= _PARALLEL
    by_angle = np.where(across, DividerKind.PERPENDICULAR, DividerKind.OBLIQUE)
    in_ring = np.where(parallel, DividerKind.RING_SLIT, DividerKind.RING_FOLD)
    plain = np.where(parallel, DividerKind.ALONG, by_angle)
    kind[edge[~slit]] = np.where(has_slit[component], in_ring, plain)[~slit]


@kernel
def _examine_vertices(pieces: GraphPieces, role: U8_1) -> Any:
    """Return masks of vertices, (q,) each: corners of two dividers, inner vertices, and others.

    At a corner exactly two straight dividers meet at an angle.  At an inner vertex only dividers
    meet, at least three.  Slits that end there do not count.
    At the other vertices dividers meet outlines or holes.

    ``role`` (p,) is the Role of each piece.
    """
    vertex, start, end, bulge, twin = pieces
    degree = np.zeros(len(vertex), np.int64)
    others = np.zeros(len(vertex), np.int64)
    piece = np.zeros((len(vertex), 2), np.int64)
    for p in range(len(start)):
        if twin[p] != p or role[p] == _SLIT:
            continue
        for v in (start[p], end[p]):
            if degree[v] < 2:
                piece[v, degree[v]] = p
            degree[v] += 1
            if role[p] != _DIVIDER:
                others[v] += 1
    corner = np.zeros(len(vertex), np.bool_)
    inner = np.zeros(len(vertex), np.bool_)
    on_rim = np.zeros(len(vertex), np.bool_)
    for v in range(len(vertex)):
        inner[v] = degree[v] > 2 and others[v] == 0
        on_rim[v] = others[v] > 0
        if degree[v] != 2 or others[v] > 0:
            continue
        one, two = piece[v, 0], piece[v, 1]
        if bulge[one] != 0.0 or bulge[two] != 0.0:
            continue
        far_one, far_two = start[one] + end[one] - v, start[two] + end[two] - v
        x, y = vertex[far_one, 0] - vertex[v, 0], vertex[far_one, 1] - vertex[v, 1]
        u, w = vertex[far_two, 0] - vertex[v, 0], vertex[far_two, 1] - vertex[v, 1]
        size = math.sqrt((x * x + y * y) * (u * u + w * w))
        corner[v] = abs(x * u + y * w) <= _CORNER * size
    return corner, inner, on_rim


@kernel
def _mark_parts_of_sides(
    pieces: GraphPieces, role: U8_1, left: I32_1, right: I32_1, rows: I64_1
) -> Any:
    """Return the mask of pieces that continue straight in the outline of one of their faces, (k,).

    ``role``, ``left``, ``right`` (p,) each: Role of each piece, and the faces on its left and
    right.
    ``rows`` (k,): the pieces.
    """
    vertex, start, end, bulge, _ = pieces
    # The outline pieces at each vertex, as a linked list.
    head = np.full(len(vertex), -1, np.int64)
    following = np.full((len(start), 2), -1, np.int64)
    _link_outlines(pieces, role, head, following)
    found = np.zeros(len(rows), np.bool_)
    for k in range(len(rows)):
        p = rows[k]
        if bulge[p] != 0.0:
            continue
        for v in (start[p], end[p]):
            far = start[p] + end[p] - v
            x, y = vertex[v, 0] - vertex[far, 0], vertex[v, 1] - vertex[far, 1]
            link = head[v]
            while link >= 0:
                o, at_end = link // 2, link % 2
                link = following[o, at_end]
                beside = left[o] == left[p] or left[o] == right[p]
                if not (beside or right[o] == left[p] or right[o] == right[p]):
                    continue
                away = start[o] + end[o] - v
                u, w = vertex[away, 0] - vertex[v, 0], vertex[away, 1] - vertex[v, 1]
                size = math.sqrt((x * x + y * y) * (u * u + w * w))
                if u * u + w * w < _MIN_REST * _MIN_REST * (x * x + y * y):
                    continue
                if x * u + y * w > 0.0 and abs(x * w - y * u) <= _PARALLEL * size:
                    found[k] = True
    return found


@kernel(allocates=False)
def _link_outlines(pieces: GraphPieces, role: U8_1, head: OutI64_1, following: OutI64_2) -> None:
    """Write linked lists of the straight outline pieces at each vertex.

    ``role`` (p,): Role of each piece.
    ``head`` (q,): first link of each vertex: twice the piece, plus 1 for its end.  -1 is the end of
    a list.
    ``following`` (p, 2): next link after the start and after the end of each piece.
    """
    _, start, end, bulge, twin = pieces
    for o in range(len(start)):
        if role[o] == _OUTLINE and bulge[o] == 0.0 and twin[o] == o:
            following[o, 0] = head[start[o]]
            head[start[o]] = 2 * o
            following[o, 1] = head[end[o]]
            head[end[o]] = 2 * o + 1
