"""The limits of a board for kinds of tools hold in planning and in verification."""

from __future__ import annotations

import re
import tomllib
from dataclasses import replace

import pytest

from knifetip import pipeline
from knifetip.errors import LibraryError, PlanError
from knifetip.library import load
from knifetip.model.board import Board, ToolLimits
from knifetip.model.dieline import LineType
from knifetip.pipeline import Compiled
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline

OUTLINE = dieline((LineType.CUT, closed((0, 0), (80, 0), (80, 50), (0, 50))))


def limited(*limits: ToolLimits) -> Board:
    return replace(load.board("greyboard-3.0"), limits=limits)


def compiled(machine: str, board: Board) -> Compiled:
    lines = drawing(OUTLINE.ends, [("0", 7, "CONTINUOUS")] * len(OUTLINE))
    return pipeline.compile(lines, OUTLINE, load.machine(machine), board)


def codes(made: Compiled, board: Board) -> set[str]:
    """Return the codes of the findings on a program that is made of another board."""
    machine = load.machine("demo-table")
    verdict = pipeline.verify(made.program.text, OUTLINE, made.placement, machine, board)
    return {finding.message.code for finding in verdict.findings}


@pytest.mark.parametrize(
    ("limit", "expected"), [(0.0, 24000.0), (6000.0, 6000.0), (30000.0, 24000.0)]
)
def test_the_lower_of_both_feeds_is_used(limit: float, expected: float) -> None:
    made = compiled("demo-table", limited(ToolLimits("knife", limit)))
    assert made.verdict.accepted
    assert {float(word) for word in re.findall(rb"F(\d+)", made.program.text)} >= {expected}
    assert made.toolpath.feed.max() == expected


def test_a_program_that_is_faster_than_the_board_permits_is_refused() -> None:
    made = compiled("demo-table", limited())
    assert "verify.wrong-feed" not in codes(made, limited())
    assert "verify.wrong-feed" in codes(made, limited(ToolLimits("knife", 6000.0)))
    assert "verify.wrong-feed" not in codes(made, limited(ToolLimits("cutter", 6000.0)))


def test_a_cutter_makes_more_passes_in_a_board_that_demands_it() -> None:
    def depths(board: Board) -> int:
        text = compiled("router-table", board).program.text
        return len(set(re.findall(rb"Z-?[\d.]+ F", text)))

    one, two = depths(limited()), depths(limited(ToolLimits("cutter", step=1.0)))
    assert two > one


def test_the_library_states_lower_feeds_for_thick_greyboard() -> None:
    feeds = []
    for caliper in ("1.0", "1.5", "2.0", "3.0", "4.0"):
        (knife,) = load.board(f"greyboard-{caliper}").limits
        assert knife.kind == "knife"
        feeds.append(knife.feed)
    assert feeds == sorted(feeds, reverse=True)


def test_an_unknown_kind_of_tool_is_refused() -> None:
    text = (
        'title = "A"\nmaterial = "greyboard"\ncaliper = 2.0\ngrain = 90.0\ncrease_along = 0.6\n'
        "crease_across = 0.65\nend_clearance = 0.2\ngroove_depth = 1.3\ngroove_overcut = 3.0\n"
        'half_cut_depth = 1.0\nperforation = [3.0, 2.0]\nshort_crease = "press"\n'
        "[limits.scissors]\nfeed = 100.0\n"
    )
    with pytest.raises(LibraryError, match="knife"):
        load.parse_board("a", tomllib.loads(text))


def test_a_board_above_which_the_head_does_not_travel_is_refused() -> None:
    with pytest.raises(PlanError, match=r"6\.8 mm thick") as caught:
        compiled("flat-cutter-hpgl", replace(load.board("fbb-0.4"), caliper=6.8))
    assert caught.value.message.code == "board.above-travel"
    # 3 mm of board and 2 mm of clearance are exactly the height at which the head travels.
    assert compiled("flat-cutter-hpgl", replace(load.board("fbb-0.4"), caliper=3.0))


def test_a_board_thicker_than_the_machine_takes_is_refused_by_planner_and_verifier() -> None:
    board = load.board("fbb-0.4")
    made = compiled("demo-table", board)
    lines = drawing(OUTLINE.ends, [("0", 7, "CONTINUOUS")] * len(OUTLINE))
    small = replace(load.machine("demo-table"), max_caliper=0.35)
    with pytest.raises(PlanError, match=r"0\.4 mm thick, but .* up to 0\.35 mm") as caught:
        pipeline.compile(lines, OUTLINE, small, board)
    assert caught.value.message.code == "board.too-thick"
    # A program that was made for another machine is refused by the verifier as well.
    verdict = pipeline.verify(made.program.text, OUTLINE, made.placement, small, board)
    assert [finding.message.code for finding in verdict.findings] == ["board.too-thick"]
    assert not verdict.accepted
    # The limit itself is permitted.
    exact = replace(small, max_caliper=0.4)
    assert pipeline.compile(lines, OUTLINE, exact, board).verdict.accepted


def test_the_swings_of_a_free_blade_keep_the_feed_of_the_board() -> None:
    board = limited(ToolLimits("knife", 4200.0))
    assert compiled("drag-knife-table", replace(board, caliper=0.5)).verdict.accepted
