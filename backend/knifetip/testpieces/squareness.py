"""squareness: find scale and squareness of the axes from the sides and diagonals of a rectangle.

The machine cuts a rectangle w × h as a parallelogram w' × h' with the angle γ between the axes.
With p the diagonal from the lower left corner, and q the other one::

    scale of X = w' / w         scale of Y = h' / h
    p² = w'² + h'² + 2 w' h' cos γ
    q² = w'² + h'² - 2 w' h' cos γ      hence cos γ = (p² - q²) / (4 w' h')

(law of cosines).  The sum p² + q² = 2 (w'² + h'²) holds for every γ (parallelogram law), so it
checks the measures.  An error u of each reading gives u / w and u / h in the scales, and
u √(p² + q²) / (2 w' h') radians in γ.

The piece may have been cut by programs that correct an angle γ₀ (``Machine.squareness``): for each
drawn (x, y), the axes went to Y = y / sin γ₀ and X = x - Y cos γ₀.  With the true angle γ and the
true scales k of the axes, the left side of the piece ends at::

    h' cos γ' = (h / sin γ₀) (k_y cos γ - k_x cos γ₀)      k_x = w' / w
    h' sin γ' = (h / sin γ₀)  k_y sin γ

where γ' is the angle that was measured.  So γ and k_y are direction and length of the vector
(h' sin γ₀ / h) (cos γ', sin γ') + (k_x cos γ₀, 0).  For γ₀ = 90° they are γ' and h' / h.  If γ₀ and
the scales are right, the piece is right, and γ = γ₀.

k_y is the scale along the axis Y as it leans, so it is that of its pulses.  Programs of the
controller have pulses or steps per mm.  A side that is k times too long needs 1 / k times as many.
"""

from __future__ import annotations

import math
from typing import Any, Final

from pydantic import Field

from knifetip.errors import PieceRefused
from knifetip.library.definition import Shelf
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.tool import Cutter, Knife, Laser
from knifetip.testpieces.piece import Arrow, Line, Piece, polyline
from knifetip.testpieces.wizard import Bench, Figure, Measures, Wizard, check_length

#: Sides of the rectangle (mm), the greatest that takes at most half of the table.
_SIZES: Final = ((500.0, 400.0), (400.0, 300.0), (300.0, 200.0), (150.0, 100.0))
#: Codes of the scales of X and Y, with those of the pulses per mm that follow.
_PULSES: Final = {
    "testpiece.figure.scale-x": "testpiece.figure.pulses-x",
    "testpiece.figure.scale-y": "testpiece.figure.pulses-y",
}
#: Greatest error that a sum of squares of diagonals may have, in readings.
_MOST_READINGS: Final = 4.0
#: Decimals of the angle (degrees) in the file: less than 0.001 mm in a metre.
_DECIMALS: Final = 5


class SquarenessMeasures(Measures):
    """Sides and diagonals of the rectangle."""

    width: float = Field(gt=0.0, le=2000.0, title="w, width", description="Side along X (mm)")
    height: float = Field(gt=0.0, le=2000.0, title="h, height", description="Side along Y (mm)")
    diagonal_up: float = Field(
        gt=0.0,
        le=3000.0,
        title="p, first diagonal",
        description="From the lower left corner, beside which there is a slit, to the upper right "
        "(mm)",
    )
    diagonal_down: float = Field(
        gt=0.0,
        le=3000.0,
        title="q, second diagonal",
        description="From the upper left corner to the lower right (mm)",
    )


def size(bench: Bench) -> tuple[float, float]:
    """Return width and height of the rectangle as it is drawn (mm)."""
    machine = bench.machine
    for width, height in _SIZES:
        if width <= 0.5 * machine.width and height <= 0.5 * machine.height:
            return width, height
    return _SIZES[-1]


