"""Passes, curves and kinds of knives by board, in planning and in verification."""

from __future__ import annotations

import re
import tomllib
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.errors import LibraryError
from knifetip.library import load
from knifetip.model.board import Board, ToolLimits
from knifetip.model.dieline import LineType
from knifetip.model.machine import Machine
from knifetip.model.tool import Knife
from knifetip.pipeline import Compiled
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline, edges

#: A blank with a bent slit, a slit that meets the outline, a hole of r 20, and other knife work.
BLANK = dieline(
    (LineType.CUT, closed((0, 0), (300, 0), (300, 200), (0, 200))),
    (LineType.CUT, edges(((50, 50), (100, 50)), ((100, 50), (100, 90)), ((150, 0), (150, 60)))),
    (LineType.CUT, edges(((200, 100), (240, 100)), ((240, 100), (200, 100)))),
    (LineType.HALF_CUT, edges(((20, 150), (280, 150)))),
    (LineType.PERFORATION, edges(((20, 170), (280, 170)))),
    bulge={7: 1.0, 8: 1.0},
)


def board(name: str = "foam-5.0", **limits: Any) -> Board:
    return replace(load.board(name), limits=(ToolLimits("knife", **limits),))


def compiled(used: Board, machine: str | Machine = "demo-table") -> Compiled:
    lines = drawing(BLANK.ends, [("0", 7, "CONTINUOUS")] * len(BLANK), bulge=BLANK.bulge)
    table = load.machine(machine) if isinstance(machine, str) else machine
    return pipeline.compile(lines, BLANK, table, used)


def codes(text: bytes, made: Compiled, used: Board, machine: str = "demo-table") -> set[str]:
    verdict = pipeline.verify(text, BLANK, made.placement, load.machine(machine), used)
    return {finding.message.code for finding in verdict.findings}


@pytest.mark.parametrize("machine", ["demo-table", "v-groove-table", "two-carriage-table"])
@pytest.mark.parametrize("step", [0.0, 6.0, 2.0, 1.0])
def test_each_pass_of_a_knife_is_at_most_a_step_deeper(step: float, machine: str) -> None:
    used = board(step=step)
    made = compiled(used, machine)
    assert made.verdict.accepted
    # 5 mm of board and 0.3 mm of mat, in equal passes.
    passes = 1 if step == 0.0 else int(np.ceil(5.3 / step))
    depths = {round(5.0 - z, 4) for z in made.toolpath.pose[:, 2] if z < 5.0}
    through = {round(5.3 * number / passes, 4) for number in range(1, passes + 1)}
    half = int(np.ceil(used.half_cut_depth / step)) if step else 1
    partial = {round(used.half_cut_depth * n / half, 4) for n in range(1, half + 1)}
    assert depths == through | partial


@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
def test_a_program_with_deeper_passes_than_the_board_permits_is_refused(dialect: str) -> None:
    machine = replace(load.machine("demo-table"), dialect=dialect)
    made = compiled(board(step=2.0), machine)
    assert made.verdict.accepted
    for step, refused in ((2.0, False), (1.5, True), (6.0, False), (0.0, True)):
        # A board without a limit has no passes, so that the first pass is work of its own.
        verdict = pipeline.verify(
            made.program.text, BLANK, made.placement, machine, board(step=step)
        )
        assert verdict.accepted is not refused, step


@pytest.mark.parametrize("missing", ["first", "last"])
def test_every_pass_is_necessary(missing: str) -> None:
    used = board(step=3.0)
    made = compiled(used)
    text = made.program.text.decode()
    # Plunges of the two passes of through cuts: to 5 - 5.3 / 2 mm, and into the mat.
    first, last = r"Z2\.3500", r"Z-0\.3000"
    assert re.search(first, text)
    old, new = (first, "Z-0.3000") if missing == "first" else (last, "Z2.3500")
    changed = re.sub(old, new, text).encode()
    found = codes(changed, made, used)
    assert ("verify.pass-too-deep" in found) is (missing == "first")
    assert ("verify.not-worked" in found) is (missing == "last")


def test_a_shallow_pass_beside_the_cut_is_found() -> None:
    used = board(step=3.0)
    made = compiled(used)
    lines = made.program.text.decode().splitlines()
    # The first cut in the first pass ends too far.
    plunge = next(row for row, words in enumerate(lines) if "Z2.3500" in words)
    cut = next(row for row in range(plunge + 1, len(lines)) if re.match(r"G1 [XY]", lines[row]))
    lines[cut] = re.sub(
        r"([XY])([\d.]+)", lambda m: f"{m[1]}{float(m[2]) + 5.0:.4f}", lines[cut], count=1
    )
    changed = "".join(f"{line}\n" for line in lines).encode()
    assert not pipeline.verify(
        changed, BLANK, made.placement, load.machine("demo-table"), used
    ).accepted


def test_the_blade_is_turned_in_every_pass() -> None:
    """A blade across its line tears the board, at any depth."""
    used = board(step=3.0)
    made = compiled(used)
    lines = made.program.text.decode().splitlines()
    plunge = next(row for row, words in enumerate(lines) if "Z2.3500" in words)
    turn = next(row for row in range(plunge, 0, -1) if re.search(r"C-?[\d.]+", lines[row]))
    lines[turn] = re.sub(r"C(-?[\d.]+)", lambda m: f"C{float(m[1]) + 90.0:.4f}", lines[turn])
    changed = "".join(f"{line}\n" for line in lines).encode()
    assert "verify.not-worked" not in codes(changed, made, used)
    assert not pipeline.verify(
        changed, BLANK, made.placement, load.machine("demo-table"), used
    ).accepted


