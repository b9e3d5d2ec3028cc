"""Note a crease wheel whose rim is narrow or wide for the thickness of the board.

A narrow rim that is pressed deep into thick board cuts the upper liner instead of bending it.  The
rims of creasing rules follow the thickness T of the board: 0.7 mm (2 pt) up to about 2 mm, 1.05 mm
(3 pt) for B-flute of 3 mm, 1.4 mm (4 pt) for C-flute of 4 mm.  This is common practice, not a
standard; it amounts to a third of T.

A wide rim makes a wide bead in thin board, and the fold has no definite line.  Shreiner, a maker of
creasing matrices, states rules of 2 pt for board of 0.008 to 0.020 in (0.2 to 0.5 mm), and of 3 or
4 pt for thicker board ("What score rule heights should I use").  Above about 1.2 mm (3 pt rules of
1.05 mm) wider rims are in use, on greyboard as on corrugated board.
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
#: Widest rims (mm) for boards up to some thicknesses (mm), ascending: 2 pt and 4 pt, rounded up.
_WIDEST: Final = ((0.51, 0.75), (1.2, 1.5))


def check_rims(context: CheckContext, work: TipPaths) -> None:
    """Add one note if a wheel that presses the board has a rim narrower than a third of its
    thickness, and one if a rim is wider than the rules for this thickness.

    The notes are about the narrowest and the widest of the wheels that make the tip paths ``work``.
    """
    stations = np.unique(work.station[work.operation == OperationKind.CREASE])
    tools = [context.machine.stations[int(station)].tool for station in stations]
    rims = [tool.width for tool in tools if isinstance(tool, CreaseWheel)]
    if not rims:
        return
    caliper = context.board.caliper
    rim = min(rims)
    if caliper > _MOST_RIMS * rim + context.tolerance:
        least = math.ceil(10.0 * caliper / _MOST_RIMS) / 10.0
        message = Message("verify.narrow-rim", width=rim, caliper=caliper, least=least)
        context.findings.add("planned", message, rim, severity=Severity.NOTE)
    rim = max(rims)
    most = next((wide for thick, wide in _WIDEST if caliper <= thick), math.inf)
    if rim > most:
        message = Message("verify.wide-rim", width=rim, caliper=caliper, most=most)
        context.findings.add("planned", message, rim, severity=Severity.NOTE)
