"""emit: write the program of a toolpath in the language of the machine's controller."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from knifetip.languages.registry import find_language
from knifetip.model.machine import Machine
from knifetip.model.program import Program
from knifetip.model.toolpath import Toolpath
from knifetip.post.check import check_toolpath


class Emitter(Protocol):
    """A function that writes programs in one controller language."""

    def __call__(
        self, toolpath: Toolpath, machine: Machine, *, tolerance: float, notes: Sequence[str]
    ) -> Program:
        """Return the program of a checked toolpath.

        The same input gives the same bytes: a program contains no dates and no host names.
        ``tolerance`` is the greatest deviation of the tip from the path (mm); ``notes`` are the
        comments at the top of the program.

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
    """Return the program that moves the head along a toolpath, in a controller language.

    Parameters
    ----------
    toolpath : Toolpath
        One chain of moves; the first move of each station is a rapid.
    machine : Machine
        Gives the datums and outputs of the stations, and the travel height.
    dialect : str
        Name of a controller language; if empty, the language of the machine.
    tolerance : float, mm
        Greatest deviation of the tip from the path, including the deviation that the controller
        adds.
    notes : sequence of str
        Comments at the top, if the language has comments.  One of them is ``placement X… Y…``, the
        shift of the drawing on the table.

    Raises
    ------
    LibraryError
        No controller language has the name.
    ProgramError
        The toolpath cannot be written in the language.
    """
    check_toolpath(toolpath)
    emitter: Emitter = find_language(dialect or machine.dialect).load_part("emitter")
    return emitter(toolpath, machine, tolerance=tolerance, notes=notes)
