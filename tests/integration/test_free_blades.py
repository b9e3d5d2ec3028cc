"""Drag knives that turn by themselves: programs of HPGL cutters and three-axis tables, and wrong
ones.
"""

from __future__ import annotations

import math
import re
import tomllib
from dataclasses import replace
from importlib import resources
from typing import Any

import numpy as np
import pytest

from knifetip import compensate, plan, process, sequence
from knifetip.errors import LibraryError
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine
from knifetip.model.tool import Knife, Laser
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.model.verdict import Severity, Verdict
from knifetip.planning.questions import tool_questions
from knifetip.verification.verify import verify
from tests.support.shapes import closed, dieline, edges

BOARD = load.board("fbb-0.4")
MACHINES = ("drag-knife-table", "drag-knife-hpgl")
CUT, HALF = LineType.CUT, LineType.HALF_CUT
#: A window in a blank with an arc, a slit inside, and a half-cut.
LINE = dieline(
    (CUT, closed((100, 100), (300, 100), (300, 250), (100, 250))),
    (CUT, closed((150, 150), (200, 150), (180, 200))),
    (CUT, edges(((220, 200), (260, 230)))),
    (HALF, edges(((110, 200), (140, 120)))),
    bulge={2: 0.3},
)
SQUARE = dieline((CUT, closed((100, 100), (200, 100), (200, 200), (100, 200))))


def machine(name: str, **changes: Any) -> Machine:
    found = load.machine(name)
    (held,) = found.stations
    assert isinstance(held.tool, Knife)
    return replace(found, stations=(replace(held, tool=replace(held.tool, **changes)),))


def toolpath(table: Machine, line: Dieline = LINE) -> Toolpath:
    return sequence([compensate(one) for one in plan(line, table, BOARD)], table)


def judged(text: bytes, table: Machine, line: Dieline = LINE) -> Verdict:
    return verify(text, line, (0.0, 0.0), table, BOARD)


def codes(verdict: Verdict, severity: Severity = Severity.FAULT) -> set[str]:
    return {one.message.code for one in verdict.findings if one.severity is severity}


@pytest.mark.parametrize("line", [LINE, SQUARE], ids=["blank", "square"])
@pytest.mark.parametrize("name", MACHINES)
def test_the_programs_are_accepted(name: str, line: Dieline) -> None:
    table = machine(name)
    text = process(toolpath(table, line), table).text
    verdict = judged(text, table, line)
    assert verdict.findings == ()
    assert not re.search(rb"[ABC]-?\d+\.\d", text)  # no axis for the heading
    # The deviation of the tip is at most the resolution of the device.
    limit = 0.001 if name == "drag-knife-table" else 0.025
    assert verdict.path_deviation.max() < limit
    assert verdict.uncut.max() == 0.0


@pytest.mark.parametrize("radius", [0.08, 0.1, 0.15])
@pytest.mark.parametrize("name", MACHINES)
def test_the_round_ends_of_narrow_slots_are_cut(name: str, radius: float) -> None:
    """The axis, 0.75 mm ahead, travels up to nine times as far as the tip."""
    corners = closed(
        *((100, 100), (150 - radius, 100), (150 - radius, 130), (150 + radius, 130)),
        *((150 + radius, 100), (200, 100), (200, 200), (100, 200)),
    )
    line = dieline((CUT, corners), bulge={2: -1.0})
    table = machine(name)
    text = process(toolpath(table, line), table).text
    verdict = judged(text, table, line)
    assert codes(verdict) == set()
    assert verdict.uncut.max() == 0.0


@pytest.mark.parametrize("depth", [0.0, 0.1])
def test_the_axis_swings_about_every_corner(depth: float) -> None:
    """Planned poses against figures by hand: a square of 100 mm, e = 0.75 mm."""
    table = machine("drag-knife-table", swivel_depth=depth, blade_angle=0.0)
    moves = toolpath(table, SQUARE)
    cuts = np.flatnonzero((moves.motion == Motion.FEED) & (moves.bulge == 0.0))
    swings = np.flatnonzero(moves.bulge != 0.0)
    # Four corners; the track begins and ends in the middle of a side along which the blade parks.
    assert len(cuts) == 5
    length = np.hypot(*(moves.pose[cuts + 1, :2] - moves.pose[cuts, :2]).T)
    assert length.sum() == pytest.approx(400.0)
    corners = [
        row for row in swings if abs(moves.bulge[row]) == pytest.approx(math.tan(math.pi / 8))
    ]
    assert len(corners) == 4
    for row in corners:
        start, end = moves.pose[row, :2], moves.pose[row + 1, :2]
        assert math.hypot(*(end - start)) == pytest.approx(0.75 * math.sqrt(2.0))
        c = math.radians(float(moves.pose[row, 3]))
        tip = start - 0.75 * np.array([math.cos(c), math.sin(c)])
        assert np.abs(np.round(tip / 100.0) * 100.0 - tip).max() < 1e-9
        expected = -table.into_mat if depth == 0.0 else BOARD.caliper - depth
        assert moves.pose[row + 1, 2] == pytest.approx(expected)
    assert moves.feed[swings] == pytest.approx(6000.0)


