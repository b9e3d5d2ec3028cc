"""deflection: find the deflection of a cutter in a board from the sides of a rectangle.

The cutting force pushes a cutter away from the contour: where the contour runs along Y by δx, where
it runs along X by δy (``compensation.deflection``).  knifetip moves the path towards the contour by
the deflection in the file of the board.  If the true one is greater by ε, each side of the part
lies ε outside, and the part is 2 ε too large::

    δx' = δx + (w' - w) / 2         δy' = δy + (h' - h) / 2

An error u of the reading gives u / 2.  An error of the cutter's radius acts in the same way and is
included in δ.  Source: "Tool radius compensation", eqs 10 and 11, for contours along the axes;
``POST /api/boards/NAME/deflection`` fits points of any direction.
"""

from __future__ import annotations

from typing import Final

from pydantic import Field

from knifetip.library.definition import Shelf
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.tool import Cutter
from knifetip.testpieces.piece import Arrow, Piece, polyline
from knifetip.testpieces.wizard import (
    Bench,
    Figure,
    Measures,
    Wizard,
    check_changed,
    check_length,
)

WIDTH, HEIGHT = 200.0, 150.0  #: sides of the rectangle as it is drawn (mm)
#: A deflection that is found less than 0 by no more than this is 0 (mm).
_MOST_NEGATIVE: Final = -0.1


class DeflectionMeasures(Measures):
    """Sides of the part that was milled."""

    width: float = Field(
        gt=0.0, le=300.0, title="w, width", description="Side along X (mm); drawn 200 mm"
    )
    height: float = Field(
        gt=0.0, le=300.0, title="h, height", description="Side along Y (mm); drawn 150 mm"
    )


def draw(bench: Bench) -> Piece:
    """Return a rectangle; raise ``PieceRefused`` if the station does not mill the cuts."""
    bench.check_makes(LineType.CUT, (Cutter,))
    corners = ((0.0, 0.0), (WIDTH, 0.0), (WIDTH, HEIGHT), (0.0, HEIGHT), (0.0, 0.0))
    arrows = (
        Arrow((0.0, 20.0), (WIDTH, 20.0), "w"),
        Arrow((20.0, 0.0), (20.0, HEIGHT), "h"),
    )
    return Piece(polyline(corners), arrows)


def figures(bench: Bench, measures: DeflectionMeasures) -> list[Figure]:
    """Return δx' and δy' of the station's cutter in the board (formulas at the head).

    Raises
    ------
    PieceRefused
        A measure is not plausible, or the part is smaller than drawn, as no force makes it.
    """
    name = bench.station.name
    known = [one for one in bench.board.deflection if one.tool == name]
    x, y = (known[0].x, known[0].y) if known else (0.0, 0.0)
    found = []
    for code, field, side, drawn, old in (
        ("testpiece.figure.deflection-x", "width", measures.width, WIDTH, x),
        ("testpiece.figure.deflection-y", "height", measures.height, HEIGHT, y),
    ):
        new = old + check_length(field, side, drawn) / 2.0
        new = round(max(check_changed(field, new, _MOST_NEGATIVE), 0.0), 6)
        path = ("deflection", name, code[-1])
        half = measures.reading / 2.0
        found.append(Figure(code, Shelf.BOARDS, path, old, new, half, "mm"))
    return found


WIZARD: Final = Wizard(
    "deflection",
    Message("testpiece.deflection"),
    Message("testpiece.deflection.description"),
    Message("testpiece.deflection.instruction"),
    ("cutter",),
    DeflectionMeasures,
    draw,
    figures,
)
