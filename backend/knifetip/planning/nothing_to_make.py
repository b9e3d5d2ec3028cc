"""nothing_to_make: refuse drawings without an edge that a tool could make."""

from __future__ import annotations

from collections import Counter
from typing import Final

import numpy as np

from knifetip.errors import PlanError
from knifetip.messages import Message
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing, ImportOutcome

#: Greatest number of reasons that the refusal of a drawing without edges states.
_SHOWN: Final = 3


def check_has_work(drawing: Drawing, dieline: Dieline) -> None:
    """Raise an error if a drawing has no edges, or if all its edges are ignored.

    Raises
    ------
    PlanError
        There is nothing to make, whatever the machine.
    """
    if len(dieline) == 0:
        dropped = np.flatnonzero(drawing.import_report.outcome == ImportOutcome.DROPPED)
        if len(dropped) == 0:
            raise PlanError("drawing.empty")
        reasons = [drawing.import_report.reason[row] for row in dropped.tolist()]
        # The first reason of each code is an example of the others.
        example = {reason.code: reason for reason in reversed(reasons)}
        commonest = Counter(reason.code for reason in reasons).most_common(_SHOWN)
        raise PlanError(
            "drawing.no-lines",
            count=len(dropped),
            reasons=[
                Message("drawing.no-lines-reason", count=count, reason=example[code])
                for code, count in commonest
            ],
        )
    if (dieline.line_type == LineType.IGNORED).all():
        raise PlanError("drawing.all-ignored", count=len(dieline))
