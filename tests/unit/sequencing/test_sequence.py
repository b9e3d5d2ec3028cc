"""One way through all tracks: order, links, headings, travel."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.compensation.compensate import compensate
from knifetip.errors import PlanError, TravelExceeded
from knifetip.model.dieline import LineType
from knifetip.model.machine import Axis
from knifetip.model.toolpath import Motion
from knifetip.planning.plan import plan
from knifetip.sequencing.order import nearest_neighbour, unwound
from knifetip.sequencing.sequence import sequence
from shapes import BOARD, MACHINE, closed, dieline, edges


def sequenced(*groups, machine=MACHINE):
    operations = plan(dieline(*groups), machine, BOARD)
    return sequence([compensate(operation) for operation in operations], machine)


def test_the_way_begins_and_ends_parked():
    path = sequenced((LineType.CUT, edges(((10, 10), (90, 10)))))
    np.testing.assert_array_equal(path.pose[0], [0, 0, 20, 0])
    np.testing.assert_array_equal(path.pose[-1], [0, 0, 20, 0])


def test_a_tool_is_changed_at_travel_height():
    path = sequenced(
        (LineType.CREASE, edges(((10, 10), (10, 90)))),
        (LineType.CUT, edges(((20, 10), (90, 10)))),
    )
    change = np.flatnonzero(path.tool[1:] != path.tool[:-1])
    assert len(change) == 1
    assert path.pose[change[0] + 1, 2] == 20.0
    # The new tool first goes over its start, then down.
    np.testing.assert_allclose(path.pose[change[0] + 2, :3], [20, 10, 20])


def test_links_between_tracks_stay_above_the_board():
    path = sequenced(
        (
            LineType.CUT,
            np.concatenate([closed((0, 0), (9, 0), (9, 9)), closed((30, 0), (39, 0), (39, 9))]),
        )
    )
    rapid = path.motion == Motion.RAPID
    assert path.pose[1:][rapid][:, 2].min() == 4.0  # caliper 2 and clearance 2


def test_every_row_of_the_tracks_is_there_once():
    groups = [(LineType.CREASE, edges(*[((x, 10), (x, 90)) for x in range(10, 90, 7)]))]
    operation = plan(dieline(*groups), MACHINE, BOARD)[0]
    before = compensate(operation)
    after = sequence([before], MACHINE)
    fed = after.motion == Motion.FEED
    assert sorted(after.source[fed]) == sorted(before.source[before.motion == Motion.FEED])
    assert after.track.max() == before.track.max()


def test_the_wheel_turns_by_less_than_a_quarter_between_creases():
    path = sequenced(
        (
            LineType.CREASE,
            edges(((10, 10), (10, 90)), ((12, 90), (12, 10)), ((14, 10), (14, 90))),
        )
    )
    rapid = np.flatnonzero(path.motion == Motion.RAPID)[2:-2]
    assert np.abs(np.diff(path.pose[:, 3]))[rapid].max() <= 90.0


def test_c_stays_within_its_travel_though_the_work_winds_up():
    squares = np.concatenate(
        [closed((x, 0), (x + 9, 0), (x + 9, 9), (x, 9)) for x in range(0, 400, 20)]
    )
    path = sequenced((LineType.CUT, squares))
    assert path.pose[:, 3].min() >= -1080
    assert path.pose[:, 3].max() <= 1080


def test_c_unwinds_in_the_air_inside_a_track_too():
    # Sixty right angles to the left would be fifteen turns.
    size = np.arange(300.0, 0.0, -5.0)
    turns = np.array([[1, 0], [0, 1], [-1, 0], [0, -1]])[np.arange(60) % 4]
    corners = np.concatenate([[[0.0, 0.0]], np.cumsum(size[:, None] * turns, axis=0)])
    spiral = np.stack([corners[:-1], corners[1:]], axis=1)
    path = sequenced((LineType.CUT, spiral))
    assert path.pose[:, 3].max() <= 1080
    assert (path.motion == Motion.FEED).sum() == 60


def test_a_head_that_would_leave_the_machine_is_named():
    narrow = replace(MACHINE, x=Axis(-500.0, 100.0, 1500.0, 8000.0))
    with pytest.raises(
        TravelExceeded, match=r"Wheel \(station 2\) would go 10\.00 mm above .* axis X"
    ):
        sequenced((LineType.CREASE, edges(((50, 10), (50, 90)))), machine=narrow)


def test_nothing_to_do_is_said():
    with pytest.raises(PlanError, match="Nothing in this drawing"):
        sequence([], MACHINE)


@given(seed=st.integers(0, 500), count=st.integers(1, 60))
def test_the_nearest_start_is_always_taken(seed, count):
    random = np.random.default_rng(seed)
    start, end = random.uniform(0, 100, (2, count, 2))
    order = nearest_neighbour(start, end, np.zeros(2))
    assert sorted(order) == list(range(count))
    here, left = np.zeros(2), set(range(count))
    for track in order:
        left_now = np.array(sorted(left))
        distances = np.hypot(*(start[left_now] - here).T)
        assert np.hypot(*(start[track] - here)) <= distances.min() + 1e-12
        left.remove(int(track))
        here = end[track]


def test_headings_take_the_nearest_equivalent_turn():
    start = np.array([350.0, 10.0, 350.0])
    shift = unwound(start, start, start, start, 0.0, -1080.0, 1080.0, 360.0)
    np.testing.assert_array_equal(start + shift, [-10.0, 10.0, -10.0])


def test_headings_come_back_before_the_limit():
    start, end = np.array([0.0, 0.0]), np.array([300.0, 300.0])
    shift = unwound(start, end, start, end, 0.0, -100.0, 400.0, 360.0)
    np.testing.assert_array_equal(shift, [0.0, 0.0])
