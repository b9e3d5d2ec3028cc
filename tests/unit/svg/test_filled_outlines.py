"""Filled areas without a stroke: outlines of blanks, and artwork beside lines."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.model.drawing import Drawing
from knifetip.svg.read import read
from tests.support.writers.svg_text import svg

#: A blank of 90 × 60 with two folds, whose corners are cut off.
BLANK = "M5 0H85L90 5V55L85 60H5L0 55V5Z"
FOLDS = "M30 0V60M60 0V60"


def area(data: str, name: str = "area", fill: str = "#7cb342") -> str:
    """Return the SVG element of a filled area."""
    return f'<path id="{name}" stroke="none" fill="{fill}" d="{data}"/>'


def lines(data: str, name: str = "lines") -> str:
    """Return the SVG element of dashed lines."""
    return f'<path id="{name}" fill="none" stroke="#111" stroke-dasharray="4,2" d="{data}"/>'


def imported(drawing: Drawing) -> set[str]:
    """Return the handles of the elements that give edges."""
    handles = drawing.import_report.handle
    return {handles[row] for row in np.unique(drawing.entity).tolist()}


@pytest.mark.parametrize(
    ("shape", "folds"),
    [
        pytest.param(BLANK, FOLDS, id="folds from side to side"),
        pytest.param(BLANK, "M30 1V59M60 1V59", id="folds that stop short"),
        pytest.param(BLANK, "M30 0V60M60 0V60M0 30H90", id="folds that cross"),
        pytest.param(BLANK, "M30 20H60V40H30ZM30 20L5 0", id="folds that close a panel"),
        pytest.param(BLANK.removesuffix("Z"), FOLDS, id="without a closing command"),
        pytest.param("M0 0H90V60H0Z", FOLDS, id="a rectangle with folds from side to side"),
        pytest.param("M45 0A30 30 0 0 1 45 60A30 30 0 0 1 45 0Z", "M45 0V60", id="a disc"),
        pytest.param("M0 0C30 -20 60 -20 90 0V60C60 80 30 80 0 60Z", "M0 0H90M0 60H90", id="arcs"),
    ],
)
def test_an_area_with_open_lines_on_it_is_an_outline(shape: str, folds: str) -> None:
    drawing = read(svg(area(shape), lines(folds)))
    assert imported(drawing) == {"area", "lines"}
    rows = np.flatnonzero(drawing.true_colour == 0x7CB342)
    starts, ends = drawing.ends[rows, 0], drawing.ends[rows, 1]
    # The contour closes.
    np.testing.assert_allclose(np.roll(starts, -1, axis=0), ends, atol=1e-6)


@pytest.mark.parametrize(
    ("shape", "others"),
    [
        pytest.param(BLANK, lines(BLANK) + lines(FOLDS), id="lines close the same outline"),
        pytest.param(
            BLANK,
            lines("M5 0H85L90 5V55L85 60M85 60H5L0 55V5L5 0") + lines(FOLDS),
            id="the outline in two lines",
        ),
        pytest.param(
            "M32 10H50L58 20V50H32Z", lines(BLANK) + lines(FOLDS + "M40 30H50"), id="artwork"
        ),
        pytest.param("M0 5L30 0V60L0 55Z", lines(BLANK) + lines(FOLDS), id="a panel in colour"),
        pytest.param("M-9 -9H99V69H-9Z", lines(FOLDS), id="a background"),
        pytest.param(
            "M0 0H90V60H0Z", lines("M30 0V60M0 30H90"), id="a rectangle with lines at all sides"
        ),
        pytest.param("M200 0H250L260 30V60H200Z", lines(FOLDS), id="beside the lines"),
        pytest.param("M0 0H120V5L5 60H0Z", lines("M60 45H90V60M70 50H80"), id="lines in its box"),
    ],
)
def test_an_area_beside_an_outline_of_lines_is_artwork(shape: str, others: str) -> None:
    drawing = read(svg(area(shape), others))
    assert "area" not in imported(drawing)


def test_a_shape_on_a_filled_blank_is_artwork() -> None:
    shape = area("M32 10H50L58 20V50H32Z", "shape", "#f00")
    drawing = read(svg(area(BLANK), shape, lines(FOLDS + "M40 30H50")))
    assert imported(drawing) == {"area", "lines"}


def test_two_filled_blanks_are_two_outlines() -> None:
    second = area(BLANK, "right") + lines(FOLDS, "more")
    right = f'<g transform="translate(100 0)">{second}</g>'
    drawing = read(svg(area(BLANK), lines(FOLDS), right, box="0 0 200 200"))
    assert imported(drawing) == {"area", "lines", "right", "more"}


def test_a_filled_outline_is_cut_and_its_dashed_lines_are_folds() -> None:
    drawing = pipeline.read(svg(area(BLANK), lines(FOLDS)))
    dieline = pipeline.classify(drawing, load.profile("default"))
    assert [LineType(kind).word for kind in dieline.line_type] == ["cut"] * 8 + ["crease"] * 2
