"""Cartons compile on a machine of the library: accepted, without a question."""

from __future__ import annotations

import pytest

from knifetip import pipeline
from knifetip.cartons.file import carton_dxf
from knifetip.cartons.registry import STYLES
from knifetip.library import load
from knifetip.model.interpretation import Interpretation
from knifetip.model.verdict import Severity
from tests.support.cartons.carton_sizes import SIZES, Dimensions, sized


def check_compiles(code: str, dimensions: Dimensions, board: str, **options: str) -> None:
    """Assert that a carton is read without a question, and its program is accepted."""
    stock, machine = load.board(board), load.machine("demo-table")
    data = carton_dxf(STYLES[code].draw(sized(code, dimensions, **options), stock))
    drawing = pipeline.read(data)
    dieline = pipeline.interpret(drawing, Interpretation())
    assert pipeline.questions(drawing, dieline, machine) == []
    verdict = pipeline.compile(drawing, dieline, machine, stock).verdict
    assert [one.text for one in verdict.findings if one.severity is not Severity.NOTE] == []
    assert verdict.accepted


@pytest.mark.parametrize("code", STYLES)
def test_the_unit_of_small_cartons_is_not_asked(code: str) -> None:
    for board in SIZES[code].boards:
        size = sized(code, SIZES[code].dimensions[0])
        drawing = pipeline.read(carton_dxf(STYLES[code].draw(size, load.board(board))))
        assert drawing.unit == "mm"
        assert pipeline.questions(drawing, pipeline.interpret(drawing, Interpretation())) == []


@pytest.mark.parametrize("code", STYLES)
def test_the_usual_size_compiles(code: str) -> None:
    style = STYLES[code]
    example = style.example
    check_compiles(code, (example.length, example.width, example.depth), style.board)


@pytest.mark.long
@pytest.mark.parametrize("code", STYLES)
def test_all_sizes_compile_in_all_boards(code: str) -> None:
    for dimensions in SIZES[code].dimensions:
        for board in SIZES[code].boards:
            check_compiles(code, dimensions, board)


@pytest.mark.long
@pytest.mark.parametrize(
    ("code", "options"),
    [
        ("ecma-a20.20", {"lids": "straight"}),
        ("rigid-box", {"part": "lid"}),
        ("telescope-tray", {"part": "lid"}),
    ],
)
def test_options_compile(code: str, options: dict[str, str]) -> None:
    for dimensions in SIZES[code].dimensions[:2]:
        check_compiles(code, dimensions, SIZES[code].boards[1], **options)
