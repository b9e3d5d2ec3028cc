"""Kernels that compare the stretches of tip paths with the edges that they follow."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from knifetip.kernels import F64_1, F64_2, I32_1, Bool_1, OutF64_1, kernel
from knifetip.verification.curves.curve import heading_on
from knifetip.verification.curves.intervals import SHORT
from knifetip.verification.expectation.edges import angle_of_two


class FollowedStretches(NamedTuple):
    """k stretches of tip paths, and the stretches of the edges that they follow."""

    work: I32_1  #: (k,) index of the tip path
    along: F64_2  #: (k, 2) mm, start and end along the tip path
    edge: I32_1  #: (k,) index of the edge
    place: F64_2  #: (k, 2) mm, start and end along the edge


@kernel
def sample_stretches(curve: F64_2, edges: F64_2, stretches: FollowedStretches) -> Any:
    """Return the positions on the edges and the distances to their left of three points of each of
    k stretches: start, middle and end; (3, k) mm each.

    Parameters
    ----------
    curve, edges : (n, 6) and (m, 6)
        The tip paths and the edges: lines and arcs as rows of six numbers (see ``curves.curve``).
    """
    work, along, edge, place = stretches
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


@kernel
def heading_errors(
    curve: F64_2,
    heading: F64_2,
    edges: F64_2,
    stretches: FollowedStretches,
    chorded: Bool_1,
    presses: bool,
    turn: float,
) -> Any:
    """Return the greatest difference between the heading of the tool and the direction of the edge
    at the ends of k stretches, (k,) degrees; 0 for a stretch that does not follow its edge.

    Parameters
    ----------
    heading : (n, 2) degrees
        Headings of the tool at the start and the end of each tip path.
    chorded : (m,)
        Mask of the edges that the tool follows in chords; the heading is compared with the chord.
    presses
        Whether a tip path of length 0 follows its edge.
    turn : degrees
        Rotation after which the tool has the same shape again.
    curve, edges
        See ``sample_stretches``.
    """
    work, along, edge, place = stretches
    worst = np.zeros(len(work))
    for k in range(len(work)):
        path, own = work[k], edge[k]
        length = curve[path, 5]
        is_point = length < 1e-6
        span, size = place[k, 1] - place[k, 0], along[k, 1] - along[k, 0]
        # A short path has no exact direction: its ends are rounded to the last digit.
        follows = size > SHORT and abs(span) > 0.5 * size
        if not (follows or (presses and is_point)):
            continue
        for side in range(2):
            fraction = along[k, side] / (1.0 if is_point else length)
            first, last = heading[path, 0], heading[path, 1]
            if chorded[own]:
                drawn = math.degrees(heading_on(curve, path, along[k, side]))
            else:
                drawn = math.degrees(heading_on(edges, own, place[k, side]))
                drawn += 180.0 if span < 0.0 else 0.0
            error = angle_of_two(first + (last - first) * fraction, drawn, turn)
            worst[k] = max(worst[k], error)
    return worst


@kernel(allocates=False)
def record_greatest(rows: I32_1, measure: F64_1, greatest: OutF64_1) -> None:
    """Increase the entries ``rows``, (k,), of the column ``greatest`` to ``measure``, (k,), where
    ``measure`` is greater.
    """
    for k in range(len(rows)):
        if measure[k] > greatest[rows[k]]:
            greatest[rows[k]] = measure[k]
