"""Other ways to draw a drawing, which do not change what is cut and creased.

Each function returns a drawing without texts, and for each of its edges the edge of the original
drawing that it belongs to.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from knifetip.geometry.columns import F64, I64, U8
from knifetip.model.dieline import LineType
from knifetip.model.drawing import NO_LINE_WIDTH, Drawing

_COLUMNS = ("layer", "colour", "true_colour", "linetype", "line_width", "entity", "fit_error")


def restyled(drawing: Drawing, kinds: U8, styles: Mapping[LineType, tuple[str, int]]) -> Drawing:
    """Return a drawing whose edges have a layer and a colour by their line type, and no dashes.

    Parameters
    ----------
    drawing
        A drawing of n edges.
    kinds : (n,)
        LineType of each edge.
    styles
        Name of the layer and AutoCAD colour index of each line type.
    """
    layers = tuple(dict.fromkeys(layer for layer, _ in styles.values()))
    words = [styles[LineType(int(kind))] for kind in kinds]
    count = len(drawing)
    return replace(
        drawing,
        annotations=(),
        layer=np.array([layers.index(layer) for layer, _ in words], np.int32),
        layers=layers,
        colour=np.array([colour for _, colour in words], np.int32),
        true_colour=np.full(count, -1, np.int32),
        linetype=np.zeros(count, np.int32),
        linetypes=("CONTINUOUS",),
        line_width=np.full(count, NO_LINE_WIDTH, np.int32),
    )


def turned(drawing: Drawing, degrees: float) -> tuple[Drawing, I64]:
    """Return a drawing turned counter-clockwise about the origin."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    ends = drawing.ends @ np.array([[c, s], [-s, c]])
    return replace(drawing, ends=ends, annotations=()), np.arange(len(drawing))


def mirrored(drawing: Drawing) -> tuple[Drawing, I64]:
    """Return the mirror image of a drawing, with left and right exchanged."""
    ends, bulge = drawing.ends * [-1.0, 1.0], -drawing.bulge
    return replace(drawing, ends=ends, bulge=bulge, annotations=()), np.arange(len(drawing))


def three_up(drawing: Drawing, gap: float) -> tuple[Drawing, I64]:
    """Return three copies of a drawing beside each other, ``gap`` apart (drawing units)."""
    step = float(np.ptp(drawing.ends[..., 0])) + gap
    row = np.tile(np.arange(len(drawing)), 3)
    shift = np.repeat(np.arange(3) * step, len(drawing))
    ends = drawing.ends[row] + np.stack([shift, 0.0 * shift], axis=1)[:, None]
    return _like(drawing, row, ends, drawing.bulge[row]), row


def in_pieces(drawing: Drawing, longest: float) -> tuple[Drawing, I64]:
    """Return a drawing whose edges are divided into equal pieces, at most ``longest`` long."""
    count = np.maximum(np.ceil(drawing.lengths / longest - 1e-9), 1.0).astype(np.int64)
    row = np.repeat(np.arange(len(drawing)), count)
    number = np.arange(len(row)) - np.repeat(np.cumsum(count) - count, count)
    ends = np.stack([_points(drawing, row, (number + at) / count[row]) for at in (0, 1)], axis=1)
    bulge = np.tan(np.arctan(drawing.bulge) / count)[row]
    return _like(drawing, row, ends, bulge), row


def _points(drawing: Drawing, row: I64, share: F64) -> F64:
    """Return the points at fractions of the lengths of edges, (k, 2)."""
    start, along = drawing.ends[row, 0], drawing.ends[row, 1] - drawing.ends[row, 0]
    half = 2.0 * np.arctan(drawing.bulge[row])
    straight = np.abs(half) < 1e-9
    sine = np.where(straight, 1.0, np.sin(half))
    # The chord to a point of an arc, in units of the whole chord, and its angle to it.
    reach = np.where(straight, share, np.sin(half * share) / sine)
    turn = half * (share - 1.0)
    c, s = reach * np.cos(turn), reach * np.sin(turn)
    x, y = along.T
    points: F64 = start + np.stack([c * x - s * y, s * x + c * y], axis=1)
    return points


def _like(drawing: Drawing, row: I64, ends: F64, bulge: F64) -> Drawing:
    """Return a drawing of edges that have the styles of the edges with the indices ``row``."""
    columns = {name: getattr(drawing, name)[row] for name in _COLUMNS}
    return replace(drawing, ends=ends, bulge=bulge, annotations=(), **columns)
