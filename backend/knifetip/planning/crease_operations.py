"""crease_operations: plan the operations that roll the creases of a dieline."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry import arc
from knifetip.geometry.azimuth import azimuth, unit_vectors
from knifetip.geometry.chain import chain
from knifetip.geometry.columns import F64, I32, U8, Bool
from knifetip.geometry.path import Paths
from knifetip.geometry.spatial_index.box_pairs import box_pairs
from knifetip.geometry.tolerance import ANGLE, GAP, POINT
from knifetip.model.board import Board
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.job_options import CreaseDepth
from knifetip.model.operation import End, Operation
from knifetip.planning.crease_wheels import choose_wheels, crease_stations, with_chosen_wheels
from knifetip.planning.dashes import merge_dashes
from knifetip.planning.double_creases import double_creases
from knifetip.planning.path_ends import close_joints, end_directions, end_points
from knifetip.planning.setup import Setup
from knifetip.planning.split_at_cuts import split_at_cuts

#: Greatest difference between the depth of a curved crease and the depth of the board's rule (mm).
_DEPTH_ERROR: Final = 0.004


def plan_creases(dieline: Dieline, rows: I32, setup: Setup) -> list[Operation]:
    """Return the operations that roll the creases of a dieline, one for each wheel that is used.

    The depth depends on the angle φ between the direction of a crease and the grain of the board:
    d = d∥ + (d⊥ - d∥) sin² φ, with the board's depths d∥ along and d⊥ across the grain.  The
    direction of an arc is its tangent, so the depth changes along it.  An arc is therefore split
    into pieces of constant depth, which differs from d by at most ``_DEPTH_ERROR``.  A depth that
    the user has chosen for an edge replaces d.

    Parameters
    ----------
    rows : (m,)
        Indices of the creases in the dieline.
    setup
        Machine, board and station of the crease wheel for straight creases, and the chosen depths.

    Raises
    ------
    PlanError
        Different depths or wheels were chosen for creases that continue each other.
    """
    board = setup.board
    paths, source, ends = _crease_paths(dieline, rows)
    _check_chosen(paths, source, setup)
    if board.double_crease > 0.0:
        paths, path, segment = double_creases(paths, board.double_crease, source)
        source, ends = source[segment], (ends[0][path], ends[1][path])
    ahead, last = arc.tangents(paths.start, paths.end, paths.bulge)
    tangents = np.stack([ahead[paths.first[:-1]], last[paths.first[1:] - 1]], axis=1)
    end_depth = _depth_along(tangents.reshape(-1, 2), board).reshape(-1, 2)
    end_depth = _with_chosen(end_depth, source[paths.first[:-1]], setup)
    paths, segment = _split_by_depth(paths, board)
    source = source[segment]
    # The tangent in the middle of an arc is parallel to its chord.
    depth = _with_chosen(_depth_along(paths.end - paths.start, board), source, setup)
    _check_depths(depth, source, setup)
    stations = crease_stations(setup.machine, setup.station)
    wheel = choose_wheels(paths, source, depth, stations, board)
    wheel = with_chosen_wheels(wheel, setup.chosen_stations(source[paths.first[:-1]]), stations)
    operations = []
    for index in np.unique(wheel):
        operation = replace(setup, station=stations[index]).operation(
            LineType.CREASE, paths, source, depth[:, None], ends
        )
        operation = replace(operation, end_depth=end_depth)
        if wheel.any():
            operation = operation.with_paths(np.flatnonzero(wheel == index).astype(np.int32))
        operations.append(operation)
    return operations


def _check_depths(depth: F64, source: I32, setup: Setup) -> None:
    """Raise ``PlanError`` if creases are deeper than the board and the yield of the creasing base.

    ``depth``, ``source`` (n,): depth of each segment (mm), and its edge in the dieline.
    """
    board, machine = setup.board, setup.machine
    give = machine.base_yield if machine.creasing_base == "soft" else 0.0
    deep = np.flatnonzero(depth > board.caliper + give + POINT)
    if len(deep):
        edges = np.unique(source[deep])
        raise PlanError(
            "crease.below-base",
            count=len(edges),
            depth=float(depth[deep].max()),
            most=board.caliper + give,
            machine=machine.title,
            at_edges=edges,
        )


def _depth_along(direction: F64, board: Board) -> F64:
    """Return the depths of creases with given directions, (n,) mm.

    ``direction`` are n vectors of any length along the creases, (n, 2).
    """
    sine = np.sin(np.radians(azimuth(direction) - board.grain))
    result: F64 = board.crease_along + (board.crease_across - board.crease_along) * sine**2
    return result


def _chosen_depths(source: I32, setup: Setup) -> F64:
    """Return the depths that the user has chosen for n edges, (n,) mm; NaN for those without."""
    if CreaseDepth not in setup.chosen:
        return np.full(len(source), np.nan)
    return setup.chosen[CreaseDepth].numbers("depth", np.nan)[source]


def _with_chosen(depth: F64, source: I32, setup: Setup) -> F64:
    """Return depths of n creases, (n,) or (n, 2) mm: those that a user chose, else the given ones.

    ``source`` are the indices in the dieline of the edges of the creases, (n,).
    """
    chosen = _chosen_depths(source, setup)
    if depth.ndim == 2:
        chosen = chosen[:, None]
    result: F64 = np.where(np.isfinite(chosen), chosen, depth)
    return result


def _check_chosen(paths: Paths, source: I32, setup: Setup) -> None:
    """Raise ``PlanError`` if what was chosen for the segments of a path differs.

    The wheel rolls along a path without a lift, so the board would be pressed between two depths,
    and one wheel makes the whole path.
    """
    # A depth of 0 stands for the depth of the board.
    depth = np.nan_to_num(_chosen_depths(source, setup))
    changes = (np.diff(depth) != 0.0) | (np.diff(setup.chosen_stations(source)) != 0)
    differs = np.flatnonzero(changes & (np.diff(paths.path_of) == 0))
    for row in differs[:1]:
        pair = source[row : row + 2]
        raise PlanError("edge-choice.joined", edge=pair[0], other=pair[1], at_edges=pair)


def _split_by_depth(paths: Paths, board: Board) -> tuple[Paths, I32]:
    """Split the arcs of creases into equal pieces along which the depth hardly changes.

    From sin² a - sin² b = sin(a + b) sin(a - b) it follows that along a piece with sweep θ the
    depth differs from the depth in its middle by at most |d⊥ - d∥| sin(θ/2).  θ is chosen so that
    this is at most ``_DEPTH_ERROR``.

    Returns the paths, and the segment of the given paths from which each new segment comes, (m,).
    """
    change = abs(board.crease_across - board.crease_along)
    if change <= _DEPTH_ERROR:
        return paths, np.arange(len(paths.bulge), dtype=np.int32)
    sweep = 2.0 * np.arcsin(_DEPTH_ERROR / change)
    # An arc of exactly one greatest sweep is one piece, whatever its last digit.
    pieces = np.ceil(np.abs(arc.sweep(paths.bulge)) / sweep - 1e-9).astype(np.int64).clip(1)
    row = np.repeat(np.arange(len(pieces), dtype=np.int32), pieces)
    place = np.arange(len(row)) - np.repeat(np.cumsum(pieces) - pieces, pieces)
    begins, finishes = place == 0, place + 1 == pieces[row]
    whole = begins & finishes
    start, end, bulge = arc.sub_arc(
        paths.start[row],
        paths.end[row],
        paths.bulge[row],
        place / pieces[row],
        (place + 1) / pieces[row],
    )
    return (
        Paths(
            np.where(begins[:, None], paths.start[row], start),
            np.where(finishes[:, None], paths.end[row], end),
            np.where(whole, paths.bulge[row], bulge),
            np.append(0, np.cumsum(pieces))[paths.first],
        ),
        row,
    )


def _crease_paths(dieline: Dieline, rows: I32) -> tuple[Paths, I32, tuple[U8, U8]]:
    """Return the paths of creases, the index in the dieline of the edge of each segment, and the
    kinds of the path ends.

    Dashes are merged, coincident creases become one, and creases are split where cuts cross them.
    The kinds are two arrays of ``End``, (p,) each: of the starts and of the finishes of p paths.
    ``rows`` are the indices of the creases in the dieline.
    """
    cut = dieline.line_type == LineType.CUT
    cut_ends, cut_bulge = dieline.ends[cut], dieline.bulge[cut]
    plain = dieline.line_type[rows] == LineType.CREASE
    ends, bulge, row = merge_dashes(
        dieline.ends[rows[plain]], dieline.bulge[rows[plain]], (cut_ends, cut_bulge)
    )
    # A combi line is perforated too, so its dashes stay as they are drawn.
    row = np.concatenate([rows[plain][row], rows[~plain]])
    order = np.argsort(row, kind="stable")
    ends = np.concatenate([ends, dieline.ends[rows[~plain]]])[order]
    bulge = np.concatenate([bulge, dieline.bulge[rows[~plain]]])[order]
    chains = chain(ends, bulge, ANGLE)
    paths, source = close_joints(chains.paths(ends, bulge)), row[order][chains.order]
    start, finish = np.split(np.where(_continued_ends(paths), End.CONTINUED, End.FREE), 2)
    path_of = paths.path_of
    paths, segment, crossed = split_at_cuts(paths, cut_ends, cut_bulge, chains.closed)
    old_path = path_of[segment[paths.first[:-1]]]
    kinds = np.where(crossed, End.FREE, np.stack([start, finish], axis=1)[old_path])
    kinds = kinds.astype(np.uint8)
    return paths, source[segment], (kinds[:, 0], kinds[:, 1])


def _continued_ends(paths: Paths) -> Bool:
    """Return the mask of the ends of p paths at which a crease continues straight, (2p,).

    The starts of all paths come first, then the finishes.  A crease continues at an end if a
    segment passes or begins less than ``GAP`` from the end, has the direction of the end there, and
    leads on by more than ``GAP``.
    """
    (points, segment), outward = end_points(paths), -end_directions(paths)
    result = np.zeros(len(points), np.bool_)
    boxes = arc.bounding_boxes(paths.start, paths.end, paths.bulge)
    end, row = box_pairs(arc.point_boxes(points), boxes, GAP)
    # A segment does not continue itself, unless it is a closed curve.
    others = (row != segment[end]) | (paths.bulge[row] != 0.0)
    end, row = end[others], row[others]
    if len(end) == 0:
        return result
    segments = paths.start[row], paths.end[row], paths.bulge[row]
    fraction = arc.nearest_fraction(*segments, points[end])
    cosine = (unit_vectors(arc.tangent_at(*segments, fraction)) * outward[end]).sum(axis=1)
    ahead = np.where(cosine > 0.0, 1.0 - fraction, fraction) * arc.length(*segments)
    straight = np.abs(cosine) >= np.cos(np.radians(ANGLE)) - 1e-12
    # Drawings contain distances of exactly ``GAP``, which must not depend on rounding.
    near = np.hypot(*(arc.point_at(*segments, fraction) - points[end]).T) < GAP - POINT
    result[end[straight & near & (ahead > GAP + POINT)]] = True
    return result
