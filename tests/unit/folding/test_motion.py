"""Panels of boxes in space, beside positions from arithmetic of the tests."""

from __future__ import annotations

from collections import Counter
from itertools import product
from math import cos, radians, sin

import numpy as np
import pytest
import shapely

from knifetip.folding.motion import panel_transforms
from knifetip.folding.records import FoldTree
from knifetip.geometry.columns import F64
from tests.support.shapes import BOARD, closed, edges
from tests.unit.folding.blanks import CREASE, CUT, GROOVE, THIN, cross, folded

A = 40.0


def corners(tree: FoldTree, panel: int, z: float, fraction: float = 1.0) -> F64:
    """Return the corners of a panel at a height of the flat board, in space."""
    flat = shapely.get_coordinates(tree.panels[panel].polygon.exterior)[:-1]
    placed = panel_transforms(tree, np.array([fraction]))[0, panel]
    points = np.column_stack([flat, np.full(len(flat), z), np.ones(len(flat))])
    moved: F64 = (points @ placed.T)[:, :3]
    return moved


def panel_at(tree: FoldTree, x: float, y: float) -> int:
    (found,) = [
        k for k, panel in enumerate(tree.panels) if panel.polygon.contains(shapely.Point(x, y))
    ]
    return found


@pytest.mark.parametrize(("side_up", "height"), [("inside", A), ("outside", -A)])
def test_the_panels_of_a_cube_meet_at_its_eight_corners(side_up: str, height: float) -> None:
    tree = folded(*cross(A), board=THIN, side_up=side_up)
    assert len(tree.panels) == 6
    assert tree.roots == (panel_at(tree, A / 2, 1.5 * A),)
    expected = set(product((0.0, A), (A, 2 * A), (0.0, height)))
    met: Counter[tuple[float, ...]] = Counter()
    for panel in range(6):
        for corner in corners(tree, panel, 0.0):
            nearest = min(expected, key=lambda one: np.abs(np.array(one) - corner).max())
            np.testing.assert_allclose(corner, nearest, atol=1e-6)
            met[nearest] += 1
    assert met == dict.fromkeys(expected, 3)


def test_a_turned_blank_folds_to_the_same_box() -> None:
    turn = np.array([[cos(0.3), sin(0.3)], [-sin(0.3), cos(0.3)]])
    rows = [(kind, ends @ turn + (17.0, -5.0)) for kind, ends in cross(A)]
    tree = folded(*rows, board=THIN)
    heights = np.concatenate([corners(tree, panel, 0.0)[:, 2] for panel in range(6)])
    # Corners of panels lie on a grid of 0.001 mm.
    np.testing.assert_allclose(np.sort(heights), np.repeat([0.0, A], 12), atol=0.005)
    places = np.concatenate([corners(tree, panel, 0.0) for panel in range(6)])
    apart = np.linalg.norm(places[:, None] - places[None], axis=2)
    assert ((apart < 0.01).sum(axis=1) == 3).all()


@pytest.mark.parametrize("fraction", [0.0, 0.25, 0.5, 1.0])
def test_a_chain_of_panels_turns_by_the_sum_of_its_angles(fraction: float) -> None:
    tree = folded(*cross(A), board=THIN)
    angle = radians(90.0 * fraction)
    # From the fold at y = A downwards: one side at the angle, then one at twice the angle.
    y = A - A * cos(angle) - A * cos(2.0 * angle)
    z = A * sin(angle) + A * sin(2.0 * angle)
    lowest = corners(tree, panel_at(tree, A / 2, -A / 2), 0.0, fraction)
    end = lowest[np.hypot(lowest[:, 1] - y, lowest[:, 2] - z) < 1e-6]
    assert sorted(end[:, 0].round(6) + 0.0) == [0.0, A]


def test_a_groove_turns_about_the_bottom_face_and_a_crease_about_the_middle() -> None:
    for line_type, height in ((GROOVE, 0.0), (CREASE, BOARD.caliper / 2.0)):
        tree = folded(*cross(A, line_type))
        wall = panel_at(tree, A / 2, 2.5 * A)
        # The fold at y = 2 A stays where it is at the height of the axis, and only there.
        for z in (0.0, BOARD.caliper / 2.0, BOARD.caliper):
            foot = corners(tree, wall, z)
            foot = foot[np.argsort(foot[:, 2])][:2]
            np.testing.assert_allclose(foot[:, 1], 2 * A + height - z, atol=1e-6)
            np.testing.assert_allclose(foot[:, 2], height, atol=1e-6)


def test_an_own_angle_counts_for_its_fold_only() -> None:
    tree = folded(*cross(A), board=THIN)
    (number,) = [k for k in tree.order if tree.folds[k].child == panel_at(tree, A / 2, 2.5 * A)]
    again = folded(*cross(A), board=THIN, angles={number: -30.0})
    wall = corners(again, panel_at(again, A / 2, 2.5 * A), 0.0)
    assert wall[:, 2].min() == pytest.approx(-A * sin(radians(30.0)), abs=1e-6)
    same = panel_at(again, 1.5 * A, 1.5 * A)
    np.testing.assert_allclose(corners(again, same, 0.0), corners(tree, same, 0.0))


def test_many_fractions_at_once_give_what_each_gives_alone() -> None:
    tree = folded(*cross(A))
    fractions = np.array([0.0, 0.3, 1.0])
    together = panel_transforms(tree, fractions)
    assert together.shape == (3, 6, 4, 4)
    np.testing.assert_array_equal(together[0], np.tile(np.eye(4), (6, 1, 1)))
    for k, fraction in enumerate(fractions):
        np.testing.assert_allclose(together[k], panel_transforms(tree, fractions[k : k + 1])[0])
        assert fraction == fractions[k]


def test_two_blanks_fold_each_about_its_own_root() -> None:
    shifted = [(kind, ends + np.array((200.0, 0.0))) for kind, ends in cross(A)]
    tree = folded(*cross(A), *shifted, board=THIN)
    assert len(tree.panels) == 12
    assert {tree.panels[root].blank for root in tree.roots} == {0, 1}
    heights = np.concatenate([corners(tree, k, 0.0)[:, 2] for k in range(12)])
    assert sorted(set(heights.round(5) + 0.0)) == [0.0, A]


def test_a_crease_that_ends_before_the_cut_divides_the_blank() -> None:
    square = closed((0.0, 0.0), (100.0, 0.0), (100.0, 80.0), (0.0, 80.0))
    short = edges(((50.0, 2.0), (50.0, 77.0)))
    tree = folded((CUT, square), (CREASE, short))
    assert [round(panel.polygon.area, 2) for panel in tree.panels] == [4000.0, 4000.0]
    far = edges(((50.0, 8.0), (50.0, 72.0)))
    assert len(folded((CUT, square), (CREASE, far)).panels) == 1


def test_slits_in_line_with_a_fold_leave_one_hinge() -> None:
    square = closed((0.0, 0.0), (100.0, 0.0), (100.0, 80.0), (0.0, 80.0))
    fold = edges(((50.0, 0.0), (50.0, 20.0)), ((50.0, 30.0), (50.0, 80.0)))
    slit = edges(((50.0, 20.0), (50.0, 30.0)))
    tree = folded((CUT, square), (CREASE, fold), (CUT, slit))
    (only,) = tree.folds
    assert only.hinge.length == pytest.approx(70.0, abs=0.01)
    assert only.hinge.straight
    np.testing.assert_allclose(sorted(only.axis[:, 1]), [0.0, 80.0], atol=1e-3)
