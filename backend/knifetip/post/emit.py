"""emit: the program of a toolpath, in the language of the machine's controller.

Toolpath, Machine -> Program
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from knifetip.languages.registry import find_language
from knifetip.model.machine import Machine
from knifetip.model.program import Program
from knifetip.model.toolpath import Toolpath
from knifetip.post.check import check_toolpath


class Emitter(Protocol):
    """Writes programs in one language."""

    def __call__(
        self, toolpath: Toolpath, machine: Machine, *, tolerance: float, notes: Sequence[str]
    ) -> Program:
        """Return the program of a checked toolpath.

        Raises ProgramError where the language cannot express it.

        The same input gives the same bytes: no dates, no names of hosts.
        """
        ...


def process(
    toolpath: Toolpath,
    machine: Machine,
    dialect: str = "",
    *,
    tolerance: float = 0.01,
    notes: Sequence[str] = (),
) -> Program:
    """Return the program that moves the head along the toolpath.

    Parameters
    ----------
    toolpath : Toolpath
        One chain of moves; each station's first move is a rapid.
    machine : Machine
        Its stations' datums and outputs, and the height for rapids.
    dialect : str
        Name of a controller language; that of the machine where it is empty.
    tolerance : float, mm
        How far the tip may be from the line, what the controller adds included.
    notes : sequence of str
        Comments at the top, where the language has comments.  One of them is
        ``placement X… Y…``: what was added to the drawing's coordinates to place it on the sheet.

    Raises
    ------
    LibraryError
        There is no such language.
    ProgramError
        The toolpath cannot be written in this language.
    """
    check_toolpath(toolpath)
    emitter: Emitter = find_language(dialect or machine.dialect).part("emitter")
    return emitter(toolpath, machine, tolerance=tolerance, notes=notes)
