"""station_offset: find the offset of a station from marks of its tool and of the knife.

The joint position is the programmed position plus the station's offset D.  If the true offset is
D', the tool works D - D' beside its line.  The knife of another station is the reference: its lines
are where they are drawn.  With a the drawn and a' the measured distance from the line of the knife
to that of the tool, along X and along Y::

    D - D' = a' - a         hence D' = D - (a' - a)

Offsets are those of the axes: if Y is not perpendicular to X, a' - a is converted to axes before.
A V-groove and a double crease are measured at the middle of their two lines.  Our derivation.
"""

from __future__ import annotations

from typing import Final

from pydantic import Field

from knifetip.errors import PieceRefused
from knifetip.library.definition import Shelf
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.tool import CreaseWheel, Knife, VCutter
from knifetip.testpieces.piece import Arrow, Line, Piece, blank
from knifetip.testpieces.wizard import Bench, Figure, Measures, Wizard, check_length

DISTANCE: Final = 20.0  #: a, distance of the lines of the two tools as they are drawn (mm)
_SIZE: Final = 150.0
_LENGTH: Final = 50.0
_NEAR, _FAR = 30.0, 80.0


class StationOffsetMeasures(Measures):
    """Distances between the lines of the two tools."""

    distance_x: float = Field(
        gt=0.0,
        le=100.0,
        title="x, distance of the upright lines",
        description="From the cut to the middle of the line of the tool (mm); drawn 20 mm",
    )
    distance_y: float = Field(
        gt=0.0,
        le=100.0,
        title="y, distance of the level lines",
        description="From the cut to the middle of the line of the tool (mm); drawn 20 mm",
    )


def _line_type(bench: Bench) -> LineType:
    """Return the line type that the tool of the station makes."""
    return LineType.V_GROOVE if isinstance(bench.station.tool, VCutter) else LineType.CREASE


def draw(bench: Bench) -> Piece:
    """Return a piece with an upright and a level line of the knife, and of the tool beside them.

    Raises
    ------
    PieceRefused
        The station has no crease wheel or V-cutter, another one makes its lines, or the machine has
        no knife.
    """
    line_type = _line_type(bench)
    bench.check_makes(line_type, (CreaseWheel, VCutter))
    reference = bench.makes(LineType.CUT)
    if reference is None or not isinstance(reference.tool, Knife):
        raise PieceRefused("testpiece.no-knife", machine=bench.machine.title)
    own = _NEAR + DISTANCE
    # A V-cutter may end a groove only at the board's edge.
    groove = line_type == LineType.V_GROOVE
    first, last = (0.0, _SIZE) if groove else (_FAR, _FAR + _LENGTH)
    lines = (
        *blank(_SIZE, _SIZE),
        Line((_NEAR, _FAR), (_NEAR, _FAR + _LENGTH), LineType.CUT),
        Line((own, first), (own, last), line_type),
        Line((_FAR, _NEAR), (_FAR + _LENGTH, _NEAR), LineType.CUT),
        Line((first, own), (last, own), line_type),
    )
    middle = _FAR + _LENGTH / 2.0
    arrows = (
        Arrow((_NEAR, middle), (own, middle), "x"),
        Arrow((middle, _NEAR), (middle, own), "y"),
    )
    return Piece(lines, arrows)


def figures(bench: Bench, measures: StationOffsetMeasures) -> list[Figure]:
    """Return the offsets of the station along X and Y (formula at the head of this module).

    Raises
    ------
    PieceRefused
        A measure is not plausible.
    """
    station = bench.station
    errors = bench.machine.to_axes(
        check_length("distance_x", measures.distance_x, DISTANCE),
        check_length("distance_y", measures.distance_y, DISTANCE),
    )
    found = []
    for code, error, old in zip(
        ("testpiece.figure.offset-x", "testpiece.figure.offset-y"),
        errors,
        (station.x, station.y),
        strict=True,
    ):
        path = (*bench.station_path, "datum", code[-1])
        new = round(old - error, 6)
        found.append(Figure(code, Shelf.MACHINES, path, old, new, measures.reading, "mm"))
    return found


WIZARD: Final = Wizard(
    "station-offset",
    Message("testpiece.station-offset"),
    Message("testpiece.station-offset.description"),
    Message("testpiece.station-offset.instruction"),
    ("crease-wheel", "v-cutter"),
    StationOffsetMeasures,
    draw,
    figures,
)
