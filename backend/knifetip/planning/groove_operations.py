"""groove_operations: plan the operation that cuts the V-grooves of a dieline."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from knifetip.geometry.chain import chain, continues_straight
from knifetip.geometry.columns import I32
from knifetip.geometry.tolerance import COLLINEAR
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.operation import End, Operation
from knifetip.model.tool import VCutter
from knifetip.planning.arc_to_chords import arcs_to_chords
from knifetip.planning.boundary import BoardOutline, run_out_lengths
from knifetip.planning.flank_check import check_flanks
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
        An arc is too tight for the blade.
    """
    board, cutter = setup.board, setup.station.tool
    assert isinstance(cutter, VCutter)
    ends, bulge, joint = dieline.ends[rows], dieline.bulge[rows], 0.0
    if board.groove_curve > 0.0:
        ends, bulge, rows, joint = arcs_to_chords(ends, bulge, rows, cutter, board.groove_curve)
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
    check_flanks(paths, source, reach, run_out, dieline)
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
