"""groove_operations: plan the operation that cuts the V-grooves of a dieline."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from knifetip.geometry.azimuth import left_normal, unit_vectors
from knifetip.geometry.chain import chain, continues_straight
from knifetip.geometry.columns import F64, I32
from knifetip.geometry.path import Paths
from knifetip.geometry.points_on_segments import find_points_on_segments
from knifetip.geometry.tolerance import COLLINEAR, GAP
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.operation import End, Operation
from knifetip.model.tool import VCutter
from knifetip.planning.arc_to_chords import arcs_to_chords
from knifetip.planning.boundary import BoardOutline, run_out_lengths
from knifetip.planning.flank_check import check_flanks, clearing_shifts, damaging_paths
from knifetip.planning.path_ends import end_directions, end_points
from knifetip.planning.setup import Setup
from knifetip.planning.sheet_outline import sheet_run_outs


def plan_grooves(
    outline: BoardOutline,
    sheet: BoardOutline | None,
    dieline: Dieline,
    rows: I32,
    setup: Setup,
) -> Operation:
    """Return the operation that cuts the V-grooves of a dieline.

    Parameters
    ----------
    outline
        Outline of the board, beyond which grooves run out.
    sheet
        Outline of a sheet that was cut to size: the blade leaves the sheet entirely at grooves that
        end on its edge.  None if the sheet is larger than the drawing by an unknown width.
    rows : (m,)
        Indices of the V-grooves in the dieline.
    setup
        Machine, board and station of the V-cutter.

    Raises
    ------
    FlankOutside
        A flank of a groove would leave the board or run through a cut.
    CurvedGroove
        An arc is too tight for the blade, or the board permits no chords.
    """
    board, cutter = setup.board, setup.station.tool
    assert isinstance(cutter, VCutter)
    ends, bulge, rows, joint = arcs_to_chords(
        dieline.ends[rows], dieline.bulge[rows], rows, cutter, board.groove_curve
    )
    chains = chain(ends, bulge, COLLINEAR)
    paths, source = chains.paths(ends, bulge), rows[chains.order]
    passes = 1
    if board.groove_pass > 0.0:
        passes = max(1, math.ceil(board.groove_depth / board.groove_pass - 1e-9))
    depth = np.tile(board.groove_depth * np.arange(1, passes + 1) / passes, (len(source), 1))
    reach = board.groove_depth * cutter.slope
    (points, segment), inward = end_points(paths), end_directions(paths)
    own = source[segment]
    run_out, on_edge = run_out_lengths(points, -inward, 2.0 * reach, outline, own)
    run_out = run_out.reshape(2, -1).T
    shifted = _shifted_from_cuts(paths, reach, run_out, dieline, board.groove_shift)
    if shifted is not None:
        shifted_points, _ = end_points(shifted)
        new_run_out, still = run_out_lengths(shifted_points, -inward, 2.0 * reach, outline, own)
        # A groove that would no longer end on the board's edge is refused as it is drawn.
        if (still == on_edge).all():
            paths, points, run_out = shifted, shifted_points, new_run_out.reshape(2, -1).T
    check_flanks(paths, source, reach, run_out, dieline, board.groove_shift)
    # At a joint of two chords the blade overruns into the groove that it has cut itself.
    joined = (
        continues_straight(points, inward, joint + COLLINEAR)
        if joint
        else np.zeros(len(own), np.bool_)
    )
    kinds = np.where(on_edge, End.MEETS, np.where(joined, End.CONTINUED, End.FREE))
    start, finish = np.split(kinds.astype(np.uint8), 2)
    if sheet is not None:
        blade = (cutter.half_width, reach)
        leaving = sheet_run_outs(points, -inward, blade, setup.machine.clearance, sheet)
        run_out = np.maximum(run_out, np.where(on_edge, leaving, 0.0).reshape(2, -1).T)
    operation = setup.operation(LineType.V_GROOVE, paths, source, depth, (start, finish))
    return replace(operation, run_out=run_out)


def _shifted_from_cuts(
    paths: Paths, reach: float, run_out: F64, dieline: Dieline, limit: float
) -> Paths | None:
    """Return grooves shifted away from cuts beside them; None if no groove is shifted.

    A groove is not shifted if another groove continues it, if a flank would pass through a cut
    after the shift too, or if one of its ends would lose or gain the contact with a cut.

    ``paths``: the p grooves.
    ``reach`` mm: distance of the flanks from a groove's line on the top face.
    ``run_out`` (p, 2) mm: run-out of each groove beyond its start and its end.
    ``limit`` mm: greatest shift of a groove.
    """
    shift = clearing_shifts(paths, reach, run_out, dieline, limit)
    if not shift.any():
        return None
    (points, _), inward = end_points(paths), end_directions(paths)
    continued = continues_straight(points, inward, COLLINEAR).reshape(2, -1).any(axis=0)
    shift[continued] = 0.0
    cuts = dieline.line_type == LineType.CUT
    lines = dieline.ends[cuts, 0], dieline.ends[cuts, 1], dieline.bulge[cuts]
    no_owner = np.full(len(points), -1, np.int32)
    contact = find_points_on_segments(points, no_owner, *lines, GAP)
    result = _shift_paths(paths, shift)
    after = find_points_on_segments(end_points(result)[0], no_owner, *lines, GAP)
    shift[(contact != after).reshape(2, -1).any(axis=0)] = 0.0
    result = _shift_paths(paths, shift)
    # What needs a further shift cannot be shifted.
    shift[damaging_paths(result, reach, run_out, dieline)] = 0.0
    return _shift_paths(paths, shift) if shift.any() else None


def _shift_paths(paths: Paths, shift: F64) -> Paths:
    """Return straight paths, shifted to their left by ``shift``, (p,) mm."""
    by_segment = shift[paths.path_of]
    left = left_normal(unit_vectors(paths.end - paths.start)) * by_segment[:, None]
    return replace(paths, start=paths.start + left, end=paths.end + left)
