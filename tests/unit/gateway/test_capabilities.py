"""Axes, outputs and buffers of controllers, and the letter of the rotary axis on the wire."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.gateway.grbl.capabilities import Capabilities
from knifetip.messages import render

#: Answers to $I of grblHAL (build 20260817, with four and with six axes), grbl 1.1h and FluidNC.
GRBLHAL_4 = [
    "[VER:1.1f.20260817:]",
    "[OPT:VNML+,100,1024,4,0]",
    "[AXS:4:XYZA]",
    "[NEWOPT:ENUMS,RT+,TC,SED]",
    "[FIRMWARE:grblHAL]",
    "[AUX IO:0,4,0,0]",
]
GRBLHAL_6 = ["[VER:1.1f.20260817:]", "[OPT:VN,35,1024,6,0]", "[AXS:6:XYZABC]", "[FIRMWARE:grblHAL]"]
GRBL = ["[VER:1.1h.20190825:]", "[OPT:V,15,128]"]
FLUIDNC = ["[VER:3.9 FluidNC v3.9.1:]", "[OPT:PHS]"]


def test_a_default_grblhal_with_four_axes_turns_the_tool_by_a() -> None:
    found = Capabilities.read(GRBLHAL_4, 4)
    assert found == Capabilities("XYZA", 4, 100, 1024, grblhal=True)
    assert (found.rotary_letter, found.rotary_axis) == ("A", 3)


def test_of_six_axes_c_is_the_sixth() -> None:
    found = Capabilities.read(GRBLHAL_6, 6)
    assert (found.rotary_letter, found.rotary_axis, found.outputs) == ("C", 5, None)


def test_grbl_1_1_has_three_axes_and_no_outputs() -> None:
    found = Capabilities.read(GRBL, 3)
    assert found == Capabilities("XYZ", 0, 15, 128)
    assert found.rotary_letter == ""


@pytest.mark.parametrize(("lines", "reported"), [([], 4), ([], 0), (GRBL, 4)])
def test_a_controller_that_does_not_state_its_axes_gets_the_program_as_it_is(
    lines: list[str], reported: int
) -> None:
    found = Capabilities.read(lines, reported)
    assert (found.rotary_letter, found.rotary_axis, found.outputs) == ("C", 3, None)
    assert found.obstacle(b"M64 P9") is None
    assert found.to_wire(b"G1 C90") == b"G1 C90"


@pytest.mark.parametrize(("reported", "letter", "index"), [(4, "A", 3), (5, "A", 3), (6, "C", 5)])
def test_fluidnc_has_its_axes_in_one_order(reported: int, letter: str, index: int) -> None:
    found = Capabilities.read(FLUIDNC, reported)
    assert (found.rotary_letter, found.rotary_axis, found.outputs) == (letter, index, None)


@pytest.mark.parametrize(
    ("axes", "letter", "index"),
    [("XYZC", "C", 3), ("XYZU", "U", 3), ("XYZAB", "A", 3), ("XYZUV", "", 3), ("XYZBC", "C", 4)],
)
def test_the_rotary_axis_is_c_or_the_only_other_axis_or_a(
    axes: str, letter: str, index: int
) -> None:
    found = Capabilities(axes)
    assert (found.rotary_letter, found.rotary_axis) == (letter, index)


@pytest.mark.parametrize(
    ("axes", "program", "letter", "index"),
    [
        ("XYZABC", "A", "A", 3),
        ("XYZABC", "B", "B", 4),
        ("XYZC", "A", "C", 3),
        ("XYZBC", "A", "", 3),
        ("", "B", "B", 3),
    ],
)
def test_the_letter_of_the_machine_file_comes_first(
    axes: str, program: str, letter: str, index: int
) -> None:
    found = Capabilities(axes, program_letter=program)
    assert (found.rotary_letter, found.rotary_axis) == (letter, index)
    line = b"G1 X1 %s90" % program.encode()
    assert (found.obstacle(line) is None) == bool(letter)
    if letter:
        assert found.to_wire(line) == b"G1 X1 %s90" % letter.encode()
        assert found.from_wire(found.to_wire(line)) == line
        assert found.operation_to_wire(b"$J=G91 C5") == b"$J=G91 %s5" % letter.encode()


def test_the_letter_is_replaced_in_words_and_not_in_comments() -> None:
    found = Capabilities("XYZA")
    line = b"G1 X1 C-90.5 c4 (Crease C1) F100 ; C2"
    assert found.to_wire(line) == b"G1 X1 A-90.5 a4 (Crease C1) F100 ; C2"
    assert found.from_wire(found.to_wire(line)) == line


@given(st.text(alphabet="GXYZCcMFIJ0123456789.- ()%N;", max_size=60).map(str.encode))
def test_the_replacement_can_be_reversed_and_keeps_the_length(line: bytes) -> None:
    for axes in ("XYZA", "XYZC", "XYZB", ""):
        found = Capabilities(axes)
        sent = found.to_wire(line)
        assert found.from_wire(sent) == line
        assert len(sent) == len(line)


@pytest.mark.parametrize(
    ("axes", "line", "words"),
    [
        ("XYZ", b"G1 X1 C90 F100", "no axis that rotates the tool (its axes are X, Y, Z)"),
        ("XYZUV", b"G1 c90", "no axis that rotates the tool"),
        ("XYZA", b"G1 A90", "already contains this letter"),
        ("XYZA", b"M64 P04", "has no digital output 4 (it has 4 outputs)"),
        ("XYZC", b"m65p5", "has no digital output 5"),
    ],
)
def test_a_line_that_the_controller_cannot_execute_is_explained(
    axes: str, line: bytes, words: str
) -> None:
    obstacle = Capabilities(axes, outputs=4).obstacle(line)
    assert obstacle is not None
    assert words in render(obstacle)


@pytest.mark.parametrize("line", [b"(C and A) G1 X1", b"M64 P3", b"G0 Z20 ; A", b"M5"])
def test_other_lines_have_no_obstacle(line: bytes) -> None:
    for axes in ("XYZ", "XYZA", "XYZC"):
        assert Capabilities(axes, outputs=4).obstacle(line) is None
