"""The line types of cuts for which a user has chosen a depth."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from knifetip.model.chosen_work import ChosenWork
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.job_options import CutDepth


def with_depths(dieline: Dieline, work: ChosenWork, caliper: float) -> Dieline:
    """Return a dieline whose cuts of a chosen depth are cuts or half-cuts according to the depth.

    Parameters
    ----------
    work
        What is chosen for the edges.
    caliper
        Thickness of the board (mm); a cut at least as deep is a cut through the board.
    """
    if CutDepth not in work:
        return dieline
    depth = work[CutDepth].numbers("depth", np.nan)
    given = np.isfinite(depth)
    given &= np.isin(dieline.line_type, (LineType.CUT, LineType.HALF_CUT))
    made = np.where(depth >= caliper, LineType.CUT, LineType.HALF_CUT)
    return replace(dieline, line_type=np.where(given, made, dieline.line_type).astype(np.uint8))
