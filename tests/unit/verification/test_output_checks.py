"""States that an earlier job may have left: lowered stations, a spindle that runs."""

from __future__ import annotations

from dataclasses import replace

import pytest

from knifetip.messages import hint
from knifetip.model.machine import Machine
from knifetip.verification.verify import verify
from tests.support.programs.handwritten import (
    BOARD,
    DIELINE,
    GRBLHAL,
    LINUXCNC,
    MACHINE,
    PLACEMENT,
    changed,
    dieline,
)

HEAD = "G0 Z20.0000\nM65 P0\nM65 P1\nM65 P2\nM5\n"
BOTH = pytest.mark.parametrize("program", [LINUXCNC, GRBLHAL], ids=["linuxcnc", "grblhal"])


def program_findings(text: bytes, machine: Machine = MACHINE, *, drawn: bool = True) -> list[str]:
    line = DIELINE if drawn else dieline()
    findings = verify(text, line, PLACEMENT, machine, BOARD).findings
    return [f"{finding.text} {hint(finding.message)}".strip() for finding in findings]


def with_head(program: bytes, head: str) -> bytes:
    # Without a tool table, a dwell must be between the lift and the outputs.
    rested = HEAD.replace("M65 P0", "G4 P0\nM65 P0")
    return changed(program, HEAD if program == LINUXCNC else rested, head)


@BOTH
@pytest.mark.parametrize(
    ("gone", "what"),
    [
        ("M65 P0\n", "moves the head before it switches off output 0 (M65 P0)"),
        ("M65 P1\n", "moves the head before it switches off output 1 (M65 P1)"),
        (
            "M65 P2\n",
            "while station 3 may still be lowered. Raise station 3 (M65 P2) before",
        ),
        ("M5\n", "moves the head before it switches off the spindle (M5)"),
        (
            "G0 Z20.0000\n",
            "before the program has set the height of the head. Lift the head to Z 20.000 mm",
        ),
    ],
)
def test_each_line_of_the_header_is_needed(program: bytes, gone: str, what: str) -> None:
    assert program_findings(program) == []
    # The first station's own output is stated again by the line that lowers it.
    if gone == "M65 P1\n":
        lines = program_findings(
            with_head(program, HEAD.replace(gone, "").replace("Z20", "Z20.0\nG0 X1 Z20"))
        )
    else:
        lines = program_findings(with_head(program, HEAD.replace(gone, "")))
    assert any(what in line for line in lines), lines


@BOTH
@pytest.mark.parametrize(
    ("head", "what"),
    [
        # Lower than the travel height, and down again before the stations are released.
        (HEAD.replace("Z20.0000", "Z19.9000"), "Lift the head to Z 20.000 mm"),
        (
            HEAD.replace("Z20.0000\n", "Z20.0000\nG0 Z3.0000\n"),
            "moves the head before it switches off output",
        ),
        # Sideways or turned while a tool may be in the board.
        (
            HEAD.replace("Z20.0000", "X5.0000 Z20.0000"),
            "moves the head before it switches off output 0",
        ),
        (
            HEAD.replace("Z20.0000", "Z20.0000 C90.0000"),
            "moves the head before it switches off output 0",
        ),
        (
            HEAD.replace("G0 Z20.0000", "G0 X5.0000\nG0 Z20.0000"),
            "moves the head before it switches off",
        ),
        # Released in the board, and lifted afterwards.
        (
            HEAD.split("\n", 1)[1] + "G0 Z20.0000\n",
            "before the program has set the height of the head",
        ),
        (HEAD.replace("M65 P2\n", "M64 P2\n"), "lowers station 3 while"),
    ],
)
def test_only_lifts_may_come_before_all_states_are_set(
    program: bytes, head: str, what: str
) -> None:
    if head.endswith("M64 P2\nM5\n"):
        what = "lowers station 2 while station 3 may still be lowered"
    lines = program_findings(with_head(program, head))
    assert any(what in line for line in lines), lines


