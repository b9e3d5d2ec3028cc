"""Possible starts of closed paths: corners, and the middles of segments."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip.compensation.centre_paths import centre_paths
from knifetip.compensation.compensate import compensate
from knifetip.compensation.contour_starts import contour_starts
from knifetip.geometry.columns import F64
from knifetip.model.contour_starts import ContourStarts
from knifetip.model.dieline import LineType
from knifetip.model.operation import Operation
from knifetip.model.toolpath import Motion
from knifetip.planning.plan import plan
from tests.support.operations import ROUTER, contour
from tests.support.shapes import BOARD, KNIFE, MACHINE, closed, dieline, edges


def starts_of(operation: Operation) -> ContourStarts:
    starts = contour_starts(operation)
    assert starts is not None
    return starts


def planned(
    ends: F64, bulge: dict[int, float] | None = None, kind: LineType = LineType.CUT
) -> Operation:
    return plan(dieline((kind, ends), bulge=bulge), MACHINE, BOARD)[-1]


def test_a_knife_starts_at_corners_at_which_it_is_lifted() -> None:
    # The corner at (50, -2) turns by about 5°.
    operation = planned(closed((0, 0), (50, -2), (100, 0), (100, 50), (0, 50)))
    starts = starts_of(operation)
    corners = operation.paths.start[starts.segment]
    assert {tuple(xy) for xy in corners} == {(0, 0), (100, 0), (100, 50), (0, 50)}
    np.testing.assert_array_equal(starts.entry[:, :2], corners)
    np.testing.assert_array_equal(starts.leave[:, :2], corners)
    at = corners.tolist().index([100, 50])
    turn = (starts.entry[at, 2] - starts.leave[at, 2]) % 360.0
    assert turn in (pytest.approx(90.0), pytest.approx(270.0))


def test_the_starts_of_a_contour_with_many_corners_do_not_depend_on_its_first_edge() -> None:
    # The corners of a star with 15 points, each of which lifts the knife.
    turn = np.arange(30) * np.pi / 15
    radius = np.where(np.arange(30) % 2, 60.0, 100.0)
    corner = 100.0 + np.column_stack([radius * np.cos(turn), radius * np.sin(turn)])
    chosen = set()
    for first in (0, 1, 7, 20):
        operation = planned(closed(*map(tuple, np.roll(corner, -first, axis=0).tolist())))
        starts = starts_of(operation)
        assert len(starts.segment) == 12
        chosen.add(tuple(sorted(map(tuple, starts.entry[:, :2].round(6).tolist()))))
    assert len(chosen) == 1


def test_a_smooth_contour_starts_in_the_middle_of_long_lines() -> None:
    # A rounded rectangle with lines of 80, 30, 80 and 1 mm; 1 mm is shorter than the overrun.
    bend = np.tan(np.pi / 8)
    outline = closed((0, 0), (80, 0), (90, 10), (90, 40), (80, 50), (0, 50), (-24, 26), (-24, 25))
    bulge = {1: bend, 3: bend}
    operation = planned(outline, bulge | {5: np.tan(np.pi / 8), 7: 0.4})
    blunt = replace(operation, tool=replace(KNIFE, swivel=170.0))
    starts = starts_of(blunt)
    assert sorted(starts.entry[:, :2].tolist()) == [[40, 0], [40, 50], [90, 25]]
    np.testing.assert_array_equal(starts.entry, starts.leave)


def test_an_open_path_has_one_start() -> None:
    ends = np.concatenate([edges(((0, 80), (50, 80))), closed((0, 0), (9, 0), (9, 9))])
    operation = planned(ends, kind=LineType.HALF_CUT)
    starts = starts_of(operation)
    assert sorted(np.diff(starts.first)) == [1, 3]
    row = int(np.flatnonzero(np.diff(starts.first) == 1)[0])
    at = starts.first[row]
    np.testing.assert_array_equal(starts.entry[at], [0, 80, 0])
    np.testing.assert_array_equal(starts.leave[at], [50, 80, 0])


def test_a_path_with_many_corners_has_twelve_starts() -> None:
    angle = np.arange(400) * 2.0 * np.pi / 400
    star = (100.0 + 10.0 * (np.arange(400) % 2))[:, None] * np.column_stack(
        [np.cos(angle), np.sin(angle)]
    )
    starts = starts_of(planned(closed(*map(tuple, star.tolist()))))
    assert len(starts.segment) == 12
    assert np.diff(starts.segment).min() >= 33


@pytest.mark.parametrize("begin", range(4))
def test_a_cutter_starts_beside_the_stated_line(begin: int) -> None:
    operation = contour((0, 0), (0, 50), (80, 50), (80, 0), side=1, begin=np.array([begin]))
    middle = operation.paths.start[begin] / 2.0 + operation.paths.end[begin] / 2.0
    centre = centre_paths(operation)
    away = np.hypot(*(centre.paths.start[0] - middle))
    assert away == pytest.approx(ROUTER.radius)
    assert centre.segment[0] == begin


def test_a_cutter_starts_where_its_leads_have_room() -> None:
    # A slot of 7 mm leads to the line at the left, which is too near to the line opposite.
    outline = [(0, 0), (0, 7), (30, 7), (30, 60), (90, 60), (90, -40), (30, -40), (30, 0)]
    operation = contour(*outline[::-1], side=1)
    cramped = next(
        row for row, xy in enumerate(operation.paths.start.tolist()) if xy == [30.0, 7.0]
    )
    stated = replace(operation, begin=np.array([cramped]))
    np.testing.assert_array_equal(
        centre_paths(stated).paths.start[0], centre_paths(operation).paths.start[0]
    )
    leads = compensate(stated).motion == Motion.LEAD_IN
    assert leads.any()


def test_operations_without_closed_paths_have_no_choice() -> None:
    assert contour_starts(planned(edges(((0, 0), (50, 0))))) is None


def test_no_path_starts_beside_a_stretch_that_the_cutter_hardly_reaches() -> None:
    # In the mouth of a slot, the cutter touches only 0.03 mm of the upper side of the slot.  A lead
    # there would run 0.01 mm beside the edge below the mouth.
    points = (
        (0, -50), (80, -50), (80, 40), (-40, 40), (-40, 3.9), (-3.02, 3.2), (50, 3.2), (50, 0),
        (0, 0),
    )  # fmt: skip
    operation = contour(*points, side=-1, begin=np.array([5]))
    assert centre_paths(operation).segment[0] != 5
