"""Check the swivels of free blades about their tips: the depth, and the mark in the top face.

The leading edge of a blade slants by α, so at the depth t its point in the top face is t tan α
ahead of the tip.  While the blade turns by γ about its tip, this point moves on an arc and leaves
the lines before and after the swivel by up to t tan α sin γ, or t tan α from 90° on.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.tool import Knife
from knifetip.model.verdict import Severity
from knifetip.verification.checks.common.base import StationCheck
from knifetip.verification.curves.curve import line_curves
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.findings import MAX_FINDINGS

#: A smaller turn is no swivel, and by so much rounded coordinates may turn a blade (degrees).
_LEAST_TURN: Final = 1.0


def check_blade_swivels(check: StationCheck, blade: Knife) -> None:
    """Add findings for swivels at edges of a check that are too deep, or whose mark in the top face
    lies farther beside the edge than the board permits.
    """
    swivels, board = check.context.swivels, check.context.board
    slant = math.tan(math.radians(blade.blade_angle))
    depth = board.caliper - swivels.z
    mark = depth * slant * np.sin(np.radians(np.minimum(swivels.turn, 90.0)))
    limit = blade.swivel_depth + check.context.depth_tolerance
    deep = (
        (blade.swivel_depth > 0.0) & (depth > limit) & (swivels.turn > blade.swivel + _LEAST_TURN)
    )
    rows = np.flatnonzero((swivels.turn > _LEAST_TURN) & (deep | (mark > board.cut_tolerance)))
    if len(rows) == 0:
        return
    points = line_curves(swivels.tip[rows], swivels.tip[rows])
    reach = check.tolerance + float(swivels.drift[rows].max())
    nothing = np.zeros(len(check.edges))
    near = find_overlaps(points, check.edges.curve, nothing, check.size, reach)
    touched, first = np.unique(near.curve, return_index=True)
    for k, at in list(zip(touched.tolist(), first.tolist(), strict=True))[:MAX_FINDINGS]:
        row, edge = int(rows[k]), int(near.edge[at])
        line = int(swivels.line[row])
        if deep[row]:
            message = Message(
                "verify.deep-swivel", depth=float(depth[row]), planned=blade.swivel_depth
            )
            check.add_finding("depth", edge, message, float(depth[row]), line=line)
            continue
        message = Message(
            "verify.swivel-mark",
            turn=float(swivels.turn[row]),
            mark=float(mark[row]),
            tolerance=board.cut_tolerance,
        )
        severity = Severity.SHORTFALL
        check.add_finding("beside", edge, message, float(mark[row]), line=line, severity=severity)