def test_the_first_lift_clears_the_longest_station() -> None:
    long = replace(MACHINE, stations=(replace(MACHINE.stations[0], z=6.0), *MACHINE.stations[1:]))
    lift = (
        "G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1\n"
        + HEAD.replace("M65 P0", "G4 P0\nM65 P0")
        + "G49\nM2\n"
    )
    low = program_findings(lift.encode(), long, drawn=False)
    assert "Only a lift straight up, to Z 26.000 mm or higher, may come earlier" in low[0]
    assert any("while axis Z is at 20.000 mm, which is too low" in line for line in low)
    assert program_findings(lift.replace("Z20.0000", "Z26.0000").encode(), long, drawn=False) == []


@BOTH
@pytest.mark.parametrize("lift", [None, "G0 Z17.0000"])
def test_a_station_is_changed_at_the_travel_height(program: bytes, lift: str | None) -> None:
    text = program.decode()
    at = text.index("G0 Z", text.index("F30000"))
    line = text[at : text.index("\n", at) + 1]
    mutant = text[:at] + ("" if lift is None else lift + "\n") + text[at + len(line) :]
    assert any("while axis Z is at" in found for found in program_findings(mutant.encode()))


@BOTH
def test_the_lift_before_the_last_release_is_needed(program: bytes) -> None:
    text = program.decode()
    at = text.rindex("G0 Z20.0000\n")
    lines = program_findings((text[:at] + text[at + 12 :]).encode())
    assert lines == [lines[0]]
    assert (
        "while axis Z is at 4.000 mm, which is too low. Lift the "
        "head to Z 20.000 mm before this program line." in lines[0]
    )


@BOTH
def test_a_station_is_lowered_after_the_previous_one_is_raised(program: bytes) -> None:
    text = program.decode()
    at = text.index("M65 P1\n", text.index("F30000"))
    down = text.index("M64 P2\n")
    swapped = text[:at] + "M64 P2\n" + text[at + 7 : down] + "M65 P1\n" + text[down + 7 :]
    assert any(
        "lowers station 3 while station 2 may still be lowered" in f
        for f in program_findings(swapped.encode())
    )


@BOTH
def test_a_spindle_is_not_started_again_in_the_board(program: bytes) -> None:
    plunge = "G1 Z1.0000 F6000\nG1 X79.8237 F24000"
    again = "G1 Z1.0000 F6000\nM5\nM3 S1\nG4 P0.15\nG1 X79.8237 F24000"
    lines = program_findings(changed(program, plunge, again))
    assert any("while axis Z is at 1.000 mm" in line for line in lines), lines


def test_a_program_without_work_must_set_all_states() -> None:
    bare = b"G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1\nG0 Z20.0000\nM2\n"
    assert program_findings(bare, drawn=False) == [
        f"The program never switches off {thing}, although an earlier program may have left it on. "
        f"Switch off {thing} at the beginning of the program."
        for thing in (
            "output 0 (M65 P0)",
            "output 1 (M65 P1)",
            "output 2 (M65 P2)",
            "the spindle (M5)",
        )
    ]


def test_a_station_without_an_output_needs_no_state() -> None:
    fixed = replace(MACHINE, stations=(replace(MACHINE.stations[0], output=-1),))
    bare = b"G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1\nG0 Z20.0000\nM5\nG4 P0.15\nG0 X5 Y5\nM2\n"
    assert program_findings(bare, fixed, drawn=False) == []


@pytest.mark.parametrize("height", [-1.4, 3.0, 19.9])
def test_no_head_goes_low_while_no_station_is_selected(height: float) -> None:
    # At the end of the program, after a dwell in which all stations have come up.
    program, end = GRBLHAL, GRBLHAL.rindex(b"M30")
    text = program[:end] + b"G4 P0.15\nG0 Z%.4f\n" % height + program[end:]
    lines = program_findings(text)
    assert any(f"goes down to {height:.2f} mm while no station" in line for line in lines), lines
    lifted = text.replace(b"G0 Z%.4f" % height, b"G0 Z20.0000")
    assert program_findings(lifted) == []
