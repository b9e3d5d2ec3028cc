"""Direction and speed of the spindles of stations, as LinuxCNC interprets them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip.post.emit import process
from tests.controllers.hand_written import (
    TABLE,
    TOOLS,
    ToolpathBuilder,
    add_creases,
    add_cuts,
    add_groove,
)
from tests.controllers.linuxcnc_rs274 import ABSENT, RS274, read_program

pytestmark = [pytest.mark.controller, pytest.mark.skipif(RS274 is None, reason=ABSENT)]

KNIFE = TABLE.stations[0]


@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
@pytest.mark.parametrize(("word", "speed"), [("M3", 9000.0), ("M4", 12000.0)])
def test_the_spindle_turns_as_its_station_states_while_it_works_and_for_no_other(
    dialect: str, word: str, speed: float
) -> None:
    knife = replace(KNIFE, spindle=word, spindle_speed=speed)
    table = replace(TABLE, stations=(knife, *TABLE.stations[1:]))
    path = add_creases(add_cuts(add_groove(ToolpathBuilder()))).toolpath()
    program = process(path, table, dialect).text
    tools = TOOLS if dialect == "linuxcnc" else None
    reading = read_program(program, tools)
    assert reading.accepted, reading.stderr
    moves = reading.moves
    lowered = np.array([bool(outputs & 1) for outputs in moves.outputs])
    expected = speed if word == "M3" else -speed
    assert lowered.any()
    assert not lowered.all()
    assert (moves.spindle[lowered] == expected).all()
    assert (moves.spindle[~lowered] == 0.0).all()
