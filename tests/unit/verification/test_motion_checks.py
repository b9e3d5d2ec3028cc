from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from knifetip.model.machine import Machine
from knifetip.model.verdict import Finding
from knifetip.verification.verify import verify
from tests.support.programs.handwritten import (
    BOARD,
    DIELINE,
    GRBLHAL,
    LINUXCNC,
    MACHINE,
    PLACEMENT,
    changed,
    cutter_program,
    dieline,
    knife_program,
    wheel_program,
)
from tests.support.shapes import with_dimensions


def findings(text: bytes) -> list[Finding]:
    return list(verify(text, DIELINE, PLACEMENT, MACHINE, BOARD).findings)


def findings_without_dieline(text: bytes) -> list[Finding]:
    """Return the findings about a program with an empty dieline."""
    return list(verify(text, dieline(), PLACEMENT, MACHINE, BOARD).findings)


@pytest.mark.parametrize(
    ("old", "new", "line", "expected"),
    [
        ("G1 Y65.6000 F30000", "G1 Y65.6000 F30001", 18, "30,001 mm/min instead of 30,000"),
        ("G1 Z1.4000 F6000", "G1 Z1.4000 F5999", 17, "5,999 mm/min instead of 6,000"),
        ("G1 X110.0000 F24000", "G1 X110.0000 F34000", 57, "34,000 mm/min instead of 24,000"),
    ],
)
def test_a_feed_that_is_not_the_tools_own_is_found(
    old: str, new: str, line: int, expected: str
) -> None:
    found = [finding for finding in findings(changed(LINUXCNC, old, new)) if finding.line == line]
    assert found[0].kind == "feed"
    assert expected in found[0].text


def test_a_timed_arc_that_takes_another_time_is_found() -> None:
    arc = "X120.0000 Y30.0000 C90.0000 I0.0000 J10.0000 F1527.887"
    found = findings(changed(GRBLHAL, arc, arc.replace("1527", "1627")))
    assert [(finding.kind, finding.line) for finding in found] == [("feed", 52)]
    # 15.708 mm at 24,000 mm/min
    assert "takes 0.0369 s instead of 0.0393 s" in found[0].text


def test_c_must_not_share_a_feed_in_mm_per_minute() -> None:
    arc = "G93 G3 X120.0000 Y30.0000 C90.0000 I0.0000 J10.0000 F1527.887\nG94 G1 Y70.0000 F24000"
    plain = "G3 X120.0000 Y30.0000 C90.0000 I0.0000 J10.0000\nG1 Y70.0000"
    found = findings(changed(GRBLHAL, arc, plain))
    assert [(finding.kind, finding.line) for finding in found] == [("feed", 52)]
    assert "C turns by 90.0000°" in found[0].text


def test_a_rapid_in_the_board_is_found_with_its_depth() -> None:
    found = findings(changed(LINUXCNC, "G1 Y65.6000 F30000", "G0 Y65.6000"))
    assert any(
        finding.kind == "stray" and finding.line == 18 and finding.measure == pytest.approx(0.6)
        for finding in found
    )


def test_a_rapid_after_a_lift_that_stays_in_the_board_is_found() -> None:
    found = findings(changed(LINUXCNC, "G1 Y65.6000 F30000\nG1 Z4", "G1 Y65.6000 F30000\nG1 Z1.9"))
    assert any(finding.kind == "stray" and finding.line == 20 for finding in found)


def test_a_plunge_across_the_tilted_blade_is_found() -> None:
    # Straight down instead of along the blade: 1.3 mm deep at 45° is 1.3 mm sideways.
    text = cutter_program(
        "G0 X41.5 Y44 Z20 C0", "G0 Z4", "G1 Z0.7 F3000", "G1 X81.5 F12000", "G1 Z4 F3000"
    )
    found = [finding for finding in findings_without_dieline(text) if finding.kind == "deviation"]
    assert [finding.line for finding in found] == [13, 15]
    assert [finding.measure for finding in found] == pytest.approx([1.3, 1.3])


