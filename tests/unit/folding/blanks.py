"""Blanks for tests of folding: boxes whose folded shape is known."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from knifetip.folding.fold import fold_tree
from knifetip.folding.records import FoldOptions, FoldTree
from knifetip.geometry.columns import F64
from knifetip.model.board import Board
from knifetip.model.dieline import LineType
from knifetip.pipeline import clean
from tests.support.shapes import BOARD, closed, dieline, edges

CUT, CREASE, GROOVE = LineType.CUT, LineType.CREASE, LineType.V_GROOVE
#: A board without thickness folds like a surface.
THIN = replace(BOARD, caliper=1e-9)


def folded(
    *rows: tuple[LineType, F64],
    board: Board = BOARD,
    angles: Mapping[int, float] | None = None,
    **options: Any,
) -> FoldTree:
    """Return the fold tree of a drawing; the inside of the board is up."""
    given = FoldOptions(**{"side_up": "inside", **options}, angles=angles or {})
    return fold_tree(clean(dieline(*rows)).dieline, board, given)


def cross(
    side: float, line_type: LineType = CREASE, lid: float | None = None
) -> tuple[tuple[LineType, F64], ...]:
    """Return cuts and folds of a cube: a cross of six panels, of which the two lowest are a chain.

    The panel in the middle has the corners (0, side) and (side, 2 side).  ``lid`` is the length of
    the panel above it; ``side`` by default.
    """
    a, top = side, 2.0 * side + (side if lid is None else lid)
    outline = closed(
        (0.0, -a), (a, -a), (a, a), (2 * a, a), (2 * a, 2 * a), (a, 2 * a),
        (a, top), (0.0, top), (0.0, 2 * a), (-a, 2 * a), (-a, a), (0.0, a),
    )  # fmt: skip
    folds = edges(
        ((0.0, 0.0), (a, 0.0)),
        ((0.0, a), (a, a)),
        ((a, a), (a, 2 * a)),
        ((a, 2 * a), (0.0, 2 * a)),
        ((0.0, 2 * a), (0.0, a)),
    )
    return (CUT, outline), (line_type, folds)
