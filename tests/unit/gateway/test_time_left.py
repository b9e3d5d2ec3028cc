"""The estimate of the remaining time: from the stated duration, without the time of holds."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from itertools import pairwise

import numpy as np
import pytest

from knifetip.gateway.controller import State
from knifetip.gateway.interpreter import Interpreter
from knifetip.gateway.line_times import LineTimes
from knifetip.gateway.motion import Limits
from knifetip.gateway.program_blocks import read_blocks
from knifetip.gateway.time_left import LATE, TimeLeft
from knifetip.library import load
from knifetip.simulators.grbl.table import Table

MACHINE = load.machine("demo-table")
#: The gateway computes 80 s for the lines of a program whose job states 100 s.
LINES, STATED = 80.0, 100.0


def times(seconds: float, step: float = 0.1) -> Iterator[float]:
    return (step * count for count in range(round(seconds / step) + 1))


def run(left: TimeLeft, real: float, seconds: Iterable[float], late: float = 0.0) -> list[float]:
    """Return the estimates while a copy runs that really takes ``real`` seconds."""
    found = []
    for now in seconds:
        done = LINES * min(max(now - late, 0.0) / real, 1.0)
        estimate = left.update(done, State.RUN, now)
        assert estimate is not None
        found.append(estimate)
    return found


def begun(stated: float = STATED) -> TimeLeft:
    left = TimeLeft(stated)
    left.begin(LINES)
    return left


def test_the_first_estimate_is_the_stated_duration() -> None:
    left = TimeLeft(STATED)
    assert left.expected == STATED
    left.begin(LINES)
    assert left.update(0.0, State.CHECK, 0.0) == STATED
    assert left.update(0.0, State.CHECK, 30.0) == STATED
    assert left.update(0.0, State.RUN, 30.1) == STATED


def test_a_feed_override_scales_the_rest_at_once() -> None:
    left = begun()
    assert left.update(0.0, State.RUN, 0.0) == pytest.approx(STATED)
    assert left.update(0.0, State.RUN, 0.0, 50) == pytest.approx(2.0 * STATED)
    assert left.update(0.0, State.RUN, 0.0, 200) == pytest.approx(0.5 * STATED)


def test_time_at_another_feed_is_no_evidence_of_another_pace() -> None:
    """At 50 %, a program of 100 s takes 200 s; back at 100 % after a half, the other takes 50 s."""
    left = begun()
    for now in times(100.0):
        found = left.update(LINES * now / 200.0, State.RUN, now, 50)
    assert found == pytest.approx(100.0, rel=0.05)
    assert left.update(0.5 * LINES, State.RUN, 100.0) == pytest.approx(50.0, rel=0.05)


@pytest.mark.parametrize("real", [93.0, 100.0, 107.0])
@pytest.mark.parametrize("late", [0.0, 0.4, 1.0])
def test_it_is_within_10_percent_from_the_first_second(real: float, late: float) -> None:
    found = run(begun(), real, times(0.5 * real), late)
    pairs = zip(times(90), found, strict=False)
    errors = [abs(one - (real - now)) / (real - now) for now, one in pairs]
    assert max(errors) < 0.1


@pytest.mark.parametrize("speed", [0.5, 4.0])
def test_another_speed_is_learned_in_the_first_quarter(speed: float) -> None:
    real = STATED / speed
    found = run(begun(), real, times(0.5 * real))
    assert found[0] == STATED
    at = round(0.25 * real / 0.1)
    assert found[at:] == pytest.approx(
        [real - 0.1 * count for count in range(at, len(found))], rel=0.2
    )


def test_a_hold_counts_no_time_and_the_estimate_never_grows_in_it() -> None:
    # Half as fast as stated: a pace that the estimate has just begun to learn.
    left = begun()
    before = run(left, 200.0, times(10.0))[-1]
    held = [left.update(LINES * 0.05, State.HOLD, 10.0 + now) for now in times(600.0)]
    estimates = [before, *(one for one in held if one is not None)]
    assert len(estimates) == len(held) + 1
    assert all(later <= earlier for earlier, later in pairwise(estimates))
    after = left.update(LINES * (0.05 + 0.0005), State.RUN, 610.1)
    assert after == pytest.approx(estimates[-1], rel=0.01)


def test_a_later_copy_takes_as_long_as_the_one_before() -> None:
    left = begun()
    run(left, 150.0, times(150.0))
    left.end()
    assert left.expected == pytest.approx(150.0, abs=LATE)
    left.begin(LINES)
    # The next copy begins an hour later.
    assert left.update(0.0, State.RUN, 3600.0) == pytest.approx(150.0, abs=LATE)


def test_without_a_stated_duration_the_lines_count() -> None:
    left = begun(0.0)
    assert left.update(0.0, State.RUN, 0.0) == LINES
    assert left.update(20.0, State.RUN, 20.0) == LINES - 20.0


def test_lines_of_unknown_duration_have_no_estimate() -> None:
    left = TimeLeft(STATED)
    left.begin(0.0)
    assert left.update(0.0, State.RUN, 1.0) is None


PROGRAM = b"""G21 G90 G94
M65 P0
G0 Z20
G0 X20 Y20
M64 P0
G4 P0.15
G1 Z-0.3 F6000
G1 Y300 F24000
G1 X320
G1 X330 Y290
G93
G3 X330 Y270 I0 J-10 C-180 F300
G94
G1 X20 Y20 F24000
G0 Z20
M65 P0
G4 P0.15
M30
"""


def test_the_times_of_lines_are_those_of_the_simulated_table() -> None:
    limits = Limits.from_machine(MACHINE)
    lines = LineTimes(limits)
    for block in read_blocks(PROGRAM, Interpreter((0.0, 0.0, MACHINE.travel_z, 0.0))):
        lines.add(block)
    lines.end()
    table = Table(MACHINE, window=4096)
    table.receive(PROGRAM)
    table.elapse(math.inf)
    assert np.sum(lines.seconds) == pytest.approx(table.time, rel=0.01)
