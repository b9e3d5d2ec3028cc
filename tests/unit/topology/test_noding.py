"""Edges are split where others end on them, cross them or touch them."""

import numpy as np
import pytest

from knifetip.topology.noding import split_at_crossings


@pytest.mark.parametrize("gap", [0.0, 1e-7, 0.0015])
def test_arcs_that_touch_between_their_ends_are_split_there(gap: float) -> None:
    top = 20.0 + gap
    ends = np.array([[(10.0, 0.0), (-10.0, 0.0)], [(-10.0, top), (10.0, top)]])
    pieces, _, row = split_at_crossings(ends, np.ones(2))
    np.testing.assert_array_equal(np.sort(row), [0, 0, 1, 1])
    touched = pieces.reshape(-1, 2)
    touched = touched[np.abs(touched[:, 0]) < 1.0]
    np.testing.assert_allclose(touched, [(0.0, 10.0)] * 4, atol=0.002)


def test_a_short_edge_that_nothing_splits_is_kept() -> None:
    ends = np.array([[(0, 0), (40, 0)], [(20, -5), (20, 5)], [(60, 0), (60.001, 0)]], np.float64)
    _, _, row = split_at_crossings(ends, np.zeros(3))
    assert row.tolist() == [0, 0, 1, 1, 2]
