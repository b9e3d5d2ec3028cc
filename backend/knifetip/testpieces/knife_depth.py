"""knife_depth: find the height of the tip of a knife from cuts of increasing depth.

Cut i has the programmed depth h(i) below the top face of a board of the thickness T.  If the knife
cuts deeper than programmed by e, cut i goes through the board where h(i) + e ≥ T.  With N the first
cut that goes through and s = h(N) - h(N - 1)::

    T - h(N) ≤ e < T - h(N - 1)         hence e = T - h(N) + s / 2 ± s / 2

The joint position is the programmed position plus the station's offset (``Station.z``), so an
offset z gives the depth h + z' - z with z' the true offset, and z' = z + e.  An error u of the
measured thickness adds to the uncertainty.  Our derivation.
"""

from __future__ import annotations

from typing import Final

from pydantic import Field

from knifetip.errors import PieceRefused
from knifetip.library.definition import Shelf
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.tool import Knife
from knifetip.testpieces.piece import Arrow, Line, Piece, blank
from knifetip.testpieces.wizard import Bench, Figure, Measures, Wizard, check_length

COUNT: Final = 12  #: number of cuts
_PITCH: Final = 8.0
_MARGIN: Final = 20.0
_LENGTH: Final = 25.0
_LONGER: Final = 8.0  #: additional length of each fifth cut
_MOST_STEP: Final = 0.1
#: Least depth of a cut, as a share of the thickness of the board.
_LEAST_SHARE: Final = 0.2


class KnifeDepthMeasures(Measures):
    """What is found on the row of cuts."""

    first_through: int = Field(
        ge=0,
        le=COUNT,
        title="N, number of the first cut that goes through",
        description="Counted from the cut-off corner; each fifth cut is longer. 0 if none goes "
        "through",
    )
    caliper: float | None = Field(
        default=None,
        gt=0.0,
        le=50.0,
        title="T, thickness of this board",
        description="Measured at this sheet (mm); empty for the thickness in the file of the board",
    )


def depths(bench: Bench) -> list[float]:
    """Return the programmed depths of the cuts, increasing up to a usual through cut (mm)."""
    deepest = bench.board.caliper + bench.machine.into_mat
    least = _LEAST_SHARE * bench.board.caliper
    step = round(min(_MOST_STEP, (deepest - least) / (COUNT - 1)), 3)
    return [round(deepest - step * (COUNT - 1 - row), 4) for row in range(COUNT)]


def draw(bench: Bench) -> Piece:
    """Return a piece with a row of cuts of increasing depth; each fifth one is longer.

    Raises
    ------
    PieceRefused
        The station has no knife, another one makes the cuts, or programs do not set depths.
    """
    bench.check_makes(LineType.CUT, (Knife,))
    bench.check_sets_depth()
    width = 2.0 * _MARGIN + _PITCH * (COUNT - 1)
    height = 2.0 * _MARGIN + _LENGTH + _LONGER
    lines = list(blank(width, height))
    for row, depth in enumerate(depths(bench)):
        x = _MARGIN + _PITCH * row
        top = _MARGIN + _LENGTH + (_LONGER if row % 5 == 4 else 0.0)
        lines.append(Line((x, _MARGIN), (x, top), LineType.CUT, depth))
    arrow = Arrow((_MARGIN, _MARGIN - 8.0), (width - _MARGIN, _MARGIN - 8.0), "N")
    return Piece(tuple(lines), (arrow,))


def figures(bench: Bench, measures: KnifeDepthMeasures) -> list[Figure]:
    """Return the offset in Z of the knife's station (formula at the head of this module).

    Raises
    ------
    PieceRefused
        All cuts or none go through, so the offset is beyond the range of the piece.
    """
    rows = depths(bench)
    number = measures.first_through
    if number in (0, 1):
        code = "testpiece.none-through" if number == 0 else "testpiece.all-through"
        reach = abs(bench.board.caliper - rows[-1 if number == 0 else 0])
        raise PieceRefused(code, reach=reach, source=("first_through",))
    caliper = bench.board.caliper if measures.caliper is None else measures.caliper
    check_length("caliper", caliper, bench.board.caliper, 0.5 * bench.board.caliper)
    step = rows[number - 1] - rows[number - 2]
    deeper = caliper - rows[number - 1] + step / 2.0
    path = (*bench.station_path, "datum", "z")
    uncertainty = step / 2.0 + (0.0 if measures.caliper is None else measures.reading)
    old = bench.station.z
    return [
        Figure(
            "testpiece.figure.offset-z", Shelf.MACHINES, path, old, old + deeper, uncertainty, "mm"
        )
    ]


WIZARD: Final = Wizard(
    "knife-depth",
    Message("testpiece.knife-depth"),
    Message("testpiece.knife-depth.description"),
    Message("testpiece.knife-depth.instruction"),
    ("knife",),
    KnifeDepthMeasures,
    draw,
    figures,
)
