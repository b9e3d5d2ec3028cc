"""Drawings that no machine can make are refused before questions are asked, with the reason."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.errors import KnifetipError
from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.model.drawing import Drawing
from knifetip.model.interpretation import Interpretation
from tests.support.drawings import drawing
from tests.support.shapes import closed
from tests.support.writers.dxf_text import dxf, entity

MACHINE, BOARD = load.machine("demo-table"), load.board("fbb-0.4")


def refusal(read: Drawing, line_type: LineType) -> KnifetipError:
    """Return why a drawing whose edges have a line type is refused."""
    types = np.full(len(read), line_type, np.uint8)
    line = pipeline.interpret(read, Interpretation(overrides=types.tobytes()))
    assert pipeline.questions(read, line, MACHINE) == []
    with pytest.raises(KnifetipError) as caught:
        pipeline.compile(read, line, MACHINE, BOARD)
    return caught.value


def rectangle(width: float, height: float) -> Drawing:
    return drawing(closed((0, 0), (width, 0), (width, height), (0, height)), [("0", 7, "")] * 4)


def test_a_file_without_lines_is_refused_with_what_was_left_out() -> None:
    texts = [entity("TEXT", (10, x), (20, 0), (40, 5), (1, "carton")) for x in (0, 50)]
    point = entity("POINT", (10, 0), (20, 0))
    error = refusal(pipeline.read(dxf(*texts, point)), LineType.CUT)
    assert error.message.code == "drawing.no-lines"
    assert "All 3 objects were left out: the object is a text, which is not cut (2 objects)" in str(
        error
    )


def test_an_empty_file_is_refused() -> None:
    assert refusal(pipeline.read(dxf()), LineType.CUT).message.code == "drawing.empty"


def test_a_drawing_of_ignored_edges_is_refused() -> None:
    error = refusal(rectangle(100, 50), LineType.IGNORED)
    assert str(error).startswith("There is nothing to make: all 4 edges of the drawing are ignored")


@pytest.mark.parametrize(
    ("width", "height", "code"),
    [
        (1000, 1400, "drawing.fits-turned"),
        (1000, 1700, "drawing.larger-than-table"),
        (1300, 1400, "drawing.larger-than-table"),
    ],
)
def test_a_drawing_is_to_be_turned_only_if_it_fits_then(
    width: float, height: float, code: str
) -> None:
    assert refusal(rectangle(width, height), LineType.CUT).message.code == code
