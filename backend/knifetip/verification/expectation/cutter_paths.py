"""The expected paths of a cutter's centre: the offset of each edge, as lines and arcs.

Source: "Tool radius compensation", equations 1-9.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.model.board import Board
from knifetip.model.machine import Station
from knifetip.verification.columns import F64, I32, I64
from knifetip.verification.curves.curve import line_curves
from knifetip.verification.curves.intervals import EPSILON
from knifetip.verification.expectation.edges import Edges
from knifetip.verification.expectation.outline import CutOutlines
from knifetip.verification.tools import expected_tool

#: Greatest distance between an elliptic offset and its chords (mm).
_CHORD_ERROR: Final = 1e-4


@dataclass(frozen=True, eq=False, slots=True)
class CutterPaths:
    """k expected paths of a cutter's centre, each a line or arc beside a stretch of one edge."""

    curve: F64  #: (k, 6) rows as in ``curves.curve``
    edge: I64  #: (k,) index of the edge
    place: F64  #: (k, 2) mm, positions on the edge of both ends of the piece

    def edge_intervals(self, piece: I32, place: F64) -> tuple[F64, F64]:
        """Convert stretches of the expected paths to the stretches of the edges beside them.

        Parameters
        ----------
        piece : (n,)
            Index of the expected path of each of n stretches.
        place : (n, 2) mm
            Positions on that path of the two ends of the stretch.

        Returns
        -------
        Two arrays, (n,) mm each: the start and the end of each stretch along the edge of its path.
        """
        fraction = place / np.maximum(self.curve[piece, 5], EPSILON)[:, None]
        first, last = self.place[piece, 0], self.place[piece, 1]
        position = first[:, None] + (last - first)[:, None] * fraction
        return position.min(axis=1), position.max(axis=1)


def disc_reach(board: Board, station: Station) -> F64:
    """Return the half-axes along X and Y of the disc that a cutter removes, (2,) mm.

    They are the radius of the cutter less its deflection in the board.  The station must have a
    router bit or a laser.
    """
    disc = expected_tool(station.tool).disc
    assert disc is not None
    deflection = next((one for one in board.deflection if one.tool == station.name), None)
    return np.full(2, disc.radius) - ((deflection.x, deflection.y) if deflection else 0.0)


def cutter_paths(bounds: CutOutlines, reach: F64) -> CutterPaths:
    """Return the expected paths of the cutter's centre: beside each edge, or on it for an open cut.

    An open cut is a cut that does not separate a part from waste.

    Parameters
    ----------
    bounds
        Outlines that the cuts form.
    reach : (2,) mm
        Half-axes along X and Y of the disc within which the cutter removes board.
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
    # The centre of an arc to the left lies on its left.
    grows = -curve[bent, 0] * waste[bent]
    if reach[0] == reach[1]:
        radius = curve[bent, 3] + grows * reach[0]
        moved[bent, 3] = radius
        moved[bent, 5] *= radius / curve[bent, 3]
        fits = np.ones(len(curve), np.bool_)
        # A disc does not fit into an arc with a smaller radius.
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


def _elliptic_path(edges: Edges, row: int, sign: float, reach: F64) -> CutterPaths:
    """Return chords that replace the path of the centre of an elliptic disc along one arc.

    The disc touches the arc with its rim.  ``row`` is the index of the arc in ``edges``.  ``sign``
    is 1 if the centre is outside the circle of the arc, and -1 if it is inside.  ``reach`` are the
    half-axes of the disc along X and Y, (2,) mm.  No chords are returned if the disc does not fit
    into the circle.
    """
    curve = edges.curve[row]
    axes = curve[3] + sign * reach
    sweep = curve[5] / curve[3]
    count = max(1, int(np.ceil(sweep * np.sqrt(max(axes.max(), 1.0) / (8.0 * _CHORD_ERROR)))))
    position = np.linspace(0.0, curve[5], count + 1)
    angle = curve[4] + curve[0] * position / curve[3]
    points = curve[1:3] + axes * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    fits = slice(0, count if (axes > EPSILON).all() else 0)
    return CutterPaths(
        line_curves(points[:-1], points[1:])[fits],
        np.full(count, row)[fits],
        np.stack([position[:-1], position[1:]], axis=1)[fits],
    )
