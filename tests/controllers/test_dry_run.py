"""Dry programs, interpreted by LinuxCNC: above the board, nothing on, the path of the program."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip.gateway.dry_program import dry_program, frame_program
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


#: rs274 reads lengths of the tool table as inches, so Z without a word would jump at a tool change.
LEVEL = {
    number: replace(tool, datum=(tool.datum[0], tool.datum[1], 0.0, tool.datum[3]))
    for number, tool in TOOLS.items()
}


@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
def test_a_dry_program_stays_at_its_height_and_switches_nothing(dialect: str) -> None:
    path = add_cuts(add_groove(add_creases(ToolpathBuilder()))).toolpath()
    program = process(path, TABLE, dialect).text
    tools = LEVEL if dialect == "linuxcnc" else None
    dry = read_program(dry_program(program, TABLE, 0.5), tools)
    assert dry.accepted, dry.stderr
    wet = read_program(program, tools).moves
    moves = dry.moves
    first = np.argmax(moves.joints[:, 2] > 0.0)
    height = TABLE.travel_z + max(station.z for station in TABLE.stations)
    assert moves.joints[first:, 2] == pytest.approx(height)
    assert not moves.outputs.any()
    assert not moves.oscillates.any()
    # The same ends of moves in X, Y and C, in the same order; moves of Z alone are left out.
    ends = [
        one.joints[:, [0, 1, 5]][np.any(np.diff(one.joints[:, [0, 1, 5]], axis=0, prepend=0.0), 1)]
        for one in (moves, wet)
    ]
    assert ends[0] == pytest.approx(ends[1])
    lines = moves.feed[moves.kind != 0]
    assert lines.min() > 0.0


def test_a_frame_is_accepted() -> None:
    box = (20.0, 20.0, 320.0, 220.0)
    frame = read_program(frame_program(box, TABLE.stations[0], TABLE, 0.2))
    assert frame.accepted, frame.stderr
    assert frame.moves.joints[:, 0].max() == 320.0 + TABLE.stations[0].x
