import math

import numpy as np
import pytest

from knifetip.verification.moves import Moves
from knifetip.verification.rs274.modal import interpret
from knifetip.verification.rs274.parse import parse
from tests.support.programs.handwritten import LINUXCNC, MACHINE, changed

HEADER = "G21 G90 G91.1 G17 G40 G49 G94 G54\n"


def moves_of(text: str) -> tuple[Moves, list[tuple[int, str]]]:
    return interpret(parse(text.encode()), MACHINE)


def faults_of(text: str) -> list[str]:
    return [f"{line}: {fault}" for line, fault in moves_of(text)[1]]


def test_a_joint_is_the_number_plus_the_datum_of_the_station_in_force() -> None:
    moves, faults = moves_of(
        HEADER + "G64 P0.005 Q0.005\nG0 Z20\nT2 M6 G43\nG0 X10 Y20 Z20 C5\nG49\nM2\n"
    )
    assert faults == []
    np.testing.assert_array_equal(moves.end[1], [70.0, 20.0, 18.5, 5.0])


def test_an_axis_that_is_not_said_stays_where_the_joint_is() -> None:
    moves, _ = moves_of(HEADER + "G0 X10 Y20 Z20 C5\nT2 M6 G43\nG0 X0\nM2\n")
    # The wheel's datum moves X by 60 and lowers Z by 1.5; only X is said anew.
    np.testing.assert_array_equal(moves.end[1], [60.0, 20.0, 20.0, 5.0])


def test_without_tool_words_the_station_is_the_one_that_was_lowered_last() -> None:
    moves, _ = moves_of(
        HEADER + "G0 Z20\nM64 P1\nG4 P0.15\nG0 X0\nM65 P1\nM64 P2\nG4 P0.15\nG0 X1\nM65 P2\nM2\n"
    )
    assert moves.station.tolist() == [-1, 1, 2]
    assert moves.piston.tolist() == [[False] * 3, [False, True, False], [False, False, True]]


def test_the_sweep_of_an_arc_has_the_sign_of_its_turn() -> None:
    moves, faults = moves_of(
        HEADER
        + "G0 X10 Y0 Z20 C0\nG3 X0 Y10 I-10 J0 F600\nG2 X10 Y0 I0 J-10\nG3 X10 Y0 I-5 J0\nM2\n"
    )
    assert faults == []
    np.testing.assert_allclose(moves.sweep, [0.0, math.pi / 2, -math.pi / 2, 2 * math.pi])
    np.testing.assert_allclose(moves.centre[1:], [[0, 0], [0, 0], [5, 0]], atol=1e-12)


def test_a_feed_is_forgotten_when_the_feed_mode_changes() -> None:
    start = HEADER + "G0 X0 Y0 Z20 C0\nG1 X1 F600\nG93 G1 X2 F10\n"
    assert moves_of(start + "G94 G1 X3 F600\nM2\n")[1] == []
    assert faults_of(start + "G94 G1 X3\nM2\n") == [
        "5: feeds, and no F has been said since the feed mode was set."
    ]
    assert faults_of(start + "G1 X3\nM2\n") == [
        "5: is timed (G93) and has no F.",
    ]


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("G20", "G20 does not belong here."),
        ("G91", "G91 does not belong here."),
        ("G18", "G18 does not belong here."),
        ("G41", "G41 does not belong here."),
        ("G0.5 X1", "G0.5 does not belong here."),
        ("M7", "M7 does not belong here."),
        ("G0 X1 R2", "the letter R does not belong here."),
        ("G0 X1 X2", "says the same thing twice."),
        ("G0 G1 X1 F5", "says the same thing twice."),
        ("G54 G54", "says the same thing twice."),
        ("X1", "has axis words and no G0, G1, G2 or G3."),
        ("G1 F100", "says how to move and not where to."),
        ("G1 X1 I2 F5", "has the centre of an arc, and is none."),
        ("G2 X1 I2 F5", "is an arc without X, Y, I or J."),
        ("G3 X11 Y0 I-5 J0 F5", "is an arc whose ends differ in radius by more than 0.002 mm."),
        ("G0 X1 M5", "moves, and switches something else on the same line."),
        ("P5", "has a P that belongs to nothing, or to two words."),
        ("G4", "lacks its P."),
        ("G4 P0.2", "waits for another time than the machine's 0.15 s."),
        ("Q5", "has a Q that belongs to nothing."),
        ("G1 X1 F0", "has a feed that does not move."),
        ("M64 P7", "switches an output that hand-table lacks."),
        ("M3 S0", "switches what turns or oscillates on with another speed (S) than the tool's."),
        ("T9", "calls a station that hand-table lacks."),
        ("M6", "changes the station and none is named."),
        ("G43", "takes the offset of a station, and none is called."),
        ("G64 P0.005", "says G64, which controllers without a tool table reject."),
        ("N-1", "has a line number that is none."),
    ],
)
def test_a_line_that_says_something_else_is_a_fault(line: str, said: str) -> None:
    faults = faults_of(HEADER + f"G0 X10 Y0 Z20 C0\n{line}\nG0 X0\nM2\n")
    assert f"3: {said}" in faults, faults


@pytest.mark.parametrize(
    ("word", "said"),
    [
        ("G21 ", "millimetres (G21)"),
        ("G90 ", "absolute distances (G90)"),
        ("G91.1 ", "arc centres from the start (G91.1)"),
        ("G17 ", "the XY plane (G17)"),
        ("G40 ", "no radius compensation (G40)"),
        ("G49 ", "no tool length (G49)"),
        ("G94 ", "the feed mode (G94)"),
        (" G54", "the coordinate system (G54)"),
    ],
)
def test_what_the_controller_may_remember_must_be_stated_before_the_first_move(
    word: str, said: str
) -> None:
    faults = faults_of(HEADER.replace(word, "") + "G0 X0 Y0 Z20 C0\nM2\n")
    assert faults == [f"2: moves before {said} is stated."]


def test_a_piston_needs_its_time_before_anything_moves() -> None:
    text = LINUXCNC.decode().replace("M64 P1\nG4 P0.15\n", "M64 P1\n")
    assert any("moves before what was switched has settled" in fault for fault in faults_of(text))


def test_the_end_leaves_nothing_switched_on() -> None:
    text = LINUXCNC.decode()
    end = "M65 P0\nM5\nG49\nM2\n"
    assert faults_of(text) == []
    for gone, said in (
        ("M65 P0\n", "with a station lowered."),
        ("M5\n", "while something oscillates or turns."),
        ("G49\n", "with the offset of a station in force."),
        ("M2\n", "does not end (M2)."),
    ):
        faults = faults_of(text.replace(end, end.replace(gone, "")))
        assert len(faults) == 1
        assert said in faults[0]


def test_nothing_moves_after_the_end() -> None:
    moves, faults = moves_of(LINUXCNC.decode() + "G0 X500\n")
    assert (73, "stands after the end of the program.") in faults
    assert moves.end[-1, 0] == 70.3527


def test_a_tool_table_without_a_bound_for_rounded_corners_is_a_fault() -> None:
    text = LINUXCNC.decode().replace("G64 P0.0050 Q0.0050\n", "")
    assert any("nothing (G64 P) bounds" in fault for fault in faults_of(text))
    zero = changed(LINUXCNC, "G64 P0.0050 Q0.0050", "G64 P0.0000 Q0.0050").decode()
    assert any("nothing (G64 P) bounds" in fault for fault in faults_of(zero))


def test_no_lines_are_no_program() -> None:
    assert faults_of("") == ["1: is the last, and does not end (M2)."]