def draw(bench: Bench) -> Piece:
    """Return a rectangle with a slit beside its lower left corner.

    Raises
    ------
    PieceRefused
        The station does not make the cuts.
    """
    bench.check_makes(LineType.CUT, (Knife, Cutter, Laser))
    width, height = size(bench)
    corners = ((0.0, 0.0), (width, 0.0), (width, height), (0.0, height), (0.0, 0.0))
    slit = Line((20.0, 20.0), (50.0, 20.0), LineType.CUT)
    inside = 0.08 * height
    arrows = (
        Arrow((0.0, height - inside), (width, height - inside), "w"),
        Arrow((width - inside, 0.0), (width - inside, height), "h"),
        Arrow((0.0, 0.0), (width, height), "p"),
        Arrow((0.0, height), (width, 0.0), "q"),
    )
    return Piece((*polyline(corners), slit), arrows)


def figures(bench: Bench, measures: SquarenessMeasures) -> list[Figure]:
    """Return the scales of X and Y and the angle between the axes (formulas at the head).

    Where the file of the machine has pulses per mm (``controller.pulses``), the library passes them
    to ``with_pulses``; other controllers keep them in settings of their own.

    Raises
    ------
    PieceRefused
        A measure is not plausible, or sides and diagonals do not belong to one parallelogram.
    """
    drawn = size(bench)
    sides = measures.width, measures.height
    for name, side, wanted in zip(("width", "height"), sides, drawn, strict=True):
        check_length(name, side, wanted, 0.05 * wanted)
    up, down = measures.diagonal_up, measures.diagonal_down
    expected = math.sqrt(2.0 * (sides[0] ** 2 + sides[1] ** 2))
    found = math.hypot(up, down)
    if abs(found - expected) > _MOST_READINGS * measures.reading:
        raise PieceRefused(
            "testpiece.no-parallelogram",
            difference=abs(found - expected),
            source=("diagonal_up",),
        )
    product = sides[0] * sides[1]
    turn = math.degrees(measures.reading * found / (2.0 * product))
    before = bench.machine.squareness
    cut = math.acos((up**2 - down**2) / (4.0 * product))
    scale_x = sides[0] / drawn[0]
    side = sides[1] / drawn[1] * math.sin(math.radians(before))
    along = side * math.cos(cut) + scale_x * math.cos(math.radians(before))
    across = side * math.sin(cut)
    scales = [
        Figure(code, None, (), 1.0, scale, measures.reading / wanted, "factor")
        for code, scale, wanted in zip(
            _PULSES, (scale_x, math.hypot(along, across)), drawn, strict=True
        )
    ]
    angle = round(math.degrees(math.atan2(across, along)), _DECIMALS)
    # Programs of a gantry with several carriages do not correct the angle.
    stored = bench.machine.gantry is None
    shelf, path = (Shelf.MACHINES, ("squareness",)) if stored else (None, ())
    return [
        *scales,
        Figure("testpiece.figure.angle", shelf, path, before, angle, turn, "degrees"),
    ]


def with_pulses(figures: list[Figure], pulses: dict[str, Any]) -> list[Figure]:
    """Return the figures with those of the pulses per mm of X and Y in the file of a machine.

    Parameters
    ----------
    pulses
        The table ``controller.pulses`` of the file; figures of axes that it lacks are not added.
    """
    added = []
    for figure in figures:
        code = _PULSES.get(figure.code)
        before = pulses.get(figure.code[-1])
        if code is not None and isinstance(before, int | float):
            path = ("controller", "pulses", figure.code[-1])
            after = round(before / figure.after, 6)
            error = before * figure.uncertainty
            added.append(Figure(code, Shelf.MACHINES, path, float(before), after, error, "per-mm"))
    return [*figures, *added]


WIZARD: Final = Wizard(
    "squareness",
    Message("testpiece.squareness"),
    Message("testpiece.squareness.description"),
    Message("testpiece.squareness.instruction"),
    ("knife", "cutter", "laser"),
    SquarenessMeasures,
    draw,
    figures,
)
