"""choice_checks: refuse choices for edges that a machine cannot make."""

from __future__ import annotations

from knifetip.model.board import Board
from knifetip.model.chosen_work import ChosenWork
from knifetip.model.dieline import Dieline
from knifetip.model.machine import Machine
from knifetip.planning.chosen_depths import check_crease_depths, check_depths
from knifetip.planning.chosen_tools import check_tools
from knifetip.planning.cutter_choices import check_cutter_choices


def check_choices(work: ChosenWork, dieline: Dieline, machine: Machine, board: Board) -> None:
    """Raise ``PlanError`` for the first choice that a machine cannot make.

    Parameters
    ----------
    work
        What is chosen for the edges.
    dieline
        The edges, with the line types that follow from their depths.
    machine, board
        The machine that makes the edges, and the material.
    """
    check_tools(work, dieline, machine)
    check_cutter_choices(work, dieline, machine)
    check_depths(work, dieline, machine, board)
    check_crease_depths(work, dieline, machine, board)
