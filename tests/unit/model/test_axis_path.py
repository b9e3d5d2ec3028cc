"""Positions of axes that are not square, and the arcs that their moves become."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from knifetip.geometry import arc
from knifetip.geometry.columns import F64
from knifetip.model.axis_path import DEVIATION, axis_path
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Motion, Toolpath
from tests.support.shapes import MACHINE, toolpath

QUARTER = math.tan(math.pi / 8)


def leaning(degrees: float) -> Machine:
    return replace(MACHINE, squareness=degrees)


def arcs(radius: float, sweep: float, first: float = 0.3) -> Toolpath:
    """Return one arc about (700, 400) by an angle (radians), along which C turns evenly."""
    angles = np.array([first, first + sweep])
    ends = np.array([700.0, 400.0]) + radius * np.column_stack([np.cos(angles), np.sin(angles)])
    c = np.degrees(angles) + math.copysign(90.0, sweep)
    pose = np.column_stack([ends, [1.0, 1.0], c])
    return toolpath(pose, [(Motion.FEED, 6000.0, 1)], bulge=[math.tan(sweep / 4.0)])


def on_sheet(points: F64, degrees: float) -> F64:
    """Return where positions of the axes are on the sheet: Y lies at an angle from X."""
    x = np.array([1.0, 0.0])
    y = np.array([math.cos(math.radians(degrees)), math.sin(math.radians(degrees))])
    result: F64 = points[:, :1] * x + points[:, 1:2] * y
    return result


def test_y_leans_to_the_right_below_90_degrees() -> None:
    # At 1 m along the axis Y: 1000 cos 89° = 17.4524 mm to the right, and 0.1523 mm less high.
    assert leaning(89.0).to_sheet(0.0, 1000.0) == pytest.approx((17.4524, 999.8477), abs=1e-4)
    assert leaning(91.0).to_sheet(0.0, 1000.0) == pytest.approx((-17.4524, 999.8477), abs=1e-4)
    assert leaning(89.0).to_axes(17.4524, 999.8477) == pytest.approx((0.0, 1000.0), abs=1e-4)
    assert leaning(89.0).to_sheet(300.0, 0.0) == (300.0, 0.0)


def test_offsets_of_stations_are_offsets_of_the_axes() -> None:
    wheel = MACHINE.stations[1]
    pose = leaning(89.0).sheet_pose((160.0, 1000.0, 18.5, 45.0), wheel)
    assert pose == pytest.approx((117.4524, 999.8477, 20.0, 45.0), abs=1e-4)
    assert leaning(89.0).sheet_pose((100.0, 0.0, 5.0, 0.0), None) == (100.0, 0.0, 5.0, 0.0)


@pytest.mark.parametrize("degrees", [89.0, 89.9, 90.02, 91.0])
@pytest.mark.parametrize("radius", [0.05, 0.4, 8.0, 150.0, 2500.0])
@pytest.mark.parametrize("sweep", [0.01, -0.7, 1.6, -math.pi])
def test_arcs_of_the_axes_stay_on_the_arc_of_the_sheet(
    degrees: float, radius: float, sweep: float
) -> None:
    given = arcs(radius, sweep)
    path, row = axis_path(given, leaning(degrees))
    assert (row == 0).all()
    points = arc.points_along(path.pose[:-1, :2], path.pose[1:, :2], path.bulge, 101)
    seen = on_sheet(points.reshape(-1, 2), degrees)
    beside = np.hypot(*(seen - (700.0, 400.0)).T) - radius
    assert np.abs(beside).max() <= DEVIATION
    np.testing.assert_allclose(seen[[0, -1]], given.pose[:, :2], atol=1e-9)
    # C at the ends of each arc is the direction on the sheet.
    ends = on_sheet(path.pose[:, :2], degrees) - (700.0, 400.0)
    tangent = np.degrees(np.arctan2(ends[:, 1], ends[:, 0])) + math.copysign(90.0, sweep)
    error = (path.pose[:, 3] - tangent + 180.0) % 360.0 - 180.0
    assert np.abs(error).max() < 1e-6
    # Consecutive arcs bend by no more than the verifier's tolerance of a heading.
    leave, arrive = arc.tangents(path.pose[:-1, :2], path.pose[1:, :2], path.bulge)
    cross = arrive[:-1, 0] * leave[1:, 1] - arrive[:-1, 1] * leave[1:, 0]
    bend = np.degrees(np.arctan2(cross, (arrive[:-1] * leave[1:]).sum(axis=1)))
    assert np.abs(bend).max(initial=0.0) < 0.25


@pytest.mark.parametrize(
    ("degrees", "radius", "sweep", "count"),
    [
        (89.9, 1.5, math.pi / 2, 1),  # 0.0002 mm beside the ellipse
        (89.9, 100.0, 0.3, 1),
        (89.9, 100.0, math.pi / 2, 4),
        (89.0, 100.0, math.pi / 2, 9),
        (89.9, 1.0, math.pi, 2),
    ],
)
def test_an_arc_is_divided_no_more_than_needed(
    degrees: float, radius: float, sweep: float, count: int
) -> None:
    assert len(axis_path(arcs(radius, sweep), leaning(degrees)).path) == count


def test_one_arc_for_a_quarter_of_100_mm_would_leave_the_tolerance() -> None:
    degrees = 89.9
    given = arcs(100.0, math.pi / 2)
    start, end = given.pose[:, :2]
    middle = arc.point_at(start[None], end[None], given.bulge, np.array([0.5]))
    ends = np.column_stack(leaning(degrees).to_axes(*np.stack([start, *middle, end]).T))
    first, second = np.diff(ends, axis=0)
    turn = np.arctan2(first[0] * second[1] - first[1] * second[0], first @ second)
    bulge = np.array([math.tan(turn / 2.0)])
    points = arc.points_along(ends[:1], ends[2:], bulge, 101)[0]
    beside = np.hypot(*(on_sheet(points, degrees) - (700.0, 400.0)).T) - 100.0
    assert np.abs(beside).max() > 0.01


def test_lines_rapids_and_the_columns_of_moves_are_kept() -> None:
    given = toolpath(
        [(0, 0, 20, 0), (50, 30, 20, 0), (50, 30, -1, 0), (50, 130, -1, 0), (250, 330, -1, 90)],
        [
            (Motion.RAPID, 0.0, 1),
            (Motion.PLUNGE, 6000.0, 1),
            (Motion.FEED, 9000.0, 1),
            (Motion.LEAD_OUT, 8000.0, 1),
        ],
        bulge=[0.0, 0.0, 0.0, -QUARTER],
        source=[-1, 4, 4, 5],
        track=[-1, 0, 0, 0],
    )  # fmt: skip
    path, row = axis_path(given, leaning(89.5))
    assert len(path) > 4
    assert row.tolist() == [0, 1, 2] + [3] * (len(path) - 3)
    for name in ("motion", "feed", "source", "tool", "track"):
        np.testing.assert_array_equal(getattr(path, name), getattr(given, name)[row])
    last = np.append(0, np.flatnonzero(np.diff(row, append=9)) + 1)
    np.testing.assert_allclose(on_sheet(path.pose[last], 89.5), given.pose[:, :2], atol=1e-9)
    np.testing.assert_array_equal(path.pose[last, 2:], given.pose[:, 2:])
    # The plunge stays upright.
    np.testing.assert_array_equal(path.pose[1, :2], path.pose[2, :2])


def test_the_toolpath_of_square_axes_is_the_path_itself() -> None:
    given = arcs(100.0, 1.0)
    assert axis_path(given, MACHINE).path is given
