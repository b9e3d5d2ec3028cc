"""Lines have the same effect as in grblHAL, and invalid ones get its error numbers."""

from __future__ import annotations

import math
from contextlib import suppress

import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.gateway.interpreter import Block, Interpreter, LineRefused, switches_output
from knifetip.gateway.motion import Move


def read(*lines: bytes) -> Block:
    """Interpret lines after a header in millimetres; return the last block."""
    interpreter = Interpreter()
    interpreter.read(b"G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1")
    return [interpreter.read(line) for line in lines][-1]


def moved(block: Block) -> Move:
    """Return the move of a line that has one."""
    assert block.move is not None
    return block.move


def code(*lines: bytes) -> int:
    with pytest.raises(LineRefused) as refused:
        read(*lines)
    return refused.value.code


def test_words_that_are_left_out_keep_their_value() -> None:
    move = read(b"G0 X10 Y20 Z5", b"G1 Y30 F600").move
    assert move is not None
    assert move.start == (10.0, 20.0, 5.0, 0.0)
    assert move.end == (10.0, 30.0, 5.0, 0.0)
    assert move.rate == 600.0


def test_feed_and_motion_are_modal() -> None:
    assert moved(read(b"G1 X1 F600", b"X2")).rate == 600.0


def test_an_arc_turns_in_the_direction_of_its_word() -> None:
    # From (10, 0) about the origin to (0, 10): a quarter to the left, three quarters to the right.
    left = read(b"G0 X10", b"G3 X0 Y10 I-10 J0 F600").move
    right = read(b"G0 X10", b"G2 X0 Y10 I-10 J0 F600").move
    assert left is not None
    assert right is not None
    assert left.centre == right.centre == (0.0, 0.0)
    assert math.degrees(left.sweep) == pytest.approx(90.0)
    assert math.degrees(right.sweep) == pytest.approx(-270.0)


def test_an_arc_that_ends_where_it_began_is_a_full_circle() -> None:
    assert moved(read(b"G0 X10", b"G2 X10 Y0 I-10 F600")).sweep == -math.tau


def test_c_goes_with_the_arc_and_g93_is_one_over_minutes() -> None:
    move = read(b"G0 X10 C90", b"G93", b"G3 X0 Y10 C180 I-10 J0 F30").move
    assert move is not None
    assert move.at(0.5)[3] == 135.0
    assert move.minutes == pytest.approx(1.0 / 30.0)


def test_a_is_another_name_of_the_fourth_axis() -> None:
    assert moved(read(b"G0 A45")).end[3] == 45.0


def test_inches_and_relative_coordinates_are_understood() -> None:
    assert moved(read(b"G20", b"G91", b"G0 X1 C10", b"G0 X1 C10")).end == (50.8, 0.0, 0.0, 20.0)


def test_comments_and_blank_lines_do_nothing() -> None:
    for line in (b"(placement X20 Y20)", b"; words", b"", b"   ", b"%", b"(no end"):
        assert read(line).move is None


def test_small_letters_and_blanks_inside_words_are_read() -> None:
    assert moved(read(b"g0 x 1 0.5")).end[0] == 10.5


@pytest.mark.parametrize(
    ("line", "waits"),
    [
        (b"G4 P0.15", True),
        (b"M3 S1", True),
        (b"M5", True),
        (b"M30", True),
        (b"M64 P1", False),
        (b"M65 P1", False),
        (b"G0 X1", False),
        (b"(words)", False),
    ],
)
def test_what_waits_for_the_motion_before_it(line: bytes, waits: bool) -> None:
    assert read(line).waits is waits


def test_outputs_are_read_with_their_number() -> None:
    on, off = read(b"M64 P2"), read(b"M65 P2")
    assert (on.output, on.on) == (2, True)
    assert (off.output, off.on) == (2, False)


@pytest.mark.parametrize(
    ("line", "answer"),
    [(b"M64 P1", True), (b"m65p0", True), (b"G0 X1 (M64 P1)", False), (b"G4 P0.64", False)],
)
def test_lines_that_switch_outputs_are_detected(line: bytes, answer: bool) -> None:
    assert switches_output(line) is answer


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ((b"10",), 1),
        ((b"X",), 2),
        ((b"G1 X1 F-5",), 4),
        ((b"X" + b"1" * 300,), 11),
        ((b"G64 P0.005",), 20),
        ((b"T2 M6",), 20),
        ((b"G43",), 20),
        ((b"G0 G1 X1",), 21),
        ((b"G1 X1",), 22),
        ((b"G93", b"G1 X1 F60", b"G1 X2"), 22),
        ((b"G93", b"G1 X1 F60", b"G94", b"G1 X2"), 22),
        ((b"G4 P1 X5",), 24),
        ((b"G0 X1 X2",), 25),
        ((b"G0 A1 C2",), 25),
        ((b"G2 F100 I5",), 26),
        ((b"G4",), 28),
        ((b"M64",), 28),
        ((b"G0 X10", b"G3 X0 Y12 I-10 J0 F600"), 33),
        ((b"G2 X1 Y1 F100",), 35),
        ((b"G0 X1 I5",), 36),
    ],
)
def test_wrong_lines_get_grbls_number(lines: tuple[bytes, ...], expected: int) -> None:
    assert code(*lines) == expected


def test_a_refused_line_leaves_the_state_as_it_was() -> None:
    interpreter = Interpreter()
    interpreter.read(b"G1 X10 F600")
    with pytest.raises(LineRefused):
        interpreter.read(b"G91 G1 X5 Q7")
    assert moved(interpreter.read(b"X20")).end[0] == 20.0


@given(st.binary(max_size=120))
def test_no_line_at_all_breaks_the_interpreter(line: bytes) -> None:
    with suppress(LineRefused):
        Interpreter().read(line)


@given(
    st.lists(
        st.tuples(
            st.sampled_from("GMXYZCIJFPSN"),
            st.sampled_from([*"012345", "17", "21", "90", "94", "-3.5", "nan", "9" * 200]),
        ),
        max_size=6,
    )
)
def test_what_a_line_of_words_does_is_finite_and_a_dwell_needs_its_word(
    words: list[tuple[str, str]],
) -> None:
    line = " ".join(map("".join, words)).encode()
    try:
        block = Interpreter().read(line)
    except LineRefused:
        return
    assert (block.dwell is not None) == (b"G4" in line.split())
    if block.move is not None:
        assert all(map(math.isfinite, [*block.move.start, *block.move.end]))
        assert block.move.rate > 0.0
