"""``process``, compared with programs that can be checked by hand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.errors import LibraryError, ProgramError
from knifetip.library.load import machine
from knifetip.model.program import Program
from knifetip.model.tool import Cutter
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.post.emit import process
from knifetip.sequencing.linuxcnc import BLENDED
from tests.controllers.grbl_words import read_grbl
from tests.support.examples import examples
from tests.support.shapes import toolpath as toolpath_of

QUARTER = np.tan(np.radians(90) / 4)
TABLE = machine("demo-table")


#: Station, motion, (x, y, z, c), bulge and feed of a move.
Row = tuple[int, Motion, tuple[float, float, float, float], float, float]


def toolpath(*moves: Row) -> Toolpath:
    """Return a toolpath of these moves, from (0, 0, 20, 0)."""
    poses = [(0.0, 0.0, 20.0, 0.0), *[move[2] for move in moves]]
    rows = [(motion, feed, station) for station, motion, _, _, feed in moves]
    return toolpath_of(poses, rows, bulge=[move[3] for move in moves])


def rapid(x: float, y: float, z: float = 20.0, c: float = 0.0, station: int = 1) -> Row:
    return station, Motion.RAPID, (x, y, z, c), 0.0, 0.0


def feed(
    x: float,
    y: float,
    z: float = -0.3,
    c: float = 0.0,
    bulge: float = 0.0,
    station: int = 1,
) -> Row:
    return station, Motion.FEED, (x, y, z, c), bulge, 24000.0


def moves(program: Program) -> list[str]:
    """Return the lines of the moves of the toolpath."""
    rows = zip(program.lines(), program.source, strict=True)
    return [line.decode() for line, row in rows if row >= 0]


def linuxcnc(*rows: Row) -> list[str]:
    return moves(process(toolpath(*rows), TABLE, "linuxcnc"))


def grblhal(*rows: Row) -> list[str]:
    return moves(process(toolpath(*rows), TABLE, "grblhal"))


TWO_STATIONS = (
    rapid(100, 50, c=90, station=2),
    (2, Motion.PLUNGE, (100, 50, 1.2, 90), 0.0, 6000.0),
    (2, Motion.FEED, (100, 150, 1.2, 90), 0.0, 30000.0),
    (2, Motion.LIFT, (100, 150, 20, 90), 0.0, 6000.0),
    rapid(10, 10),
    (1, Motion.PLUNGE, (10, 10, -0.3, 0), 0.0, 6000.0),
    feed(20, 10),
    feed(30, 20, c=90, bulge=QUARTER),
    (1, Motion.SWIVEL, (30, 20, -0.3, 180), 0.0, 36000.0),
    feed(10, 20, c=180),
    (1, Motion.LIFT, (10, 20, 20, 180), 0.0, 6000.0),
)


def test_a_program_for_linuxcnc_leaves_datums_to_the_tool_table() -> None:
    program = process(
        toolpath(*TWO_STATIONS),
        TABLE,
        "linuxcnc",
        notes=["placement X20.0000 Y20.0000"],
    )
    assert program.text.decode().splitlines() == [
        "(placement X20.0000 Y20.0000)",
        "G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1",
        "G64 P0.0005 Q0.0005",
        "G0 Z20.0000",
        "M65 P0",
        "M65 P1",
        "M65 P2",
        "M5",
        "(station 2 Crease wheel)",
        "T2 M6 G43",
        "M64 P1",
        "G4 P0.15",
        "G0 X100.0000 Y50.0000 Z20.0000 C90.0000",
        "G1 Z1.2000 F6000",
        "G1 Y150.0000 F30000",
        "G1 Z20.0000 F6000",
        "(station 1 Oscillating knife)",
        "M65 P1",
        "T1 M6 G43",
        "M64 P0",
        "M3 S1",
        "G4 P0.15",
        "G0 X10.0000 Y10.0000 Z20.0000 C0.0000",
        "G1 Z-0.3000 F6000",
        "G1 X20.0000 F24000",
        "G4 P0",  # C begins to turn: LinuxCNC must not blend here
        "G3 X30.0000 Y20.0000 C90.0000 I0.0000 J10.0000",
        "G4 P0",
        "G93 G1 C180.0000 F400",  # 90 degrees at 36,000 a minute
        "G4 P0",
        "G94 G1 X10.0000 F24000",
        "G1 Z20.0000 F6000",
        "G0 Z20.0000",
        "M65 P0",
        "M65 P1",
        "M65 P2",
        "M5",
        "G49",
        "M2",
    ]
    rows = [-1] * 12 + [0, 1, 2, 3] + [-1] * 6 + [4, 5, 6, -1, 7, -1, 8, -1, 9, 10] + [-1] * 7
    assert program.source.tolist() == rows
    assert program.dialect == "linuxcnc"


def test_a_program_for_grblhal_has_the_datums_in_its_numbers() -> None:
    program = process(
        toolpath(*TWO_STATIONS), TABLE, "grblhal", notes=["placement X20.0000 Y20.0000"]
    )
    # The wheel's datum is X +60, Z -1.5; the quarter circle of r 10 is 15.708 mm at 24,000 mm/min.
    assert program.text.decode().splitlines() == [
        "(placement X20.0000 Y20.0000)",
        "G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1",
        "G0 Z20.0000",
        "G4 P0",
        "M65 P0",
        "M65 P1",
        "M65 P2",
        "M5",
        "M64 P1",
        "G4 P0.15",
        "G0 X160.0000 Y50.0000 Z18.5000 C90.0000",
        "G1 Z-0.3000 F6000",
        "G1 Y150.0000 F30000",
        "G1 Z18.5000 F6000",
        "G4 P0",
        "M65 P1",
        "M64 P0",
        "M3 S1",
        "G4 P0.15",
        "G0 X10.0000 Y10.0000 Z20.0000 C0.0000",
        "G1 Z-0.3000 F6000",
        "G1 X20.0000 F24000",
        "G93 G3 X30.0000 Y20.0000 C90.0000 I0.0000 J10.0000 F1527.89",
        "G93 G1 C180.0000 F400",
        "G94 G1 X10.0000 F24000",
        "G1 Z20.0000 F6000",
        "G0 Z20.0000",
        "G4 P0",
        "M65 P0",
        "M65 P1",
        "M65 P2",
        "M5",
        "G49",
        "M30",
    ]
    last = read_grbl(program.text)[-1]
    assert not last.outputs
    assert not last.oscillates


@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
def test_every_program_starts_and_ends_with_a_lift_and_then_releases_all_outputs(
    dialect: str,
) -> None:
    # Two stations share output 2, and one is mounted 4 mm above the others.
    wheel, cutter = TABLE.stations[1], replace(TABLE.stations[2], z=4.0)
    twin = replace(wheel, number=7, output=2)
    table = replace(TABLE, stations=(TABLE.stations[0], wheel, cutter, twin))
    rows = [rapid(1, 1), feed(2, 1), rapid(2, 1)]
    lines = process(toolpath(*rows), table, dialect).text.decode().splitlines()
    still = ["G4 P0"] if dialect == "grblhal" else []
    off = [*still, "M65 P0", "M65 P1", "M65 P2", "M5"]
    first = lines.index("G0 Z24.0000")
    assert not any(line.startswith(("G0", "G1", "M")) for line in lines[:first])
    assert lines[first + 1 : first + 1 + len(off)] == off
    last = ["G0 Z20.0000", *off, "G49", lines[-1]]
    assert lines[-len(last) :] == last


def test_the_first_lift_stays_within_the_travel() -> None:
    low = replace(TABLE, z=replace(TABLE.z, high=19.0))
    text = process(toolpath(rapid(1, 1, 10.0)), low, "grblhal").text
    assert b"G92.1\nG0 Z19.0000\n" in text


def test_leaving_the_oscillating_knife_stops_it_and_lifts_its_piston() -> None:
    rows = [rapid(1, 1), feed(2, 1), rapid(2, 1), rapid(5, 5, station=3)]
    lines = process(toolpath(*rows), TABLE, "linuxcnc").text.decode().splitlines()
    at = lines.index("(station 3 V-cutter)")
    assert lines[at + 1 : at + 6] == ["M65 P0", "M5", "T3 M6 G43", "M64 P2", "G4 P0.15"]


def test_stations_without_piston_and_settling_time_get_no_such_words() -> None:
    bare = replace(TABLE, stations=(replace(TABLE.stations[1], output=-1),), settle=0.0)
    text = process(toolpath(rapid(1, 1, station=2)), bare, "linuxcnc").text
    for word in (b"M64", b"M65", b"G4 ", b"M3"):
        assert word not in text


def test_the_first_move_of_a_station_has_words_for_all_axes() -> None:
    rows = [rapid(0, 0), feed(5, 0), rapid(5, 0), rapid(5, 0, station=2)]
    assert linuxcnc(*rows)[-1] == "G0 X5.0000 Y0.0000 Z20.0000 C0.0000"
    assert grblhal(*rows)[-1] == "G0 X65.0000 Y0.0000 Z18.5000 C0.0000"


def test_words_are_written_only_if_their_printed_value_changes() -> None:
    rows = [rapid(1, 1), feed(10, 1.00004), feed(10.00004, 2), feed(10.00004, 2)]
    assert linuxcnc(*rows) == [
        "G0 X1.0000 Y1.0000 Z20.0000 C0.0000",
        "G1 X10.0000 Z-0.3000 F24000",
        "G1 Y2.0000",
    ]


def test_a_move_that_rounds_to_zero_has_no_line_and_the_next_row_keeps_its_number() -> None:
    program = process(
        toolpath(rapid(1, 1), feed(2, 1), feed(2.00001, 1), feed(3, 1)),
        TABLE,
        "linuxcnc",
    )
    assert [row for row in program.source if row >= 0] == [0, 1, 3]


def test_a_thousand_steps_of_a_third_of_a_unit_do_not_drift() -> None:
    step = 0.0001 / 3
    rows = [rapid(0, 0), *(feed(step * n, 0) for n in range(1, 3001))]
    assert linuxcnc(*rows)[-1] == "G1 X0.1000"


def test_zero_is_printed_without_a_sign() -> None:
    rows = [rapid(-0.0, -0.00004, c=-0.00001), feed(3, -0.0), feed(-0.00004, -1.0)]
    assert not any("-0.0000" in line for line in linuxcnc(*rows) + grblhal(*rows))


def test_an_arc_is_consistent_with_its_rounded_ends() -> None:
    # The ends are not on the grid of printed numbers; the centre is computed from the printed ends.
    rows = [
        rapid(0.00003, 0),
        feed(0.00003, 0, -0.3),
        feed(10.00008, 10.00002, c=90, bulge=QUARTER),
    ]
    line = linuxcnc(*rows)[-1]
    assert line == "G3 X10.0001 Y10.0000 C90.0000 I0.0000 J10.0000"


def test_an_arc_to_the_right_is_g2_and_always_has_c() -> None:
    rows = [rapid(0, 0, c=30), feed(0, 0, c=30), feed(0, -20, c=30, bulge=-1)]
    assert linuxcnc(*rows)[-1] == "G2 X0.0000 Y-20.0000 C30.0000 I0.0000 J-10.0000"
    assert grblhal(*rows)[-1] == "G2 X0.0000 Y-20.0000 C30.0000 I0.0000 J-10.0000"


def test_a_helical_arc_has_z() -> None:
    rows = [rapid(0, 0), feed(0, 0), feed(0, 20, z=0.7, c=180, bulge=1)]
    assert linuxcnc(*rows)[-1] == "G3 X0.0000 Y20.0000 Z0.7000 C180.0000 I0.0000 J10.0000"


@pytest.mark.parametrize(("bow", "code"), [(0.00049, "G1"), (0.00051, "G3")])
def test_an_arc_flatter_than_half_a_micrometre_becomes_a_line(bow: float, code: str) -> None:
    rows = [rapid(0, 0), feed(0, 0), feed(20, 0, bulge=2 * bow / 20)]
    assert linuxcnc(*rows)[-1].split()[0] == code


@pytest.mark.parametrize(("radius", "code"), [(0.0019, "G1"), (0.0021, "G3")])
def test_an_arc_smaller_than_linuxcnc_reads_becomes_a_line(radius: float, code: str) -> None:
    rows = [rapid(0, 0), feed(0, 0), feed(2 * radius, 0, bulge=1)]
    assert linuxcnc(*rows)[-1].split()[0] == code


def test_a_tiny_arc_becomes_a_line_or_a_turn_without_travel() -> None:
    rows = [
        rapid(0, 0),
        feed(0, 0),
        feed(0.0006, 0, c=90, bulge=1),
        feed(0.0006, 0.00001, c=180),
    ]
    line, turn = linuxcnc(*rows)[2:]
    assert line.startswith("G93 G1 X0.0006 C90.0000 F")
    # Not faster than the C axis can turn: 90 degrees at 3,600 a second are 1 / 2400 of a minute.
    assert line.endswith("F2400")
    assert turn == "G93 G1 C180.0000 F2400"


def test_a_line_with_a_turn_of_c_uses_inverse_time() -> None:
    # 60 mm at 24,000 mm/min are 1 / 400 of a minute.
    rows = [rapid(0, 0), feed(0, 0), feed(60, 0, c=10), feed(60, 30, c=10)]
    for lines in (linuxcnc(*rows), grblhal(*rows)):
        assert lines[2:] == ["G93 G1 X60.0000 C10.0000 F400", "G94 G1 Y30.0000 F24000"]


def test_a_slow_move_by_inverse_time_keeps_six_figures() -> None:
    slow = (1, Motion.FEED, (1300.0, 0.0, -0.3, 10.0), 0.0, 100.0)
    assert linuxcnc(rapid(0, 0, -0.3), slow)[-1].endswith("F0.0769231")


def test_rapids_leave_inverse_time_too_and_a_run_never_ends_in_it() -> None:
    swivel = (1, Motion.SWIVEL, (0, 0, 20, 90), 0.0, 36000.0)
    lines = linuxcnc(rapid(0, 0), swivel, rapid(0, 0, 20, 180))
    assert lines[1:] == ["G93 G1 C90.0000 F400", "G94 G0 C180.0000"]
    text = process(toolpath(rapid(0, 0), swivel), TABLE, "grblhal").text
    assert b"G93 G1 C90.0000 F400\nG94\nG0 Z20.0000\n" in text


def test_the_feed_is_repeated_after_inverse_time() -> None:
    swivel = (1, Motion.SWIVEL, (0, 0, 20, 90), 0.0, 36000.0)
    slow = (1, Motion.FEED, (10, 0, 20, 90), 0.0, 400.0)
    lines = linuxcnc(rapid(0, 0), swivel, slow)
    assert lines[1:] == ["G93 G1 C90.0000 F400", "G94 G1 X10.0000 F400"]


def test_the_end_lifts_the_last_tool_by_its_own_datum() -> None:
    text = process(toolpath(rapid(1, 1, station=2)), TABLE, "grblhal").text
    assert text.endswith(b"G0 Z18.5000\nG4 P0\nM65 P0\nM65 P1\nM65 P2\nM5\nG49\nM30\n")


def exact_stops(*rows: Row) -> list[int]:
    """Return the rows after which LinuxCNC must stop exactly."""
    program = process(toolpath(*rows), TABLE, "linuxcnc")
    lines = program.lines()
    return [int(program.source[n - 1]) for n, line in enumerate(lines) if line == b"G4 P0"]


def test_linuxcnc_stops_exactly_if_c_starts_or_stops_turning_and_not_within_a_circle() -> None:
    start = [rapid(0, 0), feed(0, 0), feed(50, 0)]
    circle = [
        feed(60, 10, c=90, bulge=QUARTER),
        feed(50, 20, c=180, bulge=QUARTER),
        feed(40, 10, c=270, bulge=QUARTER),
    ]
    assert exact_stops(*start, *circle, feed(40, -50, c=270), feed(50, -50, c=270)) == [2, 5]
    # grblHAL needs no exact stops; its only dwells are before outputs.
    grblhal = process(toolpath(*start, *circle), TABLE, "grblhal").text
    assert grblhal.count(b"G4 P0\n") == grblhal.count(b"G4 P0\nM6") == 2


def test_linuxcnc_stops_exactly_between_arcs_that_bend_to_different_sides() -> None:
    wave = [feed(10, 10, c=90, bulge=QUARTER), feed(20, 20, c=0, bulge=-QUARTER)]
    assert exact_stops(rapid(0, 0), feed(0, 0), *wave) == [1, 2]


def test_linuxcnc_blends_slow_and_slight_bends() -> None:
    # From a line into an arc of r = 1,000 mm at v: aside = (v² / a)² / 2r, a = 8,000 mm/s².
    # 0.5 micrometres, a twentieth of the tolerance, are reached at 89.44 mm/s.
    c = np.degrees(4 * np.arctan(0.1))
    for speed, expected in ((89.4, []), (89.5, [2])):
        rows = [rapid(0, 0), (1, Motion.PLUNGE, (0, 0, -0.3, 0), 0.0, 6000.0)]
        rows.append((1, Motion.FEED, (100, 0, -0.3, 0), 0.0, speed * 60))
        end = (100 + 1000 * np.sin(np.radians(c)), 1000 * (1 - np.cos(np.radians(c))), -0.3, c)
        rows.append((1, Motion.FEED, end, 0.1, speed * 60))
        assert exact_stops(*rows) == expected


def test_a_tiny_move_at_its_feed_is_as_fast_as_its_feed() -> None:
    """0.006 mm up at 6000 mm/min take 0.06 ms, less than the least time of a move in G93."""
    start = rapid(0, 0), (1, Motion.PLUNGE, (0, 0, 2.8148, 0), 0.0, 6000.0)
    turn = (1, Motion.FEED, (0.0027, 0, 2.8148, 0.0062), 0.0, 30000.0)
    rise = (1, Motion.FEED, (0.0027, 0, 2.8208, 0.0062), 0.0, 6000.0)
    assert exact_stops(*start, turn, rise) == [1, 2]


def test_a_tool_turns_before_it_plunges_but_rapids_are_blended() -> None:
    rows = [rapid(0, 0), rapid(50, 50, c=90), rapid(50, 50, c=180), feed(50, 50, c=180)]
    assert exact_stops(*rows) == [2]


def test_a_drag_knife_swivels_at_its_swivel_feed() -> None:
    swing = (1, Motion.SWIVEL, (5.0, 5.0, -0.3, 90.0), QUARTER, 36000.0)
    for lines in (
        linuxcnc(rapid(0, 0, -0.3), swing),
        grblhal(rapid(0, 0, -0.3), swing),
    ):
        assert lines[-1] == "G93 G3 X5.0000 Y5.0000 C90.0000 I0.0000 J5.0000 F400"


def test_an_arc_too_large_for_32_bits_is_sent_to_grblhal_as_chords_that_stay_on_it() -> None:
    # 500 mm wide and 1 mm high: a radius of 31,250.5 mm.
    bulge = 2 * 1.0 / 500
    c = np.degrees(4 * np.arctan(bulge))
    rows = [
        rapid(0, 0, c=-c / 2),
        feed(0, 0, c=-c / 2),
        feed(500, 0, c=c / 2, bulge=bulge),
    ]
    assert linuxcnc(*rows)[-1].startswith("G3 X500.0000")
    program = process(toolpath(*rows), TABLE, "grblhal")
    chords = [line for line in read_grbl(program.text) if line.motion == "G1"][1:]
    assert len(chords) == 32  # bows of 1 mm / 32² < 0.001 mm
    ends = np.array([line.end for line in chords])
    np.testing.assert_array_equal(ends[-1], [500, 0, -0.3, np.round(c / 2, 4)])
    # Bulging to the left of eastward travel with a turn to the left: below the chord.
    off = np.hypot(ends[:, 0] - 250, ends[:, 1] - (31250.5 - 1.0)) - 31250.5
    assert np.abs(off).max() < 1e-4
    assert ends[15, 1] == pytest.approx(-1.0, abs=1e-4)
    assert [row for row in program.source if row >= 0] == [0, 1] + [2] * 32


def test_the_same_input_gives_the_same_bytes() -> None:
    first, second = (process(toolpath(*TWO_STATIONS), TABLE, "linuxcnc") for _ in range(2))
    assert first.text == second.text


@pytest.mark.parametrize(
    ("tolerance", "word"),
    [(0.001, "0.0001"), (0.004, "0.0002"), (0.01, "0.0005"), (1.0, "0.0005")],
)
def test_blending_takes_a_twentieth_of_the_tolerance_and_at_most_half_a_micrometre(
    tolerance: float, word: str
) -> None:
    text = process(toolpath(rapid(1, 1)), TABLE, "linuxcnc", tolerance=tolerance).text.decode()
    assert f"G64 P{word} Q{word}\n" in text


def test_stated_times_and_programs_have_the_same_blending() -> None:
    text = process(toolpath(rapid(1, 1)), TABLE, "linuxcnc").text.decode()
    assert f"G64 P{BLENDED:.4f} Q{BLENDED:.4f}\n" in text


@pytest.mark.parametrize("tolerance", [0.0, -1.0, 0.0001, 0.0009, float("nan")])
def test_a_tolerance_too_small_is_refused_because_p0_means_no_limit(tolerance: float) -> None:
    with pytest.raises(ProgramError, match="tolerance"):
        process(toolpath(rapid(1, 1)), TABLE, "linuxcnc", tolerance=tolerance)


def test_notes_cannot_contain_commands() -> None:
    notes = [
        "(PY,import os)",
        "hold! now? ~",
        "line\nG0 Z-50",
        "größe",
        "",
        "()",
        "x" * 200,
    ]
    for dialect in ("linuxcnc", "grblhal"):
        text = process(toolpath(rapid(1, 1)), TABLE, dialect, notes=notes).text.decode("ascii")
        assert text.splitlines()[:6] == [
            "(PY import os)",
            "(hold now)",
            "(line G0 Z-50)",
            "(gr e)",
            f"({'x' * 66})",
            "G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1",
        ]


def test_station_names_cannot_contain_commands() -> None:
    station = replace(TABLE.stations[0], name="knife)\nG0 Z-50 (PY,x")
    odd = replace(TABLE, stations=(station,))
    text = process(toolpath(rapid(1, 1)), odd, "linuxcnc").text.decode()
    assert "\n(station 1 knife G0 Z-50 PY x)\n" in text


@pytest.mark.parametrize(
    ("row", "words"),
    [
        (feed(float("nan"), 0), "Row 1 of the toolpath .cutting move, edge 1. has a value"),
        (feed(1, 1, bulge=float("inf")), "has a value that is not a number"),
        (
            (1, Motion.FEED, (1, 1, 1, 1), 0.0, float("nan")),
            "has a value that is not a number",
        ),
        ((1, Motion.FEED, (1, 1, 1, 1), 0.0, 0.0), "has no feed"),
        ((1, Motion.FEED, (1, 1, 1, 1), 0.0, -5.0), "has no feed"),
        ((1, Motion.FEED, (1, 1, 1, 1), 0.0, 1e12), "that is too fast for any machine"),
        (feed(1e9, 1), "is more than"),
        (feed(5, 5, bulge=1.5), "more than 180°"),
        ((1, Motion.RAPID, (1, 1, 1, 1), 0.5, 0.0), "rapid move along an arc"),
        ((1, 9, (1, 1, 1, 1), 0.0, 5.0), "unknown motion"),
        (
            (1, Motion.SWIVEL, (5, 0, 20, 0), 0.0, 5.0),
            "without rotating the tool",
        ),
    ],
)
@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
def test_a_move_that_cannot_be_written_is_refused_with_its_row(
    row: Row,
    words: str,
    dialect: str,
) -> None:
    with pytest.raises(ProgramError, match=words):
        process(toolpath(rapid(0, 0), row, rapid(1, 1)), TABLE, dialect)


def test_a_toolpath_without_moves_is_refused() -> None:
    empty = toolpath_of(np.zeros((1, 4)), [])
    with pytest.raises(ProgramError, match="no moves"):
        process(empty, TABLE, "grblhal")


def test_an_unknown_dialect_is_refused_with_the_known_ones() -> None:
    with pytest.raises(LibraryError, match=r"fanuc.*grblhal, .*linuxcnc"):
        process(toolpath(rapid(1, 1)), TABLE, "fanuc")


def test_an_unknown_station_is_refused_with_the_known_ones() -> None:
    with pytest.raises(
        ProgramError, match=r"demo-table does not have\. Choose one of the stations 1, 2, 3"
    ):
        process(toolpath(rapid(1, 1, station=7)), TABLE, "grblhal")


def test_a_station_that_does_not_start_with_a_rapid_is_refused() -> None:
    with pytest.raises(ProgramError, match=r"Row 1 .* starts a cut with station 2"):
        process(toolpath(rapid(1, 1), feed(2, 2, station=2)), TABLE, "linuxcnc")


def test_a_rotating_cutter_without_a_speed_is_refused() -> None:
    router = replace(TABLE.stations[0], tool=Cutter(3.0, 1000.0, 500.0))
    with pytest.raises(ProgramError, match="spindle speed of the cutter is 0"):
        process(toolpath(rapid(1, 1)), replace(TABLE, stations=(router,)), "grblhal")


@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
def test_a_spindle_starts_before_the_plunge_and_stops_after_the_lift(dialect: str) -> None:
    router = Cutter(3.0, 1000.0, 500.0, speed=18000.0, spin_up=2.5)
    table = replace(TABLE, stations=(replace(TABLE.stations[0], tool=router),))
    text = process(toolpath(rapid(1, 1), feed(5, 1, -0.3)), table, dialect).text
    head, work = text.split(b"M3 S18000\nG4 P2.5\n")
    assert b"G1 " not in head
    assert b"M5\n" in work
    # Only at the start of the program, before the station plunges.
    assert head.count(b"M5\n") == 1
    assert head.index(b"M5\n") < head.index(b"M64")


def test_the_longer_of_piston_and_spindle_time_is_used() -> None:
    router = Cutter(3.0, 1000.0, 500.0, speed=18000.0, spin_up=0.05)
    table = replace(TABLE, stations=(replace(TABLE.stations[0], tool=router),))
    text = process(toolpath(rapid(1, 1), feed(5, 1, -0.3)), table, "linuxcnc").text
    assert b"M3 S18000\nG4 P0.15\n" in text


def test_a_program_line_too_long_for_grbl_is_refused() -> None:
    # A helical arc with every number at its longest.
    rows = [
        rapid(-1234.5678, -1234.5678, c=-1080.1234),
        feed(-1234.5678, -1234.5678, -10.0, c=-1080.1234),
        feed(-1100.1234, -12000.1234, -11.1234, c=-1070.1234, bulge=-0.3),
    ]
    with pytest.raises(ProgramError, match="but grblhal accepts only 80"):
        process(toolpath(*rows), TABLE, "grblhal")


coordinate = st.floats(-2000, 2000, allow_nan=False)
steps = st.tuples(
    coordinate,
    coordinate,
    st.sampled_from([-0.3, 1.2]),
    st.floats(-1080, 1080),
    st.one_of(st.just(0.0), st.floats(-1, 1)),
    st.floats(100, 60000),
)


@examples(60)
@given(walk=st.lists(steps, min_size=1, max_size=20))
def test_the_program_for_grbl_matches_the_toolpath_within_half_a_unit(
    walk: list[tuple[float, float, float, float, float, float]],
) -> None:
    rows = [rapid(*walk[0][:2], c=walk[0][3], station=2)]
    height = walk[0][2]
    for x, y, z, c, bulge, speed in walk:
        # Only lines change Z: a helical arc with the longest numbers would not fit.
        rows.append((2, Motion.FEED, (x, y, height, c), bulge, speed))
        rows.append((2, Motion.FEED, (x, y, z, c), 0.0, speed))
        height = z
    path = toolpath(*rows)
    program = process(path, TABLE, "grblhal")
    read = read_grbl(program.text)
    assert len(read) == len(program.source)
    for line, row in zip(read, program.source, strict=True):
        if row < 0 or row in program.source[line.number :]:
            continue
        expected = path.pose[row + 1] + (60.0, 0.0, -1.5, 0.0)
        assert np.abs(line.end - expected).max() <= 0.5e-4 + 1e-9
        if line.centre is not None:
            start, end = path.pose[row : row + 2, :2] + (60.0, 0.0)
            chord = np.hypot(*(end - start))
            radius = chord * (1 + path.bulge[row] ** 2) / (4 * abs(path.bulge[row]))
            assert np.hypot(*(line.centre - line.start[:2])) == pytest.approx(
                radius, abs=3e-4, rel=1e-3
            )
            assert (line.motion == "G3") == (path.bulge[row] > 0)