def test_a_knife_that_travels_while_it_plunges_is_found() -> None:
    text = knife_program("G0 X41.5 Y44 Z20 C0", "G0 Z4", "G1 X42 Z-0.3 F6000", "G1 Z4")
    found = [finding for finding in findings_without_dieline(text) if finding.kind == "deviation"]
    # 2.3 of the 4.3 mm down are in the board, and so are as much of the 0.5 mm across.
    assert found[0].measure == pytest.approx(0.5 * 2.3 / 4.3)


def test_a_knife_may_turn_in_the_board_by_its_swivel_angle_and_no_more() -> None:
    def turned(degrees: float) -> list[str]:
        # 3,600 degrees a second are 216,000 a minute.
        text = knife_program(
            "G0 X41.5 Y44 Z20 C0",
            "G0 Z4",
            "G1 Z-0.3 F6000",
            "G4 P0",
            f"G93 G1 C{degrees} F{216000.0 / degrees:.4f}",
            "G4 P0",
            "G94 G1 Z4 F6000",
        )
        return [
            finding.kind for finding in findings_without_dieline(text) if finding.kind != "stray"
        ]

    assert turned(15.0) == []
    assert turned(16.0) == ["heading"]


def test_a_wheel_must_not_turn_in_place() -> None:
    text = wheel_program(
        "G0 X90 Y40 Z20 C90",
        "G0 Z4",
        "G1 Z1.4 F6000",
        "G93 G1 C85 F43200",
        "G94 G1 Z4 F6000",
    )
    assert "heading" in [finding.kind for finding in findings_without_dieline(text)]


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("M64 P1\n", "M64 P2\n", "Station 2 processes the board while its output 1 is off"),
        (
            "\nM65 P1\nT3",
            "\nM64 P1\nT3",
            "Station 3 processes the board while station 2 is also lowered",
        ),
        (
            "\nM65 P2\nT1",
            "\nM64 P2\nT1",
            "Station 1 processes the board while station 3 is also lowered",
        ),
        ("M3 S1\n", "M5\n", "oscillating knife cuts while"),
        (
            "M64 P1\n",
            "M64 P1\nM3 S1\n",
            "Station 2 processes the board while the oscillation is on",
        ),
    ],
)
def test_outputs_must_be_those_of_the_station_at_work(old: str, new: str, expected: str) -> None:
    text = LINUXCNC.replace(old.encode(), new.encode(), 1)
    found = [finding for finding in findings(text) if finding.kind == "program"]
    assert any(expected in finding.text for finding in found), found


@pytest.mark.parametrize(
    ("line", "axis", "past"),
    [
        ("G0 X901 Y0 Z20 C0", "X", 1.0),
        ("G0 X0 Y-10.5 Z20 C0", "Y", 0.5),
        ("G0 X0 Y0 Z61 C0", "Z", 1.0),
        ("G0 X0 Y0 Z20 C1080.5", "C", 0.5),
    ],
)
def test_a_joint_past_its_travel_is_found(line: str, axis: str, past: float) -> None:
    found = findings_without_dieline(knife_program(line))
    assert [finding.kind for finding in found] == ["travel"]
    assert f"Axis {axis}" in found[0].text
    assert found[0].measure == pytest.approx(past)


def test_the_travel_includes_the_datum() -> None:
    # 860 + 60 for the wheel's station is 20 past 900.
    found = findings_without_dieline(wheel_program("G0 X860 Y0 Z20 C0"))
    assert [finding.kind for finding in found] == ["travel"]
    assert found[0].measure == pytest.approx(20.0)


def test_the_travel_includes_the_extreme_points_of_arcs() -> None:
    text = knife_program("G0 X895 Y100 Z20 C-90", "G3 X895 Y120 C90 I0 J10 F24000")
    found = [finding for finding in findings_without_dieline(text) if finding.kind == "travel"]
    assert [round(finding.measure, 6) for finding in found] == [5.0]


def test_a_feed_from_an_unknown_position_is_found() -> None:
    found = findings_without_dieline(knife_program("G1 X5 F24000"))
    assert any("a position that the program has not set" in finding.text for finding in found)