@pytest.mark.parametrize(("turn", "lifts"), [(14.0, 0), (16.0, 1)])
def test_the_blade_stays_down_at_joints_of_less_than_its_swivel_angle(
    turn: float, lifts: int
) -> None:
    direction = math.radians(turn)
    far = (150.0 + 50.0 * math.cos(direction), 100.0 + 50.0 * math.sin(direction))
    line = dieline((CUT, edges(((100, 100), (150, 100)), ((150, 100), far))))
    table = machine("drag-knife-table", blade_angle=0.0)
    moves = toolpath(table, line)
    text = process(moves, table).text
    assert judged(text, table, line).findings == ()
    # The blade is parked along the first line, and is turned back at the end of the second one.
    shallow = BOARD.caliper - 0.1
    swings = (moves.bulge != 0.0) & (np.abs(moves.pose[1:, 2] - shallow) < 1e-9)
    assert int(swings.sum()) == lifts + 1
    # A blade that may turn by 10° only would be turned too deep by the same program.
    blade = table.stations[0].tool
    assert isinstance(blade, Knife)
    planned = replace(blade, swivel=10.0)
    strict = replace(table, stations=(replace(table.stations[0], tool=planned),))
    assert codes(judged(text, strict, line)) == (set() if lifts else {"verify.deep-swivel"})


def test_an_arc_of_the_line_is_an_arc_of_the_axis() -> None:
    line = dieline((CUT, edges(((150, 100), (100, 150)))), bulge={0: math.tan(math.pi / 8)})
    table = machine("drag-knife-table")
    moves = toolpath(table, line)
    (row,) = np.flatnonzero(
        (moves.bulge != 0.0) & (np.hypot(*np.diff(moves.pose[:, :2], axis=0).T) > 10.0)
    )
    away = np.hypot(*(moves.pose[row : row + 2, :2] - 100.0).T)
    assert away == pytest.approx(math.hypot(50.0, 0.75))


@pytest.mark.parametrize("park", [0.0, 90.0, -135.0])
@pytest.mark.parametrize("name", MACHINES)
def test_each_program_begins_and_ends_with_the_park_heading(name: str, park: float) -> None:
    table = machine(name, park_heading=park)
    made = toolpath(table)
    text = process(made, table).text
    assert judged(text, table).findings == ()
    working = np.flatnonzero(made.motion != Motion.RAPID)
    assert (made.pose[[working[0], working[-1] + 1], 3] - park + 180.0) % 360.0 - 180.0 == (
        pytest.approx(0.0, abs=1e-9)
    )
    (note,) = made.notes
    assert note.arguments["degrees"] == park
    # With the blade turned by a quarter at the start, the beginning of the first cut is wrong.
    wrong = machine(name, park_heading=park + 90.0)
    assert codes(judged(text, wrong)) - {"verify.blade-not-parked"}


@pytest.mark.parametrize("factor", [0.8, 1.2])
@pytest.mark.parametrize("name", MACHINES)
def test_a_wrong_trail_is_refused(name: str, factor: float) -> None:
    table = machine(name)
    wrong = machine(name, trail=0.75 * factor)
    for line in (LINE, SQUARE):
        assert codes(judged(process(toolpath(wrong, line), wrong).text, table, line))


def without_swings(made: Toolpath, only: int = -1) -> Toolpath:
    """Return a toolpath whose axis moves straight on where it should swing about the tip.

    ``only`` is the index of the swing that is left out; -1 leaves out all of them.
    """
    length = np.hypot(*np.diff(made.pose[:, :2], axis=0).T)
    swings = np.flatnonzero((made.bulge != 0.0) & (length < 1.6))
    rows = swings if only < 0 else swings[only : only + 1]
    keep = np.setdiff1d(np.arange(len(made)), rows)
    # The pose before a swing is left out, so that the next move leads there directly.
    return made.with_moves(keep, np.concatenate([made.pose[:1], made.pose[keep + 1]]))


