"""contour_leads: refuse lead-ins for edges that no cutter and no laser cuts."""

from __future__ import annotations

from knifetip.errors import PlanError
from knifetip.model.chosen_work import ChosenWork
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.job_options import ContourLead
from knifetip.model.machine import Machine
from knifetip.planning.chosen_rows import chosen_rows


def check_contour_leads(work: ChosenWork, dieline: Dieline, machine: Machine) -> None:
    """Raise ``PlanError`` if a lead-in is chosen for edges that no cutter and no laser cuts.

    Parameters
    ----------
    work
        What is chosen for the edges.
    dieline
        The edges with their line types.
    """
    cuts = (LineType.CUT,)
    rows = chosen_rows(work, ContourLead, dieline, cuts, "lead-choice.other-type")
    if len(rows) and not machine.offset_cuts:
        raise PlanError("lead-choice.no-cutter", edge=rows[0], machine=machine.title, at_edges=rows)