def test_the_time_is_the_sum_of_feeds_rapids_and_dwells() -> None:
    text = knife_program("G0 X0 Y0 Z20 C0", "G0 X150 Y30", "G1 X550 F24000")
    verdict = verify(text, dieline(), PLACEMENT, MACHINE, BOARD)
    # 150 mm at 1,500 mm/s, 400 mm at 400 mm/s, 0.15 s for the piston.
    assert verdict.seconds == pytest.approx(0.1 + 1.0 + 0.15)


def headings(text: bytes, machine: Machine = MACHINE) -> list[Finding]:
    """Return the findings about headings of a program with an empty dieline."""
    found = verify(text, dieline(), PLACEMENT, machine, BOARD).findings
    return [finding for finding in found if finding.kind == "heading"]


@pytest.mark.parametrize("turns", [360, -360, 720])
@pytest.mark.parametrize("end", ["C90.0000 I0", "C180.0000 I-10", "C270.0000 I0", "C360.0000 I10"])
def test_a_blade_turns_by_the_same_angle_as_its_arc(end: str, turns: int) -> None:
    word, _ = end.split()
    turned = end.replace(word, f"C{float(word[1:]) + turns:.4f}")
    found = findings(changed(LINUXCNC, end, turned))
    line = 1 + LINUXCNC[: LINUXCNC.index(end.encode())].count(b"\n")
    matching = [finding for finding in found if finding.line == line and finding.kind == "heading"]
    assert matching
    assert matching[0].measure == pytest.approx(abs(turns))
    assert (
        f"C turns by {90.0 + turns:.3f}° in the board, although the path of the tool turns by 90"
        in (matching[0].text)
    )


@pytest.mark.parametrize("turned", [360.0, -360.0, 180.0, 3.0])
@pytest.mark.parametrize(
    ("program", "down", "speed"),
    [
        (knife_program, "G1 Z-0.3 F6000", 24000.0),
        (wheel_program, "G1 Z1.4 F6000", 30000.0),
        (cutter_program, "G1 Y40.7 Z0.7 F3000", 12000.0),
    ],
)
def test_a_tool_does_not_turn_along_a_line(
    program: Callable[..., Any], down: str, speed: float, turned: float
) -> None:
    def along(degrees: float) -> list[Finding]:
        plunge = down.replace("40.7", "37.4")
        return headings(
            program(
                "G0 X40 Y40.7 Z20 C0" if "Y" in down else "G0 X40 Y40 Z20 C0",
                "G0 Z4",
                plunge,
                f"G93 G1 X80 C{degrees} F{speed / 40.0:.4f}",
                "G94 G1 Z20 F6000",
            )
        )

    assert not [finding for finding in along(0.0) if "although the path" in finding.text]
    knife = program is knife_program
    matching = [finding for finding in along(turned) if "although the path" in finding.text]
    # A knife may turn by its swivel angle: what it then cuts is compared with the drawing.
    assert bool(matching) == (not knife or abs(turned) > 15.0)


@pytest.mark.parametrize(("end", "fine"), [(90.0, True), (-90.0, False), (270.0, False)])
def test_a_wheel_turns_by_the_same_angle_as_its_arc(end: float, fine: bool) -> None:
    text = wheel_program(
        "G0 X40 Y40 Z20 C0",
        "G0 Z4",
        "G1 Z1.4 F6000",
        f"G3 X80 Y80 C{end} I0 J40 F30000",
        "G1 Z20 F6000",
    )
    assert bool(headings(text)) != fine


def test_a_knife_turns_by_at_most_half_a_turn_in_the_board() -> None:
    free = with_dimensions(MACHINE.stations[0].tool, swivel=360.0)
    machine = replace(
        MACHINE, stations=(replace(MACHINE.stations[0], tool=free), *MACHINE.stations[1:])
    )

    def swivelled(degrees: float) -> list[Finding]:
        text = knife_program(
            "G0 X40 Y40 Z20 C0",
            "G0 Z4",
            "G1 Z-0.3 F6000",
            "G4 P0",
            f"G93 G1 C{degrees} F{216000.0 / abs(degrees):.4f}",
            "G4 P0",
            "G94 G1 Z20 F6000",
        )
        return headings(text, machine)

    assert swivelled(-90.0) == []
    assert (
        "270.000° while the tool is in the board, but at most 180.01°" in swivelled(270.0)[0].text
    )


