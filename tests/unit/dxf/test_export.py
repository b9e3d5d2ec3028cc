"""Figures written as DXF: read back with the same lines, arcs, unit and line types."""

from __future__ import annotations

import io
from pathlib import Path

import ezdxf
import numpy as np
import pytest

from knifetip import pipeline
from knifetip.dxf.export import export_dxf
from knifetip.dxf.samples import samples
from knifetip.geometry.columns import F64
from knifetip.handover.figures import drawing_figure
from knifetip.model.dieline import LineType
from knifetip.model.figure import Figure, FigureLayer
from knifetip.model.interpretation import Interpretation
from tests.support.exported import stored_edges

SAMPLES = samples()
#: Drawings by other authors: DXF, CF2 and SVG, with arcs and in several units.
FILES = (
    "Obrary__Parametric-Papercraft/Interchange-Files/cube.dxf",
    "generated__kyholdings__diecut_generator/mailer_200x150x60_t3.dxf",
    "generated__bikinon__RSC-FEFCO-02xx/f0201_B_400x300x250.dxf",
    "generated__florianfesti__boxes/PaperBox_100x40x140.dxf",
)


def directed(ends: F64, bulge: F64) -> F64:
    """Return n edges as rows [x, y, x, y, bulge], (n, 5), each from its lower end, sorted."""
    flip = (ends[:, 0, 0] > ends[:, 1, 0]) | (
        np.isclose(ends[:, 0, 0], ends[:, 1, 0], atol=1e-9) & (ends[:, 0, 1] > ends[:, 1, 1])
    )
    rows = np.column_stack([ends.reshape(-1, 4), bulge])
    rows[flip] = np.column_stack([ends[:, ::-1].reshape(-1, 4), -bulge])[flip]
    return rows[np.lexsort(np.round(rows, 5).T[::-1])]


def check_round_trip(data: bytes, unit: str | None = None) -> None:
    figure = drawing_figure(stored_edges(data, unit))
    back = pipeline.read(export_dxf(figure))
    assert (back.unit, len(back)) == ("mm", figure.edge_count)
    dieline = pipeline.interpret(back, Interpretation())
    open_edges = any(layer.name == "UNCLASSIFIED" for layer in figure.layers)
    assert open_edges or pipeline.questions(back, dieline) == []
    for layer in figure.layers:
        mine = np.array([back.layers[one] == layer.name for one in back.layer])
        found = directed(back.ends[mine], back.bulge[mine])
        assert np.abs(found - directed(layer.ends, layer.bulge)).max() < 1e-6
        if layer.name != "UNCLASSIFIED":
            assert set(dieline.line_type[mine]) == {LineType.from_word(layer.name)}


@pytest.mark.parametrize("name", SAMPLES)
def test_a_sample_is_read_back_without_a_question(name: str) -> None:
    check_round_trip(SAMPLES[name])


@pytest.mark.corpus
@pytest.mark.parametrize("name", FILES)
def test_a_drawing_by_another_author_is_read_back(corpus: Path, name: str) -> None:
    check_round_trip((corpus / name).read_bytes(), "mm")


def figure_of(*edges: tuple[float, float, float, float, float], unit: str = "mm") -> Figure:
    rows = np.array(edges, float)
    layer = FigureLayer("CUT", "#d9534f", 1, (), rows[:, :4].reshape(-1, 2, 2), rows[:, 4])
    return Figure((layer,), unit)


def test_arcs_are_arcs_and_nearly_straight_ones_keep_their_ends() -> None:
    figure = figure_of((0, 0, 10, 0, 0.0), (10, 0, 10, 20, -0.9), (10, 20, 0, 20, 1e-5))
    document = ezdxf.read(io.StringIO(export_dxf(figure).decode()))
    assert [one.dxftype() for one in document.modelspace()] == ["LINE", "ARC", "LWPOLYLINE"]
    assert {one.dxf.layer for one in document.modelspace()} == {"CUT"}
    assert document.header["$INSUNITS"] == 4
    back = pipeline.read(export_dxf(figure), "mm")
    expected = directed(figure.layers[0].ends, figure.layers[0].bulge)
    assert np.abs(directed(back.ends, back.bulge) - expected).max() < 1e-9


def test_equal_figures_give_equal_files_and_a_drawing_without_a_unit_states_none() -> None:
    figure = figure_of((0, 0, 10, 0, 0.0), unit="")
    assert export_dxf(figure) == export_dxf(figure)
    document = ezdxf.read(io.StringIO(export_dxf(figure).decode()))
    assert document.header["$INSUNITS"] == 0
    assert b"lengths in mm" not in export_dxf(figure)
