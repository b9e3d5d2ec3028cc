"""The drawn edges in sheet coordinates, and functions that find which of their ends meet."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Final, TypeVar, cast

import numpy as np

from knifetip.errors import GeometryError
from knifetip.kernels import F64_1, inline_kernel, kernel
from knifetip.model.dieline import Dieline, LineType
from knifetip.verification.columns import F64, I32, I64
from knifetip.verification.curves.curve import arc_curves, azimuth_at, line_curves, point_at
from knifetip.verification.curves.curve_grid import CurveGrid, list_curves
from knifetip.verification.curves.intervals import Overlaps
from knifetip.verification.curves.near_points import (
    PointGrid,
    list_points,
    near_points,
    pair_distances,
)
from knifetip.verification.curves.overlap import find_overlaps, search_overlaps

Result = TypeVar("Result")

#: Ends within this distance are one point (mm).
JOIN_DISTANCE: Final = 0.002


#: Ends within this distance touch (mm).
TOUCH_DISTANCE: Final = 0.05


#: Distances that drawings contain, such as 0.05 mm, may differ by this from rounding (mm).
LIMIT_SLACK: Final = 1e-6


#: Searches up to this distance share one grid of the edges (mm).
_GRID_LIMIT: Final = TOUCH_DISTANCE + LIMIT_SLACK


#: Greatest turn of edges that continue straight (degrees).
STRAIGHT_ANGLE: Final = 1.0


#: Greatest number of compared pairs in the search for near points.
MAX_PAIRS: Final = 20_000_000


#: An edge with a smaller bulge is a straight line.
_BULGE: Final = 1e-9


@dataclass(frozen=True, eq=False, slots=True)
class Edges:
    """n edges (lines and arcs) in sheet coordinates, with their line types, ends and directions."""

    row: I32  #: (n,) row in Dieline
    curve: F64  #: (n, 6) rows as in ``curves.curve``
    line_type: I32  #: (n,) ``LineType``
    ends: F64  #: (2n, 2) mm, start and end of each edge in turn
    outward: F64  #: (2n,) degrees, direction out of the edge at each end
    chord: F64  #: (n,) degrees, direction from start to end
    #: results of ``compute_once``; the arrays of a record never change
    _memory: dict[str, Any] = field(init=False, repr=False, default_factory=dict)

    def __len__(self) -> int:
        return len(self.row)

    def with_types(self, *types: LineType) -> Edges:
        """Return the edges that have one of the line types ``types`` (positional arguments)."""
        present = self.compute_once("types", lambda: set(np.unique(self.line_type).tolist()))
        wanted = sorted(present.intersection(types))
        return self.compute_once(
            f"edges of types {wanted}",
            lambda: self.select(np.flatnonzero(np.isin(self.line_type, wanted))),
        )

    def near_ends(self, distance: float) -> tuple[I64, I64]:
        """Return the k pairs of ends at most ``distance`` mm apart, (k,) each.

        End 2i is the start of edge i, and end 2i + 1 is its end.  Each end also forms a pair with
        itself.
        """
        if distance < TOUCH_DISTANCE:
            return self.compute_once(f"ends within {distance}", lambda: self._nearer_ends(distance))
        if distance == TOUCH_DISTANCE:
            return self.compute_once("touching ends", lambda: self.ends_touched_by(self.ends))
        return self.compute_once(
            f"ends within {distance}", lambda: pairs_within(self.ends, self.ends, distance)
        )

    def ends_touched_by(self, points: F64) -> tuple[I64, I64]:
        """Return the k pairs of a point and an end at most ``TOUCH_DISTANCE`` apart, (k,) each.

        ``points`` are n points, (n, 2) mm.  End 2i is the start of edge i, and end 2i + 1 is its
        end.
        """
        if len(self) == 0 or len(points) == 0:
            return np.zeros(0, np.int64), np.zeros(0, np.int64)
        grid = self.compute_once(
            "grid of ends", lambda: list_points(np.ascontiguousarray(self.ends), TOUCH_DISTANCE)
        )
        return _search_points(points, grid)

    def _nearer_ends(self, distance: float) -> tuple[I64, I64]:
        """Return those pairs of ends within ``TOUCH_DISTANCE`` that are at most ``distance`` mm
        apart.
        """
        one, other = self.near_ends(TOUCH_DISTANCE)
        near = pair_distances(self.ends, one, self.ends, other) <= distance
        return (one, other) if near.all() else (one[near], other[near])

    def find_overlaps(
        self, curves: F64, limit: float, part: tuple[F64, F64] | None = None
    ) -> Overlaps:
        """Return the stretches of k curves that lie within ``limit`` mm of the edges.

        Parameters
        ----------
        curves : (k, 6)
            Lines and arcs as rows of six numbers (see ``curves.curve``).  A curve of length 0 is a
            point; it may lie up to ``limit`` past the ends of an edge.
        limit : mm
            Greatest distance of a stretch from the edge.
        part : (n,) and (n,) mm
            Start and end of the part of each edge that is compared; no part if the end is less than
            the start.  None for the whole edges.
        """
        if len(self) == 0:
            return Overlaps.none()
        low, high = (np.zeros(len(self)), self.curve[:, 5]) if part is None else part
        if limit > _GRID_LIMIT:
            return find_overlaps(curves, self.curve, low, high, limit)
        is_whole = part is None or (np.array_equal(high, self.curve[:, 5]) and not low.any())
        name = f"overlaps within {limit} of {len(curves)} curves"
        if is_whole and name in self._memory:
            # The checks search for the same tip paths and the same ends more than once.
            known, earlier = self._memory[name]
            if np.array_equal(known, curves):
                return cast(Overlaps, earlier)
        result = search_overlaps(curves, self.grid(), low, high, limit)
        if is_whole:
            self._memory[name] = (curves, result)
        return result

    def grid(self) -> CurveGrid:
        """Return a spatial index of the n ≥ 1 edges; it is built once, for all checks."""
        return self.compute_once("grid", lambda: list_curves(self.curve, _GRID_LIMIT))

    def touched_by_points(self, points: F64, limit: float) -> Overlaps:
        """Return the points, (n, 2) mm, that lie within ``limit`` mm of the edges, as overlaps of
        curves of length 0.
        """
        return self.find_overlaps(line_curves(points, points), limit)

    def touched_ends(self, distance: float) -> tuple[I32, I32, F64]:
        """Return the k pairs of an end and an edge at most ``distance`` mm apart, and the position
        on the edge that is nearest to the end (mm), (k,) each.

        The distance is at most ``TOUCH_DISTANCE``.  End 2i is the start of edge i, and end 2i + 1
        is its end; each end also forms a pair with its own edge.
        """
        return self.compute_once(
            f"ends within {distance} of edges", lambda: self._find_touched_ends(distance)
        )

    def _find_touched_ends(self, distance: float) -> tuple[I32, I32, F64]:
        """Return the result of ``touched_ends``."""
        touches = self.touched_by_points(self.ends, TOUCH_DISTANCE)
        end, edge, place = touches.curve, touches.edge, touches.place[:, 0].copy()
        foot = point_at(self.curve[edge], place)
        pair = np.arange(len(end))
        near = pair_distances(foot, pair, self.ends, end.astype(np.int64)) <= distance
        return (end, edge, place) if near.all() else (end[near], edge[near], place[near])

    def compute_once(self, name: str, compute: Callable[[], Result]) -> Result:
        """Return the result of ``compute``, which is called only once for each ``name``.

        Several checks need the same results about the same edges.  Callers must not change them.
        """
        if name not in self._memory:
            self._memory[name] = compute()
        result: Result = self._memory[name]
        return result

    def select(self, rows: I64) -> Edges:
        """Return the edges with the indices ``rows``, in that order."""
        if len(rows) == len(self) and np.array_equal(rows, np.arange(len(rows))):
            return self
        twice = np.stack([2 * rows, 2 * rows + 1], axis=1).ravel()
        return Edges(
            self.row[rows],
            self.curve[rows],
            self.line_type[rows],
            self.ends[twice],
            self.outward[twice],
            self.chord[rows],
        )


def place_edges(dieline: Dieline, placement: tuple[float, float]) -> Edges:
    """Return the edges of a dieline in sheet coordinates; edges of zero length are left out.

    Raises
    ------
    GeometryError
        A coordinate of the placement or of an edge is not finite.
    """
    bad = ~(np.isfinite(dieline.ends).all(axis=(1, 2)) & np.isfinite(dieline.bulge))
    if bad.any() or not np.isfinite(placement).all():
        subject = f"Edge {int(np.argmax(bad))}" if bad.any() else "The placement"
        raise GeometryError("input.not-finite", what=subject)
    start = dieline.ends[:, 0] + placement
    end = dieline.ends[:, 1] + placement
    row = np.flatnonzero(np.hypot(*(end - start).T) > 0.0).astype(np.int32)
    start, end, bulge = start[row], end[row], dieline.bulge[row]
    curve = line_curves(start, end)
    bent = np.abs(bulge) >= _BULGE
    chord = end[bent] - start[bent]
    b = bulge[bent]
    # The centre lies (1 - b²) / 4b chords to the left of the chord's middle.
    left = np.stack([-chord[:, 1], chord[:, 0]], axis=1)
    centre = (start[bent] + end[bent]) / 2.0 + left * ((1.0 - b * b) / (4.0 * b))[:, None]
    curve[bent] = arc_curves(centre, start[bent], 4.0 * np.arctan(b))
    at_start = azimuth_at(curve, np.zeros(len(row)))
    at_end = azimuth_at(curve, curve[:, 5])
    return Edges(
        row=row,
        curve=curve,
        line_type=dieline.line_type[row].astype(np.int32),
        ends=np.stack([start, end], axis=1).reshape(-1, 2),
        outward=np.stack([at_start + 180.0, at_end], axis=1).ravel(),
        chord=np.degrees(np.arctan2(*(end - start).T[::-1])),
    )


def edges_from_curves(curve: F64) -> Edges:
    """Return n curves as edges with the rows 0 … n - 1 and no line type.

    ``curve`` contains lines and arcs as rows of six numbers (see ``curves.curve``), (n, 6).
    """
    zero = np.zeros(len(curve))
    ends = np.stack([point_at(curve, zero), point_at(curve, curve[:, 5])], axis=1)
    outward = np.stack([azimuth_at(curve, zero) + 180.0, azimuth_at(curve, curve[:, 5])], axis=1)
    row = np.arange(len(curve), dtype=np.int32)
    unclassified = np.full(len(curve), LineType.UNCLASSIFIED, np.int32)
    return Edges(row, curve, unclassified, ends.reshape(-1, 2), outward.ravel(), zero)


def without_duplicates(edges: Edges) -> tuple[Edges, I32, I32]:
    """Return the edges that do not coincide with an earlier edge of the same line type.

    Returns
    -------
    Three values: the remaining edges; the row in the dieline of each of k duplicates, (k,); and the
    row in the dieline of the remaining edge with which each duplicate coincides, (k,).
    """
    return edges.compute_once("without duplicates", lambda: _separate_duplicates(edges))


def _separate_duplicates(edges: Edges) -> tuple[Edges, I32, I32]:
    """Return the result of ``without_duplicates``."""
    a, b = edges.near_ends(JOIN_DISTANCE)
    same = (a % 2 == 0) & (a // 2 > b // 2)
    # An end of the second edge lies at the first edge's start; its other end must lie at the end.
    first, other = a[same] // 2, b[same]
    middle = [point_at(edges.curve[row], 0.5 * edges.curve[row, 5]) for row in (first, other // 2)]
    twins = (
        (pair_distances(edges.ends, 2 * first + 1, edges.ends, other ^ 1) <= JOIN_DISTANCE)
        & (np.hypot(*(middle[0] - middle[1]).T) <= JOIN_DISTANCE)
        & (edges.line_type[first] == edges.line_type[other // 2])
    )
    stays = np.arange(len(edges))
    np.minimum.at(stays, first[twins], other[twins] // 2)
    # The remaining edge may itself duplicate an earlier one.
    while (stays[stays] != stays).any():
        stays = stays[stays]
    twin = np.flatnonzero(stays != np.arange(len(edges)))
    left = edges.select(np.flatnonzero(stays == np.arange(len(edges))))
    return left, edges.row[twin], edges.row[stays[twin]]


def pairs_within(points: F64, others: F64, distance: float) -> tuple[I64, I64]:
    """Return the k pairs of a point of ``points`` and a point of ``others`` that are near each
    other.

    Parameters
    ----------
    points, others : (n, 2) and (m, 2) mm
        The points of which pairs are formed.
    distance : mm
        Greatest distance between the two points of a pair.

    Returns
    -------
    Two arrays, (k,) each: indices into ``points``, and indices into ``others``.

    Raises
    ------
    GeometryError
        More than ``MAX_PAIRS`` pairs would be compared.
    """
    if len(points) == 0 or len(others) == 0:
        return np.zeros(0, np.int64), np.zeros(0, np.int64)
    return _search_points(points, list_points(np.ascontiguousarray(others), distance))


def _search_points(points: F64, grid: PointGrid) -> tuple[I64, I64]:
    """Return the k pairs of one of at least one points, (n, 2) mm, and a point of a grid near it,
    (k,) each; see ``pairs_within``.
    """
    a, b, complete = near_points(np.ascontiguousarray(points), PointGrid(*grid), MAX_PAIRS)
    if not complete:
        raise GeometryError("edge.too-crowded", limit=MAX_PAIRS, distance=grid.distance)
    return a, b


def angle_between(direction_a: F64, direction_b: F64, turn: float = 360.0) -> F64:
    """Return the smaller angle between two directions, in degrees, from 0 to half of ``turn``.

    ``direction_a`` and ``direction_b`` are arrays of directions (degrees), (n,), that are compared
    element by element.  Directions that differ by a multiple of ``turn`` (degrees) are equal.
    """
    result: F64 = _angles_between(
        np.ascontiguousarray(direction_a), np.ascontiguousarray(direction_b), turn
    )
    return result


@kernel
def _angles_between(direction_a: F64_1, direction_b: F64_1, turn: float) -> Any:
    """Return the result of ``angle_between``."""
    angle = np.empty(len(direction_a))
    for row in range(len(direction_a)):
        angle[row] = angle_of_two(direction_a[row], direction_b[row], turn)
    return angle


@inline_kernel
def angle_of_two(direction_a: float, direction_b: float, turn: float) -> float:
    """Return the smaller angle between two directions (degrees); see ``angle_between``."""
    half = turn / 2.0
    beyond = direction_a - direction_b + half
    if not 0.0 <= beyond < turn:
        beyond = beyond % turn
    return abs(beyond - half)
