"""contour_leads: refuse lead-ins for edges that no cutter and no laser cuts."""

from __future__ import annotations

import numpy as np

from knifetip.errors import PlanError
from knifetip.model.chosen_work import ChosenWork
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.job_options import ContourLead
from knifetip.model.machine import Machine


def check_contour_leads(work: ChosenWork, dieline: Dieline, machine: Machine) -> None:
    """Raise ``PlanError`` if a lead-in is chosen for edges that no cutter and no laser cuts.

    Parameters
    ----------
    work
        What is chosen for the edges.
    dieline
        The edges with their line types.
    """
    if ContourLead not in work:
        return
    rows = np.flatnonzero(work[ContourLead].chosen)
    others = rows[dieline.line_type[rows] != LineType.CUT]
    for edge in others[:1]:
        word = LineType(dieline.line_type[edge]).word
        raise PlanError("lead-choice.other-type", edge=edge, type=word, at_edges=others)
    if len(rows) and not machine.offset_cuts:
        raise PlanError("lead-choice.no-cutter", edge=rows[0], machine=machine.title, at_edges=rows)
