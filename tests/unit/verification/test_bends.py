"""Bends that a wheel or a blade cannot follow, with figures from elementary geometry."""

from __future__ import annotations

from dataclasses import replace
from math import degrees, hypot, pi, radians, sqrt, tan
from typing import Any

import numpy as np
import pytest

from knifetip import compensate, plan, process, sequence
from knifetip.library import load
from knifetip.model.board import Board
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine, Station
from knifetip.model.tool import CreaseWheel, Knife
from knifetip.model.toolpath import Motion
from knifetip.model.verdict import Finding, Severity
from knifetip.verification.curves.curve import arc_curves, line_curves
from knifetip.verification.curves.point_distance import distance_from_curves
from knifetip.verification.verify import verify
from tests.support.shapes import closed, dieline, edges

MACHINE, BOARD = load.machine("demo-table"), replace(load.board("b-flute"), grain=0.0)
OUTLINE = (LineType.CUT, closed((0, 0), (400, 0), (400, 300), (0, 300)))
QUARTER = tan(pi / 8.0)


def findings_of(line: Dieline, machine: Machine = MACHINE, board: Board = BOARD) -> list[Finding]:
    toolpath = sequence([compensate(one) for one in plan(line, machine, board)], machine)
    verdict = verify(process(toolpath, machine, "grblhal").text, line, (0.0, 0.0), machine, board)
    return [finding for finding in verdict.findings if finding.kind != "planned"]


def quarter(kind: LineType, radius: float) -> Dieline:
    """Return an outline and a quarter circle of a line type as edge 4."""
    arc = edges(((100, 100), (100 + radius, 100 + radius)))
    return dieline(OUTLINE, (kind, arc), bulge={4: QUARTER})


def arguments(finding: Finding) -> dict[str, Any]:
    return dict(finding.message.arguments)


def wheel_board(depth: float, permitted: float) -> Board:
    return replace(BOARD, crease_along=depth, crease_across=depth, crease_tolerance=permitted)


@pytest.mark.parametrize("radius", [10.0, 20.0, 80.0])
def test_a_wheel_presses_beside_a_tight_arc(radius: float) -> None:
    board = wheel_board(1.8, 0.25)
    [found] = findings_of(quarter(LineType.CREASE, radius), board=board)
    # R 15 pressed 1.8 deep touches 2 √(1.8 · 28.2) = 14.249 mm.
    half = sqrt(1.8 * 28.2)
    beside = hypot(radius, half) - radius
    assert (found.kind, found.edge, found.severity) == ("beside", 4, Severity.SHORTFALL)
    said = arguments(found)
    assert said["contact"] == pytest.approx(14.249, abs=1e-3)
    assert said["distance"] == pytest.approx(beside, rel=0.02, abs=0.01)
    # The wheel stops s + clearance before each end; the straight contact is within 0.25 mm of the
    # arc as far as √(2 · 0.25 r + 0.25²), measured along the tangent.
    reach = degrees(np.arctan2(sqrt(0.5 * radius + 0.0625), radius)) * pi / 180.0 * radius
    missed = 2.0 * max(0.0, half + board.end_clearance - reach)
    if missed < radius * pi / 2.0:
        assert said["length"] == pytest.approx(missed, abs=0.3)


def test_an_arc_that_the_contact_follows_within_the_tolerance_is_accepted() -> None:
    # At r = 101.4 mm a contact of half length 7.1246 mm is 0.25 mm beside the arc.
    assert findings_of(quarter(LineType.CREASE, 102.0), board=wheel_board(1.8, 0.25)) == []
    [found] = findings_of(quarter(LineType.CREASE, 100.0), board=wheel_board(1.8, 0.25))
    assert found.message.code == "verify.crease-too-bent"
    assert arguments(found)["radius"] == 102


def test_the_tolerance_is_that_of_the_board() -> None:
    assert findings_of(quarter(LineType.CREASE, 40.0), board=wheel_board(1.8, 0.7)) == []
    assert len(findings_of(quarter(LineType.CREASE, 40.0), board=wheel_board(1.8, 0.6))) == 1


def with_small_wheel(radius: float, width: float = 0.7) -> Machine:
    last = MACHINE.stations[-1]
    wheel = CreaseWheel(radius, width, 30000.0, 6000.0)
    station = Station(9, "Small wheel", wheel, 120.0, 0.0, -1.5, 0.0, last.output + 1)
    return replace(MACHINE, stations=(*MACHINE.stations, station))


def stations_used(line: Dieline, machine: Machine, board: Board) -> dict[int, set[int]]:
    """Return the rows of creases that each station makes."""
    return {
        operation.station: set(operation.source.tolist())
        for operation in plan(line, machine, board)
        if operation.line_type == LineType.CREASE
    }


def test_a_tight_arc_is_made_by_the_smaller_wheel_and_a_line_by_the_first() -> None:
    arc = edges(((100, 100), (140, 140)), ((200, 50), (200, 250)))
    line = dieline(OUTLINE, (LineType.CREASE, arc), bulge={4: QUARTER})
    board = wheel_board(1.8, 0.25)
    assert stations_used(line, with_small_wheel(5.0), board) == {2: {5}, 9: {4}}
    # √(40² + 1.8 · 8.2) − 40 = 0.184 mm
    assert findings_of(line, with_small_wheel(5.0), board) == []
    # A wheel of 7 mm is 0.273 mm beside the arc: the better of the two, and still a shortfall.
    assert stations_used(line, with_small_wheel(7.0), board) == {2: {5}, 9: {4}}
    [found] = findings_of(line, with_small_wheel(7.0), board)
    assert arguments(found)["wheel"] == 7.0


