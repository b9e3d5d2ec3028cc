"""chosen_starts: let closed cuts begin where the user has chosen, and run in the chosen direction.

A knife begins exactly at the chosen point: the segment is divided there, and the path must begin
with the second part.  A cutter enters beside the contour, so the segment gets a short piece whose
middle is the chosen point.  A cutter and a knife with leads have the waste on their left: their
direction is fixed, and another one is refused.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, I64
from knifetip.geometry.path import Paths, reverse_paths
from knifetip.geometry.tolerance import JOIN
from knifetip.model.cleaned import Cleaned
from knifetip.model.corners import AS_OTHERS
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.edge_choice import choices_by_edge
from knifetip.model.job_options import ContourStart
from knifetip.model.operation import End, Operation
from knifetip.model.tool import DiscTool

#: A cutter enters at least this far from both ends of an edge, and at least its radius (mm).
_LEAST_ROOM: Final = 1.0
#: Part of the distance from the chosen point to the nearer end of its edge that half of the piece
#: takes in whose middle a cutter enters.
_PIECE: Final = 0.5


@dataclass(frozen=True, eq=False, slots=True)
class ChosenStart:
    """A user's choice for the closed cut with one edge, in sheet coordinates."""

    edge: int  #: row of an edge of the cleaned dieline, for messages
    rows: I32  #: rows of the cleaned dieline that make the chosen edge
    point: F64  #: (2,) mm, chosen start; a point of the edge if only the direction is chosen
    begins: bool  #: the cut must begin at ``point``
    direction: F64  #: (2,) direction at ``point`` in which the cut must run; zeros for any


def place_starts(
    starts: Sequence[ContourStart], drawn: Dieline, cleaned: Cleaned, offset: tuple[float, float]
) -> list[ChosenStart]:
    """Return the user's choices of starts and directions, in sheet coordinates.

    Parameters
    ----------
    drawn, cleaned
        The edges of the drawing, to whose rows the choices refer, and the cleaned edges.
    offset : mm
        Shift (x, y) that moves the drawing to its position on the machine's table.

    Raises
    ------
    PlanError
        The drawing has no such edge, or the edge is not made.
    """
    result = []
    for row, start in choices_by_edge(starts, drawn.line_type):
        if start.at is None and start.direction == "free":
            continue
        rows = cleaned.stretches.makers(row)
        if len(rows) == 0:
            raise PlanError("start.open", edge=row, at_edges=[row])
        line = drawn.ends[row : row + 1, 0], drawn.ends[row : row + 1, 1], drawn.bulge[[row]]
        place = np.array([0.5 if start.at is None else start.at])
        sign = {"forward": 1.0, "reverse": -1.0, "free": 0.0}[start.direction]
        result.append(
            ChosenStart(
                int(rows[0]),
                rows,
                arc.point_at(*line, place)[0] + offset,
                start.at is not None,
                sign * arc.tangent_at(*line, place)[0],
            )
        )
    return result


def apply_starts(
    operations: list[Operation], starts: Sequence[ChosenStart], *, together: bool = False
) -> list[Operation]:
    """Return all operations, with closed paths that begin and run as the user has chosen.

    Paths whose direction is chosen become an operation of their own, since sequencing may not
    reverse them.

    Parameters
    ----------
    together
        The paths of an operation stay together, because the user has chosen their order; then none
        of them is reversed.

    Raises
    ------
    PlanError
        A chosen edge is in no closed cut, or the choice contradicts another one or a rule of the
        tool.
    """
    found: set[int] = set()
    result: list[Operation] = []
    for operation in operations:
        if operation.line_type not in (LineType.CUT, LineType.HALF_CUT):
            result.append(operation)
            continue
        own = [
            (number, start)
            for number, start in enumerate(starts)
            if np.isin(operation.source, start.rows).any()
        ]
        found.update(number for number, _ in own)
        chosen = [start for _, start in own]
        result += _with_starts(operation, chosen, together) if own else [operation]
    for number, start in enumerate(starts):
        if number not in found:
            raise PlanError("start.open", edge=start.edge, at_edges=[start.edge])
    return result


