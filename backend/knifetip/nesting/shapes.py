"""shapes: parts as shapes of the engine, and places of shapes as places on a sheet."""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.layout.compose import placement_matrix
from knifetip.nesting.arrangement import Board, Place
from knifetip.nesting.engine import PlacedShape, Shape
from knifetip.nesting.parts import Part

#: Decimals of the places of copies (mm).
_DECIMALS: Final = 4


def shape_of(part: Part, quantity: int) -> Shape:
    """Return copies of a part as a shape, which is mirrored and has the first turn of the part."""
    first = part.boxes[0][0]
    ring = np.array(part.outline.exterior.coords)[:-1] @ placement_matrix(first, mirror=part.mirror)
    corners = [(float(x), float(y)) for x, y in ring]
    return Shape(corners, quantity, tuple(turn - first for turn, _ in part.boxes))


def place_of(placed: PlacedShape, index: int, part: Part, board: Board) -> Place:
    """Return the place on a sheet of a shape in the strip.

    Parameters
    ----------
    placed
        The place in the strip.
    index, part
        The part whose shape it is.
    board
        The sheet; the strip begins at the lower left corner of its window.
    """
    wanted = placed.turn + part.boxes[0][0]
    # The engine returns the same angle, perhaps less a whole turn.
    turn = min(
        (angle for angle, _ in part.boxes),
        key=lambda angle: abs((angle - wanted + 180.0) % 360.0 - 180.0),
    )
    low_x, low_y = part.box(turn).low
    return Place(
        index,
        turn,
        round(float(low_x) + placed.x + board.window[0], _DECIMALS),
        round(float(low_y) + placed.y + board.window[1], _DECIMALS),
    )
