"""crease_depth: find the depth of creases from flaps whose creases are pressed to several depths.

Flap i of a comb has a crease of the depth f(i) times the depth in the file of the board.  A person
folds the flaps and states the first and the last that fold well: no crack in the liner, and no
flap that springs back.  The depth d is the middle of this range::

    d = (d(first) + d(last)) / 2 ± ((d(last) - d(first)) / 2 + s / 2)

with s the difference of the depths of neighbouring flaps, since the limits lie anywhere between two
flaps.  One comb is creased along the grain and one across it, because the board has a depth for
each.  Our derivation.
"""

from __future__ import annotations

import math
from typing import Final

from pydantic import Field

from knifetip.errors import PieceRefused
from knifetip.library.definition import Shelf
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.tool import CreaseWheel
from knifetip.testpieces.piece import Arrow, Line, Piece, Point, polyline
from knifetip.testpieces.wizard import Bench, Figure, Measures, Wizard

COUNT: Final = 9  #: number of flaps of a comb
#: Depth of the first flap, and the difference between flaps, in depths of the board.
_FIRST, _STEP = 0.6, 0.1
#: Greatest depth, as a share of the thickness of the board.
_MOST_SHARE: Final = 0.95
_BODY: Final = 30.0  #: height of the strip that joins the flaps
_FLAP: Final = 45.0  #: length of the slits between the flaps
_ABOVE: Final = 6.0  #: distance of a crease from the ends of the slits
_STAGGER: Final = 3.0  #: distance of neighbouring creases, so that they are not one dashed line
_SIDE: Final = 2.0  #: distance of a crease from the slits
_ROLLED: Final = 16.0  #: length of a crease at its full depth
_ALONG: Final = "testpiece.figure.crease-along"
_ACROSS: Final = "testpiece.figure.crease-across"
_BETWEEN: Final = 20.0  #: distance of the two combs


class CreaseDepthMeasures(Measures):
    """The flaps that fold well, counted from the flap with the slanted corner."""

    along_first: int | None = Field(
        default=None,
        ge=1,
        le=COUNT,
        title="A1, first good flap along the grain",
        description="Comb A: number of the first flap that folds without springing back. Empty if "
        "this comb was not judged",
    )
    along_last: int | None = Field(
        default=None,
        ge=1,
        le=COUNT,
        title="A2, last good flap along the grain",
        description="Comb A: number of the last flap that folds without a crack",
    )
    across_first: int | None = Field(
        default=None,
        ge=1,
        le=COUNT,
        title="B1, first good flap across the grain",
        description="Comb B: number of the first flap that folds without springing back. Empty if "
        "this comb was not judged",
    )
    across_last: int | None = Field(
        default=None,
        ge=1,
        le=COUNT,
        title="B2, last good flap across the grain",
        description="Comb B: number of the last flap that folds without a crack",
    )


def depths(usual: float, caliper: float) -> list[float]:
    """Return the depths of the creases of a comb, increasing (mm).

    Parameters
    ----------
    usual, caliper : mm
        Depth in the file of the board, and thickness of the board.
    """
    deepest = min((_FIRST + _STEP * (COUNT - 1)) * usual, _MOST_SHARE * caliper)
    first = min(_FIRST * usual, 0.5 * deepest)
    return [round(first + (deepest - first) * row / (COUNT - 1), 3) for row in range(COUNT)]


def _comb(usual: float, bench: Bench) -> tuple[list[Line], float, float]:
    """Return the lines of a comb whose creases run along X, and its width and height (mm)."""
    wheel = bench.station.tool
    assert isinstance(wheel, CreaseWheel)
    own = depths(usual, bench.board.caliper)
    flap = _ROLLED + 2.0 * (_SIDE + wheel.contact(own[-1]) + bench.board.end_clearance)
    flap = math.ceil(flap)
    width, height = COUNT * flap, _BODY + _FLAP
    # The corner of the first flap is slanted.
    outline: list[Point] = [(0.0, 0.0), (width, 0.0), (width, height), (8.0, height)]
    lines = list(polyline([*outline, (0.0, height - 8.0), (0.0, 0.0)]))
    for row in range(1, COUNT):
        lines.append(Line((row * flap, height), (row * flap, _BODY), LineType.CUT))
    for row, depth in enumerate(own):
        y = _BODY + _ABOVE + (_STAGGER if row % 2 else 0.0)
        ends = (row * flap + _SIDE, y), ((row + 1) * flap - _SIDE, y)
        lines.append(Line(*ends, LineType.CREASE, depth))
    return lines, width, height


