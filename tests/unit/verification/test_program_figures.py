"""The figures of a program as a whole."""

import pytest

from knifetip.library import load
from knifetip.model.program_figures import ProgramFigures
from knifetip.verification.verify import verify
from tests.support.programs.handwritten import (
    BOARD,
    DIELINE,
    LINUXCNC,
    MACHINE,
    PLACEMENT,
    changed,
    dieline,
)


def figures(text: bytes) -> ProgramFigures:
    return verify(text, DIELINE, PLACEMENT, MACHINE, BOARD).program


def test_the_depth_in_the_mat_is_that_of_the_deepest_move() -> None:
    # The knife cuts 0.3 mm into the mat, and the last depth counts, too.
    assert figures(LINUXCNC).mat_depth == pytest.approx(0.3)
    deeper = changed(LINUXCNC, "G1 Z-0.3000\nG1 X110", "G1 Z-0.7500\nG1 X110")
    assert figures(deeper).mat_depth == pytest.approx(0.75)


def test_tools_that_stay_above_the_mat_have_no_depth_in_it() -> None:
    assert figures(LINUXCNC.replace(b"Z-0.3000", b"Z0.0100")).mat_depth == 0.0
    assert verify(b"", dieline(), PLACEMENT, MACHINE, BOARD).program.mat_depth == 0.0


def test_the_focus_of_a_beam_is_no_depth() -> None:
    laser = load.machine("laser-table")
    text = b"G21 G90 G54\nT1 M6\nM3 S500\nG1 Z-2 F100\nG1 X10\nM5\n"
    assert verify(text, dieline(), PLACEMENT, laser, BOARD).program.mat_depth == 0.0
