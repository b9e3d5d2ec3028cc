"""Whole points of the axis of a free blade: the tip that they drag stays on its path."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from knifetip.geometry.columns import F64
from knifetip.library import load
from knifetip.model.toolpath import Motion
from knifetip.post.trailing_points import round_points

MACHINE = load.machine("drag-knife-hpgl")
#: Units per mm, and trail of the blade in units.
UNITS, TRAIL = 40.0, 30.0
DOWN = np.uint8(Motion.PLUNGE)


def tips(points: F64, heading: float) -> F64:
    """Drag a tip behind whole points in small steps: it moves towards the axis."""
    tip = points[0] - TRAIL * np.array([math.cos(heading), math.sin(heading)])
    found = [tip]
    for first, last in pairwise(points):
        for share in np.linspace(0.0, 1.0, 2001)[1:]:
            away = first + (last - first) * share - tip
            tip = tip + away * (1.0 - TRAIL / math.hypot(*away))
        found.append(tip)
    return np.array(found)


def around(radius: float, chords: int, turns: int) -> tuple[F64, F64]:
    """Return the axis and the heading (degrees) of a blade whose tip goes round a circle."""
    angle = np.linspace(0.0, turns * 2.0 * np.pi, turns * chords + 1)
    tip = 4000.0 + radius * np.column_stack([np.sin(angle), -np.cos(angle)])
    return tip + TRAIL * np.column_stack([np.cos(angle), np.sin(angle)]), np.degrees(angle)


@pytest.mark.parametrize("radius", [3.0, 4.0])
def test_the_errors_of_whole_points_do_not_add_up(radius: float) -> None:
    """Four turns on circles of 0.075 and 0.1 mm radius; a unit is 0.025 mm."""
    axis, heading = around(radius, 26, 4)
    planned = axis - TRAIL * np.column_stack(
        [np.cos(np.radians(heading)), np.sin(np.radians(heading))]
    )
    points = round_points(
        np.concatenate([axis[:1], axis]),
        np.concatenate([heading[:1], heading]),
        np.array([Motion.PLUNGE] + [Motion.FEED] * (len(axis) - 1), np.uint8),
        np.ones(len(axis), np.uint8),
        MACHINE,
        UNITS,
    )
    away = np.hypot(*(tips(points[1:].astype(np.float64), 0.0) - planned).T)
    assert away.max() < 1.5
    one_by_one = np.hypot(*(tips(np.rint(axis), 0.0) - planned).T)
    assert one_by_one.max() > 2.8


def test_points_of_other_tools_are_rounded_one_by_one() -> None:
    machine = load.machine("flat-cutter-hpgl")
    point = np.array([[0.4, 0.6], [10.5, 3.2], [7.7, 8.8]])
    motion = np.array([Motion.PLUNGE, Motion.FEED], np.uint8)
    tool = np.ones(2, np.uint8)
    found = round_points(point, np.zeros(3), motion, tool, machine, UNITS)
    assert found.tolist() == np.rint(point).tolist()


def test_in_front_of_a_track_the_axis_is_placed_by_the_heading_that_the_blade_has() -> None:
    """A line of 0.75 mm across the blade turns it by 49.6° only, not by the planned 90°.

    Its tip enters the next track at the planned point nevertheless.
    """
    plan = [
        ((30.0, 0.45), 0.0, Motion.RAPID),
        ((30.0, 0.45), 0.0, Motion.PLUNGE),
        ((30.0, 30.45), 90.0, Motion.FEED),
        ((30.0, 30.45), 90.0, Motion.LIFT),
        ((100.0, 50.0), 90.0, Motion.RAPID),
        ((100.0, 50.0), 90.0, Motion.PLUNGE),
    ]
    point = np.array([plan[0][0], *(one for one, _, _ in plan)])
    heading = np.array([0.0, *(one for _, one, _ in plan)])
    motion = np.array([one for _, _, one in plan], np.uint8)
    found = round_points(point, heading, motion, np.ones(6, np.uint8), MACHINE, UNITS)
    # A line of 30 units, the trail, across the blade: tan(φ/2) = tan(45°) exp(-1).
    turned = math.pi / 2.0 - 2.0 * math.atan(math.exp(-1.0))
    expected = np.array([100.0, 20.0]) + TRAIL * np.array([math.cos(turned), math.sin(turned)])
    assert found[-1] == pytest.approx(expected, abs=0.51)
    assert found[-1].tolist() == found[-2].tolist()
    assert found[4].tolist() == found[3].tolist()
