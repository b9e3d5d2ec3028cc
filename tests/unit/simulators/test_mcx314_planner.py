"""The ramps that the board plans: ends at rest, joints that lose no steps, and short pieces."""

from __future__ import annotations

import math
from typing import cast

import pytest

from knifetip.languages.mcx314.wiring import Wiring
from knifetip.library import load
from knifetip.simulators.mcx314.planner import LONGEST, Piece, Planner, ProgramSegment

WIRING = cast(Wiring, load.machine("v-groove-table").controller)
#: Pulses in which the rate falls from 80,000 to 2,000 pulses/s.
BRAKE = (80_000**2 - 2_000**2) / 2 / 1_000_000


def line(*way: int, rate: float = 80_000.0, joined: bool = True) -> ProgramSegment:
    x, y, z, c = (*way, 0, 0, 0, 0)[:4]
    return ProgramSegment(1, (0, 0, 0, 0), (x, y, z, c), rate, joined)


def pieces(*stretches: ProgramSegment, stopping: bool = False) -> list[Piece]:
    """Return all pieces of stretches that are driven without a stop, from rest."""
    planner, found, speed = Planner(WIRING), list[Piece](), 2_000.0
    for number, stretch in enumerate(stretches):
        step = 0
        while step < stretch.steps:
            piece = planner.piece(stretch, step, speed, stretches[number + 1 :], stopping=stopping)
            assert piece.first == step < piece.last
            found.append(piece)
            step, speed = piece.last, piece.end
    return found


def test_a_line_ends_at_the_start_speed_after_a_ramp() -> None:
    found = pieces(line(20_000))
    assert found[-1].end == 2_000.0
    assert found[-1].rate == 2_000.0
    assert found[-1].last - found[-1].first == math.ceil(BRAKE)
    assert max(piece.rate for piece in found) == 80_000.0
    # A hold takes effect after two pieces.
    assert max((piece.last - piece.first) / 80_000.0 for piece in found[:-1]) <= LONGEST


def test_a_short_line_turns_from_one_ramp_into_the_other() -> None:
    found = pieces(line(1_000))
    peak = math.sqrt(1_000_000 * 1_000 + 2_000**2)
    assert max(piece.rate for piece in found) == pytest.approx(peak, abs=50.0)
    assert found[-1].end == 2_000.0


@pytest.mark.parametrize("count", [2, 50])
def test_a_run_of_short_lines_keeps_its_speed_and_ends_at_rest(count: int) -> None:
    found = pieces(*[line(200)] * (count + 40))
    assert found[-1].end == pytest.approx(2_000.0)
    for piece in found:
        left = 200 * (count + 40) - 200 * found.index(piece)
        assert piece.end**2 <= 2_000**2 + 2 * 1_000_000 * left
    assert max(piece.end for piece in found) == pytest.approx(
        min(80_000.0, math.sqrt(1_000_000 * 200 * (count + 40))), rel=0.05
    )


def test_at_a_joint_no_axis_changes_its_rate_by_more_than_the_start_speed() -> None:
    turn = math.radians(5.0)
    found = pieces(
        line(20_000), line(round(20_000 * math.cos(turn)), round(20_000 * math.sin(turn)))
    )
    joint = next(piece for piece in found if piece.completes)
    assert joint.end * math.tan(turn) <= 2_000.0 * 1.001
    assert joint.end > 20_000.0


def test_the_rate_of_a_small_arc_does_not_run_into_a_line() -> None:
    # C has most pulses on the arc: at the same rate the head would be eight times too fast.
    found = pieces(line(200, 0, 0, 1_600, rate=300_000.0), line(20_000))
    joint = next(piece for piece in found if piece.completes)
    assert joint.end <= 80_000.0


def test_a_joint_that_would_lose_steps_is_a_stop() -> None:
    planner = Planner(WIRING)
    assert planner.joins(line(500), line(500, 40))
    assert not planner.joins(line(500), line(-500))
    assert not planner.joins(line(500), line(500, joined=False))
    assert pieces(line(20_000), line(-20_000))[1].last <= 20_000


def test_a_hold_ramps_down_along_the_path() -> None:
    planner = Planner(WIRING)
    held = planner.piece(line(20_000), 5_000, 80_000.0, [], stopping=True)
    assert (held.first, held.rate) == (5_000, 2_000.0)
    assert held.end == pytest.approx(2_000.0, abs=400.0)


def test_pieces_last_longer_than_the_writing_of_the_next() -> None:
    found = pieces(line(7_777), line(7_777, 300), line(90), line(20_000))
    assert sum(piece.last - piece.first for piece in found) == 2 * 7_777 + 90 + 20_000
    for piece in found[:-1]:
        assert (piece.last - piece.first) / 80_000.0 > WIRING.refill