def _turned(lines: list[Line], angle: float) -> list[Line]:
    """Return lines turned about the origin (degrees) and moved to positive X and Y."""
    cos, sin = math.cos(math.radians(angle)), math.sin(math.radians(angle))

    def turn(point: Point) -> Point:
        x, y = point
        return round(x * cos - y * sin, 6), round(x * sin + y * cos, 6)

    turned = [line._replace(start=turn(line.start), end=turn(line.end)) for line in lines]
    points = [point for line in turned for point in (line.start, line.end)]
    low = min(x for x, _ in points), min(y for _, y in points)
    return _moved(turned, -low[0], -low[1])


def _moved(lines: list[Line], x: float, y: float) -> list[Line]:
    return [
        line._replace(
            start=(line.start[0] + x, line.start[1] + y), end=(line.end[0] + x, line.end[1] + y)
        )
        for line in lines
    ]


def draw(bench: Bench) -> Piece:
    """Return two combs of flaps: creases along the grain (A), and across it (B).

    Raises
    ------
    PieceRefused
        The station has no crease wheel, another one makes the creases, or programs do not set
        depths.
    """
    bench.check_makes(LineType.CREASE, (CreaseWheel,))
    bench.check_sets_depth()
    grain = bench.board.grain % 180.0
    combs = []
    for usual, turn in ((bench.board.crease_along, 0.0), (bench.board.crease_across, -90.0)):
        lines, _, _ = _comb(usual, bench)
        combs.append(_turned(lines, grain + turn))
    first, second = combs
    right = max(x for line in first for x in (line.start[0], line.end[0])) + _BETWEEN
    second = _moved(second, right, 0.0)
    arrows = [_arrow(first, "A"), _arrow(second, "B")]
    return Piece((*first, *second), tuple(arrows))


def _arrow(comb: list[Line], letter: str) -> Arrow:
    """Return the arrow from the first to the last crease of a comb."""
    creases = [line for line in comb if line.line_type == LineType.CREASE]
    return Arrow(_middle(creases[0]), _middle(creases[-1]), letter)


def _middle(line: Line) -> Point:
    (x0, y0), (x1, y1) = line.start, line.end
    return (x0 + x1) / 2.0, (y0 + y1) / 2.0


def figures(bench: Bench, measures: CreaseDepthMeasures) -> list[Figure]:
    """Return the depths of creases along and across the grain, of the combs that were judged.

    Raises
    ------
    PieceRefused
        No comb was judged, only one end of a range is given, or it ends before it begins.
    """
    board = bench.board
    combs = (
        (_ALONG, board.crease_along, measures.along_first, measures.along_last),
        (_ACROSS, board.crease_across, measures.across_first, measures.across_last),
    )
    found = []
    for code, usual, first, last in combs:
        word = code.rpartition("-")[2]
        if first is None and last is None:
            continue
        if first is None or last is None or first > last:
            name = f"{word}_{'first' if first is None else 'last'}"
            raise PieceRefused("testpiece.bad-range", source=(name,))
        own = depths(usual, board.caliper)
        low, high = own[first - 1], own[last - 1]
        value = round((low + high) / 2.0, 4)
        uncertainty = (high - low) / 2.0 + (own[1] - own[0]) / 2.0
        path = (f"crease_{word}",)
        found.append(Figure(code, Shelf.BOARDS, path, usual, value, uncertainty, "mm"))
    if not found:
        raise PieceRefused("testpiece.nothing-measured", source=("along_first",))
    return found


WIZARD: Final = Wizard(
    "crease-depth",
    Message("testpiece.crease-depth"),
    Message("testpiece.crease-depth.description"),
    Message("testpiece.crease-depth.instruction"),
    ("crease-wheel",),
    CreaseDepthMeasures,
    draw,
    figures,
)
