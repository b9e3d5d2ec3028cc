"""Creases are split where cuts cross them."""

from __future__ import annotations

import numpy as np

from knifetip.geometry.path import Paths
from knifetip.planning.split_at_cuts import split_at_cuts


def test_two_cuts_that_meet_on_a_crease_leave_nothing_between_them() -> None:
    # Both arcs end on the crease; rounding puts their crossings 3e-14 mm apart.
    crease = Paths(
        np.array([[131.57208076546132, 36.17406617561937]]),
        np.array([[131.57208076546132, 168.14617417561936]]),
        np.zeros(1),
        np.array([0, 1]),
    )
    y = 168.03693117561937
    arcs = np.array(
        [
            [[232.08069576546134, y], [131.5720807654613, 168.0369311756194]],
            [[131.57208076546132, y], [31.063465765461295, 168.0369311756194]],
        ]
    )
    pieces, row, crossed = split_at_cuts(
        crease, arcs, np.full(2, 0.32184437536665644), np.zeros(1, np.bool_)
    )
    assert len(pieces) == 2
    assert row.tolist() == [0, 0]
    assert crossed.tolist() == [[False, True], [True, False]]
    np.testing.assert_allclose(pieces.end[0], pieces.start[1], rtol=0.0, atol=1e-9)