def test_edges_of_one_line_and_arc_get_one_wheel() -> None:
    chain = edges(((100, 50), (100, 100)), ((100, 100), (140, 140)), ((140, 140), (200, 140)))
    line = dieline(OUTLINE, (LineType.CREASE, chain), bulge={5: -QUARTER})
    used = stations_used(line, with_small_wheel(5.0), wheel_board(1.8, 0.25))
    assert used == {9: {4, 5, 6}}
    assert findings_of(line, with_small_wheel(5.0), wheel_board(1.8, 0.25)) == []


def hole(radius: float) -> Dieline:
    """Return an outline and a hole of two half circles, edges 4 and 5."""
    half = edges(
        ((200 - radius, 150), (200 + radius, 150)), ((200 + radius, 150), (200 - radius, 150))
    )
    return dieline(OUTLINE, (LineType.CUT, half), bulge={4: 1.0, 5: 1.0})


def knife_of(machine: Machine) -> Knife:
    knife = machine.stations[0].tool
    assert isinstance(knife, Knife)
    return knife


@pytest.mark.parametrize(("radius", "severity"), [(1.0, "shortfall"), (3.0, "note"), (9.0, "note")])
def test_a_blade_that_turns_in_the_board_is_reported(radius: float, severity: str) -> None:
    knife = knife_of(MACHINE)
    [found] = findings_of(hole(radius))
    ahead = (BOARD.caliper + MACHINE.into_mat) * tan(radians(knife.blade_angle))
    said = arguments(found)
    assert found.severity == severity
    assert found.edge in (4, 5)
    assert said["radius"] == pytest.approx(radius, abs=1e-3)
    assert said["top"] == pytest.approx(hypot(radius, ahead) - radius, abs=2e-3)
    assert said["rear"] == pytest.approx(hypot(radius, knife.blade_width) - radius, rel=0.1)
    assert said["turn"] == pytest.approx(degrees(knife.blade_width / radius), rel=0.01)


def test_a_wide_arc_needs_no_note() -> None:
    # 3 mm of a radius of 12 mm turn by 14.3°, less than the swivel angle of 15°.
    assert findings_of(hole(12.0)) == []


def ring_of_chords(step: float) -> Dieline:
    turn = np.radians(np.arange(0.0, 360.0, step))
    ring = closed(*map(tuple, np.column_stack([200 + 2 * np.cos(turn), 150 + 2 * np.sin(turn)])))
    return dieline(OUTLINE, (LineType.CUT, ring))


def plunges(line: Dieline) -> int:
    toolpaths = [compensate(one) for one in plan(line, MACHINE, BOARD)]
    return sum(int(np.count_nonzero(one.motion == Motion.PLUNGE)) for one in toolpaths)


def test_chords_below_the_swivel_angle_are_a_bend() -> None:
    [found] = findings_of(ring_of_chords(3.0))
    assert (found.kind, found.severity) == ("beside", Severity.NOTE)
    # Chords of 3° on a radius of 2 mm are 0.10471 mm long: the blade turns as on r = 1.9998 mm.
    assert arguments(found)["radius"] == pytest.approx(1.9998, abs=1e-3)
    assert arguments(found)["turn"] > 70.0


def test_a_blade_is_lifted_at_the_corners_of_a_bend() -> None:
    line = ring_of_chords(10.0)
    assert findings_of(line) == []
    # The ring starts in the middle of a chord of 0.349 mm, is lifted at 36 joints, and repeats its
    # first T tan 10° = 0.529 mm, over two joints.  The outline has four corners.
    assert plunges(line) == 1 + 36 + 2 + 4


def test_one_corner_below_the_swivel_angle_is_no_bend() -> None:
    ahead = (200.0 + 50.0 * np.cos(np.radians(14.0)), 150.0 + 50.0 * np.sin(np.radians(14.0)))
    line = dieline(OUTLINE, (LineType.CUT, edges(((150, 150), (200, 150)), ((200, 150), ahead))))
    assert findings_of(line) == []
    assert plunges(line) == 1 + 4


def test_the_least_radius_of_blade_and_board_is_a_shortfall() -> None:
    assert [one.severity for one in findings_of(hole(9.0))] == [Severity.NOTE]
    [found] = findings_of(hole(9.0), board=replace(BOARD, least_radius=9.5))
    assert (found.severity, arguments(found)["least"]) == (Severity.SHORTFALL, 9.5)
    tool = replace(knife_of(MACHINE), least_radius=10.0)
    stations = (replace(MACHINE.stations[0], tool=tool), *MACHINE.stations[1:])
    [found] = findings_of(hole(9.0), replace(MACHINE, stations=stations))
    assert (found.severity, arguments(found)["least"]) == (Severity.SHORTFALL, 10.0)


def test_sharp_corners_are_no_bends() -> None:
    assert findings_of(dieline(OUTLINE)) == []


def test_distances_from_lines_and_arcs() -> None:
    line = line_curves(np.array([[0.0, 0.0]]), np.array([[10.0, 0.0]]))
    arc = arc_curves(np.array([[20.0, 0.0]]), np.array([[25.0, 0.0]]), np.array([pi / 2.0]))
    points = np.array([[5.0, 3.0], [-3.0, 4.0], [20.0, 2.0], [20.0, -5.0], [25.0, -1.0]])
    curves = np.concatenate([line, arc])
    expected = [3.0, 5.0, 3.0, hypot(5.0, 5.0), 1.0]
    assert distance_from_curves(points, curves) == pytest.approx(expected)
    assert distance_from_curves(points, curves[:0]).tolist() == [np.inf] * 5