def _with_starts(
    operation: Operation, starts: Sequence[ChosenStart], together: bool
) -> list[Operation]:
    """Return an operation whose closed paths begin and run as chosen; see ``apply_starts``."""
    reverse: dict[int, tuple[bool, int]] = {}
    for start in starts:
        segment = _segment_of(operation, start)
        path = int(operation.paths.path_of[segment])
        _check_closed(operation, path, start)
        if not start.direction.any():
            continue
        against = bool(_tangent(operation.paths, segment, start.point) @ start.direction < 0.0)
        if against and operation.side != 0:
            raise PlanError(
                "start.fixed-direction",
                edge=start.edge,
                station=operation.station,
                at_edges=[start.edge],
            )
        before = reverse.setdefault(path, (against, start.edge))
        if before[0] != against:
            raise _conflict(start.edge, before[1])
    operation = _reverse_closed_paths(
        operation, [path for path, (against, _) in reverse.items() if against]
    )
    at_path: dict[int, int] = {}
    for start in starts:
        if start.begins:
            segment = _segment_of(operation, start)
            path = int(operation.paths.path_of[segment])
            if path in at_path:
                raise _conflict(start.edge, at_path[path])
            at_path[path] = start.edge
            operation = _begin_at(operation, segment, path, start)
    if not reverse or operation.side != 0:
        return [operation]
    if together:
        return [replace(operation, one_way=True)]
    one_way = np.isin(np.arange(len(operation.paths)), list(reverse))
    return [
        replace(operation.with_paths(np.flatnonzero(mask).astype(np.int32)), one_way=fixed)
        for mask, fixed in ((~one_way, False), (one_way, True))
        if mask.any()
    ]


def _conflict(edge: int, other: int) -> PlanError:
    """Return the error that two edges of one contour have different choices."""
    return PlanError("start.conflict", edge=edge, other=other, at_edges=[edge, other])


def _check_closed(operation: Operation, path: int, start: ChosenStart) -> None:
    """Raise ``PlanError`` if a path has no single start, because it is open or has bridges."""
    bridged = len(operation.bridges) > 0 and np.isin(
        path, operation.paths.path_of[operation.bridges[:, 0].astype(np.int64)]
    )
    if bridged or operation.finish[path] == End.BRIDGE:
        raise PlanError("start.bridged", edge=start.edge, at_edges=[start.edge])
    if operation.finish[path] != End.CLOSED:
        raise PlanError("start.open", edge=start.edge, at_edges=[start.edge])


def _segment_of(operation: Operation, start: ChosenStart) -> int:
    """Return the segment of an operation that makes the chosen edge nearest to the chosen point."""
    paths = operation.paths
    rows: I64 = np.flatnonzero(np.isin(operation.source, start.rows))
    lines = paths.start[rows], paths.end[rows], paths.bulge[rows]
    points = np.broadcast_to(start.point, (len(rows), 2))
    nearest = arc.point_at(*lines, arc.nearest_fraction(*lines, points))
    return int(rows[np.hypot(*(nearest - points).T).argmin()])


def _line(paths: Paths, segment: int) -> tuple[F64, F64, F64]:
    """Return one segment of some paths as columns of one row."""
    return paths.start[[segment]], paths.end[[segment]], paths.bulge[[segment]]


def _tangent(paths: Paths, segment: int, point: F64) -> F64:
    """Return the direction of a segment where it is nearest to a point, (2,)."""
    line = _line(paths, segment)
    result: F64 = arc.tangent_at(*line, arc.nearest_fraction(*line, point[None]))[0]
    return result


