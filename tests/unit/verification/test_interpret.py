import math

import numpy as np
import pytest

from knifetip.messages import Message
from knifetip.verification.reading.moves import Moves
from knifetip.verification.reading.rs274.interpret import interpret
from knifetip.verification.reading.rs274.parse import parse_words
from tests.support.programs.handwritten import LINUXCNC, MACHINE, changed

HEADER = "G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1\n"


def moves_of(text: str) -> tuple[Moves, list[tuple[int, Message]]]:
    return interpret(parse_words(text.encode()), MACHINE)


def faults_of(text: str) -> list[str]:
    return [f"{line}: {fault.code}" for line, fault in moves_of(text)[1]]


def test_a_joint_is_the_number_plus_the_datum_of_the_station_in_force() -> None:
    moves, faults = moves_of(
        HEADER + "G64 P0.005 Q0.005\nG0 Z20\nT2 M6 G43\nG0 X10 Y20 Z20 C5\nG49\nM2\n"
    )
    assert faults == []
    np.testing.assert_array_equal(moves.end[1], [70.0, 20.0, 18.5, 5.0])


def test_an_axis_without_a_word_keeps_its_position() -> None:
    moves, _ = moves_of(HEADER + "G0 X10 Y20 Z20 C5\nT2 M6 G43\nG0 X0\nM2\n")
    # The wheel's datum displaces X by 60 and Z by -1.5; only X has a word in the line.
    np.testing.assert_array_equal(moves.end[1], [60.0, 20.0, 20.0, 5.0])


def test_without_tool_words_the_station_is_the_one_that_was_lowered_last() -> None:
    moves, _ = moves_of(
        HEADER + "G0 Z20\nM64 P1\nG4 P0.15\nG0 X0\nM65 P1\nM64 P2\nG4 P0.15\nG0 X1\nM65 P2\nM2\n"
    )
    assert moves.station.tolist() == [-1, 1, 2]
    assert moves.lowered.tolist() == [[False] * 3, [False, True, False], [False, False, True]]


def test_the_sweep_of_an_arc_has_the_sign_of_its_turn() -> None:
    moves, faults = moves_of(
        HEADER
        + "G0 X10 Y0 Z20 C0\nG3 X0 Y10 I-10 J0 F600\nG2 X10 Y0 I0 J-10\nG3 X10 Y0 I-5 J0\nM2\n"
    )
    assert faults == []
    np.testing.assert_allclose(moves.sweep, [0.0, math.pi / 2, -math.pi / 2, 2 * math.pi])
    np.testing.assert_allclose(moves.centre[1:], [[0, 0], [0, 0], [5, 0]], atol=1e-12)


def test_the_feed_is_cleared_when_the_feed_mode_changes() -> None:
    start = HEADER + "G0 X0 Y0 Z20 C0\nG1 X1 F600\nG93 G1 X2 F10\n"
    assert moves_of(start + "G94 G1 X3 F600\nM2\n")[1] == []
    assert faults_of(start + "G94 G1 X3\nM2\n") == ["5: rs274.no-feed"]
    assert faults_of(start + "G1 X3\nM2\n") == [
        "5: rs274.timed-without-f",
    ]
    # LinuxCNC clears it also if the mode stays.
    assert faults_of(HEADER + "G0 X0 Y0 Z20 C0\nG1 X1 F600\nG94\nG1 X2\nM2\n") == [
        "5: rs274.no-feed"
    ]


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("G20", "rs274.unknown-word"),
        ("G91", "rs274.unknown-word"),
        ("G18", "rs274.unknown-word"),
        ("G41", "rs274.unknown-word"),
        ("G0.5 X1", "rs274.unknown-word"),
        ("M7", "rs274.unknown-word"),
        ("G0 X1 R2", "rs274.unknown-letter"),
        ("G0 X1 X2", "rs274.repeated-word"),
        ("G0 G1 X1 F5", "rs274.repeated-word"),
        ("G54 G54", "rs274.repeated-word"),
        ("G4 P0 G92.1", "rs274.repeated-word"),
        ("G92 X0", "rs274.unknown-word"),
        ("X1", "rs274.axis-without-motion"),
        ("G1 F100", "rs274.motion-without-axis"),
        ("G1 X1 I2 F5", "rs274.centre-without-arc"),
        ("G2 X1 I2 F5", "rs274.incomplete-arc"),
        ("G3 X11 Y0 I-5 J0 F5", "rs274.bad-arc"),
        ("G0 X1 M5", "rs274.moves-and-switches"),
        ("P5", "rs274.stray-p"),
        ("G4", "rs274.missing-p"),
        ("G4 P0.2", "rs274.wrong-dwell"),
        ("Q5", "rs274.stray-q"),
        ("G1 X1 F0", "rs274.bad-feed"),
        ("M64 P7", "rs274.unknown-output"),
        ("M3 S0", "rs274.wrong-speed"),
        ("T9", "rs274.unknown-station"),
        ("M6", "rs274.change-without-station"),
        ("G43", "rs274.offset-without-station"),
        ("G64 P0.005", "rs274.g64-unsupported"),
        ("N-1", "rs274.bad-line-number"),
    ],
)
def test_a_line_with_other_words_is_a_fault(line: str, code: str) -> None:
    faults = faults_of(HEADER + f"G0 X10 Y0 Z20 C0\n{line}\nG0 X0\nM2\n")
    assert f"3: {code}" in faults, faults


