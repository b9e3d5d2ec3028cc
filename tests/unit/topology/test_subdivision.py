"""``subdivision``: how many components of edges enclose a point or another component."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip.topology.subdivision import subdivide

#: Left vertex of two triangles that share a side, and of the notch between them.
CORNER = (122.00778943865605, 231.5217157945216)
RIGHT = (278.062778913443, 231.521715794522)
TRIANGLES = [
    (108.713774623087, 227.521715794522, *CORNER), (*CORNER, *RIGHT),
    (*CORNER, 108.713774623087, 235.521715794522),
    (108.713774623087, 235.521715794522, *RIGHT), (*RIGHT, 108.713774623087, 227.521715794522),
]  # fmt: skip


@pytest.mark.parametrize("steps", range(-4, 5))
def test_a_point_above_a_corner_lies_in_the_face_above_it(steps: int) -> None:
    # A ray that passes the corner by a rounding error meets two edges at the same height.
    faces = subdivide(np.array(TRIANGLES).reshape(-1, 2, 2), np.zeros(5))
    x, y = CORNER
    aside = steps * np.spacing(x)
    points = np.array([(x + aside, y + 0.1), (x + aside, y - 0.1), (x - 1.0, y)])
    np.testing.assert_array_equal(faces.count_enclosing(points), [1, 1, 0])


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_point_beside_the_end_of_a_circle_lies_outside(side: float) -> None:
    # The two halves of the circle meet a vertical line at their leftmost or rightmost point.
    circle = np.array([[[-5.0, 0.0], [5.0, 0.0]], [[5.0, 0.0], [-5.0, 0.0]]])
    faces = subdivide(circle, np.ones(2))
    points = side * np.array([(4.999999999, 0.0), (5.000000001, 0.0)])
    np.testing.assert_array_equal(faces.count_enclosing(points), [1, 0])


@pytest.mark.parametrize("overlap", [-0.001, 0.0, 0.001, 0.04])
def test_a_hole_above_outlines_that_overlap_a_little_lies_in_the_upper_one(overlap: float) -> None:
    """Two circles of radius 60 one above the other, and holes in them above where they touch."""
    rows = []
    for y, radius in ((0.0, 60.0), (120.0 - overlap, 60.0), (0.0, 2.0), (120.0, 2.0), (260.0, 2.0)):
        rows += [[[-radius, y], [radius, y]], [[radius, y], [-radius, y]]]
    faces = subdivide(np.array(rows), np.ones(10))
    np.testing.assert_array_equal(faces.depth[faces.component[::2]], [0, 0, 1, 1, 0])
    upper = faces.face[2, 0]
    assert faces.enclosing[faces.component[6]] == upper
