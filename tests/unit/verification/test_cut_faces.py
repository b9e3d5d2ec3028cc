"""The faces into which cuts divide the sheet."""

import numpy as np
import pytest

from knifetip.verification.checks.order.cut_faces import find_cut_faces
from knifetip.verification.expectation.edges import place_edges
from knifetip.verification.expectation.outline import count_enclosing, find_outlines
from tests.support.programs.handwritten import CUT, dieline


@pytest.mark.parametrize("bulge", [0.0, 0.1])
def test_a_ray_does_not_pass_between_two_joined_ends(bulge: float) -> None:
    # The right side of the first blank consists of a line and a line or arc that are joined with a
    # gap of 0.0008 mm.  The ray to the left of the second blank runs at the height of this gap.
    drawn = dieline(
        (CUT, 0, 0, 100, 0, 0.0), (CUT, 100, 0, 100, 40, 0.0), (CUT, 100, 40.0008, 100, 80, bulge),
        (CUT, 100, 80, 0, 80, 0.0), (CUT, 0, 80, 0, 0, 0.0),
        (CUT, 110, 39.9998, 130, 20, 0.0), (CUT, 130, 20, 130, 60, 0.0),
        (CUT, 130, 60, 110, 39.9998, 0.0),
    )  # fmt: skip
    faces = find_cut_faces(place_edges(drawn, (0.0, 0.0)))
    assert faces.count == 3
    np.testing.assert_array_equal(faces.face.min(axis=1), 0)


def test_a_cut_that_passes_another_one_by_a_little_more_than_a_joint_crosses_it() -> None:
    # The slanted cuts of the triangle end 0.0021 mm beyond the rectangle's left side.  Measured
    # along the cuts, they leave the band of 0.002 mm beside it only 0.0001 mm before their ends.
    drawn = dieline(
        (CUT, 50, 0, 90, 0, 0.0), (CUT, 90, 0, 90, 40, 0.0),
        (CUT, 90, 40, 50, 40, 0.0), (CUT, 50, 40, 50, 0, 0.0),
        (CUT, 30, 20, 50.0021, 10, 0.0), (CUT, 30, 20, 50.0021, 30, 0.0),
    )  # fmt: skip
    faces = find_cut_faces(place_edges(drawn, (0.0, 0.0)))
    assert faces.count == 3  # outside, rectangle and triangle


@pytest.mark.parametrize("gap", [-0.0018, 0.0018])
def test_a_gap_between_joined_ends_does_not_turn_a_face_inside_out(gap: float) -> None:
    # A triangle at the end of a long cut, far from the first end.  The area between the origin and
    # the gap is several times the area of the triangle.
    drawn = dieline(
        (CUT, 0, 0, 300, 0, 0.0), (CUT, 300, 0, 300.3, 0, 0.0), (CUT, 300.3, 0, 300.3, 0.3, 0.0),
        (CUT, 300.3, 0.3, 300, gap, 0.0),
    )  # fmt: skip
    faces = find_cut_faces(place_edges(drawn, (0.0, 0.0)))
    assert faces.count == 2
    np.testing.assert_array_equal(faces.face, [[0, 0], [1, 0], [1, 0], [1, 0]])


def test_blanks_with_touching_round_sides_have_a_face_each() -> None:
    # The four arcs meet at X40 Y0 in a horizontal direction, but for 0.00002 rad by which those of
    # the two blanks cross each other; they cross again within 0.002 mm.
    bulge = np.tan(0.5 * np.arctan2(15.0, 40.0)) + 1e-5
    drawn = dieline(
        (CUT, 0, -40, 80, -40, 0.0), (CUT, 80, -40, 80, -15, 0.0), (CUT, 0, -15, 0, -40, 0.0),
        (CUT, 80, -15, 40, 0, bulge), (CUT, 40, 0, 0, -15, bulge),
        (CUT, 0, 40, 80, 40, 0.0), (CUT, 80, 15, 80, 40, 0.0), (CUT, 0, 15, 0, 40, 0.0),
        (CUT, 0, 15, 40, 0, bulge), (CUT, 40, 0, 80, 15, bulge),
    )  # fmt: skip
    faces = find_cut_faces(place_edges(drawn, (0.0, 0.0)))
    assert faces.count == 3
    assert faces.locate(np.array([[40.0, -20.0], [40.0, 20.0]])).tolist() == [1, 2]


def test_points_beside_a_gap_between_joined_ends_are_counted_inside() -> None:
    # The ends at X100 are joined, although one is 0.0017 mm higher.  Rays to the right from a point
    # at the height of the lower end, and from less than 0.0017 mm above it, pass between them.
    drawn = dieline(
        (CUT, 0, 0, 110, 0, 0.0), (CUT, 110, 0, 110, 40, 0.0), (CUT, 110, 40, 100, 40, 0.0),
        (CUT, 100, 40.0017, 100, 80, 0.0), (CUT, 100, 80, 0, 80, 0.0), (CUT, 0, 80, 0, 0, 0.0),
    )  # fmt: skip
    outlines = find_outlines(place_edges(drawn, (0.0, 0.0)))
    heights = 40.0 + np.array([-0.003, -0.001, 0.0, 0.0008, 0.0016, 0.003])
    points = np.column_stack([np.full(len(heights), 50.0), heights])
    assert count_enclosing(points, outlines).tolist() == [1] * len(heights)
