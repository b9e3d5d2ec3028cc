"""Refusals name the edges of the drawing, also where they are parts of one object of the file."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.errors import KnifetipError
from knifetip.geometry.columns import F64
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline, edges

OUTLINE = closed((0, 0), (200, 0), (200, 150), (0, 150))


def one_object(line: Dieline) -> Drawing:
    """Return the drawing of a dieline in which all edges are parts of one polyline."""
    drawn = drawing(line.ends, [("FOLD", 7, "CONTINUOUS")] * len(line), bulge=line.bulge)
    return replace(drawn, entity=np.zeros(len(line), np.int32))


def refused(line: Dieline, machine: str, board: str) -> KnifetipError:
    with pytest.raises(KnifetipError) as caught:
        pipeline.compile(one_object(line), line, load.machine(machine), load.board(board))
    return caught.value


def is_accepted(line: Dieline, machine: str, board: str, ignored: tuple[int, ...]) -> bool:
    """Return whether a program is accepted if some edges are left out."""
    line_type = line.line_type.copy()
    line_type[list(ignored)] = LineType.IGNORED
    typed = replace(line, line_type=line_type)
    made = pipeline.compile(one_object(line), typed, load.machine(machine), load.board(board))
    return made.verdict.accepted


def arc_of_chords(count: int, radius: float) -> F64:
    """Return a quarter of a circle round (20, 20), drawn as chords."""
    turns = [0.5 * math.pi * k / count for k in range(count + 1)]
    points = [(20 + radius * math.cos(turn), 20 + radius * math.sin(turn)) for turn in turns]
    return edges(*itertools.pairwise(points))


def test_all_chords_of_a_curve_that_is_made_as_one_are_named() -> None:
    line = dieline((LineType.CUT, OUTLINE), (LineType.V_GROOVE, arc_of_chords(120, 90.0)))
    error = refused(line, "v-groove-table", "greyboard-2.0")
    # Cleaning makes one arc of edges 4 to 123; the outline belongs to the same object.
    assert error.edges == tuple(range(4, 124))
    assert error.source == ("0",)
    assert error.text == (
        "1 V-groove is an arc (first: edge 4), which a straight blade cannot follow. "
        "This concerns 120 edges: 4, 5, 6, 7, 8, 9, 10, 11, 12, 13. "
        'Edge 4 is part of the object with the handle 0 on the layer "FOLD". '
        "110 more edges are not listed here."
    )
    assert is_accepted(line, "v-groove-table", "greyboard-2.0", error.edges)


#: A quarter of a circle from (140, 20) to (20, 140), as one arc.
QUARTER = ((140, 20), (20, 140))
BEND = math.tan(math.pi / 8.0)


def test_an_edge_and_its_copy_are_both_named() -> None:
    line = dieline(
        (LineType.CUT, OUTLINE),
        (LineType.V_GROOVE, edges(((150, 20), (150, 100)), QUARTER, QUARTER)),
        bulge={5: BEND, 6: BEND},
    )
    error = refused(line, "v-groove-table", "greyboard-2.0")
    # A user who leaves out only one of them still has the other.
    assert error.edges == (5, 6)


def test_pieces_of_a_divided_edge_have_the_number_of_the_whole_one() -> None:
    # A cut lies on the middle third of the groove, so cleaning makes two grooves of edge 4.
    middle = [
        (20 + 120 * math.cos(turn), 20 + 120 * math.sin(turn))
        for turn in (math.pi / 6, math.pi / 3)
    ]
    line = dieline(
        (LineType.CUT, OUTLINE),
        (LineType.V_GROOVE, edges(QUARTER)),
        (LineType.CUT, edges((middle[0], middle[1]))),
        bulge={4: BEND, 5: math.tan(math.pi / 24.0)},
    )
    cleaned = pipeline.clean(line)
    assert len(cleaned.dieline) == 7
    error = refused(line, "v-groove-table", "greyboard-2.0")
    assert error.edges == (4,)
    assert "2 V-grooves are arcs (first: edge 4)" in error.text


def test_places_are_those_of_the_drawing() -> None:
    outline = closed((300, 400), (500, 400), (500, 550), (300, 550))
    crossing = closed((450, 460), (550, 460), (550, 500), (450, 500))
    line = dieline((LineType.CUT, outline), (LineType.CUT, crossing))
    error = refused(line, "router-table", "greyboard-2.0")
    # The drawing is shifted to the origin of the table; the crossing stays where it is drawn.
    assert "at X500.000 Y460.000" in error.text or "at X500.000 Y500.000" in error.text
