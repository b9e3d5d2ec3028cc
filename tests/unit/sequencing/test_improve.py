"""Random changes of a tour: they end early where they do not shorten it, and only there."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip.geometry.columns import F64, I32
from knifetip.model.tool import Reversal
from knifetip.sequencing import order
from knifetip.sequencing.improve import Limits, improve_ring
from knifetip.sequencing.order import link_times, short_order
from knifetip.sequencing.ring import Ends

PACE = np.array([[1500.0, 1500.0, 3600.0], [8000.0, 8000.0, 36000.0]])


@pytest.fixture
def exchanges(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """The numbers of random exchanges of the tours that are improved in a test, in order."""
    numbers: list[int] = []

    def counted(entered: I32, ends: Ends, limits: Limits) -> int:
        numbers.append(improve_ring(entered, ends, limits))
        return numbers[-1]

    monkeypatch.setattr(order, "improve_ring", counted)
    return numbers


def poses(xy: F64) -> tuple[F64, F64]:
    """Return entry and exit poses, (2, n, 3) each, of tracks of 5 mm along X that start at n
    points, (n, 2) mm, or at their other ends.
    """
    start = np.column_stack([xy, np.zeros(len(xy))])
    end = start + np.array([5.0, 0.0, 0.0])
    return np.stack([start, end]), np.stack([end, start])


def time_of_tour(entry: F64, leave: F64) -> float:
    rows, flip = short_order(entry, leave, np.zeros(3), PACE, 360.0, Reversal.EITHER)
    side = flip.astype(int)
    times = link_times(entry[side, rows], leave[side, rows], np.zeros(3), PACE, 360.0)
    return float(times.sum())


def test_exchanges_end_early_on_a_regular_grid(exchanges: list[int]) -> None:
    grid = np.stack(np.meshgrid(np.arange(40) * 10.0, np.arange(20) * 30.0), axis=-1)
    time_of_tour(*poses(grid.reshape(-1, 2)))
    assert exchanges[0] <= 300


def test_exchanges_go_on_while_they_shorten_the_tour(
    exchanges: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    entry, leave = poses(np.random.default_rng(4).uniform(0, 800, (500, 2)))
    time = time_of_tour(entry, leave)
    assert exchanges[0] >= 1500
    monkeypatch.setattr(order, "_MOST_TRIALS", 0)
    assert time < 0.985 * time_of_tour(entry, leave)
    assert exchanges[1] == 0
