"""The verifier's reader of programs for an MCX314: a valid program, and each of its faults."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import cast

import numpy as np
import pytest

from knifetip.errors import ProgramUnreadable
from knifetip.languages.mcx314.wiring import Wiring
from knifetip.library import load
from knifetip.verification.reading.mcx314 import MAX_LINES, READER

TABLE, BOARD = load.machine("v-groove-table"), load.board("e-flute")

PROGRAM = """MCX314 1
; placement X20.0000 Y-20.5000
PULSES X200 Y200 Z400 C100
GO Z8000
OUT 0 OFF
OUT 1 OFF
OUT 2 OFF
OSC OFF
OUT 0 ON
OSC ON
DWELL 150
GO X2000 Y4000 C0
GO Z2000
LINE Z-2120 V160000
LINE X10000 Y-5 V80000
CCW X400 Y400 I0 J400 V80000 JOIN
LINE C9000 V360000
CW X-400 Y-400 I-400 J0 V40000
LINE Z2120 V160000
GO Z8000
OUT 0 OFF
OUT 1 OFF
OUT 2 OFF
OSC OFF
END
"""


def faults(text: str) -> list[tuple[int, str]]:
    return [(line, fault.code) for line, fault in READER.read(text.encode(), TABLE, BOARD)[1]]


def test_a_program_is_read_move_by_move() -> None:
    moves, found = READER.read(PROGRAM.encode(), TABLE, BOARD)
    assert found == []
    assert moves.line.tolist() == [4, 12, 13, 14, 15, 16, 17, 18, 19, 20]
    assert moves.code.tolist() == [0, 0, 0, 1, 1, 3, 1, 2, 1, 0]
    np.testing.assert_array_equal(moves.end[0], [math.nan, math.nan, 20.0, math.nan])
    np.testing.assert_allclose(
        moves.end[1:],
        [
            [10.0, 20.0, 20.0, 0.0],
            [10.0, 20.0, 5.0, 0.0],
            [10.0, 20.0, -0.3, 0.0],
            [60.0, 19.975, -0.3, 0.0],
            [62.0, 21.975, -0.3, 0.0],
            [62.0, 21.975, -0.3, 90.0],
            [60.0, 19.975, -0.3, 90.0],
            [60.0, 19.975, 5.0, 90.0],
            [60.0, 19.975, 20.0, 90.0],
        ],
        atol=1e-12,
    )
    np.testing.assert_allclose(moves.centre[[5, 7]], [[60.0, 21.975], [60.0, 21.975]])
    np.testing.assert_allclose(moves.sweep[[5, 7]], [math.pi / 2.0, -math.pi / 2.0])
    # 53 mm/10 at 400 mm/s, 50 mm at 400 mm/s along X, and the arc of 2 mm at 400 and 200 mm/s.
    seconds = [2120 / 160e3, 0.125, math.pi / 400.0, 0.025, math.pi / 200.0, 2120 / 160e3]
    np.testing.assert_allclose(60.0 / moves.feed[3:9], seconds)
    assert moves.rested.tolist() == [True] * 5 + [False] + [True] * 4
    assert moves.station.tolist() == [-1] + [0] * 9
    assert moves.oscillating.tolist() == [False] + [True] * 9
    assert moves.waited.tolist() == [math.inf] + [0.15] * 9
    assert moves.stated[:2].tolist() == [[False] * 4, [True] * 4]
    assert moves.switches.line.tolist() == [5, 6, 7, 8, 9, 10, 21, 22, 23, 24]
    assert moves.switches.lowers.tolist() == [-1] * 4 + [0] + [-1] * 5
    assert moves.switches.move.tolist() == [0] * 6 + [9] * 4
    assert moves.resolution == pytest.approx(math.sqrt(0.5) / 200.0)
    assert READER.placement(PROGRAM.encode()) == (20.0, -20.5)
    assert READER.placement(b"MCX314 1\n") is None


@pytest.mark.parametrize(
    ("old", "new", "line", "code"),
    [
        ("MCX314 1\n", "MCX314 2\n", 1, "bad-header"),
        ("PULSES X200", "PULSES X100", 3, "other-pulses"),
        ("PULSES X200", "PULSES 200", 3, "no-pulses"),
        ("; placement", "; placement\x07", 2, "bad-line"),
        ("DWELL 150", "DWELL 150.0", 11, "bad-line"),
        ("LINE X10000 Y-5", "LINE X10000 Y-05", 15, "bad-line"),
        ("LINE X10000 Y-5", "LINE Y-5 X10000", 15, "bad-line"),
        ("LINE X10000 Y-5", "LINE X10000 X-5", 15, "bad-line"),
        ("LINE X10000 Y-5", "LINE  X10000 Y-5", 15, "bad-line"),
        ("LINE X10000 Y-5", "LINE X10000 Y0", 15, "bad-line"),
        ("LINE X10000 Y-5", "G1 X10000 Y-5", 15, "bad-line"),
        ("GO Z2000", "GO Z2000 V100", 13, "bad-line"),
        ("GO Z2000", "GO", 13, "bad-axes"),
        ("LINE X10000 Y-5", "LINE X10000 Y-5 Z1 C1", 15, "bad-axes"),
        ("LINE X10000 Y-5", "LINE", 15, "bad-axes"),
        ("LINE X10000 Y-5", "LINE X8388608 Y-5", 15, "out-of-range"),
        ("GO X2000", "GO X-8388608", 12, "out-of-range"),
        ("GO X2000 Y4000 C0", "GO X2000 C0", 15, "unknown-position"),
        ("Y-5 V80000", "Y-5 V400001", 15, "bad-speed"),
        ("Y-5 V80000", "Y-5 V49", 15, "bad-speed"),
        ("I0 J400", "I0 J402", 16, "bad-arc"),
        ("X400 Y400 I0 J400", "X0 Y0 I0 J400", 16, "bad-arc"),
        ("GO Z2000\n", "GO Z2000\nLINE X100 V80000 JOIN\n", 14, "joins-nothing"),
        ("LINE X10000 Y-5 V80000", "LINE X39 Y-5 V80000", 16, "joins-short"),
        ("OUT 2 OFF", "OUT 3 OFF", 7, "unknown-output"),
        ("DWELL 150", "DWELL 149", 11, "wrong-dwell"),
        ("DWELL 150\n", "", 11, "not-settled"),
        ("OSC OFF\nEND", "OUT 0 ON\nOSC OFF\nEND", 26, "ends-lowered"),
        ("OSC OFF\nEND", "END", 24, "ends-oscillating"),
        ("END\n", "END\nGO Z8000\n", 26, "after-end"),
        ("END\n", "", 24, "no-end"),
        ("END\n", "END", 25, "no-newline"),
    ],
)  # fmt: skip
def test_each_fault_is_found_with_its_line(old: str, new: str, line: int, code: str) -> None:
    assert old in PROGRAM
    head, _, tail = PROGRAM.rpartition(old) if "END" in old else PROGRAM.partition(old)
    assert (line, f"mcx314.{code}") in faults(head + new + tail)


def test_arcs_need_equal_pulses_of_x_and_y() -> None:
    wiring = replace(cast(Wiring, TABLE.controller), pulses=(200.0, 100.0, 400.0, 100.0))
    text = PROGRAM.replace("Y200", "Y100").encode()
    _, found = READER.read(text, replace(TABLE, controller=wiring), BOARD)
    assert [(line, fault.code) for line, fault in found] == [
        (16, "mcx314.no-circle"),
        (18, "mcx314.no-circle"),
    ]


@pytest.mark.parametrize("data", [b"", b"\n", b"MCX314 1\n", b"\x00\xff" * 99, b"MCX314 1\n;\n\n"])
def test_bytes_that_are_no_program_give_faults(data: bytes) -> None:
    moves, found = READER.read(data, TABLE, BOARD)
    assert found
    assert len(moves.line) == 0


def test_a_machine_without_an_mcx314_and_too_many_lines_are_refused() -> None:
    with pytest.raises(ProgramUnreadable, match="does not state how"):
        READER.read(b"", replace(TABLE, controller=None), BOARD)
    with pytest.raises(ProgramUnreadable):
        READER.read(b"\n" * (MAX_LINES + 1), TABLE, BOARD)


def test_heights_are_rounded_to_pulses() -> None:
    moves, _ = READER.read(PROGRAM.encode(), TABLE, BOARD)
    assert moves.height_resolution == 0.5 / 400.0