@pytest.mark.parametrize("name", MACHINES)
def test_a_program_without_its_swings_is_refused(name: str) -> None:
    table = machine(name, swivel_depth=0.0)
    made = toolpath(table, SQUARE)
    swings = int(np.count_nonzero(made.bulge))
    assert swings == 4
    for left_out in range(swings):
        text = process(without_swings(made, left_out), table).text
        assert codes(judged(text, table, SQUARE)), left_out
    assert codes(judged(process(without_swings(made), table).text, table, SQUARE))


@pytest.mark.parametrize("name", MACHINES)
@pytest.mark.parametrize("missing", [0.1, 0.75])
def test_a_contour_that_does_not_close_is_refused(name: str, missing: float) -> None:
    table = machine(name, blade_angle=0.0, swivel_depth=0.0)
    made = toolpath(table, SQUARE)
    pose = made.pose.copy()
    last = int(np.flatnonzero(made.motion == Motion.LIFT)[-1])
    for row in (last, last + 1):
        pose[row, 0] -= missing * math.cos(math.radians(float(pose[last, 3])))
        pose[row, 1] -= missing * math.sin(math.radians(float(pose[last, 3])))
    text = process(replace(made, pose=pose), table).text
    assert codes(judged(text, table, SQUARE))


def test_a_slanted_blade_runs_past_the_start_of_a_contour() -> None:
    table = machine("drag-knife-table", blade_angle=45.0)
    made = toolpath(table, SQUARE)
    assert codes(judged(process(made, table).text, table, SQUARE)) == set()
    straight = machine("drag-knife-table", blade_angle=0.0)
    text = process(toolpath(straight, SQUARE), straight).text
    assert "verify.comes-out-short" in codes(judged(text, table, SQUARE))


def test_a_blade_that_is_pushed_back_is_found() -> None:
    table = machine("drag-knife-table")
    text = process(toolpath(table, SQUARE), table).text
    there_and_back = text.replace(b"\nG1 X150.7500 F", b"\nG1 X155.7500 F")
    assert there_and_back != text
    assert codes(judged(there_and_back, table, SQUARE)) == {"verify.blade-pushed"}


def test_a_blade_that_is_not_parked_is_found() -> None:
    table = machine("drag-knife-table", park_heading=45.0, swivel_depth=0.0)
    made = toolpath(table, SQUARE)
    swings = np.flatnonzero(made.bulge)
    text = process(without_swings(made, len(swings) - 1), table).text
    assert "verify.blade-not-parked" in codes(judged(text, table, SQUARE))


def test_swivels_of_a_slanted_blade_mark_the_top_face() -> None:
    """45°, 0.6 mm deep: the edge is 0.6 mm ahead; 0.1 mm deep: 0.1 mm, which the board permits."""
    deep = machine("drag-knife-table", blade_angle=45.0, swivel_depth=0.0)
    verdict = judged(process(toolpath(deep, SQUARE), deep).text, deep, SQUARE)
    marks = [one for one in verdict.findings if one.message.code == "verify.swivel-mark"]
    assert {round(one.measure, 3) for one in marks} == {0.6}
    assert {one.severity for one in marks} == {Severity.SHORTFALL}
    assert not verdict.accepted
    blade = deep.stations[0].tool
    assert isinstance(blade, Knife)
    shallow = replace(blade, swivel_depth=0.1)
    table = replace(deep, stations=(replace(deep.stations[0], tool=shallow),))
    assert judged(process(toolpath(table, SQUARE), table).text, table, SQUARE).accepted
    # A program that swings at the full depth is refused there.
    found = codes(judged(process(toolpath(deep, SQUARE), deep).text, table, SQUARE))
    assert "verify.deep-swivel" in found


def fields(name: str) -> dict[str, Any]:
    text = (resources.files("knifetip") / f"library/machines/{name}.toml").read_text("utf-8")
    return tomllib.loads(text)


