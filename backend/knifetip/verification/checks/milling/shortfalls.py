"""Report where a router bit or a laser cannot make the cuts as they are drawn.

A stretch of an edge is unreached if the cutter's disc cannot touch it without cutting into a part.
Every round cutter leaves some board in a concave corner, so a stretch in a corner is a note.  It is
a shortfall if it is farther from the cut than three radii of the disc, which is so in corners of
less than 29°.  A stretch that is farther from the cut than the radius of the disc is a shortfall in
two more cases: in a gap between two parts, where it is longer than the side of a corner that is as
far from the cut; and at the bottom of a slot, where the whole edge is unreached, and so are the
edges at both its ends.
Contours of which the disc touches nothing are shortfalls, too, wherever they lie.

A slit is an open cut, which does not separate a part from waste.  The centre of the disc follows
it, so the slit becomes as wide as the disc.  A wide slit is a shortfall, and slits as narrow as a
beam are a note.  Cuts that two parts share are slits in this sense.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.verdict import Severity
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.checks.milling import geometry as milling_geometry
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.curve import line_curves, point_at
from knifetip.verification.curves.intervals import uncovered_edges
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.edges import (
    JOIN_DISTANCE,
    TOUCH_DISTANCE,
    Edges,
    pairs_within,
)
from knifetip.verification.expectation.outline import CutOutlines
from knifetip.verification.findings import MAX_FINDINGS

#: Widest slit that counts as a line without width (mm); the kerf of a laser is narrower.
MAX_LINE_WIDTH: Final = 0.5
#: Greatest distance of a corner from the cut, in radii of the disc: that of a corner of 29°, so
#: that corners of 30° are no shortfalls.
_FARTHEST_CORNER: Final = 3.0
#: Greatest length of an unreached side of a corner, in lengths that follow from the distance of the
#: corner from the disc.
_LONGEST_SIDE: Final = 1.1
#: Positions in each unreached stretch at which its distance from the disc is measured.
_FRACTIONS: Final = (0.0, 0.25, 0.5, 0.75, 1.0)
#: Greatest distance from the disc that is measured (mm).
_FARTHEST: Final = 1e5


def report_unreached(
    context: CheckContext,
    bounds: CutOutlines,
    stretches: tuple[I64, F64, F64],
    centres: F64,
    reach: F64,
) -> None:
    """Add a note or a shortfall for each edge with stretches that the disc cannot touch, and record
    the greatest distance of the edge from the disc.

    Parameters
    ----------
    context
        Inputs and results of the verification; findings and figures are added to it.
    bounds
        Cuts that the cutter must make, with the contours that they form.
    stretches
        Three arrays, (k,) each: index of the edge of each unreached stretch, and the start and the
        end of the stretch along that edge (mm).
    centres : (n, 6)
        Paths of the disc's centre through the board: lines and arcs as rows of six numbers (see
        ``curves.curve``).
    reach : (2,) mm
        Half-axes of the disc along X and Y.
    """
    edges = bounds.edges
    edge, begin, end = stretches
    long = end - begin > JOIN_DISTANCE
    edge, begin, end = edge[long], begin[long], end[long]
    if len(edge) == 0 or len(centres) == 0 or reach.min() <= 0.0:
        return
    whole = np.zeros(len(edges), np.bool_)
    whole[edge[end - begin >= edges.curve[edge, 5] - 2.0 * JOIN_DISTANCE]] = True
    is_left_out = _contours_within(bounds, whole)
    length = np.bincount(edge, end - begin, minlength=len(edges))
    places = np.bincount(edge, minlength=len(edges))
    worst = np.zeros(len(edges))
    curve = edges.curve[edge]
    points = [point_at(curve, begin + fraction * (end - begin)) for fraction in _FRACTIONS]
    distance = distance_from_disc(np.concatenate(points), centres, reach)
    farthest = distance.reshape(len(_FRACTIONS), -1).max(axis=0)
    np.maximum.at(worst, edge, farthest)
    np.maximum.at(context.figures.unreached_distance, edges.row, worst)
    radius = float(reach.max())
    is_short = worst > _FARTHEST_CORNER * radius
    # The disc touches the sides of a corner that is the distance d away at the length
    # √((r + d)² - r²) from it.
    side = np.sqrt((radius + farthest) ** 2 - radius**2)
    is_short[edge[(farthest > radius) & (end - begin > _LONGEST_SIDE * side)]] = True
    is_short |= (worst > radius) & whole & _have_neighbours(edges, edge, begin, end)
    for k in np.flatnonzero(is_left_out | (worst > context.tolerance))[:MAX_FINDINGS]:
        message = Message("verify.unreached", length=length[k], places=places[k], distance=worst[k])
        if is_left_out[k]:
            message = Message("verify.contour-unreached", length=length[k], width=2.0 * radius)
        context.findings.add(
            "unreached",
            message,
            float(length[k]),
            edge=int(edges.row[k]),
            severity=Severity.SHORTFALL if is_short[k] or is_left_out[k] else Severity.NOTE,
        )


def _contours_within(bounds: CutOutlines, selected: Bool) -> Bool:
    """Return the mask of the edges on contours of which all edges are selected, (n,).

    ``selected`` (n,) is the mask of selected edges.
    """
    rows = np.flatnonzero(bounds.closing)
    has_other = np.zeros(len(selected), np.bool_)
    has_other[bounds.component[rows[~selected[rows]]]] = True
    result: Bool = bounds.closing & ~has_other[bounds.component]
    return result


def _have_neighbours(edges: Edges, edge: I64, begin: F64, end: F64) -> Bool:
    """Return the mask of the n edges both of whose ends are unreached and touch an unreached end of
    another edge, (n,).

    ``edges``: the n edges.
    ``edge``, ``begin``, ``end`` (k,) each: index of the edge of each unreached stretch, and its
    start and its end along the edge (mm).
    """
    size = edges.curve[edge, 5]
    is_left = np.zeros((len(edges), 2), np.bool_)
    is_left[edge[begin <= JOIN_DISTANCE], 0] = True
    is_left[edge[end >= size - JOIN_DISTANCE], 1] = True
    left = np.flatnonzero(is_left.ravel())
    points = edges.ends.reshape(-1, 2)[left]
    one, other = pairs_within(points, points, TOUCH_DISTANCE)
    has_neighbour = np.zeros(2 * len(edges), np.bool_)
    has_neighbour[left[one[left[one] // 2 != left[other] // 2]]] = True
    both_ends = has_neighbour.reshape(-1, 2)
    result: Bool = both_ends[:, 0] & both_ends[:, 1]
    return result


def report_wide_slits(
    context: CheckContext, edges: Edges, slits: I64, centres: F64, width: float
) -> None:
    """Report the slits that the cutter mills as wide as itself, and record their milled length.

    Each wide slit is a shortfall.  Slits as narrow as a beam share one note.

    Parameters
    ----------
    context
        Inputs and results of the verification; findings and figures are added to it.
    edges
        Cuts that the cutter must make.
    slits
        Indices of the slits, which are the open cuts.
    centres : (n, 6)
        Paths of the disc's centre that follow slits: lines and arcs as rows of six numbers (see
        ``curves.curve``).
    width : mm
        Diameter of the disc.
    """
    if len(slits) == 0:
        return
    curve = edges.curve[slits]
    size = curve[:, 5]
    overlaps = find_overlaps(centres, curve, np.zeros(len(curve)), size, context.tolerance)
    low, high = overlaps.place_range()
    left, begin, end = uncovered_edges(overlaps.edge.astype(np.int64), low, high, size)
    length = size - np.bincount(left, end - begin, minlength=len(slits))
    row = edges.row[slits]
    if width <= MAX_LINE_WIDTH:
        longest = int(length.argmax())
        if length[longest] > context.tolerance:
            count, total = int(np.count_nonzero(length > context.tolerance)), float(length.sum())
            message = Message("verify.narrow-slits", count=count, length=total, width=width)
            context.findings.add(
                "kerf", message, total, edge=int(row[longest]), severity=Severity.NOTE
            )
        return
    np.add.at(context.figures.slit_length, row, length)
    for k in np.flatnonzero(length > context.tolerance)[:MAX_FINDINGS]:
        context.findings.add(
            "kerf",
            Message("verify.wide-slit", length=length[k], width=width),
            float(length[k]),
            edge=int(row[k]),
            severity=Severity.SHORTFALL,
        )


def distance_from_disc(points: F64, centres: F64, reach: F64) -> F64:
    """Return the distance of each of n points from the area that the disc sweeps, (n,) mm.

    The distance is 0 inside the swept area, and at most ``_FARTHEST``.

    Parameters
    ----------
    points : (n, 2) mm
        The points.
    centres : (m, 6)
        Paths of the disc's centre, at least one.
    reach : (2,) mm
        Half-axes of the disc along X and Y.
    """
    result = np.full(len(points), _FARTHEST)
    start, size = np.zeros(len(centres)), centres[:, 5]
    limit = 2.0 * float(reach.max())
    remaining = np.arange(len(points))
    while len(remaining) and limit < _FARTHEST:
        # Points without a path within the limit are searched again with a larger limit.
        own = points[remaining]
        near = find_overlaps(line_curves(own, own), centres, start, size, limit)
        path, point = centres[near.edge], own[near.curve]
        foot = milling_geometry.nearest_along(path, point, reach)
        ratio = np.full(len(path), np.inf)
        for position in (np.zeros(len(path)), foot, path[:, 5]):
            apart = (point_at(path, position) - point) / reach
            ratio = np.minimum(ratio, np.hypot(*apart.T))
        np.minimum.at(result, remaining[near.curve], (ratio - 1.0) * float(reach.min()))
        remaining = remaining[result[remaining] >= _FARTHEST]
        limit *= 2.0
    distance: F64 = np.maximum(result, 0.0)
    return distance
