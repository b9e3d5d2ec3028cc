"""Discs that go through the board on a closed path release what lies in it."""

from __future__ import annotations

import math

import numpy as np
import pytest

from knifetip.geometry.columns import F64
from knifetip.library import load
from knifetip.verification.checks.order.milled_loops import loose_lines
from knifetip.verification.curves.curve import arc_curves, line_curves
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.tools import OperationKind

MACHINE, BOARD = load.machine("router-table"), load.board("greyboard-3.0")
ROUTER = next(row for row, one in enumerate(MACHINE.stations) if one.name == "Router")

Points = list[tuple[float, float]]


def square(x: float, y: float, size: float) -> Points:
    return [(x, y), (x + size, y), (x + size, y + size), (x, y + size), (x, y)]


def lines(points: Points) -> F64:
    """Return the tip paths along the lines between points."""
    return line_curves(np.array(points[:-1]), np.array(points[1:]))


def released(*tracks: F64, z: float = -0.3) -> list[float]:
    """Return the line that has released the board at each tip path; the lines count from 1."""
    curve = np.concatenate(tracks)
    number = np.repeat(np.arange(len(tracks)), [len(track) for track in tracks])
    count = len(curve)
    work = TipPaths(
        curve, np.full(count, z), np.zeros((count, 2)),
        np.full(count, OperationKind.MILL, np.uint8), np.full(count, ROUTER, np.int32),
        number.astype(np.int32), np.arange(1, count + 1, dtype=np.int32), np.zeros(count),
    )  # fmt: skip
    at, result = loose_lines(work, MACHINE, BOARD)
    assert at.tolist() == work.line.tolist()
    return [float(line) for line in result]


OUTER, INNER = lines(square(0, 0, 100)), lines(square(30, 30, 40))
HELD = [math.inf] * 4


def test_a_path_in_a_closed_path_is_loose_from_its_last_line_on() -> None:
    assert released(OUTER, INNER) == [*HELD, 4.0, 4.0, 4.0, 4.0]
    assert released(INNER, OUTER) == HELD + HELD


def test_the_first_closed_path_counts() -> None:
    assert released(OUTER, lines(square(-5, -5, 110)), INNER) == [*HELD, *HELD, *([4.0] * 4)]


def test_leads_on_both_sides_do_not_open_a_path() -> None:
    led = [(-9.0, 20.0), (-4.0, 12.0), (0.0, 0.0), *square(0, 0, 100)[1:], (-4.0, -12.0)]
    assert released(lines([*led, (-9.0, -20.0)]), INNER)[-4:] == [6.0] * 4


def test_an_open_path_and_a_shallow_one_release_nothing() -> None:
    assert released(lines(square(0, 0, 100)[:-1]), INNER) == [math.inf] * 7
    almost = [*square(0, 0, 100)[:-1], (0.0, 0.01)]
    assert released(lines(almost), INNER) == HELD + HELD
    assert released(OUTER, INNER, z=0.5) == HELD + HELD


@pytest.mark.parametrize(("inset", "line"), [(0.0, math.inf), (0.09, math.inf), (0.2, 4.0)])
def test_a_path_beside_a_closed_path_repeats_it(inset: float, line: float) -> None:
    again = lines(square(inset, inset, 100 - 2 * inset))
    assert released(OUTER, again) == [*HELD, *([line] * 4)]


def test_a_path_in_the_box_but_outside_is_held() -> None:
    # The closed path has a bay, in which the other path lies.
    bay: Points = [(0, 0), (100, 0), (100, 100), (80, 100), (80, 20), (20, 20), (20, 100), (0, 100)]
    assert released(lines([*bay, (0, 0)]), INNER)[-4:] == HELD


def test_arcs_are_closed_paths_too() -> None:
    middle, half = np.array([(50.0, 50.0)] * 2), np.array([math.pi, math.pi])
    circle = arc_curves(middle, np.array([(0.0, 50.0), (100.0, 50.0)]), half)
    assert released(circle, lines(square(20, 20, 60))) == [math.inf] * 2 + [2.0] * 4
    # The corner of the circle's box.
    assert released(circle, lines(square(1, 1, 10))) == [math.inf] * 6


def test_a_cut_that_leaves_the_closed_path_is_held_outside() -> None:
    across = lines([(50, -20), (50, 120)])
    assert released(OUTER, across) == [*HELD, math.inf]
    assert released(OUTER, lines([(50, 20), (50, 120)])) == [*HELD, math.inf]
