"""The reader of HPGL, with programs written by hand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip.errors import ProgramUnreadable
from knifetip.languages.hpgl.plotter import Plotter
from knifetip.library import load
from knifetip.verification.reading.hpgl import MAX_BYTES, READER
from knifetip.verification.reading.moves import Moves

MACHINE, BOARD = load.machine("flat-cutter-hpgl"), load.board("fbb-0.4")
GOOD = (
    "IN;\nPA;\nPU;\nSP1;\nFS30;\nVS40;\nPU800,800;\nPD;\nPD4800,800;\nPU;\n"
    "PU4800,900;\nPD;\nPD4800,4800,5200,4800;\nPU;\nSP0;\n"
).replace("PD4800,4800,5200,4800", "PD4800,4800,4810,5200")


def moves_of(text: str) -> tuple[Moves, list[str]]:
    moves, faults = READER.read(text.encode("latin-1"), MACHINE, BOARD)
    return moves, [f"{line}: {fault.code}" for line, fault in faults]


def test_a_good_program_has_no_faults() -> None:
    moves, faults = moves_of(GOOD)
    assert faults == []
    assert moves.programmed == "XY"
    assert moves.resolution == pytest.approx(0.0176777, abs=1e-7)


def test_units_become_millimetres_and_the_pen_a_height() -> None:
    moves, _ = moves_of(GOOD)
    np.testing.assert_allclose(
        moves.end[:4, :3],
        np.array([(20, 20, 5), (20, 20, -0.3), (120, 20, -0.3), (120, 20, 5)]),
    )
    assert moves.code.tolist()[:5] == [0, 1, 1, 1, 0]
    assert moves.line.tolist()[:4] == [7, 8, 9, 10]
    # The device turns the knife: east, then north; 0.25 mm in 10 mm is 1.43°.
    assert moves.end[2, 3] == 0.0
    assert moves.end[6:8, 3] == pytest.approx([90.0, 88.5679], abs=1e-3)
    assert moves.feed[2] == 24000.0
    assert set(moves.station.tolist()) == {0}


def test_a_centred_device_has_its_own_zero() -> None:
    plotter = MACHINE.controller
    assert isinstance(plotter, Plotter)
    area = (-26000, -18000, 26000, 18000)
    device = replace(plotter.device, zero=(650.0, 450.0), area=area)
    machine = replace(MACHINE, controller=replace(plotter, device=device))
    moves, faults = READER.read(
        b"IN;PA;PU;SP1;FS30;VS40;PU-400,+200;PD;PD-400,900;PU;SP0;", machine, BOARD
    )
    assert faults == []
    np.testing.assert_allclose(moves.end[0, :2], [640.0, 455.0])


@pytest.mark.parametrize(
    ("old", "new", "fault"),
    [
        ("IN;\n", "", "1: hpgl.not-initialised"),
        ("PU;\nSP0;", "IN;PU;SP0;", "14: hpgl.initialised-again"),
        ("PA;\n", "", "6: hpgl.moves-before-pa"),
        ("PA;", "PR;", "2: hpgl.unknown-instruction"),
        ("SP1;", "SP4;", "4: hpgl.unknown-pen"),
        ("SP1;\n", "", "7: hpgl.no-pen-selected"),
        ("PU;\nSP0;", "SP0;", "14: hpgl.selects-while-down"),
        ("PD4800,800;", "PD4800,800;FS12;", "9: hpgl.sets-while-down"),
        ("PD4800,800;", "VS30;PD4800,800;", "9: hpgl.sets-while-down"),
        ("PD4800,800;", "PD4800,,800;", "9: hpgl.bad-byte"),
        ("PD4800,800;", ",PD4800,800;", "9: hpgl.bad-byte"),
        ("PD4800,800;", "PD4800,800,;", "9: hpgl.bad-byte"),
        ("SP0;\n", "", "14: hpgl.ends-with-pen"),
        ("SP0;", "SP0", "15: hpgl.no-terminator"),
        ("VS40;\n", "", "8: hpgl.no-speed"),
        ("VS40;", "VS90;", "6: hpgl.speed-out-of-range"),
        ("FS30;", "FS31;", "8: hpgl.wrong-force"),
        ("FS30;\n", "", "7: hpgl.wrong-force"),
        ("PD4800,800;", "PD4800;", "9: hpgl.x-without-y"),
        ("PD4800,800;", "PD;4800,800;", "9: hpgl.loose-number"),
        ("PD4800,800;", "PD\n4800,800;", "10: hpgl.loose-number"),
        ("PD4800,800;", "PD4800.5,800;", "9: hpgl.bad-byte"),
        ("PD4800,800;", "PD4800,-;", "9: hpgl.bad-number"),
        ("PD4800,800;", "PD4800,8000000000;", "9: hpgl.bad-number"),
        ("PD4800,800;", "PD60000,800;", "9: hpgl.outside-area"),
        ("PD4800,800;", "PD-1,800;", "9: hpgl.outside-area"),
        ("PD4800,800;", "AA0,0,90;", "9: hpgl.unknown-instruction"),
        ("PD4800,800;", "P D4800,800;", "9: hpgl.lone-letter"),
        ("PD4800,800;", "\x1b.K", "9: hpgl.bad-byte"),
        ("PD4800,800;", "pd4800,800;", "9: hpgl.bad-byte"),
        ("PD4800,800;\n", "", "8: hpgl.plunge-without-move"),
        ("PD4800,800;", "PD4800,800,4800,4800;", "9: hpgl.turn-in-board"),
        ("SP1;", 'SP1;CO"note";', "4: hpgl.unknown-instruction"),
    ],
)  # fmt: skip
def test_a_broken_program_has_a_fault(old: str, new: str, fault: str) -> None:
    assert old in GOOD
    _, faults = moves_of(
        GOOD.replace(old, new, 1) if old != "PU;\nSP0;" else GOOD.replace(old, new)
    )
    assert any(found.startswith(fault) for found in faults), faults


def test_a_program_that_ends_at_work_has_a_fault() -> None:
    assert "3: hpgl.ends-down" in moves_of("IN;PA;\nSP1;\nPD10,10;\n")[1]


@pytest.mark.parametrize(
    "text", ["", "\n", ";;;", "PD", "1,2", "\x00\xff" * 50, "IN" * 999, "PD1,"]
)
def test_any_text_can_be_read(text: str) -> None:
    assert moves_of(text)[1]


def test_a_text_that_is_too_large_is_refused() -> None:
    with pytest.raises(ProgramUnreadable, match="limit is"):
        READER.read(b" " * (MAX_BYTES + 1), MACHINE, BOARD)


def test_the_placement_is_read_from_a_comment() -> None:
    assert READER.placement(b'IN;CO"placement X20.0000 Y-3.5000";PA;') == (20.0, -3.5)
    assert READER.placement(GOOD.encode()) is None
