"""Check creases against the base on which the wheels press.

A rigid base, whose surface is Z 0, damages a wheel that is pressed below it, and the wheel damages
the base.  A soft mat yields by a known depth.  The depths of a board are found by trials on one
kind of base; on the other kind the same depth gives another crease.
"""

from __future__ import annotations

import numpy as np

from knifetip.messages import Message
from knifetip.model.verdict import Severity
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.tools import OperationKind


def check_creasing_base(context: CheckContext, work: TipPaths) -> None:
    """Add a fault for each path of a wheel ``work`` that is deeper than the creasing base yields,
    and one note if the depths of the board are given for another base.
    """
    rolled = work.operation == OperationKind.CREASE
    if not rolled.any():
        return
    machine, board = context.machine, context.board
    floor = -machine.base_yield if machine.creasing_base == "soft" else 0.0
    for row in np.flatnonzero(rolled & (work.z < floor - context.depth_tolerance))[:MAX_FINDINGS]:
        excess = floor - float(work.z[row])
        message = Message(
            "verify.wheel-below-base", depth=-float(work.z[row]), most=-floor, excess=excess
        )
        context.findings.add("depth", message, excess, line=int(work.line[row]))
    if board.crease_base in ("", machine.creasing_base):
        return
    code = "verify.base-not-soft" if board.crease_base == "soft" else "verify.base-not-rigid"
    deepest = board.caliper - float(work.z[rolled].min())
    message = Message(code, board=board.title, depth=deepest)
    context.findings.add("planned", message, deepest, severity=Severity.NOTE)