@pytest.mark.parametrize(
    ("word", "mode"),
    [
        ("G21 ", "rs274.mode-g21"),
        ("G90 ", "rs274.mode-g90"),
        ("G91.1 ", "rs274.mode-g91-1"),
        ("G17 ", "rs274.mode-g17"),
        ("G40 ", "rs274.mode-g40"),
        ("G49 ", "rs274.mode-g49"),
        ("G94 ", "rs274.mode-g94"),
        (" G54", "rs274.mode-g54"),
        (" G92.1", "rs274.mode-g92-1"),
    ],
)
def test_modes_must_be_set_before_the_first_move(word: str, mode: str) -> None:
    _, faults = moves_of(HEADER.replace(word, "") + "G0 X0 Y0 Z20 C0\nM2\n")
    assert faults == [(2, Message("rs274.moves-unstated", mode=Message(mode)))]


def test_a_move_must_wait_for_a_piston_to_settle() -> None:
    text = LINUXCNC.decode().replace("M64 P1\nG4 P0.15\n", "M64 P1\n")
    assert any("rs274.not-settled" in fault for fault in faults_of(text))


def test_everything_must_be_off_at_the_end() -> None:
    text = LINUXCNC.decode()
    end = "M65 P0\nM5\nG49\nM2\n"
    assert faults_of(text) == []
    for removed, expected in (
        ("M65 P0\n", "rs274.ends-lowered"),
        ("M5\n", "rs274.ends-oscillating"),
        ("G49\n", "rs274.ends-with-offset"),
        ("M2\n", "rs274.no-end"),
    ):
        faults = faults_of(text.replace(end, end.replace(removed, "")))
        assert len(faults) == 1
        assert expected in faults[0]


def test_nothing_moves_after_the_end() -> None:
    moves, faults = moves_of(LINUXCNC.decode() + "G0 X500\n")
    assert (81, Message("rs274.after-end")) in faults
    assert moves.end[-1, 0] == 70.3527


def test_a_tool_table_without_a_bound_for_rounded_corners_is_a_fault() -> None:
    text = LINUXCNC.decode().replace("G64 P0.0050 Q0.0050\n", "")
    assert any("rs274.unbounded-rounding" in fault for fault in faults_of(text))
    zero = changed(LINUXCNC, "G64 P0.0050 Q0.0050", "G64 P0.0000 Q0.0050").decode()
    assert any("rs274.unbounded-rounding" in fault for fault in faults_of(zero))


def test_an_empty_text_is_a_fault() -> None:
    assert faults_of("") == ["1: rs274.no-end"]


def test_outputs_are_switched_at_rest_without_a_tool_table() -> None:
    start = HEADER + "G0 Z20\nG4 P0\nM65 P0\nM65 P1\nM65 P2\nM5\n"
    assert faults_of(start + "G49\nM30\n") == []
    assert faults_of(start.replace("G4 P0\n", "") + "G49\nM30\n") == [
        f"{line}: rs274.switches-while-moving" for line in (3, 4, 5)
    ]
    # LinuxCNC ends the moves before it switches an output.
    table = start.replace("G0 Z20\nG4 P0\n", "G64 P0.005 Q0.005\nG0 Z20\n") + "T1 M6\nG49\nM2\n"
    assert faults_of(table) == []


def test_a_line_number_is_the_first_word() -> None:
    assert faults_of(HEADER + "N5 G0 X1\nM2\n") == []
    assert faults_of(HEADER + "G0 N5 X1\nM2\n") == ["2: rs274.bad-line-number"]


def test_linuxcnc_states_the_rounding_of_corners_before_its_first_move() -> None:
    table = HEADER + "G0 Z20\nG64 P0.005 Q0.005\nT1 M6\nM2\n"
    assert faults_of(table) == ["2: rs274.unbounded-rounding"]