@pytest.mark.parametrize(
    ("name", "change", "words"),
    [
        (
            "drag-knife-table",
            {"free": False, "swivel_depth": 0.0},
            "station 1 has a tool that an axis must turn",
        ),
        ("drag-knife-table", {"trail": 0.0}, "but its tip lies on its axis"),
        ("demo-table", {"park_heading": 90.0}, "an axis of the machine turns this knife"),
        ("drag-knife-hpgl", {"swivel_depth": 0.1}, "cannot change the depth of a lowered tool"),
        ("flat-cutter-hpgl", {"trail": 0.75}, "itself compensates"),
    ],
)
def test_unsuitable_machine_files_are_refused(
    name: str, change: dict[str, Any], words: str
) -> None:
    file = fields(name)
    file["station"][0]["tool"].update(change)
    with pytest.raises(LibraryError, match=words):
        load.parse_machine("own", file)


def test_a_free_blade_beside_driven_tools_leaves_c_at_rest() -> None:
    file = fields("demo-table")
    file["station"][0]["tool"].update(free=True, trail=0.75, blade_angle=0.0)
    table = load.parse_machine("own", file)
    line = dieline(
        (CUT, closed((100, 100), (200, 100), (200, 200), (100, 200))),
        (LineType.CREASE, edges(((100, 150), (200, 150)), ((150, 110), (150, 140)))),
    )
    text = process(toolpath(table, line), table).text
    assert codes(judged(text, table, line)) == set()
    knife = text[text.index(b"M64 P0") :]
    assert len(set(re.findall(rb"C(-?[\d.]+)", knife))) == 1


@pytest.mark.parametrize("apart", [0.0, 1e-5, 1e-3])
def test_parallel_cuts_need_no_swing_between_them(apart: float) -> None:
    line = dieline((CUT, edges(((120, 120), (160, 120)), ((120, 140), (160, 140 + apart)))))
    table = load.machine("drag-knife-table")
    verdict = judged(process(toolpath(table, line), table).text, table, line)
    assert codes(verdict) == set(), [finding.text for finding in verdict.findings]


@pytest.mark.parametrize("angle", [30, 54, 102])
def test_a_blade_may_turn_by_half_a_turn_at_any_angle(angle: int) -> None:
    """Four digits turn a blade of 0.75 mm by up to 0.02° more than the 180° between two cuts."""
    x, y = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    first = (150.0, 150.0), (150.0 + 30.0 * x, 150.0 + 30.0 * y)
    back = (first[1][0] - 7.0 * y, first[1][1] + 7.0 * x), (150.0 - 7.0 * y, 150.0 + 7.0 * x)
    line = dieline((CUT, edges(first, back)))
    table = load.machine("drag-knife-table")
    verdict = judged(process(toolpath(table, line), table).text, table, line)
    assert codes(verdict) == set(), [finding.text for finding in verdict.findings]


def circle(x: float, y: float, radius: float) -> Any:
    return closed((x - radius, y), (x + radius, y))


@pytest.mark.parametrize("board", ["fbb-0.4", "e-flute"])
@pytest.mark.parametrize("radius", [0.01, 0.02, 0.03, 0.05, 0.1])
@pytest.mark.parametrize("name", [*MACHINES, "sample-table", "two-carriage-table"])
def test_small_circles_are_cut_all_round(name: str, radius: float, board: str) -> None:
    """The tip travels round them, and on past the start, and does not only turn in place.

    The bend is tighter than the board permits, which a person may accept.
    """
    table, material = load.machine(name), load.board(board)
    line = dieline((CUT, circle(100.0, 100.0, radius)), bulge={0: 1.0, 1: 1.0})
    made = sequence([compensate(one) for one in plan(line, table, material)], table)
    verdict = verify(process(made, table).text, line, (0.0, 0.0), table, material)
    assert codes(verdict) == set(), [finding.text for finding in verdict.findings]
    assert codes(verdict, Severity.SHORTFALL) <= {"verify.blade-bend-too-tight"}
    assert verdict.uncut.max() == 0.0


def test_a_swing_about_a_point_beside_the_tip_is_a_bend() -> None:
    """Half a turn of the axis about the tip turns the blade in place; about a point 0.02 mm beside
    the tip it cuts an arc of that radius.
    """
    table = machine("drag-knife-table", blade_angle=0.0, swivel_depth=0.1)
    text = (
        "G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1\nG0 Z10\nM5\nG0 X100.75 Y100\nG0 Z2.4\n"
        "G1 Z-0.2 F1500\nG1 X120.75 F6000\n{swing}\nG1 Z2.4 F1500\nG0 Z10\nM30\n"
    )
    line = dieline((CUT, edges(((100, 100), (120, 100)))))
    in_place = judged(text.format(swing="G3 X119.25 Y100 I-0.75 J0").encode(), table, line)
    assert "verify.deep-swivel" in codes(in_place)
    beside = judged(text.format(swing="G3 X119.25 Y100.04 I-0.75 J0.02").encode(), table, line)
    assert "verify.deep-swivel" not in codes(beside)
    (bend,) = (one for one in beside.findings if one.message.code == "verify.blade-bend")
    assert bend.message.arguments["radius"] == pytest.approx(0.02, abs=1e-3)


