"""The order of tracks: shorter than greedy, and always the same."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from knifetip.geometry.columns import F64, I32, Bool
from knifetip.model.tool import Reversal
from knifetip.sequencing.nearest import nearest_neighbour
from knifetip.sequencing.order import greedy_order, link_times, short_order
from tests.support.examples import examples

PACE = np.array([[1500.0, 1500.0, 3600.0], [8000.0, 8000.0, 36000.0]])
#: Limits of axes with which the time of an air move is the greater of its X and Y distances.
DISTANCE = np.array([[1.0, 1.0, 1e9], [1e12, 1e12, 1e12]])
HOME = np.zeros(3)


def tracks(seed: int, count: int, way: Reversal) -> tuple[F64, F64]:
    """Return the entry and exit poses, (2, n, 3) each, of random tracks of 30 mm in both
    directions.
    """
    random = np.random.default_rng(seed)
    start, azimuth = random.uniform(0, 800, (count, 2)), random.uniform(0, 360, count)
    end = start + 30.0 * np.column_stack([np.cos(np.radians(azimuth)), np.sin(np.radians(azimuth))])
    begin, finish = np.column_stack([start, azimuth]), np.column_stack([end, azimuth])
    if way == Reversal.ONE:
        return np.stack([begin, begin]), np.stack([finish, finish])
    if way == Reversal.EITHER:
        return np.stack([begin, finish]), np.stack([finish, begin])
    half = np.array([0.0, 0.0, 180.0])
    return np.stack([begin, finish + half]), np.stack([begin + half, finish])


def total(entry: F64, leave: F64, order: I32, flip: Bool, pace: F64 = PACE) -> float:
    side = flip.astype(int)
    return float(link_times(entry[side, order], leave[side, order], HOME, pace, 360.0).sum())


@settings(deadline=None)
@given(seed=st.integers(0, 500), count=st.integers(1, 60))
def test_the_nearest_start_is_always_taken(seed: int, count: int) -> None:
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


def test_a_link_takes_as_long_as_its_slowest_axis() -> None:
    # X 450 mm at 8000 mm/s² up to 1500 mm/s: 450/1500 + 1500/8000 = 0.4875 s.
    # C 100° at 36000°/s²: 2 √(100/36000) = 0.1054 s; Y 2 mm: 2 √(2/8000) = 0.0316 s.
    entry = np.array([[450.0, 0.0, 0.0], [450.0, 0.0, 460.0], [450.0, 2.0, 460.0]])
    times = link_times(entry, entry, HOME, PACE, 360.0)
    np.testing.assert_allclose(times, [0.4875, 0.1054093, 0.0316228], rtol=1e-6)
    # A wheel turns by 80° instead: 2 √(80/36000) = 0.0943 s.
    assert link_times(entry, entry, HOME, PACE, 180.0)[1] == pytest.approx(0.0942809)


@pytest.mark.parametrize("way", Reversal)
@pytest.mark.parametrize("seed", range(6))
def test_the_best_order_of_five_tracks_is_found(way: Reversal, seed: int) -> None:
    entry, leave = tracks(seed, 5, way)
    order, flip = short_order(entry, leave, HOME, PACE, 360.0, way)
    sides = [(0,)] * 5 if way == Reversal.ONE else [(0, 1)] * 5
    best = min(
        total(entry, leave, np.array(tour), np.array(side))
        for tour in itertools.permutations(range(5))
        for side in itertools.product(*sides)
    )
    assert total(entry, leave, order, flip) == pytest.approx(best)


@pytest.mark.parametrize("way", Reversal)
@examples(25)
@given(seed=st.integers(0, 10_000), count=st.integers(1, 60))
def test_every_track_comes_once_and_the_order_is_no_longer_than_greedy(
    way: Reversal, seed: int, count: int
) -> None:
    entry, leave = tracks(seed, count, way)
    order, flip = short_order(entry, leave, HOME, PACE, 360.0, way)
    assert sorted(order) == list(range(count))
    assert way != Reversal.ONE or not flip.any()
    assert total(entry, leave, order, flip) <= total(
        entry, leave, *greedy_order(entry, leave, HOME, way)
    )
    again = short_order(entry, leave, HOME, PACE, 360.0, way)
    np.testing.assert_array_equal(order, again[0])
    np.testing.assert_array_equal(flip, again[1])


@pytest.mark.parametrize(("way", "share"), list(zip(Reversal, (0.88, 0.90, 0.90), strict=True)))
def test_links_of_two_hundred_tracks_are_faster_than_greedy(way: Reversal, share: float) -> None:
    entry, leave = tracks(1, 200, way)
    order, flip = short_order(entry, leave, HOME, PACE, 360.0, way)
    best = total(entry, leave, order, flip)
    first = total(entry, leave, *greedy_order(entry, leave, HOME, way))
    assert best < share * first


@pytest.mark.parametrize(("way", "seconds"), list(zip(Reversal, (99, 88.5, 92), strict=True)))
def test_links_of_a_thousand_tracks_keep_their_time(way: Reversal, seconds: float) -> None:
    # The greedy order takes 117.6, 108.7 and 115.1 s.
    entry, leave = tracks(1, 1000, way)
    assert total(entry, leave, *short_order(entry, leave, HOME, PACE, 360.0, way)) < seconds


@pytest.mark.parametrize(
    ("seed", "count", "pace", "lkh"),
    [
        (2, 300, PACE, 33.6327),
        (2, 300, DISTANCE, 6405.07),
        (3, 1000, PACE, 87.3351),
        (3, 1000, DISTANCE, 10637.9),
    ],
)
def test_orders_are_within_one_percent_of_the_solver_lkh(
    seed: int, count: int, pace: F64, lkh: float
) -> None:
    # LKH 2.0.9 solved these as symmetric tours over both ends of all tracks.
    entry, leave = tracks(seed, count, Reversal.EITHER)
    order, flip = short_order(entry, leave, HOME, pace, 360.0, Reversal.EITHER)
    assert total(entry, leave, order, flip, pace) < 1.01 * lkh


@pytest.mark.parametrize("way", Reversal)
def test_tracks_at_one_point_are_ordered(way: Reversal) -> None:
    entry = np.zeros((2, 40, 3))
    order, _ = short_order(entry, entry, HOME, PACE, 360.0, way)
    assert sorted(order) == list(range(40))
