"""Note a crease wheel whose rim is narrow for the thickness of the board.

A narrow rim that is pressed deep into thick board cuts the upper liner instead of bending it.  The
rims of creasing rules follow the thickness T of the board: 0.7 mm (2 pt) up to about 2 mm, 1.05 mm
(3 pt) for B-flute of 3 mm, 1.4 mm (4 pt) for C-flute of 4 mm.  This is common practice, not a
standard; it amounts to a third of T.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.tool import CreaseWheel
from knifetip.model.verdict import Severity
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.tools import OperationKind

#: Greatest thickness of a board, in widths of the rim.
_MOST_RIMS: Final = 3.0


def check_rims(context: CheckContext, work: TipPaths) -> None:
    """Add one note if a wheel that presses the board has a rim narrower than a third of its
    thickness.

    The note is about the narrowest of the wheels that make the tip paths ``work``.
    """
    stations = np.unique(work.station[work.operation == OperationKind.CREASE])
    tools = [context.machine.stations[int(station)].tool for station in stations]
    rims = [tool.width for tool in tools if isinstance(tool, CreaseWheel)]
    rim, caliper = min(rims, default=np.inf), context.board.caliper
    if caliper <= _MOST_RIMS * rim + context.tolerance:
        return
    least = math.ceil(10.0 * caliper / _MOST_RIMS) / 10.0
    message = Message("verify.narrow-rim", width=rim, caliper=caliper, least=least)
    context.findings.add("planned", message, rim, severity=Severity.NOTE)