def _reverse_closed_paths(operation: Operation, paths: Sequence[int]) -> Operation:
    """Return an operation without a side, some of whose closed paths are reversed."""
    if not paths:
        return operation
    mask = np.isin(np.arange(len(operation.paths)), paths)
    turned, order = reverse_paths(operation.paths, mask)
    return replace(
        operation,
        paths=turned,
        depth=operation.depth[order],
        source=operation.source[order],
        endable=operation.endable[order],
    )


def _begin_at(operation: Operation, segment: int, path: int, start: ChosenStart) -> Operation:
    """Return an operation in which a closed path must begin at the chosen point of a segment.

    ``path`` is the number of the path.
    """
    paths, tool = operation.paths, operation.tool
    line = _line(paths, segment)
    place = float(arc.nearest_fraction(*line, start.point[None])[0])
    size = float(arc.length(*line)[0])
    room = min(place, 1.0 - place) * size
    first, last = int(paths.first[path]), int(paths.first[path + 1])
    if isinstance(tool, DiscTool):
        least = max(_LEAST_ROOM, tool.radius)
        if room < least:
            raise PlanError(
                "start.at-corner",
                edge=start.edge,
                distance=room,
                least=least,
                at_edges=[start.edge],
            )
        if not operation.endable[segment]:
            raise PlanError("start.not-last", edge=start.edge, at_edges=[start.edge])
        half = _PIECE * room / size
        return _split_segment(operation, segment, path, (place - half, place + half), 1)
    if room > JOIN:
        return _split_segment(operation, segment, path, (place,), 1)
    following = first + (segment + 1 - first) % (last - first)
    return _begin_with_segment(operation, path, segment if place < 0.5 else following)


def _begin_with_segment(operation: Operation, path: int, segment: int) -> Operation:
    """Return an operation in which a closed path must begin with a segment."""
    fixed = operation.starts.copy()
    fixed[path] = segment
    return replace(operation, fixed=fixed)


def _split_segment(
    operation: Operation, segment: int, path: int, places: tuple[float, ...], piece: int
) -> Operation:
    """Return an operation in which a segment is divided, and its path must begin with one piece.

    ``places``: fractions of the segment at which it is divided, ascending.
    ``piece``: number of the piece with which the path begins, from 0.
    """
    paths = operation.paths
    count = len(places) + 1
    times = np.ones(len(paths.bulge), np.int64)
    times[segment] = count
    rows = np.repeat(np.arange(len(paths.bulge)), times)
    pieces = slice(segment, segment + count)
    bounds = np.array([0.0, *places, 1.0])
    ends, start = paths.end[rows].copy(), paths.start[rows].copy()
    bulge = paths.bulge[rows].copy()
    near, far, bent = arc.sub_arc(
        paths.start[np.full(count, segment)],
        paths.end[np.full(count, segment)],
        paths.bulge[np.full(count, segment)],
        bounds[:-1],
        bounds[1:],
    )
    # The ends of the segment stay equal, bit for bit, and the pieces share their points.
    near[1:] = far[:-1]
    near[0], far[-1] = paths.start[segment], paths.end[segment]
    start[pieces], ends[pieces], bulge[pieces] = near, far, bent
    added = np.where(np.arange(len(paths.first)) > path, count - 1, 0)
    corner, corner_k = operation.corner_at[rows].copy(), operation.k_at[rows].copy()
    # There is no corner between the pieces.
    inner = slice(segment + 1, segment + count)
    corner[inner], corner_k[inner] = AS_OTHERS, np.nan
    bridges, fixed = operation.bridges.copy(), operation.starts.copy()
    bridges[bridges[:, 0] > segment, 0] += count - 1
    fixed[fixed > segment] += count - 1
    fixed[path] = segment + piece
    return replace(
        operation,
        paths=Paths(start, ends, bulge, paths.first + added),
        depth=operation.depth[rows],
        source=operation.source[rows],
        endable=operation.endable[rows],
        corner_at=corner,
        k_at=corner_k,
        bridges=bridges,
        fixed=fixed,
    )
