"""Kernels that measure how far the stretches of tip paths lie from the edges that they follow."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from knifetip.kernels import F64_1, F64_2, I32_1, OutF64_1, kernel


@kernel
def sample_stretches(
    curve: F64_2, work: I32_1, along: F64_2, edges: F64_2, edge: I32_1, place: F64_2
) -> Any:
    """Return the positions on the edges and the distances to their left of three points of each of
    k stretches: start, middle and end; (3, k) mm each.

    Parameters
    ----------
    curve, edges : (n, 6) and (m, 6)
        The tip paths and the edges: lines and arcs as rows of six numbers (see ``curves.curve``).
    work, edge : (k,)
        Index of the tip path and of the edge of each stretch.
    along, place : (k, 2) mm
        Start and end of each stretch along the tip path, and along the edge.
    """
    position, distance = np.empty((3, len(work))), np.empty((3, len(work)))
    for k in range(len(work)):
        path, own = work[k], edge[k]
        for sample in range(3):
            share = 0.5 * sample
            s = along[k, 0] * (1.0 - share) + along[k, 1] * share
            if curve[path, 0] == 0.0:
                x, y = curve[path, 3] * s, curve[path, 4] * s
            else:
                angle = curve[path, 4] + curve[path, 0] * s / curve[path, 3]
                x, y = curve[path, 3] * math.cos(angle), curve[path, 3] * math.sin(angle)
            x, y = curve[path, 1] + x - edges[own, 1], curve[path, 2] + y - edges[own, 2]
            if edges[own, 0] == 0.0:
                distance[sample, k] = edges[own, 3] * y - edges[own, 4] * x
            else:
                distance[sample, k] = edges[own, 0] * (edges[own, 3] - math.hypot(x, y))
            position[sample, k] = place[k, 0] * (1.0 - share) + place[k, 1] * share
    return position, distance


@kernel(allocates=False)
def record_greatest(rows: I32_1, measure: F64_1, greatest: OutF64_1) -> None:
    """Increase the entries ``rows``, (k,), of the column ``greatest`` to ``measure``, (k,), where
    ``measure`` is greater.
    """
    for k in range(len(rows)):
        if measure[k] > greatest[rows[k]]:
            greatest[rows[k]] = measure[k]