def test_whole_units_do_not_turn_the_blade_on_its_way() -> None:
    """A circle of 0.1 mm on a crossing of lines, on a cutter with units of 0.025 mm.

    The axis of the blade, 0.75 mm ahead, is rounded 26 times on its way round the circle.
    """
    lines = edges(((100, 100), (110, 100)), ((105, 95), (105, 105)), ((105, 105), (120, 105)))
    line = dieline(
        (CUT, np.concatenate([lines, circle(105, 100, 0.1), circle(120, 105, 0.1)])),
        bulge={3: 1.0, 4: 1.0, 5: 1.0, 6: 1.0},
    )
    table = load.machine("drag-knife-hpgl")
    verdict = judged(process(toolpath(table, line), table).text, table, line)
    assert codes(verdict) == set(), [finding.text for finding in verdict.findings]
    assert verdict.uncut.max() == 0.0
    assert verdict.path_deviation.max() < 0.04


@pytest.mark.parametrize("shift", [(0.042, 0.018), (0.035, 0.041), (0.035, 0.016)])
def test_an_upright_blade_may_return_at_an_acute_corner(shift: tuple[float, float]) -> None:
    """A side of 0.2 mm lies within the tolerance of the next one, 8° beside it.

    A slanted blade would cut the top face past the corner; an upright one does not.
    """
    corners = np.array(
        [
            *((377.142, 150.172), (377.287, 149.005), (377.142, 148.713), (376.996, 148.859)),
            *((377.433, 148.276), (377.871, 148.276), (378.454, 147.547)),
        ]
    )
    line = dieline((CUT, np.stack([corners[:-1], corners[1:]], axis=1) + shift))
    table = machine("drag-knife-hpgl", blade_angle=0.0)
    verdict = judged(process(toolpath(table, line), table).text, table, line)
    assert codes(verdict) == set(), [finding.text for finding in verdict.findings]


@pytest.mark.parametrize("name", MACHINES)
@pytest.mark.parametrize("size", [2.5, 8.5, 60.0])
@pytest.mark.parametrize("turn", [0.0, 175.0, 260.0])
def test_folds_can_be_made_as_perforations(name: str, size: float, turn: float) -> None:
    table = load.machine(name)
    angle = math.radians(turn)
    fold = ((200, 150), (200 + size * math.cos(angle), 150 + size * math.sin(angle)))

    def blank(kind: LineType) -> Dieline:
        return dieline(
            (CUT, closed((100, 50), (300, 50), (300, 250), (100, 250))), (kind, edges(fold))
        )

    [question] = tool_questions(blank(LineType.CREASE), table)
    assert question.message.code == "question.tool-for-folds"
    assert question.choices[0] == "perforation"
    perforated = blank(LineType.PERFORATION)
    text = process(toolpath(table, perforated), table, table.dialect).text
    assert judged(text, table, perforated).accepted
    # Without its gaps, the fold is cut through.
    cut = process(toolpath(table, blank(CUT)), table, table.dialect).text
    assert judged(cut, table, perforated).accepted == (size < 10.0)


def test_a_machine_without_a_knife_has_no_perforations_to_offer() -> None:
    laser = load.machine("laser-table")
    laser = replace(
        laser, stations=tuple(one for one in laser.stations if isinstance(one.tool, Laser))
    )
    [question] = tool_questions(dieline((LineType.CREASE, edges(((10, 10), (50, 10))))), laser)
    assert question.message.code == "question.tool"
    assert question.choices == ("cut", "ignored")


def test_a_groove_becomes_a_crease_before_anything_else() -> None:
    grooved = dieline((LineType.V_GROOVE, edges(((10, 10), (50, 10)))))
    [question] = tool_questions(grooved, load.machine("flat-cutter-hpgl"))
    assert question.message.code == "question.tool"
    assert question.choices[:3] == ("crease", "perforation", "half-cut")
