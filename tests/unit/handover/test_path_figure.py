"""The figure of a tool path: the tip runs on the drawn lines, and the head beside them."""

from __future__ import annotations

import numpy as np
import shapely

from knifetip import pipeline
from knifetip.dxf.samples import samples
from knifetip.geometry import arc
from knifetip.geometry.columns import F64
from knifetip.handover.figures import path_figure
from knifetip.library import load
from knifetip.model.figure import FigureLayer
from knifetip.model.interpretation import Interpretation
from knifetip.presentation.toolpath import pack_toolpath
from tests.support.exported import stored_edges

DATA = samples()["rigid-box-blank.dxf"]


def points(layer: FigureLayer) -> F64:
    """Return 9 points along each line and arc, (9 n, 2)."""
    start, end = layer.ends[:, 0], layer.ends[:, 1]
    return np.concatenate(
        [
            arc.point_at(start, end, layer.bulge, np.full(len(start), fraction))
            for fraction in np.linspace(0.0, 1.0, 9)
        ]
    )


def as_lines(layer: FigureLayer) -> shapely.Geometry:
    start, end = layer.ends[:, 0], layer.ends[:, 1]
    chords = [
        arc.point_at(start, end, layer.bulge, np.full(len(start), fraction))
        for fraction in np.linspace(0.0, 1.0, 65)
    ]
    return shapely.union_all(shapely.linestrings(np.stack(chords, axis=1)))


def test_the_tip_covers_the_drawn_lines_and_the_head_of_the_v_cutter_does_not() -> None:
    drawing = pipeline.read(DATA)
    machine = load.machine("demo-table")
    compiled = pipeline.compile(
        drawing,
        pipeline.interpret(drawing, Interpretation()),
        machine,
        load.board("greyboard-2.0"),
    )
    figure = path_figure(pack_toolpath(compiled, machine), stored_edges(DATA), machine)
    line, tip, head, lift = figure.layers
    assert [one.name for one in figure.layers] == ["LINE", "TIP", "HEAD", "LIFT"]
    # Ends of grooves stop before the cut by a setback, nowhere else is a line without a tip.
    away = shapely.distance(shapely.points(points(line)), as_lines(tip))
    assert np.quantile(away, 0.95) < 0.05
    beside = shapely.distance(shapely.points(points(head)), as_lines(line))
    assert beside.max() > 1.0
    assert len(lift.bulge) > 0
    low, _ = figure.box
    assert (low >= 0.0).all()