def test_a_controller_without_depths_makes_one_pass_and_the_verdict_has_a_note() -> None:
    used = board("greyboard-2.0", step=1.0)
    made = compiled(used, "flat-cutter-hpgl")
    assert made.verdict.accepted
    found = [one.message.code for one in made.verdict.findings]
    assert found.count("verify.one-pass") == 1
    assert "verify.one-pass" not in codes(
        made.program.text, made, board("greyboard-2.0"), "flat-cutter-hpgl"
    )


@pytest.mark.parametrize("machine", ["demo-table", "v-groove-table", "two-carriage-table"])
@pytest.mark.parametrize("slow", [0.0, 10.0, 20.05, 20.1, 30.0, 80.0])
def test_the_feed_is_lower_in_tight_curves(slow: float, machine: str) -> None:
    used = board("greyboard-2.0", slow_radius=slow)
    made = compiled(used, machine)
    assert made.verdict.accepted
    feeds = made.toolpath.feed[np.abs(made.toolpath.bulge) > 0.1]
    # The hole has a radius of 20 mm.
    [knife] = {
        one.tool.feed for one in load.machine(machine).stations if isinstance(one.tool, Knife)
    }
    np.testing.assert_allclose(feeds.max(), knife * min(1.0, 20.0 / slow if slow else 1.0))


def test_a_controller_without_headings_has_one_feed() -> None:
    made = compiled(board("greyboard-2.0", slow_radius=80.0), "flat-cutter-hpgl")
    assert made.verdict.accepted
    assert len(set(made.toolpath.feed[made.toolpath.feed > 0.0].tolist())) == 2


@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
def test_a_curve_that_is_followed_too_fast_is_refused(dialect: str) -> None:
    machine = replace(load.machine("demo-table"), dialect=dialect)
    fast = compiled(board("greyboard-2.0"), machine)
    slow = compiled(board("greyboard-2.0", slow_radius=40.0), machine)
    for made, used, accepted in (
        (fast, board("greyboard-2.0"), True),
        (fast, board("greyboard-2.0", slow_radius=40.0), False),
        (slow, board("greyboard-2.0"), False),
        (slow, board("greyboard-2.0", slow_radius=39.0), False),
    ):
        verdict = pipeline.verify(made.program.text, BLANK, made.placement, machine, used)
        assert verdict.accepted is accepted


def two_knives() -> Machine:
    """Return a table with an oscillating knife in station 1 and a fixed one in station 4."""
    machine = load.machine("demo-table")
    [first] = [one for one in machine.stations if isinstance(one.tool, Knife)]
    knife = first.tool
    assert isinstance(knife, Knife)
    assert knife.oscillating
    fixed = replace(first, number=4, output=-1, tool=replace(knife, oscillating=False))
    return replace(machine, stations=(*machine.stations, fixed))


@pytest.mark.parametrize(("blade", "station"), [("", 1), ("oscillating", 1), ("fixed", 4)])
def test_the_knife_that_suits_the_board_makes_the_cuts(blade: str, station: int) -> None:
    used = board("greyboard-2.0", blade=blade)
    made = compiled(used, two_knives())
    assert made.verdict.accepted
    assert set(made.toolpath.tool.tolist()) == {station}


def test_a_fixed_knife_in_a_board_for_an_oscillating_one_is_a_note() -> None:
    machine = two_knives()
    fixed = replace(machine, stations=machine.stations[1:])
    used = board("greyboard-2.0", blade="oscillating")
    made = compiled(used, fixed)
    assert made.verdict.accepted
    found = [one.message.code for one in made.verdict.findings]
    assert found.count("verify.fixed-blade") == 1
    both = [one.message.code for one in compiled(used, machine).verdict.findings]
    assert "verify.fixed-blade" not in both


def test_another_kind_of_blade_is_refused() -> None:
    text = load.board_toml("foam-5.0")
    fields = tomllib.loads(text)
    fields["limits"]["knife"]["blade"] = "round"
    with pytest.raises(LibraryError):
        load.parse_board("a", fields)


def test_the_library_cuts_thick_board_in_passes() -> None:
    passes = {}
    for name in ("greyboard-2.0", "greyboard-3.0", "greyboard-4.0", "foam-10.0"):
        used = load.board(name)
        made = compiled(used)
        assert made.verdict.accepted
        # The perforation, whose dashes are cut through, has the passes of the cuts.
        depths = {round(used.caliper - z, 3) for z in made.toolpath.pose[:, 2] if z < used.caliper}
        step = next(one.step for one in used.limits) or 100.0
        passes[name] = int(np.ceil((used.caliper + 0.3) / step))
        assert {
            round((used.caliper + 0.3) * k / passes[name], 3) for k in (1, passes[name])
        } <= depths
    assert passes == {
        "greyboard-2.0": 1,
        "greyboard-3.0": 2,
        "greyboard-4.0": 3,
        "foam-10.0": 2,
    }
