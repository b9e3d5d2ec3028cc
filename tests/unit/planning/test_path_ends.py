"""Joints of paths that the drawing leaves a little open."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip.geometry.path import Paths
from knifetip.planning.path_ends import close_joints
from tests.support.shapes import edges


@pytest.mark.parametrize("turned", [False, True])
def test_a_short_segment_keeps_its_direction(turned: bool) -> None:
    ends = edges(((0, 40), (0, 0)), ((0, 0.0018), (0.5, 0.0018)), ((0.5, 0), (0.5, 40)))
    ends = ends[::-1, ::-1] if turned else ends
    first = np.array([0, 3], np.int32)
    paths = close_joints(Paths(ends[:, 0], ends[:, 1], np.zeros(3), first))
    np.testing.assert_array_equal(paths.start[1:], paths.end[:-1])
    np.testing.assert_array_equal([paths.start[1], paths.end[1]], ends[1])
