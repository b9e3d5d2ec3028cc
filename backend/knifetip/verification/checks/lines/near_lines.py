"""Find lines that lie side by side so near to each other that the board between them does not hold.

Rays start at points along each line, to both sides and at right angles to it.  Where a ray meets
another line that runs in nearly the same direction, the two lie side by side there, as far apart as
the ray is long.  All such places of two chains of edges are one finding, at the place where they
are nearest:

* **Drawn twice**: a chain has another one of the same line type beside it for most of its length,
  nearer than the board is thick.  A person must decide, so this is a shortfall.
* **Narrow**: any other pair of lines nearer than the limit of their line types is a note: a strip
  or a slot narrower than the board is thick, creases that become one band, a crease that tears off
  at a cut.

Two V-grooves are compared by their flanks instead (``groove_flanks``).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.dieline import LineType
from knifetip.model.machine import Machine
from knifetip.model.verdict import Severity
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.checks.lines.edges_beside import edges_beside
from knifetip.verification.checks.lines.groove_flanks import groove_width
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.curve import azimuth_at, line_curves, point_at
from knifetip.verification.expectation.edge_paths import edge_paths, link_ends
from knifetip.verification.expectation.edges import (
    JOIN_DISTANCE,
    Edges,
    angle_between,
    without_duplicates,
)

#: Greatest difference in direction of lines that lie side by side (degrees).
_ALONGSIDE: Final = 15.0
#: Two lines lie side by side for at least so many times their mean distance.
_LONG: Final = 12.0
#: Greatest number of findings.
_MOST_FINDINGS: Final = 50
#: Distance of the points at which rays start, in calipers, and the least one (mm).
_PITCH: Final = 0.5
_LEAST_PITCH: Final = 0.5
#: Most points; on longer drawings they are farther apart.
_MOST_POINTS: Final = 20_000
#: Part of its length that a chain which is drawn twice has beside the other one.
_MOST: Final = 0.8
#: Distance at which a ray meets a line (mm).
_TOUCH: Final = 1e-4

_CUTS: Final = (LineType.CUT,)
_MARKS: Final = (LineType.CREASE, LineType.HALF_CUT)
_KINDS: Final = (*_CUTS, *_MARKS, LineType.V_GROOVE)


@dataclass(frozen=True, eq=False, slots=True)
class _Sides:
    """k places at which a line has another one beside it."""

    edge: I64  #: (k,) the edge at which the ray starts
    other: I64  #: (k,) the edge that the ray meets
    place: F64  #: (k,) mm along ``edge``
    distance: F64  #: (k,) mm between the two
    share: float  #: mm of ``edge`` that each place stands for


def check_near_lines(context: CheckContext) -> None:
    """Add a shortfall or a note for each two chains of edges that lie too near to each other."""
    drawn = context.edges.with_types(*_KINDS)
    limits = _limits(context.board, context.machine)
    reach = float(limits.max())
    if len(drawn) < 2 or reach <= 0.0:
        return
    # A ray that ends in the other line is compared with only a part of it.
    compared = np.where(limits > reach - 2.0 * _TOUCH, limits + 2.0 * _TOUCH, limits)
    selected = edges_beside(drawn, compared, _TOUCH, _ALONGSIDE)
    if not selected.any():
        return
    edges, _, _ = without_duplicates(drawn)
    beside = np.isin(edges.row, drawn.row[selected])
    sides = _sides(edges, beside, reach, context.board.caliper)
    near = sides.distance < limits[edges.line_type[sides.edge], edges.line_type[sides.other]]
    rows = np.flatnonzero(near)
    if not len(rows):
        return
    chain, sizes = _chains(edges)
    first, second = chain[sides.edge[rows]], chain[sides.other[rows]]
    pairs, index = np.unique(np.column_stack([first, second]), axis=0, return_inverse=True)
    index = index.ravel()
    count = np.bincount(index, minlength=len(pairs))
    mean = np.bincount(index, sides.distance[rows], minlength=len(pairs)) / np.maximum(count, 1)
    # Both sides of one chain see each other.
    length = sides.share * count / np.where(pairs[:, 0] == pairs[:, 1], 2.0, 1.0)
    long = length >= np.maximum(_LONG * mean, context.board.caliper)
    seen: set[tuple[int, int]] = set()
    for number in np.argsort(-length, kind="stable"):
        a, b = (int(one) for one in pairs[number])
        if not long[number] or (b, a) in seen:
            continue
        seen.add((a, b))
        own = rows[index == number]
        nearest = int(own[np.argmin(sides.distance[own])])
        _report(context, edges, sides, nearest, float(length[number]), sizes[[a, b]], a != b)
        if len(seen) == _MOST_FINDINGS:
            return


def _chains(edges: Edges) -> tuple[I64, F64]:
    """Return the number of the chain of each of n edges, (n,), and the length of each chain, (c,)
    mm.

    A chain consists of edges of one line type that follow each other end to end.
    """
    chain, sizes = np.zeros(len(edges), np.int64), [np.zeros(0)]
    for kind in _KINDS:
        rows = np.flatnonzero(edges.line_type == kind)
        some = edges.select(rows)
        paths = edge_paths(some, link_ends(some, 180.0)[0])
        chain[rows] = paths.path + sum(map(len, sizes))
        sizes.append(paths.length)
    return chain, np.concatenate(sizes)


def _report(
    context: CheckContext,
    edges: Edges,
    sides: _Sides,
    at: int,
    length: float,
    sizes: F64,
    are_two: bool,
) -> None:
    """Add the finding for two chains of edges that lie side by side for ``length`` mm.

    They are nearest at the place ``at``.  ``sizes`` (2,) are the lengths of the chains (mm), and
    ``are_two`` is whether they are two chains, and not two sides of one.
    """
    edge, other = int(sides.edge[at]), int(sides.other[at])
    kind, kind_of_other = LineType(edges.line_type[edge]), LineType(edges.line_type[other])
    distance, caliper = float(sides.distance[at]), context.board.caliper
    values = {"distance": distance, "length": length}
    severity = Severity.SHORTFALL
    if kind == kind_of_other and are_two and length >= _MOST * float(sizes.min()):
        message = Message("verify.drawn-twice", type=kind.word, **values)
    else:
        severity = Severity.NOTE
        if kind == kind_of_other == LineType.CUT:
            message = Message("verify.narrow-cuts", caliper=caliper, **values)
        else:
            types = {"type": kind.word, "other": kind_of_other.word}
            message = Message("verify.narrow-lines", caliper=caliper, **types, **values)
    row = int(edges.row[max(edge, other)])
    context.findings.add("near", message, distance, edge=row, severity=severity)


def _limits(board: Board, machine: Machine) -> F64:
    """Return the least distance of lines side by side for each pair of line types, (t, t) mm."""
    limits = np.zeros((len(LineType) + 1, len(LineType) + 1))
    for kind in (*_CUTS, *_MARKS):
        limits[kind, kind] = board.caliper
    for mark in _MARKS:
        limits[LineType.CUT, mark] = limits[mark, LineType.CUT] = 0.5 * board.caliper
    width = groove_width(board, machine)
    for mark in _MARKS:
        limits[LineType.V_GROOVE, mark] = limits[mark, LineType.V_GROOVE] = 0.5 * width
    return limits


def _sides(edges: Edges, beside: Bool, reach: float, caliper: float) -> _Sides:
    """Return the places at which edges have another edge within ``reach`` mm beside them.

    ``beside``: mask of the edges of which places are searched, (n,).
    """
    size = edges.curve[:, 5]
    pitch = max(_PITCH * caliper, _LEAST_PITCH, float(size.sum()) / _MOST_POINTS)
    # Along the whole sequence of edges, so that many short edges have few points.
    reached = np.cumsum(size)
    wanted = np.arange(0.5 * pitch, reached[-1], pitch)
    row = np.minimum(np.searchsorted(reached, wanted), len(size) - 1).astype(np.int64)
    searched = beside[row]
    wanted, row = wanted[searched], row[searched]
    place = np.clip(wanted - (reached - size)[row], 0.0, size[row])
    curve = edges.curve[row]
    points, heading = point_at(curve, place), azimuth_at(curve, place)
    normal = np.radians(heading + 90.0)
    # A ray that ended on a line would meet it before its end only.
    away = (reach + 2.0 * _TOUCH) * np.column_stack([np.cos(normal), np.sin(normal)])
    rays = np.concatenate([line_curves(points, points + away), line_curves(points, points - away)])
    met = edges.find_overlaps(rays, _TOUCH)
    distance = 0.5 * (met.along[:, 0] + met.along[:, 1])
    # Lines that coincide are one line; each ray meets the edge at which it starts.
    apart = np.flatnonzero(distance > JOIN_DISTANCE)
    distance, other = distance[apart], met.edge[apart].astype(np.int64)
    point = met.curve[apart].astype(np.int64) % len(row)
    edge = row[point]
    along = np.clip(met.place[apart].mean(axis=1), 0.0, size[other])
    turn = angle_between(azimuth_at(edges.curve[other], along), heading[point], 180.0)
    kept = np.flatnonzero(turn <= _ALONGSIDE)
    pair = edges.line_type[[edge[kept], other[kept]]]
    kept = kept[~(pair == LineType.V_GROOVE).all(axis=0)]
    kept = kept[~_adjacent(edges, edge[kept], other[kept])]
    # Only the nearest line beside a point counts, once for both sides.
    order = kept[np.lexsort((distance[kept], point[kept]))]
    first = np.ones(len(order), np.bool_)
    first[1:] = point[order[1:]] != point[order[:-1]]
    order = order[first]
    return _Sides(edge[order], other[order], place[point[order]], distance[order], pitch)


def _adjacent(edges: Edges, edge_a: I64, edge_b: I64) -> Bool:
    """Return the mask of the k pairs of edges with a common end, (k,)."""
    ends = edges.ends.reshape(-1, 2, 2)
    gap = ends[edge_a][:, :, None] - ends[edge_b][:, None, :]
    result: Bool = np.hypot(gap[..., 0], gap[..., 1]).min(axis=(1, 2)) <= _TOUCH
    return result
