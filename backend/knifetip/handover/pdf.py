"""pdf: draw figures in PDF files as lines and curves, with the widths and dashes of print."""

from __future__ import annotations

from datetime import UTC, datetime
from typing import Final, NamedTuple

import numpy as np
from fpdf import FPDF
from fpdf.drawing import PaintedPath
from fpdf.enums import PathPaintRule

from knifetip.geometry import arc
from knifetip.geometry.columns import F64
from knifetip.model.figure import Figure, FigureLayer

_STROKE: Final = 0.25  # mm
#: Date in the file, which is always the same, so that equal figures give equal files.
_DATE: Final = datetime(2000, 1, 1, tzinfo=UTC)
_MARGIN: Final = 5.0  # mm
#: Sides of a page (mm): readers of PDF show no page that is smaller or larger.
_LEAST_PAGE: Final = 20.0
_MOST_PAGE: Final = 5000.0
#: Largest bulge of an arc that one curve approximates, a quarter of a circle.
_QUARTER: Final = np.tan(np.pi / 8.0)


class Frame(NamedTuple):
    """Where a figure is drawn on a page (mm, from the upper left corner)."""

    x: float
    y: float
    width: float
    height: float


def write_pdf(figure: Figure) -> bytes:
    """Return a figure as a PDF file with one page, in true size unless it exceeds 5 m."""
    low, high = figure.box
    size = np.maximum(high - low, 1e-9)
    scale = min(1.0, (_MOST_PAGE - 2.0 * _MARGIN) / float(size.max()))
    width, height = np.maximum(size * scale + 2.0 * _MARGIN, _LEAST_PAGE).tolist()
    pdf = FPDF(unit="mm", format=(width, height))
    pdf.set_creation_date(_DATE)
    pdf.set_auto_page_break(False)
    pdf.add_page()
    inside = Frame(_MARGIN, _MARGIN, width - 2.0 * _MARGIN, height - 2.0 * _MARGIN)
    draw_figure(pdf, figure, inside, most_scale=1.0)
    return bytes(pdf.output())


def draw_figure(pdf: FPDF, figure: Figure, frame: Frame, *, most_scale: float = 1e9) -> None:
    """Draw a figure in the middle of a frame, as large as the frame permits.

    Parameters
    ----------
    most_scale
        Greatest scale, 1 for true size.
    """
    low, high = figure.box
    size = np.maximum(high - low, 1e-9)
    scale = min(most_scale, frame.width / size[0], frame.height / size[1])
    left = frame.x + (frame.width - size[0] * scale) / 2.0
    top = frame.y + (frame.height - size[1] * scale) / 2.0
    with pdf.drawing_context() as context:
        for layer in figure.layers:
            if len(layer.bulge) == 0:
                continue
            points = (layer.ends - (low[0], high[1])) * (scale, -scale) + (left, top)
            # Y points down on the page, so that an arc turns the other way.
            context.add_item(_path(layer, points, -layer.bulge))


def draw_sample(pdf: FPDF, layer: FigureLayer, frame: Frame) -> None:
    """Draw a horizontal line as the lines of a layer are drawn, as long as a frame is wide."""
    ends = np.array([[(frame.x, frame.y), (frame.x + frame.width, frame.y)]])
    with pdf.drawing_context() as context:
        context.add_item(_path(layer, ends, np.zeros(1)))


def _path(layer: FigureLayer, ends: F64, bulge: F64) -> PaintedPath:
    """Return the edges of a layer, (n, 2, 2) mm on the page and (n,), as a path to be stroked."""
    path = PaintedPath()
    path.style.stroke_color = layer.colour
    path.style.fill_color = None
    path.style.paint_rule = PathPaintRule.STROKE
    path.style.stroke_width = _STROKE
    path.style.stroke_cap_style = "butt" if layer.dashes else "round"
    path.style.stroke_dash_pattern = layer.dashes or None
    path.style.auto_close = False
    before = None
    for (start, end), bow in zip(ends.tolist(), bulge.tolist(), strict=True):
        if start != before:
            path.move_to(*start)
        if bow == 0.0:
            path.line_to(*end)
        else:
            for first, second, last in _curves(np.array(start), np.array(end), bow):
                path.curve_to(*first, *second, *last)
        before = end
    return path


def _curves(start: F64, end: F64, bulge: float) -> list[list[list[float]]]:
    """Return an arc as Bézier curves of at most a quarter of a circle: two controls and the end.

    The curves deviate from the arc by at most 0.03 % of its radius.
    """
    count = int(np.ceil(np.arctan(abs(bulge)) / np.arctan(_QUARTER) - 1e-9))
    fraction = np.linspace(0.0, 1.0, count + 1)
    starts, ends = np.tile(start, (count + 1, 1)), np.tile(end, (count + 1, 1))
    bow = np.full(count + 1, bulge)
    points = arc.point_at(starts, ends, bow, fraction)
    points[-1] = end
    # A tangent is as long as the chord of the whole arc.
    along = arc.tangent_at(starts, ends, bow, fraction) / np.hypot(*(end - start))
    quarter = np.arctan(bulge) / count  # a quarter of the sweep of each curve
    chord = np.hypot(*(points[1] - points[0]))
    reach = chord / (3.0 * np.cos(quarter) ** 2)
    first, second = points[:-1] + along[:-1] * reach, points[1:] - along[1:] * reach
    curves: list[list[list[float]]] = np.stack([first, second, points[1:]], axis=1).tolist()
    return curves
