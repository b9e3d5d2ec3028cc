"""crease_operations: plan the operation that rolls the creases of a dieline."""

from __future__ import annotations

import numpy as np

from knifetip.geometry.azimuth import azimuth
from knifetip.geometry.chain import chain, continues_straight
from knifetip.geometry.columns import I32, U8
from knifetip.geometry.path import Paths
from knifetip.geometry.tolerance import ANGLE
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.operation import End, Operation
from knifetip.planning.creases import double_creases, split_at_cuts
from knifetip.planning.dashes import merge_dashes
from knifetip.planning.path_ends import end_directions, end_kinds, end_points
from knifetip.planning.setup import Setup


def plan_creases(dieline: Dieline, rows: I32, setup: Setup) -> Operation:
    """Return the operation that rolls the creases of a dieline.

    The depth depends on the angle φ between a segment's chord and the grain of the board:
    d = d∥ + (d⊥ - d∥) sin² φ, with the board's depths d∥ along and d⊥ across the grain.

    Parameters
    ----------
    rows : (m,)
        Indices of the creases in the dieline.
    setup
        Machine, board and station of the crease wheel.
    """
    board = setup.board
    paths, source, ends = _crease_paths(dieline, rows)
    if board.double_crease > 0.0:
        paths, path, segment = double_creases(paths, board.double_crease, source)
        source, ends = source[segment], (ends[0][path], ends[1][path])
    chord = azimuth(paths.end - paths.start) - board.grain
    depth = board.crease_along + (board.crease_across - board.crease_along) * (
        np.sin(np.radians(chord)) ** 2
    )
    return setup.operation(LineType.CREASE, paths, source, depth[:, None], ends)


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
    paths, source = chains.paths(ends, bulge), row[order][chains.order]
    # Chains end where several edges continue in one direction: such ends are not free.
    continued = continues_straight(end_points(paths)[0], end_directions(paths))
    start, finish = end_kinds(paths, continued, End.CONTINUED)
    path_of = paths.path_of
    paths, segment, split = split_at_cuts(paths, cut_ends, cut_bulge)
    old_path = path_of[segment[paths.first[:-1]]]
    kinds = np.where(split, End.FREE, np.stack([start, finish], axis=1)[old_path]).astype(np.uint8)
    return paths, source[segment], (kinds[:, 0], kinds[:, 1])
