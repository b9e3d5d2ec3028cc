"""Parts and holes between which the cutter does not fit are milled together."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip.geometry.path import Paths
from knifetip.planning.facing_contours import merge_facing_layers, slit_layers

Contour = list[tuple[float, float, float]]


def rectangle(x: float, y: float, width: float, height: float) -> Contour:
    """Return the vertices of a rectangle, anticlockwise, with the bulge of each side."""
    return [(x, y, 0.0), (x + width, y, 0.0), (x + width, y + height, 0.0), (x, y + height, 0.0)]


def circle(x: float, y: float, radius: float) -> Contour:
    return [(x - radius, y, 1.0), (x + radius, y, 1.0)]


def merged(*contours: tuple[int, Contour]) -> list[int]:
    """Return the layers of contours after merging, for a cutter of 6 mm.

    Contours with an odd layer are holes, and those with an even one parts, which are reversed.
    """
    starts, ends, bulges, first = [], [], [], [0]
    for layer, vertices in contours:
        points = np.array(vertices)
        following = np.roll(points, -1, axis=0)
        pair = (points[:, :2], following[:, :2], points[:, 2])
        if layer % 2 == 0:
            pair = (pair[1][::-1], pair[0][::-1], -pair[2][::-1])
        starts.append(pair[0])
        ends.append(pair[1])
        bulges.append(pair[2])
        first.append(first[-1] + len(points))
    paths = Paths(
        np.concatenate(starts), np.concatenate(ends), np.concatenate(bulges), np.array(first)
    )
    layers = np.array([layer for layer, _ in contours])
    result = merge_facing_layers(paths, layers, np.ones(len(layers), np.bool_), 6.0)
    return [int(layer) for layer in result]


OUTLINE = (0, rectangle(0, 0, 300, 200))
HOLE = (1, rectangle(20, 20, 100, 100))


@pytest.mark.parametrize(("gap", "layer"), [(5.9, 1), (6.1, 2)])
def test_a_part_nearer_to_its_hole_than_the_diameter_gets_the_layer_of_the_hole(
    gap: float, layer: int
) -> None:
    part = (2, rectangle(20 + gap, 40, 40, 40))
    assert merged(OUTLINE, HOLE, part) == [0, 1, layer]


@pytest.mark.parametrize(("gap", "layer"), [(5.9, 1), (6.1, 2)])
def test_the_distance_of_arcs_is_measured_between_their_ends(gap: float, layer: int) -> None:
    assert merged(OUTLINE, HOLE, (2, circle(70, 40 + gap, 20))) == [0, 1, layer]
    round_hole = (1, circle(70, 70, 50))
    assert merged(OUTLINE, round_hole, (2, circle(70, 40 + gap, 20))) == [0, 1, layer]


def test_a_part_near_a_part_that_faces_the_hole_is_milled_with_both() -> None:
    first, second = (2, rectangle(24, 40, 30, 40)), (2, rectangle(58, 40, 30, 40))
    assert merged(OUTLINE, HOLE, first, second) == [0, 1, 1, 1]
    far = (2, rectangle(60.5, 40, 30, 40))
    assert merged(OUTLINE, HOLE, first, far) == [0, 1, 1, 2]


def test_a_part_is_not_merged_with_a_hole_on_the_other_side_of_the_board() -> None:
    other = (1, rectangle(125, 20, 100, 100))
    inside_other = (2, rectangle(132, 40, 40, 40))
    assert merged(OUTLINE, HOLE, other, inside_other) == [0, 1, 1, 2]
    # The hole in a part is near to the outline of the part.
    part, its_hole = (2, rectangle(22, 40, 40, 40)), (3, rectangle(24, 42, 36, 36))
    assert merged(OUTLINE, HOLE, part, its_hole) == [0, 1, 1, 3]


@pytest.mark.parametrize(("gap", "layer"), [(5.9, 0), (6.1, 2)])
def test_parts_near_each_other_in_the_same_waste_are_milled_together(
    gap: float, layer: int
) -> None:
    # Slits or necks may give contours of one waste different layers.
    small = (2, rectangle(300 + gap, 50, 0.04, 0.04))
    assert merged(OUTLINE, small) == [0, layer]
    # A chain of near parts ends in the lowest layer of all.
    last = (4, rectangle(310 + gap, 50, 40, 40))
    bridge = (2, rectangle(304 + gap, 50, 2, 40))
    assert merged(OUTLINE, small, bridge, last) == [0, *([layer] * 3)]


def test_a_part_in_the_bay_of_another_part_is_in_the_same_waste() -> None:
    # The box of the part lies in the box of the bay's part, but not in the part.
    corners = ((0, 0), (100, 0), (100, 100), (90, 100), (90, 10), (0, 10))
    bay: Contour = [(x, y, 0.0) for x, y in corners]
    assert merged((0, bay), (2, rectangle(84.5, 50, 4, 4))) == [0, 0]
    assert merged((0, bay), (2, rectangle(70, 50, 4, 4))) == [0, 2]


def test_a_part_in_the_hole_of_a_near_part_has_other_waste() -> None:
    ring, hole = (2, rectangle(22, 40, 40, 40)), (3, rectangle(24, 42, 36, 36))
    inner = (4, rectangle(26, 44, 10, 10))
    assert merged(OUTLINE, HOLE, ring, hole, inner) == [0, 1, 1, 3, 3]


@pytest.mark.parametrize(("gap", "layer"), [(0.0, 2), (2.9, 2), (3.1, 0)])
def test_a_slit_beside_a_contour_is_cut_before_it(gap: float, layer: int) -> None:
    part = np.array([(0, 0), (0, 40), (40, 40), (40, 0), (0, 0)], np.float64)
    slit = np.array([(-gap - 5.0, 20.0), (-gap, 20.0)])
    paths = Paths(
        np.concatenate([part[:-1], slit[:-1]]), np.concatenate([part[1:], slit[1:]]),
        np.zeros(5), np.array([0, 4, 5]),
    )  # fmt: skip
    milled = np.array([True, False])
    assert slit_layers(paths, np.array([2, 0]), milled, ~milled, 3.0).tolist() == [2, layer]
    assert slit_layers(paths, np.array([2, 3]), milled, ~milled, 3.0).tolist() == [2, 3]
