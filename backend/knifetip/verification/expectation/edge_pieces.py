"""Pieces of edges between the points at which other edges end on them or cross them."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np

from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.curves.curve import point_at
from knifetip.verification.curves.group_order import order_in_groups
from knifetip.verification.curves.intervals import Overlaps
from knifetip.verification.expectation.edges import JOIN_DISTANCE, Edges, edges_from_curves

#: An overlap that comes this near to an end of an edge reaches it (mm).
_ROUNDING: Final = 1e-6


def split_at_junctions(edges: Edges) -> tuple[Edges, I64, F64]:
    """Return the p pieces of n edges between the ends of other edges that lie on them, the index of
    the edge of each piece (p,), and the position on this edge at which the piece begins (p,) mm.
    """
    curve, owner, begin = split_edges(edges, at_crossings=False)
    return _pieces_of(edges, curve, owner), owner, begin


def divide_at_contacts(edges: Edges, among: Bool) -> Edges:
    """Return the pieces of the edges in a mask between the points at which these edges meet.

    The edges meet where an end of one lies on another between its ends, and where two of them
    cross.  If they meet nowhere, all ``edges`` are returned as they are.

    Parameters
    ----------
    edges
        The n edges.
    among : (n,)
        Mask of the edges that are divided.
    """
    end, touched, place = edges.touched_ends(JOIN_DISTANCE)
    inner = (place > JOIN_DISTANCE) & (place < edges.curve[touched, 5] - JOIN_DISTANCE)
    cross = _crossing_pairs(edges)
    if not (
        (inner & among[end // 2] & among[touched]).any()
        or (among[cross.curve] & among[cross.edge]).any()
    ):
        return edges
    chosen = edges.select(np.flatnonzero(among))
    curve, owner, _ = split_edges(chosen)
    return _pieces_of(chosen, curve, owner)


def _pieces_of(edges: Edges, curve: F64, owner: I64) -> Edges:
    """Return the p pieces of n edges as edges; ``curve`` are the pieces, (p, 6), and ``owner`` is
    the index of the edge of each, (p,).  If no edge is divided, ``edges`` is returned.
    """
    if len(curve) == len(edges):
        return edges
    pieces = edges_from_curves(curve)
    own = {name: getattr(edges, name)[owner] for name in ("row", "line_type", "chord")}
    return replace(pieces, **own)


def split_edges(edges: Edges, *, at_crossings: bool = True) -> tuple[F64, I64, F64]:
    """Split n edges where the ends of other edges touch them, and where two edges cross.

    Parameters
    ----------
    edges
        The n edges.
    at_crossings
        Whether edges are also split where they cross.

    Returns
    -------
    Three arrays: the p pieces as rows of six numbers (p, 6) (see ``curves.curve``), the index of
    the edge of each piece (p,), and the position on that edge at which the piece starts (p,) mm.
    """
    curve, size = edges.curve, edges.curve[:, 5]
    _, touched, place = edges.touched_ends(JOIN_DISTANCE)
    inner = (place > JOIN_DISTANCE) & (place < size[touched] - JOIN_DISTANCE)
    split, place = touched[inner], place[inner]
    if at_crossings:
        crossing, crossing_place = _crossings(edges)
        split, place = np.concatenate([split, crossing]), np.concatenate([place, crossing_place])
    owner = np.concatenate([np.arange(len(curve)), split])
    position = np.concatenate([np.zeros(len(curve)), place])
    order = order_in_groups(owner, position, position)
    owner, position = owner[order].astype(np.int64), position[order]
    last = np.append(owner[1:] != owner[:-1], True)[: len(owner)]
    stop = np.where(last, size[owner], np.append(position[1:], 0.0)[: len(position)])
    long_enough = (stop - position > JOIN_DISTANCE) | (last & (position == 0.0))
    owner, position, stop = owner[long_enough], position[long_enough], stop[long_enough]
    piece = curve[owner].copy()
    straight = piece[:, 0] == 0.0
    moved = point_at(piece, position)
    piece[straight, 1:3] = moved[straight]
    turned = piece[:, 0] * position / np.where(straight, 1.0, piece[:, 3])
    piece[~straight, 4] += turned[~straight]
    piece[:, 5] = stop - position
    return piece, owner, position


def _crossings(edges: Edges) -> tuple[I32, F64]:
    """Return the index of an edge and a position on it (mm) for each point at which another edge
    crosses it, (k,) each.
    """
    cross = _crossing_pairs(edges)
    low, high = cross.place_range()
    return cross.edge, 0.5 * (low + high)


def _crossing_pairs(edges: Edges) -> Overlaps:
    """Return an overlap for each ordered pair of edges and each point at which they cross."""
    return edges.compute_once("crossings", lambda: _find_crossing_pairs(edges))


def _find_crossing_pairs(edges: Edges) -> Overlaps:
    """Return the result of ``_crossing_pairs``."""
    size = edges.curve[:, 5]
    cross = edges.find_overlaps(edges.curve, JOIN_DISTANCE)
    # If an end of one lies within ``JOIN_DISTANCE`` of the other, the overlap reaches this end, and
    # the edges touch and do not cross.
    low, high = cross.place_range()
    crosses = (cross.along[:, 0] > _ROUNDING) & (cross.along[:, 1] < size[cross.curve] - _ROUNDING)
    crosses &= (low > _ROUNDING) & (high < size[cross.edge] - _ROUNDING)
    return cross.select(crosses)
