"""Equidistants: where a cutter's centre should run beside every edge.

    Edges, CutOutlines, reach -> CutterPaths: pieces of way, each beside a stretch of one edge

Source: the radius paper, equations 1-9.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.verification.columns import F64, I32, I64
from knifetip.verification.curves.curve import line_curves
from knifetip.verification.curves.intervals import EPSILON
from knifetip.verification.expectation.edges import Edges
from knifetip.verification.expectation.outline import CutOutlines

#: Chords of an equidistant that is no circle stay within this of it (mm).
_CHORD_ERROR: Final = 1e-4


@dataclass(frozen=True, eq=False, slots=True)
class CutterPaths:
    """Where the centre should run: k pieces, each beside a stretch of one edge."""

    curve: F64  #: (k, 6)
    edge: I64  #: (k,)
    place: F64  #: (k, 2) mm along the edge at both ends of the piece

    def edge_intervals(self, piece: I32, place: F64) -> tuple[F64, F64]:
        """Return from where to where along its edge (mm) a stretch, (n, 2) mm, of a piece is."""
        share = place / np.maximum(self.curve[piece, 5], EPSILON)[:, None]
        first, last = self.place[piece, 0], self.place[piece, 1]
        at = first[:, None] + (last - first)[:, None] * share
        return at.min(axis=1), at.max(axis=1)


def cutter_paths(bounds: CutOutlines, reach: F64) -> CutterPaths:
    """Return the way of the centre beside every edge; an open cut is followed on its line.

    Parameters
    ----------
    reach : (2,) mm
        How far the disc takes board away from its centre, along X and along Y.
    """
    curve = bounds.edges.curve
    waste = np.where(bounds.board_left, -1.0, 1.0) * bounds.closing
    straight = np.flatnonzero(curve[:, 0] == 0.0)
    moved = curve.copy()
    u = curve[straight, 3:5]
    n = np.stack([-u[:, 1], u[:, 0]], axis=1) * waste[straight, None]
    moved[straight, 1:3] += n * reach
    edge = np.arange(len(curve))
    place = np.stack([np.zeros(len(curve)), curve[:, 5]], axis=1)
    bent = np.flatnonzero(curve[:, 0] != 0.0)
    # To its left an arc to the left has its centre.
    grows = -curve[bent, 0] * waste[bent]
    if reach[0] == reach[1]:
        radius = curve[bent, 3] + grows * reach[0]
        moved[bent, 3] = radius
        moved[bent, 5] *= radius / curve[bent, 3]
        fits = np.ones(len(curve), np.bool_)
        # No disc fits into an arc that is tighter than itself.
        fits[bent[radius <= EPSILON]] = False
        return CutterPaths(moved[fits], edge[fits], place[fits])
    pieces = [CutterPaths(moved[straight], edge[straight], place[straight])]
    for row, sign in zip(bent, grows, strict=True):
        pieces.append(_elliptic_path(bounds.edges, int(row), float(sign), reach))
    return CutterPaths(
        np.concatenate([piece.curve for piece in pieces]),
        np.concatenate([piece.edge for piece in pieces]),
        np.concatenate([piece.place for piece in pieces]),
    )


def _elliptic_path(edges: Edges, row: int, grows: float, reach: F64) -> CutterPaths:
    """Return chords of the ellipse that runs beside an arc where δx and δy differ."""
    curve = edges.curve[row]
    axes = curve[3] + grows * reach
    sweep = curve[5] / curve[3]
    count = max(1, int(np.ceil(sweep * np.sqrt(max(axes.max(), 1.0) / (8.0 * _CHORD_ERROR)))))
    at = np.linspace(0.0, curve[5], count + 1)
    angle = curve[4] + curve[0] * at / curve[3]
    points = curve[1:3] + axes * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    fits = slice(0, count if (axes > EPSILON).all() else 0)
    return CutterPaths(
        line_curves(points[:-1], points[1:])[fits],
        np.full(count, row)[fits],
        np.stack([at[:-1], at[1:]], axis=1)[fits],
    )