def test_a_tool_may_turn_along_a_short_line_only_if_it_replaces_a_tiny_arc() -> None:
    def turned(length: float) -> list[Finding]:
        text = knife_program(
            "G0 X40 Y40 Z20 C0",
            "G0 Z4",
            "G1 Z-0.3 F6000",
            f"G93 G1 X{40 + length:.4f} C60 F3600",
            "G94 G1 Z20 F6000",
        )
        return headings(text)

    # 60° over 0.008 mm bow by 0.001 mm; controllers reject such arcs.
    assert turned(0.008) == []
    assert turned(0.02)
    assert turned(0.0005)


def test_a_first_move_sideways_from_an_unknown_height_is_found() -> None:
    for first in ("G0 X5 Y5 Z20", "G0 C90 Z20", "G0 Y5"):
        text = changed(GRBLHAL, "G0 Z20.0000\nG4 P0\nM65 P0\nM65 P1", f"{first}\nM65 P0\nM65 P1")
        found = [finding for finding in findings(text) if finding.line == 3]
        assert any("a position that the program has not set" in finding.text for finding in found)


@pytest.mark.parametrize("which", range(8))
def test_linuxcnc_needs_an_exact_stop_where_c_starts_or_stops_turning(which: int) -> None:
    lines = LINUXCNC.decode().split("\n")
    stops = [row for row, line in enumerate(lines) if line == "G4 P0"]
    assert len(stops) == 8
    del lines[stops[which]]
    found = findings("\n".join(lines).encode())
    assert [(each.message.code, each.line) for each in found] == [
        ("verify.moves-overlap", stops[which] + 1)
    ]
    # On the radius of 10 mm at 400 mm/s C turns at 40 rad/s (2,292°/s) and starts in 0.0637 s.
    # In this time the head travels 25.46 mm: 25.46² / (2 · 10).
    assert found[0].measure == pytest.approx(32.42, abs=0.01)


def test_a_slow_arc_needs_no_exact_stop() -> None:
    slow = replace(MACHINE.stations[0], tool=with_dimensions(MACHINE.stations[0].tool, feed=1800.0))
    machine = replace(MACHINE, stations=(slow, *MACHINE.stations[1:]))
    text = LINUXCNC.replace(b"F24000", b"F1800").replace(b"G4 P0\n", b"")
    # 30 mm/s: the overlap is 0.11 mm long, and separates the paths by 0.0006 mm.
    assert not verify(text, DIELINE, PLACEMENT, machine, BOARD).findings


def test_a_turn_in_place_must_not_overlap_a_move() -> None:
    def codes(*stops: str) -> list[tuple[str, int]]:
        text = knife_program(
            "G0 X41.5 Y44 Z20 C0",
            "G0 Z4",
            "G1 Z-0.3 F6000",
            "G1 X50 F24000",
            *stops[:1],
            "G93 G1 C15 F14400",
            *stops[1:],
            "G94 G1 X60 Y46.6795 F24000",
            "G1 Z4 F6000",
        )
        found = findings_without_dieline(text)
        return [(each.message.code, each.line) for each in found if each.kind == "heading"]

    assert codes("G4 P0", "G4 P0") == []
    assert codes() == [("verify.turn-overlaps", 16), ("verify.turn-overlaps", 17)]


@pytest.mark.parametrize("program", [knife_program, cutter_program])
def test_a_blade_does_not_plunge_without_a_move(program: Callable[..., bytes]) -> None:
    rise = "Y42 " if program is cutter_program else ""
    text = program("G0 X60 Y42 Z20 C0", "G0 Z4", "G1 Z0.7 F3000", f"G1 {rise}Z4")
    codes = [each.message.code for each in findings(text)]
    assert "verify.plunge-without-move" in codes
