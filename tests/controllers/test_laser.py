"""Laser programs interpreted by LinuxCNC: the beam is on only for cuts, half a kerf off the
part.
"""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from tests.controllers.linuxcnc_rs274 import ABSENT, RS274, TRAVERSE, TipTool, read_program
from tests.support.programs.laser import BOARD, HOLE, program

pytestmark = [pytest.mark.controller, pytest.mark.skipif(RS274 is None, reason=ABSENT)]

TABLE = {2: TipTool("wheel", 0.4, datum=(60.0, 0.0, -1.5, 0.0)), 5: TipTool("router", 0.4)}


def test_linuxcnc_switches_the_beam_on_for_cuts_only() -> None:
    reading = read_program(program("linuxcnc", "B").text, TABLE)
    assert reading.accepted, reading.stderr
    moves = reading.moves
    assert not moves.oscillates[moves.kind == TRAVERSE].any()
    burns = moves.oscillates
    assert (moves.station[burns] == 5).all()
    assert burns.sum() > 10
    np.testing.assert_allclose(moves.end[burns, 2], BOARD.caliper)
    np.testing.assert_allclose(moves.feed[burns], 9000.0)
    # Outputs of air assist and shutter.
    assert ((moves.outputs[burns] & 0b110000) == 0b110000).all()
    hole = shapely.Polygon(HOLE).exterior
    ends = shapely.points(moves.end[burns, :2])
    beside = shapely.distance(hole, ends)
    near = beside < 0.5
    np.testing.assert_allclose(beside[near], 0.1, atol=1e-3)
    assert near.sum() >= 5
