"""Figures as SVG, PNG and PDF, read back by other libraries and by the import."""

from __future__ import annotations

import io
from typing import Any

import numpy as np
import pypdf
import pytest
from PIL import Image

from knifetip import pipeline
from knifetip.dxf.samples import samples
from knifetip.errors import DrawingTooLarge
from knifetip.geometry import arc
from knifetip.handover.export import export
from knifetip.handover.figures import drawing_figure
from knifetip.model.figure import Figure, FigureLayer
from tests.support.exported import stored_edges

POINT = 25.4 / 72.0  # mm


@pytest.fixture(scope="module")
def box() -> Figure:
    return drawing_figure(stored_edges(samples()["rigid-box-blank.dxf"]))


def length(figure: Figure) -> float:
    return sum(
        float(arc.length(one.ends[:, 0], one.ends[:, 1], one.bulge).sum()) for one in figure.layers
    )


def one_layer(ends: Any, bulge: Any) -> Figure:
    return Figure((FigureLayer("CUT", "#d9534f", 1, (), np.array(ends, float), np.array(bulge)),))


def test_an_svg_has_the_size_and_all_edges_of_the_drawing(box: Figure) -> None:
    back = pipeline.read(export(box, "svg", 100))
    assert (back.unit, len(back)) == ("mm", box.edge_count)
    assert back.lengths.sum() == pytest.approx(length(box), abs=1e-3)
    assert np.count_nonzero(back.bulge) == sum(np.count_nonzero(one.bulge) for one in box.layers)
    assert {one.name for one in box.layers} <= set(back.layers)


def test_a_pdf_has_the_size_of_the_drawing(box: Figure) -> None:
    content = export(box, "pdf", 100)
    page = pypdf.PdfReader(io.BytesIO(content)).pages[0]
    low, high = box.box
    assert float(page.mediabox.width) * POINT == pytest.approx(high[0] - low[0] + 10.0, abs=0.01)
    back = pipeline.read(content, "pt")
    assert back.lengths.sum() == pytest.approx(length(box), rel=1e-3)


def test_the_curves_of_a_pdf_lie_on_their_arcs() -> None:
    """A circle of 100 mm in two arcs: all points of its curves are 100 mm from the centre."""
    figure = one_layer([[(-100, 0), (100, 0)], [(100, 0), (-100, 0)]], [1.0, 1.0])
    page = pypdf.PdfReader(io.BytesIO(export(figure, "pdf", 100))).pages[0]
    contents = page.get_contents()
    assert contents is not None
    place = np.zeros(2)
    distances = []
    size = np.array([float(page.mediabox.width), float(page.mediabox.height)]) / 2.0
    scale = np.eye(3)
    for operands, operator in contents.operations:
        numbers = [float(one) for one in operands if isinstance(one, int | float)]
        if operator == b"cm":
            a, b, c, d, e, f = numbers
            scale = np.array([[a, b, 0], [c, d, 0], [e, f, 1]]) @ scale
        elif operator == b"m":
            place = np.array(numbers)
        elif operator == b"c":
            controls = np.array([place, *np.array(numbers).reshape(3, 2)])
            for t in np.linspace(0.0, 1.0, 11):
                weights = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t**3]
                point = np.append(np.array(weights) @ controls, 1.0) @ scale
                distances.append(np.hypot(*(point[:2] - size)) * POINT)
            place = controls[3]
    assert len(distances) == 4 * 11
    assert np.abs(np.array(distances) - 100.0).max() < 0.05


def test_a_png_has_the_wanted_size_and_the_colours_of_the_line_types(box: Figure) -> None:
    picture = Image.open(io.BytesIO(export(box, "png", 640)))
    assert max(picture.size) == 640
    colours = {colour for _, colour in picture.getcolors(1 << 20) or []}
    assert {(255, 255, 255), (0xD9, 0x53, 0x4F), (0x8F, 0x6A, 0xE6)} <= colours


@pytest.mark.parametrize("form", ["svg", "png", "dxf", "pdf"])
def test_empty_flat_and_far_drawings_are_written(form: Any) -> None:
    for figure in (
        Figure(()),
        one_layer([[(5, 5), (5, 5)]], [0.0]),
        one_layer([[(0, 0), (9, 0)]], [0.0]),
        one_layer([[(0, 0), (1e7, 1e-3)]], [0.0]),
    ):
        assert export(figure, form, 64)


def test_a_file_with_too_many_edges_is_refused() -> None:
    figure = one_layer(np.zeros((200_001, 2, 2)), np.zeros(200_001))
    for form in ("dxf", "pdf"):
        with pytest.raises(DrawingTooLarge) as caught:
            export(figure, form, 64)
        assert caught.value.message.arguments["limit"] == 200_000


def test_the_shortest_edges_are_left_out_of_a_picture() -> None:
    figure = one_layer([[(0, 0), (n, 0)] for n in (3, 1, 2)], [0.0, 0.0, 0.0])
    assert figure.longest(2).layers[0].ends[:, 1, 0].tolist() == [3.0, 2.0]
    assert figure.longest(3) is figure
