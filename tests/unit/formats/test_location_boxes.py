"""Location boxes of objects that produce no geometry, in each format."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose

from knifetip.cf2.read import read as read_cf2
from knifetip.drawing_builder.path_table import CUBIC, LINE, Table, boxes
from knifetip.hpgl.read import read as read_hpgl
from knifetip.lightburn.read import read as read_lightburn
from knifetip.model.drawing import Drawing
from knifetip.pdf.read import read as read_pdf
from knifetip.svg.read import read as read_svg
from tests.support.writers import cf2_text
from tests.support.writers.cf2_text import cf2, sub
from tests.support.writers.lightburn_text import polyline, project, shape
from tests.support.writers.pdf_text import MM, pdf, stream
from tests.support.writers.svg_text import svg

POINT = 25.4 / 72.0


def boxes_by_handle(drawing: Drawing) -> dict[str, list[float]]:
    """Return the location boxes (mm) by the handles of the entities."""
    rows, measured = drawing.import_report.location_boxes
    handles = list(drawing.import_report.handle)
    return {handles[row]: box for row, box in zip(rows.tolist(), measured.tolist(), strict=True)}


@pytest.mark.parametrize(
    ("inside", "box"),
    [
        ('<rect id="a" x="20" y="20" width="30" height="10" fill="#00f" stroke="none"/>', "fill"),
        ('<image id="a" x="20" y="20" width="30" height="10" href="a.png"/>', "fill"),
        ('<g transform="translate(20 20)"><image id="a" width="30" height="10"/></g>', "fill"),
        ('<g display="none"><path id="a" d="M20 20L50 30"/></g>', "fill"),
        ('<path id="a" d="M20 20L50 30" visibility="hidden"/>', "fill"),
        ('<use id="a" x="20" y="30" href="b.svg#lid"/>', [20, 70, 20, 70]),
        ('<text id="a" x="20" y="30" font-size="5">Lid</text>', [20, 70, 20, 70]),
        ('<image id="a" x="20" width="wide"/>', None),
        ('<path id="a" d=""/>', None),
    ],
)
def test_boxes_of_svg_objects(inside: str, box: list[float] | str | None) -> None:
    drawing = read_svg(svg('<path d="M0 0H90"/>', inside))
    expected = [20, 70, 50, 80] if box == "fill" else box
    assert boxes_by_handle(drawing) == ({} if expected is None else {"a": pytest.approx(expected)})


def test_boxes_of_pdf_objects() -> None:
    drawing = read_pdf(
        pdf(
            "0 0 m 90 0 l S 20 30 10 5 re f 1 0 0 1 5 5 cm 20 30 10 5 re W n",
            "q 40 0 0 20 7 8 cm /Im0 Do Q BT /F1 9 Tf 3 4 Td (words) Tj ET 500 500 m 600 500 l S",
            "/Sh0 sh",
            resources="/XObject <</Im0 6 0 R>>",
            more=[stream(b"x", "/Subtype /Image")],
            size=(100.0, 100.0),
        )
    )
    measured = {handle: np.array(box) / POINT for handle, box in boxes_by_handle(drawing).items()}
    assert_allclose(measured["#2"], [20, 30, 30, 35], atol=1e-9)  # a filled area
    assert_allclose(measured["#3"], [25, 35, 35, 40], atol=1e-9)  # a clipping path
    assert_allclose(measured["#4"], [12, 13, 52, 33], atol=1e-9)  # an image
    assert_allclose(measured["#5"], [8, 9, 8, 9], atol=1e-9)  # a text
    assert_allclose(measured["#6"], [505, 505, 605, 505], atol=1e-9)  # a line outside the page
    assert_allclose(
        measured["#7"], [25, 35, 35, 40], atol=1e-9
    )  # a shading inside the clipping path
    assert len(measured) == 6


def test_a_pdf_shading_without_a_clipping_path_has_the_box_of_the_page() -> None:
    drawing = read_pdf(pdf("0 0 m 9 0 l S /Sh0 sh", size=(90.0 * MM, 90.0 * MM)))
    assert boxes_by_handle(drawing) == {"#2": pytest.approx([0.0, 0.0, 90.0, 90.0])}


def test_boxes_of_cf2_records() -> None:
    carton = sub("LID", cf2_text.line(0, 0, 90, 0), "T,2,1,0,3,4,0,5,4", "Rev. B")
    drawing = read_cf2(
        cf2("C,LID,100,50,90,1,1", "C,GONE,7,8,0,1,1", head=("UM", "SCALE,1,1"), subs=carton)
    )
    text, gone = boxes_by_handle(drawing).values()
    assert_allclose(text, [96, 53, 96, 53])
    assert gone == [7, 8, 7, 8]


def test_boxes_contain_ends_and_curve_handles_but_no_line_handles() -> None:
    numbers = np.array([[0, 0, 4, 0, 9, 9, 9, 9], [0, 0, 4, 0, 1, 5, 3, -2]], np.float64)
    table = Table(np.array([LINE, CUBIC], np.uint8), numbers, np.array([0, 2]))
    matrix = np.array([[1, 0, 0, 1, 0, 0]] * 2 + [[0, 1, 1, 0, 10, 0]], np.float64)
    measured = boxes(table, matrix)
    assert measured[[0, 2]].tolist() == [[0, 0, 4, 0], [8, 0, 15, 4]]
    assert np.isnan(measured[1]).all()


def test_boxes_of_plotter_instructions() -> None:
    drawing = read_hpgl(
        b"IN;SP1;PU0,0;PD40,0;SP0;PU80,80;PD160,120;SP1;PU400,0;LBLid\x03PR;PD40,0;"
        b"PA;PG;PU40,40;CI40;"
    )
    assert boxes_by_handle(drawing) == {
        "#7": [2, 2, 4, 3],
        "#10": [10, 0, 10, 0],
        "#16": pytest.approx([0, 1, 2, 1]),
    }


def test_boxes_of_lightburn_shapes() -> None:
    words = shape("Text", matrix="1 0 0 1 20 30", Str="Lid")
    drawing = read_lightburn(project(polyline((0, 0), (9, 0)), words))
    assert boxes_by_handle(drawing) == {"#2": [20, 30, 20, 30]}
