"""Random changes of a tour: they end early where they do not shorten it, and only there."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip.geometry.columns import F64, I32, U8
from knifetip.model.tool import Reversal
from knifetip.sequencing import order
from knifetip.sequencing.improve import improve_tour
from knifetip.sequencing.order import link_times, short_order
from knifetip.sequencing.tour import Tracks

PACE = np.array([[1500.0, 1500.0, 3600.0], [8000.0, 8000.0, 36000.0]])


@pytest.fixture
def swaps(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """The numbers of random swaps of the tours that are improved in a test, in order."""
    numbers: list[int] = []

    def counted(track: I32, side: U8, tracks: Tracks, trials: int) -> int:
        numbers.append(improve_tour(track, side, tracks, trials))
        return numbers[-1]

    monkeypatch.setattr(order, "improve_tour", counted)
    return numbers


def poses(xy: F64) -> tuple[F64, F64]:
    """Return entry and exit poses, (2, n, 3) each, of tracks of 5 mm along X that start at n
    points, (n, 2) mm.
    """
    start = np.column_stack([xy, np.zeros(len(xy))])
    end = start + np.array([5.0, 0.0, 0.0])
    return np.stack([start, start]), np.stack([end, end])


def time_of_tour(entry: F64, leave: F64) -> float:
    rows, _ = short_order(entry, leave, np.zeros(3), PACE, 360.0, Reversal.ONE)
    return float(link_times(entry[0, rows], leave[0, rows], np.zeros(3), PACE, 360.0).sum())


def test_swaps_end_early_on_a_regular_grid(swaps: list[int]) -> None:
    grid = np.stack(np.meshgrid(np.arange(40) * 10.0, np.arange(20) * 30.0), axis=-1)
    time_of_tour(*poses(grid.reshape(-1, 2)))
    assert swaps[0] <= 400


def test_swaps_go_on_while_they_shorten_the_tour(
    swaps: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    entry, leave = poses(np.random.default_rng(4).uniform(0, 800, (500, 2)))
    time = time_of_tour(entry, leave)
    assert swaps[0] >= 600
    monkeypatch.setattr(order, "_MOST_TRIALS", 0)
    assert time < 0.995 * time_of_tour(entry, leave)
    assert swaps[1] == 0
