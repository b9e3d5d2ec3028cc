"""Tracks in a chosen order: the ends at which they start, and the places of the other tracks."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from knifetip.sequencing.chosen_order import choose_ends, in_chosen_order
from knifetip.sequencing.order import link_times

PACE = np.array([[1000.0, 800.0, 720.0], [4000.0, 3000.0, 2000.0]])


def test_listed_tracks_share_the_positions_of_listed_tracks() -> None:
    order = np.array([4, 2, 0, 3, 1], np.int32)
    rank = np.array([1, 3, 3, 0, 2])  # tracks 3, 0 and 4 have places; 1 and 2 have none
    np.testing.assert_array_equal(in_chosen_order(order, rank, 3), [3, 2, 0, 4, 1])


@pytest.mark.parametrize("seed", range(8))
def test_no_other_ends_are_better_in_the_chosen_order(seed: int) -> None:
    random = np.random.default_rng(seed)
    count = 6
    entry, leave = random.uniform(0.0, 400.0, (2, 2, count, 3))
    origin, order = random.uniform(0.0, 400.0, 3), random.permutation(count).astype(np.int32)

    def seconds(flip: np.ndarray) -> float:
        ends = np.asarray(flip, np.int64)
        return float(link_times(entry[ends, order], leave[ends, order], origin, PACE, 360.0).sum())

    best = min(seconds(np.array(flip)) for flip in product((0, 1), repeat=count))
    assert seconds(choose_ends(order, entry, leave, origin, PACE, 360.0)) == pytest.approx(best)
