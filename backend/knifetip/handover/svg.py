"""svg: write a figure as SVG in its true size, with a group for each layer."""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from knifetip.geometry import arc
from knifetip.model.figure import Figure, FigureLayer

#: Decimals of coordinates (mm).
_DECIMALS: Final = 6
_MARGIN: Final = 2.0  # mm
_STROKE: Final = 0.25  # mm


def write_svg(figure: Figure) -> bytes:
    """Return a figure as an SVG file whose page is as large as the figure, with a margin of 2 mm.

    A figure without a unit has no physical size.
    """
    low, high = figure.box
    width, height = (high - low + 2.0 * _MARGIN).tolist()
    unit = "mm" if figure.unit else ""
    pieces = [
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        '<svg xmlns="http://www.w3.org/2000/svg" '
        f'width="{width:.6g}{unit}" height="{height:.6g}{unit}" '
        f'viewBox="0 0 {width:.6g} {height:.6g}" fill="none" stroke-width="{_STROKE}" '
        'stroke-linecap="round">\n'
    ]
    for layer in figure.layers:
        if len(layer.bulge):
            dashes = " ".join(f"{one:g}" for one in layer.dashes)
            dashed = f' stroke-dasharray="{dashes}" stroke-linecap="butt"' if dashes else ""
            pieces.append(
                f'<g id="{layer.name}" stroke="{layer.colour}"{dashed}>\n'
                f'<path d="{_path_data(layer, low[0], high[1])}"/>\n</g>\n'
            )
    return "".join([*pieces, "</svg>\n"]).encode()


def _path_data(layer: FigureLayer, left: float, top: float) -> str:
    """Return the path data of a layer; Y points down in SVG."""
    points = (layer.ends - (left, top)) * (1.0, -1.0) + _MARGIN
    points = np.round(points, _DECIMALS) + 0.0
    radius = np.round(np.abs(arc.radius(layer.ends[:, 0], layer.ends[:, 1], layer.bulge)), 9)
    steps = []
    before = None
    for (start, end), bulge, size in zip(
        points.tolist(), layer.bulge.tolist(), radius.tolist(), strict=True
    ):
        if start != before:
            steps.append(f"M{start[0]} {start[1]}")
        if not math.isfinite(size):
            steps.append(f"L{end[0]} {end[1]}")
        else:
            flags = f"{int(abs(bulge) > 1.0)} {int(bulge < 0.0)}"
            steps.append(f"A{size} {size} 0 {flags} {end[0]} {end[1]}")
        before = end
    return "".join(steps)
