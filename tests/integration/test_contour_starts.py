"""Starts and directions of closed cuts that the user has chosen: programs and their verdicts."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.compensation.compensate import compensate
from knifetip.errors import PlanError
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.job_options import ContourStart, JobOptions
from knifetip.model.tool import Knife
from knifetip.model.toolpath import Motion
from knifetip.model.verdict import Verdict
from knifetip.pipeline import Compiled
from knifetip.planning.plan import plan
from knifetip.sequencing.sequence import sequence
from knifetip.verification.verify import trace_program
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline, edges

#: A blank of 200 × 150 mm with an arc as edge 1, and a square hole of 50 mm: edges 4 to 7.
LINE = dieline(
    (LineType.CUT, closed((100, 100), (300, 100), (300, 250), (100, 250))),
    (LineType.CUT, closed((150, 150), (200, 150), (200, 200), (150, 200))),
    bulge={1: 0.3},
)
KNIFE = ("demo-table", "fbb-0.4")
ROUTER = ("router-table", "greyboard-3.0")
LASER = ("laser-table", "fbb-0.4")
DRAG = ("drag-knife-table", "fbb-0.4")
PEN = ("drag-knife-hpgl", "fbb-0.4")


def start(edge: int, at: float | None = None, direction: str = "free") -> ContourStart:
    return ContourStart.model_validate({"edges": (edge,), "at": at, "direction": direction})


def compiled(target: tuple[str, str], *starts: ContourStart, line: Dieline = LINE) -> Compiled:
    machine, board = target
    drawn = drawing(line.ends, [("CUT", 7, "CONTINUOUS")] * len(line), bulge=line.bulge)
    options = JobOptions(contour_starts=starts)
    return pipeline.compile(drawn, line, load.machine(machine), load.board(board), options=options)


def verdict(
    made: Compiled, target: tuple[str, str], *starts: ContourStart, text: bytes | None = None
) -> Verdict:
    machine, board = load.machine(target[0]), load.board(target[1])
    options = JobOptions(contour_starts=starts)
    program = made.program.text if text is None else text
    return pipeline.verify(program, LINE, made.placement, machine, board, options=options)


def codes(found: Verdict) -> set[str]:
    return {one.message.code for one in found.findings if one.refuses}


def first_points(made: Compiled, target: tuple[str, str]) -> list[list[float]]:
    """Return the points at which the tip enters the board, in the drawing (mm)."""
    machine, board = load.machine(target[0]), load.board(target[1])
    paths = trace_program(made.program.text, machine, board)[2]
    begins = np.flatnonzero(np.diff(paths.track, prepend=-1))
    points: list[list[float]] = np.round(paths.ends()[0][begins] - made.placement, 3).tolist()
    return points


@pytest.mark.parametrize("target", [KNIFE, DRAG, PEN])
def test_a_knife_begins_at_the_chosen_point(target: tuple[str, str]) -> None:
    made = compiled(target, start(0, 0.3), start(5, 0.5))
    assert made.verdict.accepted
    points = first_points(made, target)
    # 30 % of the way from (100, 100) to (300, 100), and half of that from (200, 150) to (200, 200).
    assert any(np.allclose(point, (160, 100), atol=0.026) for point in points)
    assert any(np.allclose(point, (200, 175), atol=0.026) for point in points)


@pytest.mark.parametrize("target", [ROUTER, LASER])
def test_a_cutter_begins_beside_the_chosen_point(target: tuple[str, str]) -> None:
    made = compiled(target, start(0, 0.3))
    assert made.verdict.accepted
    machine, board = load.machine(target[0]), load.board(target[1])
    paths = trace_program(made.program.text, machine, board)[2]
    found = paths.ends()[0] - made.placement
    used = int(paths.station[0])
    disc = machine.stations[used].tool.diameter / 2.0
    deflection = next(
        (one for one in board.deflection if one.tool == machine.stations[used].name), None
    )
    # The lead-in ends below the edge, in the waste, so that the disc touches the chosen point.
    away = disc - (deflection.y if deflection else 0.0)
    assert (np.hypot(*(found - (160.0, 100.0 - away)).T) < 0.001).any()


@pytest.mark.parametrize("target", [KNIFE, DRAG, PEN])
@pytest.mark.parametrize("direction", ["forward", "reverse"])
def test_a_knife_runs_in_the_chosen_direction(target: tuple[str, str], direction: str) -> None:
    made = compiled(target, start(0, 0.3, direction))
    assert made.verdict.accepted
    assert verdict(made, target, start(0, direction=direction)).accepted
    other = {"forward": "reverse", "reverse": "forward"}[direction]
    assert codes(verdict(made, target, start(0, direction=other))) == {"verify.other-direction"}
    assert codes(verdict(made, target, start(1, direction=other))) == {"verify.other-direction"}


@pytest.mark.parametrize("target", [KNIFE, DRAG, PEN, ROUTER, LASER])
def test_a_program_that_begins_elsewhere_is_refused(target: tuple[str, str]) -> None:
    made = compiled(target, start(0, 0.3))
    for other in (start(0, 0.31), start(0, 0.7), start(2, 0.3), start(3, 1.0), start(5, 0.2)):
        assert codes(verdict(made, target, other)) == {"verify.other-start"}
    # The default is free, and so is the other contour.
    assert verdict(made, target).accepted


def test_a_contour_that_is_begun_before_the_chosen_point_is_refused() -> None:
    """The whole loop from the chosen point is not enough if a part of it was cut before."""
    made = compiled(KNIFE, start(0, 0.0, "forward"))
    lines, heading, place, row = made.program.text.split(b"\n"), b"", [b"", b""], 0
    for number, line in enumerate(lines):
        words = dict(re.findall(rb"([XYC])(-?[\d.]+)", line))
        place = [words.get(b"X", place[0]), words.get(b"Y", place[1])]
        heading = words.get(b"C", heading)
        if line.startswith(b"G1 Z-0.3") and place == [b"20.0000", b"20.0000"]:
            row = number
            break
    # Edge 3, from (100, 250) to (100, 100), is cut once more before the loop from (100, 100).
    there = [b"G0 Z20.0000", b"G0 X20.0000 Y170.0000 C270.0000", b"G0 Z2.4000"]
    cut = [b"G1 Z-0.3000 F6000", b"G1 Y20.0000 F24000", b"G1 Z2.4000 F6000"]
    back = [b"G0 Z20.0000", b"G0 X20.0000 Y20.0000 C" + heading, b"G0 Z2.4000"]
    text = b"\n".join([*lines[:row], *there, *cut, *back, *lines[row:]])
    assert "verify.other-start" in codes(verdict(made, KNIFE, start(0, 0.0, "forward"), text=text))
    # The way there and back alone changes nothing.
    text = b"\n".join([*lines[:row], *there, *back, *lines[row:]])
    assert "verify.other-start" not in codes(
        verdict(made, KNIFE, start(0, 0.0, "forward"), text=text)
    )


@pytest.mark.parametrize(("one_way", "begin"), [(False, 100.0), (True, 300.0)])
def test_sequencing_does_not_reverse_a_chosen_direction(one_way: bool, begin: float) -> None:
    """A blade without slant and trail begins a cut at its nearer end, unless it must not."""
    machine, board = load.machine("demo-table"), load.board("fbb-0.4")
    knife, *others = machine.stations
    assert isinstance(knife.tool, Knife)
    upright = replace(knife, tool=replace(knife.tool, blade_angle=0.0))
    machine = replace(machine, stations=(upright, *others))
    line = dieline((LineType.CUT, edges(((300, 100), (100, 100)))))
    (operation,) = plan(line, machine, board)
    path = sequence([compensate(replace(operation, one_way=one_way))], machine)
    feed = int(np.flatnonzero(path.motion == Motion.FEED)[0])
    assert path.pose[feed, 0] == pytest.approx(begin)


@pytest.mark.parametrize("target", [ROUTER, LASER])
def test_a_cutter_keeps_the_waste_on_its_left(target: tuple[str, str]) -> None:
    assert compiled(target, start(0, direction="reverse")).verdict.accepted
    with pytest.raises(PlanError) as caught:
        compiled(target, start(0, direction="forward"))
    assert caught.value.message.arguments["error"].code == "start.fixed-direction"
    assert caught.value.edges == (0,)


@pytest.mark.parametrize(
    ("target", "starts", "code"),
    [
        (ROUTER, [start(0, 0.0)], "start.at-corner"),
        (KNIFE, [start(0, 0.1), start(1, 0.5)], "start.conflict"),
        (
            KNIFE,
            [start(0, direction="forward"), start(2, direction="reverse")],
            "start.conflict",
        ),
        (KNIFE, [start(8, 0.5)], "start.open"),
    ],
)
def test_a_choice_against_a_rule_is_refused_with_its_edge(
    target: tuple[str, str], starts: list[ContourStart], code: str
) -> None:
    line = dieline(
        (LineType.CUT, closed((100, 100), (300, 100), (300, 250), (100, 250))),
        (LineType.CUT, closed((150, 150), (200, 150), (200, 200), (150, 200))),
        (LineType.CREASE, edges(((120, 220), (280, 220)))),
    )
    with pytest.raises(PlanError) as caught:
        compiled(target, *starts, line=line)
    assert caught.value.message.arguments["error"].code == code
    assert set(caught.value.edges) <= {row for one in starts for row in one.edges}
    assert caught.value.edges


def test_an_edge_that_the_drawing_does_not_have_is_refused() -> None:
    with pytest.raises(PlanError) as caught:
        compiled(KNIFE, start(8, 0.5))
    assert caught.value.message.code == "edge-choice.no-edge"


def test_a_contour_with_bridges_has_no_single_start() -> None:
    board = replace(load.board("greyboard-3.0"), bridge_width=2.0, bridge_spacing=80.0)
    drawn = drawing(LINE.ends, [("CUT", 7, "CONTINUOUS")] * len(LINE), bulge=LINE.bulge)
    options = JobOptions(contour_starts=(start(0, 0.5),))
    with pytest.raises(PlanError) as caught:
        pipeline.compile(drawn, LINE, load.machine("router-table"), board, options=options)
    assert caught.value.message.arguments["error"].code == "start.bridged"


def test_a_corner_of_a_contour_is_a_start_for_a_knife() -> None:
    made = compiled(KNIFE, start(2, 1.0, "forward"))
    assert made.verdict.accepted
    # Edge 2 ends at (100, 250): the cut begins there with edge 3, without an overrun.
    assert [100.0, 250.0] in first_points(made, KNIFE)
    assert not re.search(rb"Y169\.9", made.program.text)


def test_no_choice_leaves_the_program_as_it_is() -> None:
    plain, free = compiled(KNIFE), compiled(KNIFE, start(0))
    assert plain.program.text == free.program.text


def test_options_of_a_job_keep_the_last_choice_of_an_edge() -> None:
    made = compiled(KNIFE, start(0, 0.3), start(0, 0.6))
    assert verdict(made, KNIFE, start(0, 0.6)).accepted


def test_choices_are_stored_as_json() -> None:
    options = JobOptions(contour_starts=(start(3, 0.25, "reverse"),))
    stored: dict[str, Any] = options.model_dump(mode="json")
    assert stored["contour_starts"] == [{"edges": [3], "at": 0.25, "direction": "reverse"}]
    assert JobOptions.model_validate(stored) == options
