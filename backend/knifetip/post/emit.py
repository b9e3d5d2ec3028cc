"""emit: write the program of a toolpath in the language of the machine's controller.

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

        The same input gives the same bytes: no dates, no host names.

        Raises
        ------
        ProgramError
            The language cannot express the toolpath.
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
        Datums and outputs of its stations, and the travel height.
    dialect : str
        Name of a controller language; if empty, that of the machine.
    tolerance : float, mm
        Greatest deviation of the tip from the path, including that of the controller.
    notes : sequence of str
        Comments at the top, if the language has comments.  One of them is ``placement X… Y…``, the
        shift of the drawing on the table.

    Raises
    ------
    LibraryError
        There is no such language.
    ProgramError
        The toolpath cannot be written in this language.
    """
    check_toolpath(toolpath)
    emitter: Emitter = find_language(dialect or machine.dialect).load_part("emitter")
    return emitter(toolpath, machine, tolerance=tolerance, notes=notes)
