"""emit: write the program of a toolpath in the controller language of the machine."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Protocol

import numpy as np

from knifetip.languages.registry import find_language
from knifetip.model.axis_path import axis_path
from knifetip.model.held_heading import hold_heading
from knifetip.model.machine import Machine
from knifetip.model.program import Program
from knifetip.model.toolpath import Toolpath
from knifetip.post.check import check_toolpath


class Emitter(Protocol):
    """A function that writes programs in one controller language: HPGL or an RS274/NGC dialect."""

    def __call__(
        self, toolpath: Toolpath, machine: Machine, *, tolerance: float, notes: Sequence[str]
    ) -> Program:
        """Return the program of a toolpath that ``check_toolpath`` has accepted.

        The poses of ``toolpath`` are positions of the axes without the offsets of stations.
        The same input gives the same bytes: a program contains no dates and no host names.
        ``tolerance`` is the greatest deviation of the tip from the path (mm); ``notes`` are the
        comments at the top of the program.

        Raises
        ------
        ProgramError
            The toolpath cannot be expressed in the language.
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
    """Return the program that moves the head along a toolpath.

    Parameters
    ----------
    toolpath : Toolpath
        One chain of moves; the first move of each station is a rapid.
    machine : Machine
        Contains the datums and outputs of the stations, and the travel height.
    dialect : str
        Name of the controller language in which the program is written, such as ``linuxcnc``,
        ``grblhal`` or ``hpgl``.  If empty, the machine's own language is used.
    tolerance : float, mm
        Greatest deviation of the tip from the path, including the deviation that the controller
        adds.
    notes : sequence of str
        Comments at the top, if the language has comments.  One of them is ``placement X… Y…``, the
        shift of the drawing on the table.

    Raises
    ------
    LibraryError
        There is no controller language with this name.
    ProgramError
        The toolpath cannot be written in this language.
    """
    check_toolpath(toolpath)
    language = find_language(dialect or machine.dialect)
    if language.sets_pose:
        toolpath = hold_heading(toolpath, machine)
    emitter: Emitter = language.load_part("emitter")
    path, row = axis_path(toolpath, machine)
    program = emitter(path, machine, tolerance=tolerance, notes=notes)
    if path is toolpath:
        return program
    return replace(program, source=np.append(row, -1)[program.source].astype(np.int32))
