"""A job for the laser table: a blank with a hole, a slit, an arc and a crease."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from knifetip import compensate, plan, process, sequence
from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.model.machine import Machine
from knifetip.model.program import Program
from knifetip.model.toolpath import Toolpath
from tests.support.shapes import closed, dieline, edges

LASER: Final = load.machine("laser-table")
BOARD: Final = load.board("fbb-0.4")
BLANK: Final = [(100, 100), (300, 100), (300, 200), (200, 200), (200, 250), (100, 250)]
HOLE: Final = [(120, 120), (170, 120), (170, 160), (120, 160)]
LINE: Final = dieline(
    (LineType.CUT, closed(*BLANK)),
    (LineType.CUT, closed(*HOLE)),
    (LineType.CUT, edges(((200, 120), (200, 180)))),
    (LineType.CREASE, edges(((110, 180), (190, 180)))),
    bulge={1: 0.2, 7: -0.1},
)


def toolpath(corner: str = "auto") -> Toolpath:
    """Return the head's path for the job, with one type of corner (A to D)."""
    work = [replace(operation, corner=corner) for operation in plan(LINE, LASER, BOARD)]
    return sequence([compensate(operation) for operation in work], LASER)


def program(dialect: str, corner: str = "auto", machine: Machine = LASER) -> Program:
    """Return the program of the job for a controller language."""
    notes = ["placement X0.0000 Y0.0000"]
    return process(toolpath(corner), replace(machine, dialect=dialect), notes=notes)
