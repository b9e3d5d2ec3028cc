"""cutter_choices: refuse choices that only cutters and lasers can make."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from knifetip.errors import PlanError
from knifetip.model.chosen_work import ChosenWork
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.edge_choice import LineTypeChoice
from knifetip.model.job_options import ContourLead, EdgeCorner
from knifetip.model.machine import Machine
from knifetip.planning.chosen_rows import chosen_rows

#: The choices that only cutters and lasers can make, for cuts.  Each has two codes of errors: for
#: an edge of another line type, and for a machine without such a tool.
_CHOICES: Final[Mapping[type[LineTypeChoice], tuple[str, str]]] = {
    EdgeCorner: ("corner-choice.other-type", "corner-choice.no-cutter"),
    ContourLead: ("lead-choice.other-type", "lead-choice.no-cutter"),
}


def check_cutter_choices(work: ChosenWork, dieline: Dieline, machine: Machine) -> None:
    """Raise ``PlanError`` if corners or lead-ins are chosen that no cutter and no laser makes.

    Parameters
    ----------
    work
        What is chosen for the edges.
    dieline
        The edges with their line types.
    """
    for choice, (other_type, no_cutter) in _CHOICES.items():
        rows = chosen_rows(work, choice, dieline, (LineType.CUT,), other_type)
        if len(rows) and not machine.offset_cuts:
            raise PlanError(no_cutter, edge=rows[0], machine=machine.title, at_edges=rows)
