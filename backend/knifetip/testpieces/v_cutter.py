"""v_cutter: measure the place of the tip of a V-cutter: its offsets d and r from the head's axis.

A groove is two flanks, cut with opposite headings.  Seen in the direction of travel, knifetip puts
the head d to the right of the tip and r ahead of it (``compensation.vgroove``).  If the true
distances are d' and r', the tip of each pass lies d - d' to the right of the line and r - r' ahead
of its end.  "Right" is opposite for the two passes, so their traces at the bottom of the groove are
apart by

    b = 2 (d - d')          hence d' = d - b / 2

where b > 0 leaves a strip of board between the traces, and b < 0 means that the cuts cross.  The
depth of the groove does not change b.  The blade is 2 r' wide, so a pass along a line of the length
L cuts the top face over

    M = L + 2 r'            hence r' = (M - L) / 2

Source: geometry of Yang, Du, Shu & Qian, "Study on tool compensation of NC carton samplemaker",
eqs 4.2; the two formulas are our derivation.  An error of the reading u gives u / 2 in both.
"""

from __future__ import annotations

from typing import Final

from pydantic import Field

from knifetip.library.definition import Shelf
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.tool import VCutter
from knifetip.testpieces.piece import Arrow, Line, Piece, blank
from knifetip.testpieces.wizard import (
    Bench,
    Figure,
    Measures,
    Wizard,
    check_changed,
    check_length,
)

_WIDTH: Final = 140.0
_HEIGHT: Final = 90.0
_LENGTH: Final = 60.0  #: L, length of the inner groove
_LEFT: Final = 40.0
_LOW, _HIGH = 30.0, 65.0
#: Marks of the scale beside each end of the inner groove (mm): length, pitch, and number.
_MARK, _PITCH, _MARKS = 4.0, 1.0, 6
#: Least dimension of a V-cutter (mm).
_LEAST: Final = 0.1


class VCutterMeasures(Measures):
    """What is measured on the grooves."""

    gap: float = Field(
        ge=-5.0,
        le=5.0,
        title="b, distance of the two cuts at the bottom",
        description="At the board's edge, at the bottom of the groove (mm): positive if board is "
        "left between the cuts, negative if they cross each other",
    )
    cut_length: float | None = Field(
        default=None,
        gt=0.0,
        le=200.0,
        title="M, length of one cut of the inner groove",
        description="In the top face, from the start to the end of one flank (mm); the line is 60 "
        "mm long. Empty if it was not measured",
    )


def _has_inner_groove(bench: Bench, cutter: VCutter) -> bool:
    """Return whether the board permits a groove that ends inside the piece."""
    return 2.0 * cutter.half_width <= bench.board.groove_overcut


def draw(bench: Bench) -> Piece:
    """Return a piece with two grooves: one ends at its edge, the other one beside a scale inside.

    Raises
    ------
    PieceRefused
        The station has no V-cutter, or another one makes the grooves.
    """
    bench.check_makes(LineType.V_GROOVE, (VCutter,))
    cutter = bench.station.tool
    assert isinstance(cutter, VCutter)
    inner = _has_inner_groove(bench, cutter)
    start = (_LEFT if inner else 0.0, _HIGH)
    lines = [*blank(_WIDTH, _HEIGHT), Line(start, (_WIDTH, _HIGH), LineType.V_GROOVE)]
    arrows = [Arrow((_WIDTH, _HIGH - 4.0), (_WIDTH, _HIGH + 4.0), "b")]
    if inner:
        right = _LEFT + _LENGTH
        lines.append(Line((_LEFT, _LOW), (right, _LOW), LineType.V_GROOVE))
        blade = 2.0 * cutter.half_width
        arrows.append(Arrow((_LEFT, _LOW - 8.0), (right + blade, _LOW - 8.0), "M"))
        if bench.makes(LineType.HALF_CUT) is not None:
            # Beside the whole width of the groove.
            near = _LOW + bench.board.groove_depth * cutter.slope + 3.0
            for end, out in ((_LEFT, -1.0), (right, 1.0)):
                for mark in range(_MARKS):
                    x = end + out * mark * _PITCH
                    far = near + (2.0 * _MARK if mark % 5 == 0 else _MARK)
                    lines.append(Line((x, near), (x, far), LineType.HALF_CUT))
    return Piece(tuple(lines), tuple(arrows))


def figures(bench: Bench, measures: VCutterMeasures) -> list[Figure]:
    """Return d' and, if the inner groove was measured, r' (formulas at the head of this module).

    Raises
    ------
    PieceRefused
        A measure is not plausible.
    """
    cutter = bench.station.tool
    assert isinstance(cutter, VCutter)
    tool = (*bench.station_path, "tool")
    half = measures.reading / 2.0
    back = check_changed("gap", cutter.back - measures.gap / 2.0, _LEAST)
    found = [
        Figure(
            "testpiece.figure.back", Shelf.MACHINES, (*tool, "back"), cutter.back, back, half, "mm"
        )
    ]
    if measures.cut_length is not None:
        width = 2.0 * cutter.half_width
        check_length("cut_length", measures.cut_length, _LENGTH + width)
        radius = check_changed("cut_length", (measures.cut_length - _LENGTH) / 2.0, _LEAST)
        path = (*tool, "half_width")
        found.append(
            Figure(
                "testpiece.figure.half-width",
                Shelf.MACHINES,
                path,
                cutter.half_width,
                radius,
                half,
                "mm",
            )
        )
    return found


WIZARD: Final = Wizard(
    "v-cutter",
    Message("testpiece.v-cutter"),
    Message("testpiece.v-cutter.description"),
    Message("testpiece.v-cutter.instruction"),
    ("v-cutter",),
    VCutterMeasures,
    draw,
    figures,
)
