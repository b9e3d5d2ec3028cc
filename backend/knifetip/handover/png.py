"""png: draw a figure as a PNG picture, on white."""

from __future__ import annotations

import io
from typing import Final

import numpy as np
from PIL import Image, ImageDraw

from knifetip.geometry import arc
from knifetip.geometry.chords import chord_counts
from knifetip.geometry.columns import F64
from knifetip.model.figure import Figure, FigureLayer

#: Each pixel is the mean of so many times as many, so that slanted lines are smooth.
_FINER: Final = 2
_MARGIN: Final = 12  # pixels
_STROKE: Final = 1.5  # pixels
#: Greatest distance of a chord from its arc (pixels).
_DEVIATION: Final = 0.1


def write_png(figure: Figure, width: int) -> bytes:
    """Return a figure as a PNG picture; the longer side of the picture has ``width`` pixels.

    Lines are solid, because dashes of a small picture cannot be told apart.

    Parameters
    ----------
    width : pixels
        Greater than 24.
    """
    low, high = figure.box
    size = np.maximum(high - low, 1e-9)
    scale = (width - 2 * _MARGIN) / size.max()
    pixels = np.ceil(size * scale).astype(int) + 2 * _MARGIN
    finer = _FINER * pixels.clip(1, width)
    picture = Image.new("RGB", (int(finer[0]), int(finer[1])), "white")
    pen = ImageDraw.Draw(picture)
    stroke = round(_STROKE * _FINER)
    for layer in figure.layers:
        for points in _polylines(layer, scale):
            placed = (points - (low[0], high[1])) * (scale, -scale) + _MARGIN
            pen.line((placed * _FINER).ravel().tolist(), fill=layer.colour, width=stroke)
    shown = picture.resize((int(finer[0]) // _FINER, int(finer[1]) // _FINER), Image.Resampling.BOX)
    content = io.BytesIO()
    shown.save(content, "PNG", optimize=True)
    return content.getvalue()


def _polylines(layer: FigureLayer, scale: float) -> list[F64]:
    """Return each edge of a layer as points, (m, 2) each; ``scale`` are pixels per unit."""
    start, end, bulge = layer.ends[:, 0], layer.ends[:, 1], layer.bulge
    chords = chord_counts(start, end, bulge, _DEVIATION / scale)
    edge = np.repeat(np.arange(len(bulge)), chords + 1)
    first = np.cumsum(chords + 1) - (chords + 1)
    fraction = (np.arange(len(edge)) - first[edge]) / chords[edge]
    points = arc.point_at(start[edge], end[edge], bulge[edge], fraction)
    return np.split(points, first[1:]) if len(bulge) else []
