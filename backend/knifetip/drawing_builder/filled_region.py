"""The region that a filled path encloses, with chords in place of its curves."""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.drawing_builder.clip import Region
from knifetip.drawing_builder.path_segments import PlacedSegments
from knifetip.drawing_builder.path_table import ARC, CUBIC, LINE, Table
from knifetip.geometry.affine import Matrix
from knifetip.geometry.columns import F64

#: Chords that replace a Bézier curve, and an elliptic arc: a quarter of a circle with a radius of
#: 500 mm deviates by 0.01 mm, so that a curve is not cut by a clip path of the same shape.
_CHORDS: Final = {CUBIC: 128, ARC: 256}


def filled_region(table: Table, matrix: Matrix, *, even_odd: bool) -> Region:
    """Return the region that one path encloses if it is filled.

    Parameters
    ----------
    table
        Segments of the path.
    matrix
        Matrix from the coordinates of the path to file units.
    even_odd
        Whether the path is filled by the even-odd rule, not by the nonzero rule.
    """
    if not len(table.kind):
        return Region()
    with np.errstate(all="ignore"):
        if not table.kind.any():
            # Most clip paths are rectangles, so lines alone are fast.
            a, b, c, d, e, f = matrix
            edges = table.numbers[:, :4].reshape(-1, 2, 2) @ ((a, b), (c, d)) + (e, f)
        else:
            placed = PlacedSegments(table, np.tile(np.array(matrix), (len(table.kind), 1)))
            edges = _chords(placed)
        closing = _closing_edges(edges)
    if len(closing):
        edges = np.concatenate([edges, closing])
    return Region(edges, np.zeros(len(edges), np.int64), np.array([even_odd]))


def _chords(placed: PlacedSegments) -> F64:
    """Return the segments of a path as (m, 2, 2) lines, in their order."""
    lines = np.flatnonzero(placed.kind == LINE)
    points = [np.stack([placed.start[lines], placed.end[lines]], axis=1)]
    origin = [lines]
    for kind, rows in ((CUBIC, placed.cubic), (ARC, placed.arc)):
        share = np.linspace(0.0, 1.0, _CHORDS[kind] + 1)[:, None, None]
        if kind == CUBIC:
            a, b, c, d = np.moveaxis(placed.control, 1, 0)
            rest = 1.0 - share
            curve = rest**3 * a + 3.0 * rest * share * (rest * b + share * c) + share**3 * d
        else:
            angle = placed.first[:, None] + share * placed.turn[:, None]
            curve = placed.centre + np.cos(angle) * placed.u + np.sin(angle) * placed.v
        curve[0], curve[-1] = placed.start[rows], placed.end[rows]
        chords = np.stack([curve[:-1], curve[1:]], axis=2)
        points.append(np.moveaxis(chords, 1, 0).reshape(-1, 2, 2))
        origin.append(np.repeat(rows, _CHORDS[kind]))
    edges: F64 = np.concatenate(points)[np.argsort(np.concatenate(origin), kind="stable")]
    return edges


def _closing_edges(edges: F64) -> F64:
    """Return the (c, 2, 2) edges that close the open subpaths of a path; a fill closes them."""
    begins = np.append(True, (edges[1:, 0] != edges[:-1, 1]).any(axis=1))
    first = np.flatnonzero(begins)
    last = np.append(first[1:], len(edges)) - 1
    closing = np.stack([edges[last, 1], edges[first, 0]], axis=1)
    open_edges: F64 = closing[(closing[:, 0] != closing[:, 1]).any(axis=1)]
    return open_edges
