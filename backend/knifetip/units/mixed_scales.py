"""mixed_scales: warn of parts of one sheet that are drawn at different scales.

A part is a set of connected edges.  Two parts have different scales if they have the same shape at
different sizes, or if the lengths of their edges are round numbers in different units, for example
after a block was inserted 25.4 times too large.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.geometry.columns import F64, I64
from knifetip.geometry.union_find import component_roots
from knifetip.geometry.unique_rows import unique_rows
from knifetip.messages import Message
from knifetip.model.drawing import Drawing
from knifetip.model.unit import MILLIMETRES, factor
from knifetip.units import weights
from knifetip.units.lengths import Lengths, edge_lengths, table_likelihood

#: Number of the largest parts that are compared.  Each part needs at least this number of edges, of
#: different lengths, and this fraction of the drawing's size.
_PARTS: Final = 8
_EDGES: Final = 6
_DIFFERENT: Final = 4
_SHARE: Final = 0.005
#: Edge ends closer to each other than this fraction of the drawing's size are one point.
_JOINED: Final = 1e-5
#: Relative tolerance of the ratio between lengths of similar parts.
_ALIKE: Final = 2e-4
#: Ratios between similar parts that are reported: details, and units that were mistaken.
_SCALES: Final = (1.5, 2.0, 2.5, 4.0, 5.0, 10.0, 20.0, 25.4, 50.0, 100.0)


def mixed_scale_warnings(drawing: Drawing) -> list[Message]:
    """Return warnings if connected parts of the drawing have different scales, else an empty list.

    At most one warning is about two parts of the same shape at different sizes, and at most one is
    about two parts whose lengths are round numbers in different units.
    """
    ends, bulge = drawing.ends / factor(drawing.unit), drawing.bulge
    parts = _largest_parts(ends)
    return _similar_parts(parts, ends, bulge) + _parts_in_other_units(parts, ends, bulge)


def _largest_parts(ends: F64) -> list[I64]:
    """Return the largest connected parts of n edges, each as an array of the indices of its edges.

    A part is a set of connected edges.  Parts that are too small, or have too few edges, to be
    compared are omitted.  ``ends`` are the start and end points of the edges, shape (n, 2, 2).
    """
    if len(ends) < 2 * _EDGES:
        return []
    flat = ends.reshape(-1, 2)
    low = np.array([flat[:, 0].min(), flat[:, 1].min()])
    size = float(max(flat[:, 0].max() - low[0], flat[:, 1].max() - low[1]))
    step = _JOINED * size
    if not step > 0.0 or not np.isfinite(step):
        return []
    # The offset keeps round coordinates away from the borders between cells.
    _, node = unique_rows(np.round((flat - low) / step + 0.37).astype(np.int64))
    root = component_roots(node, int(node.max()) + 1)[node[::2]]
    edges = np.bincount(root)
    largest = np.argsort(-edges, kind="stable")[:_PARTS]
    if len(ends) - edges[largest[0]] < _EDGES:
        return []
    parts = []
    for number in largest:
        if edges[number] < _EDGES:
            break
        rows = np.flatnonzero(root == number)
        corner = ends[rows].reshape(-1, 2)
        if float(np.ptp(corner, axis=0).max()) >= _SHARE * size:
            parts.append(rows)
    return parts


def _similar_parts(parts: list[I64], ends: F64, bulge: F64) -> list[Message]:
    """Return a warning if two parts have the same shape at different sizes, else an empty list.

    ``ends`` (n, 2, 2): start and end points of all n edges of the drawing (file units).
    ``bulge`` (n,): bulges of all edges of the drawing.
    """
    shapes = []
    for rows in parts:
        across = ends[rows, 1] - ends[rows, 0]
        run = np.sort(np.hypot(across[:, 0], across[:, 1]))
        if len(np.unique(np.round(run / run[-1], 4))) >= _DIFFERENT and (bulge[rows] == 0.0).any():
            shapes.append(run)
    for number, one in enumerate(shapes):
        for other in shapes[number + 1 :]:
            if len(one) != len(other):
                continue
            small, large = sorted((one, other), key=lambda run: float(run[-1]))
            times = float(large[-1] / small[-1])
            if any(abs(times - scale) < 1e-3 * scale for scale in _SCALES) and np.allclose(
                large, small * times, rtol=_ALIKE, atol=1e-9 * times
            ):
                return [Message("unit.part-drawn-twice", factor=times)]
    return []


def _parts_in_other_units(parts: list[I64], ends: F64, bulge: F64) -> list[Message]:
    """Return a warning if the edge lengths of two parts are round in different units, else [].

    ``ends`` (n, 2, 2): start and end points of all n edges of the drawing (file units).
    ``bulge`` (n,): bulges of all edges of the drawing.
    """
    candidates: list[tuple[dict[tuple[str, str], float], Lengths]] = []
    for rows in parts:
        found = edge_lengths(ends[rows], bulge[rows])
        if len(found.value) >= _DIFFERENT:
            candidates.append((_likelihoods(found), found))
    for number, (one, _) in enumerate(candidates):
        for other, _ in candidates[number + 1 :]:
            here, there = max(one, key=one.__getitem__), max(other, key=other.__getitem__)
            lead = min(one[here] - one[there], other[there] - other[here])
            if here != there and lead >= weights.DECISION_MARGIN:
                return [Message("unit.parts-differ", one=_drawn_in(here), other=_drawn_in(there))]
    return []


def _likelihoods(lengths: Lengths) -> dict[tuple[str, str], float]:
    """Return the log-likelihood of one part's edge lengths for each pair of unit and system.

    The unit, "mm", "in", "pt" or "px", is the one in which the part is assumed to be drawn.  The
    system, "metric" or "imperial", is the one in which its lengths are assumed to be round numbers.
    Other units are omitted: lengths that are round in cm or m are round in mm, and lengths that are
    round in feet are round in inches.  ``lengths`` are the lengths of the part's edges in file
    units.
    """
    return {
        (unit, system): table_likelihood(lengths, MILLIMETRES[unit], table)
        for unit in ("mm", "in", "pt", "px")
        for system, table in (("metric", weights.METRIC), ("imperial", weights.IMPERIAL))
    }


def _drawn_in(key: tuple[str, str]) -> Message:
    """Return the message that names the unit in which a part is drawn.

    ``key`` is this unit, such as "mm", and the system of measures in which the lengths of the part
    are round numbers, "metric" or "imperial".
    """
    match key:
        case ("mm", "metric"):
            return Message("unit.drawn-in-millimetres")
        case ("in", "imperial"):
            return Message("unit.drawn-in-inches")
        case (unit, "metric"):
            return Message("unit.drawn-in-metric", unit=unit)
        case (unit, _):
            return Message("unit.drawn-in-imperial", unit=unit)
