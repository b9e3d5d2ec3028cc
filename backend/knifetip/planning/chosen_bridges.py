"""chosen_bridges: leave bridges where the user has placed them.

An outline with a bridge of the user has no others.  A bridge lies on one segment: at both ends of
the gap of a cutter the disc cuts one radius farther than its centre travels, so a bridge needs that
much more room on the segment.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, I64
from knifetip.geometry.path import Paths
from knifetip.geometry.tolerance import JOIN
from knifetip.model.cleaned import Cleaned
from knifetip.model.dieline import Dieline
from knifetip.model.job_options import BridgeAt
from knifetip.model.operation import End, Operation

#: Least length of a cut between two bridges (mm).
_LEAST_CUT: Final = 1.0


@dataclass(frozen=True, eq=False, slots=True)
class ChosenBridge:
    """A bridge that the user has placed, in sheet coordinates."""

    edge: int  #: row of an edge of the cleaned dieline, for messages
    rows: I32  #: rows of the cleaned dieline that make the chosen edge
    point: F64  #: (2,) mm, middle of the bridge
    width: float  #: mm


@dataclass(frozen=True, eq=False, slots=True)
class PlacedBridges:
    """k bridges on paths, sorted by path and by position."""

    path: I32  #: (k,)
    along: F64  #: (k,) mm from the start of the path to the middle of the bridge
    width: F64  #: (k,) mm

    def merged_with(self, path: I32, along: F64, width: float) -> PlacedBridges:
        """Return these bridges and others of one width."""
        paths = np.concatenate([self.path, path]).astype(np.int32)
        places = np.concatenate([self.along, along])
        widths = np.concatenate([self.width, np.full(len(path), width)])
        order = np.lexsort((places, paths))
        return PlacedBridges(paths[order], places[order], widths[order])


NO_BRIDGES: Final = PlacedBridges(np.zeros(0, np.int32), np.zeros(0), np.zeros(0))


def locate_bridges(
    bridges: Sequence[BridgeAt], drawn: Dieline, cleaned: Cleaned, offset: tuple[float, float]
) -> list[ChosenBridge]:
    """Return the user's bridges in sheet coordinates.

    Parameters
    ----------
    drawn, cleaned
        The edges of the drawing, to whose rows the bridges refer, and the cleaned edges.
    offset : mm
        Shift (x, y) that moves the drawing to its position on the machine's table.

    Raises
    ------
    PlanError
        The drawing has no such edge, or the edge is not made.
    """
    result = []
    for bridge in bridges:
        for row in bridge.edges:
            if row >= len(drawn):
                raise PlanError("edge-choice.no-edge", row=row, count=len(drawn))
            rows = cleaned.stretches.makers(row)
            if len(rows) == 0:
                raise PlanError("bridge.no-outline", edge=row, at_edges=[row])
            line = drawn.ends[[row], 0], drawn.ends[[row], 1], drawn.bulge[[row]]
            point = arc.point_at(*line, np.array([bridge.at]))[0] + offset
            result.append(ChosenBridge(int(rows[0]), rows, point, bridge.width))
    return result


def bridges_on_paths(
    bridges: Sequence[ChosenBridge],
    paths: Paths,
    source: I32,
    reach: float,
    selected: I64 | None = None,
) -> PlacedBridges:
    """Return the bridges that lie on closed paths.

    Parameters
    ----------
    paths, source
        Paths of n segments, and the row of the cleaned dieline of each segment, (n,).
    reach : mm
        Length by which the tool cuts farther than its path at both ends of a gap.
    selected
        Numbers of the paths that may have bridges; None for all closed ones.

    Raises
    ------
    PlanError
        A bridge is too near to an end of its edge or to another bridge.
    """
    held = np.flatnonzero(paths.closed) if selected is None else selected
    open_rows = np.isin(paths.path_of, held)
    size = arc.length(paths.start, paths.end, paths.bulge)
    begin = np.cumsum(size) - size
    found: list[tuple[int, float, float, int]] = []
    for bridge in bridges:
        rows = np.flatnonzero(np.isin(source, bridge.rows) & open_rows)
        if len(rows) == 0:
            continue
        lines = paths.start[rows], paths.end[rows], paths.bulge[rows]
        points = np.broadcast_to(bridge.point, (len(rows), 2))
        place = arc.nearest_fraction(*lines, points)
        away = np.hypot(*(arc.point_at(*lines, place) - points).T)
        nearest = int(away.argmin())
        segment, at = int(rows[nearest]), float(place[nearest] * size[rows[nearest]])
        room = min(at, float(size[segment]) - at)
        least = bridge.width / 2.0 + reach
        if room < least - JOIN:
            raise PlanError(
                "bridge.at-corner",
                edge=bridge.edge,
                distance=room,
                least=least,
                at_edges=[bridge.edge],
            )
        path = int(paths.path_of[segment])
        along = float(begin[segment] - begin[paths.first[path]]) + at
        found.append((path, along, bridge.width, bridge.edge))
    found.sort()
    _check_apart(found, paths, reach)
    if not found:
        return NO_BRIDGES
    path_of, along_of, width_of, _ = zip(*found, strict=True)
    return PlacedBridges(np.array(path_of, np.int32), np.array(along_of), np.array(width_of))


def _check_apart(found: list[tuple[int, float, float, int]], paths: Paths, reach: float) -> None:
    """Raise ``PlanError`` if two neighbouring bridges leave no cut between them.

    ``found`` are path, position, width and edge of each bridge, sorted.
    """
    for number, (path, along, width, edge) in enumerate(found):
        same = [one for one in found if one[0] == path]
        if len(same) == 1:
            continue
        follows = number + 1 < len(found) and found[number + 1][0] == path
        after = found[number + 1] if follows else same[0]
        distance = after[1] - along + (0.0 if follows else float(paths.lengths[path]))
        least = (width + after[2]) / 2.0 + 2.0 * reach + _LEAST_CUT
        if distance < least - JOIN:
            raise PlanError(
                "bridge.too-near",
                edge=edge,
                other=after[3],
                distance=distance,
                least=least,
                at_edges=[edge, after[3]],
            )


def check_made(bridges: Sequence[ChosenBridge], operations: Sequence[Operation]) -> None:
    """Raise ``PlanError`` if a bridge lies on no outline of a part."""
    for bridge in bridges:
        for operation in operations:
            own = np.isin(operation.source, bridge.rows)
            at_bridges = operation.finish[operation.paths.path_of[own]] == End.BRIDGE
            milled = operation.bridges[:, 0].astype(np.int64)
            if at_bridges.any() or np.isin(operation.source[milled], bridge.rows).any():
                break
        else:
            raise PlanError("bridge.no-outline", edge=bridge.edge, at_edges=[bridge.edge])
