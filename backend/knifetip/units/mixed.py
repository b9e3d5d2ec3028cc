"""mixed: parts of one sheet that are drawn at different scales.

    Drawing -> warnings

Two signs: the same shape twice, one larger than the other, and two parts whose lengths are good
numbers in different units, as where a block was inserted 25.4 times too large.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.geometry.columns import F64, I64
from knifetip.geometry.distinct import distinct
from knifetip.geometry.sets import settle, unite
from knifetip.kernels import OutI64_1, kernel
from knifetip.model.drawing import Drawing
from knifetip.model.unit import MILLIMETRES, NAMES, factor
from knifetip.units import weights
from knifetip.units.lengths import Lengths, of_edges, table_likelihood

#: Parts that are looked at, the largest; each has so many edges and different lengths, and is so
#: large a share of the drawing.
_PARTS: Final = 8
_EDGES: Final = 6
_DIFFERENT: Final = 4
_SHARE: Final = 0.005
#: Ends that are nearer than this share of the drawing's size are one point.
_JOINED: Final = 1e-5
#: Lengths of similar parts keep their ratio to this.
_ALIKE: Final = 2e-4
#: Scales of similar parts: a drawing and its detail, or a unit taken for another.
_SCALES: Final = (1.5, 2.0, 2.5, 4.0, 5.0, 10.0, 20.0, 25.4, 50.0, 100.0)


def by_parts(drawing: Drawing) -> list[str]:
    """Return what parts of different scales there are, in words."""
    ends, bulge = drawing.ends / factor(drawing.unit), drawing.bulge
    parts = _parts(ends)
    return _similar(parts, ends, bulge) + _foreign(parts, ends, bulge)


def _parts(ends: F64) -> list[I64]:
    """Return the rows of the largest parts that hang together."""
    if len(ends) < 2 * _EDGES:
        return []
    flat = ends.reshape(-1, 2)
    low = np.array([flat[:, 0].min(), flat[:, 1].min()])
    size = float(max(flat[:, 0].max() - low[0], flat[:, 1].max() - low[1]))
    step = _JOINED * size
    if not step > 0.0 or not np.isfinite(step):
        return []
    # Not through zero and whole numbers, which is where points are.
    _, node = distinct(np.round((flat - low) / step + 0.37).astype(np.int64))
    root = _roots(node, int(node.max()) + 1)[node[::2]]
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


def _similar(parts: list[I64], ends: F64, bulge: F64) -> list[str]:
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
                return [
                    f"The same part is drawn twice, once {times:.3g} times larger than the other: "
                    "one of them is a detail, or came in with a wrong unit."
                ]
    return []


def _foreign(parts: list[I64], ends: F64, bulge: F64) -> list[str]:
    """Say it where two parts are good numbers in different units."""
    told: list[tuple[dict[tuple[str, str], float], Lengths]] = []
    for rows in parts:
        found = of_edges(ends[rows], bulge[rows])
        if len(found.value) >= _DIFFERENT:
            told.append((_families(found), found))
    for number, (one, _) in enumerate(told):
        for other, _ in told[number + 1 :]:
            here, there = max(one, key=one.__getitem__), max(other, key=other.__getitem__)
            clear = min(one[here] - one[there], other[there] - other[here])
            if here != there and clear >= weights.DECIDES:
                return [
                    f"Parts of the drawing do not agree: one is drawn in {_family(here)}, another "
                    f"in {_family(there)}."
                ]
    return []


def _families(found: Lengths) -> dict[tuple[str, str], float]:
    """Return the logarithm of how likely a part's lengths are in each unit and system.

    mm, cm and m share their grids, and so do inches and feet: only one of each stands here.
    """
    return {
        (unit, system): table_likelihood(found, MILLIMETRES[unit], table)
        for unit in ("mm", "in", "pt", "px")
        for system, table in (("metric", weights.METRIC), ("imperial", weights.IMPERIAL))
    }


def _family(key: tuple[str, str]) -> str:
    unit, system = key
    size = {"metric": "millimetres", "imperial": "fractions of inches"}[system]
    return (
        size
        if (unit, system) in (("mm", "metric"), ("in", "imperial"))
        else (f"{size} written as {NAMES[unit]}")
    )


@kernel
def _roots(node: OutI64_1, count: int) -> Any:
    """Return the part of each of ``count`` nodes; edge i joins nodes 2 i and 2 i + 1."""
    root = np.arange(count)
    for edge in range(len(node) // 2):
        unite(root, node[2 * edge], node[2 * edge + 1])
    settle(root)
    return root
