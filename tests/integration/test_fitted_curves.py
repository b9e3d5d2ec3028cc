"""Curves of a file through all stages: the stated deviation includes the fit of the curves."""

from __future__ import annotations

from io import StringIO

import ezdxf
import numpy as np
import pytest

from knifetip import pipeline
from knifetip.geometry import arc
from knifetip.library import load
from knifetip.model.drawing import Drawing

HALF_AXES = (176.0, 0.68 * 176.0)


def ellipse_file(scale: float = 1.0) -> bytes:
    """Return a DXF in millimetres with one ellipse on layer CUT, in a block that is scaled."""
    document = ezdxf.new("R2010", units=4)
    block = document.blocks.new("SHAPE")
    block.add_ellipse(
        (200.0 / scale, 150.0 / scale),
        (HALF_AXES[0] / scale, 0.0),
        0.68,
        dxfattribs={"layer": "CUT"},
    )
    document.modelspace().add_blockref(
        "SHAPE", (0, 0), dxfattribs={"xscale": scale, "yscale": scale, "zscale": scale}
    )
    text = StringIO()
    document.write(text)
    return text.getvalue().encode()


def distance_from_ellipse(drawing: Drawing) -> float:
    """Return the greatest distance of points of the edges from the ellipse (mm)."""
    start, end = drawing.ends[:, 0], drawing.ends[:, 1]
    points = np.concatenate(
        [
            arc.point_at(start, end, drawing.bulge, np.full(len(drawing), fraction))
            for fraction in np.linspace(0.0, 1.0, 33)
        ]
    ) - [200.0, 150.0]
    t = np.arctan2(points[:, 1] / HALF_AXES[1], points[:, 0] / HALF_AXES[0])
    a, b = HALF_AXES
    for _ in range(20):
        # Newton's method for the foot of the perpendicular.
        x, y = a * np.cos(t) - points[:, 0], b * np.sin(t) - points[:, 1]
        slope = -a * np.sin(t) * x + b * np.cos(t) * y
        change = (a * np.sin(t)) ** 2 + (b * np.cos(t)) ** 2 - a * np.cos(t) * x - b * np.sin(t) * y
        t = t - slope / change
    return float(np.hypot(a * np.cos(t) - points[:, 0], b * np.sin(t) - points[:, 1]).max())


@pytest.mark.parametrize("scale", [1.0, 25.4])
def test_a_drawing_has_the_distance_of_its_edges_from_the_curve(scale: float) -> None:
    drawing = pipeline.read(ellipse_file(scale))
    true = distance_from_ellipse(drawing)
    assert true > 0.001
    assert true - 1e-6 <= drawing.fit_error.max() <= min(1.05 * true, 0.0035)


@pytest.mark.parametrize("dialect", ["grblhal", "linuxcnc"])
def test_the_verdict_states_the_fit_and_accepts_the_program(dialect: str) -> None:
    drawing = pipeline.read(ellipse_file())
    dieline = pipeline.classify(drawing, load.profile("default"))
    table, board = load.machine("demo-table"), load.board("greyboard-2.0")
    verdict = pipeline.compile(drawing, dieline, table, board, dialect=dialect).verdict
    assert verdict.accepted, verdict.findings[:2]
    np.testing.assert_allclose(verdict.blending, 0.0005 if dialect == "linuxcnc" else 0.0)
    # Cleaning merges arcs of one circle; the merged arc has the greatest distance of its parts.
    assert (verdict.fit_error >= drawing.fit_error).all()
    # Cleaning may join fitted arcs, up to 0.0035 mm from the curve.
    assert drawing.fit_error.max() <= verdict.fit_error.max() <= 0.0035
    total = verdict.path_deviation + verdict.blending + verdict.fit_error
    np.testing.assert_allclose(verdict.deviation, total)
    assert verdict.deviation.max() >= distance_from_ellipse(drawing)
