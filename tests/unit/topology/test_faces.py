"""``faces``: the faces on both sides of each piece, compared with shapely's polygons."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from knifetip.geometry.columns import F64
from knifetip.topology.faces import Faces, trace_faces
from knifetip.topology.planar_graph import PlanarGraph, build_graph
from tests.support.cartons.random_drawings import random_drawing

TOUCH = 0.05


def graph_and_faces(ends: F64, bulge: F64) -> tuple[PlanarGraph, Faces]:
    graph = build_graph(ends, bulge, TOUCH, 1.0)
    assert graph is not None
    return graph, trace_faces(graph, ends, bulge, TOUCH)


def straight(*lines: tuple[float, float, float, float]) -> tuple[PlanarGraph, Faces]:
    ends = np.array(lines, float).reshape(-1, 2, 2)
    return graph_and_faces(ends, np.zeros(len(ends)))


SQUARE = [(0, 0, 10, 0), (10, 0, 10, 10), (10, 10, 0, 10), (0, 10, 0, 0)]


def test_a_square_has_an_inside_and_an_outside() -> None:
    _, sides = straight(*SQUARE)
    np.testing.assert_allclose(np.sort(sides.area), [-100.0, 100.0])
    assert sides.area[sides.left[0]] == 100.0
    assert sides.right[0] == sides.outer_face[0]


def test_a_circle_of_two_half_turns_has_the_area_of_a_circle() -> None:
    ends = np.array([[[-5.0, 0], [5, 0]], [[5, 0], [-5, 0]]])
    _, sides = graph_and_faces(ends, np.ones(2))
    np.testing.assert_allclose(np.sort(sides.area), [-25 * np.pi, 25 * np.pi])


def test_a_line_across_makes_two_faces_and_one_that_ends_inside_none() -> None:
    _, sides = straight(*SQUARE, (5, 0, 5, 10), (0, 5, 3, 5))
    np.testing.assert_allclose(np.sort(sides.area), [-100.0, 50.0, 50.0])


def test_a_part_lies_in_the_face_that_holds_it_and_not_in_the_one_beside_it() -> None:
    inner = [(6, 6, 8, 6), (8, 6, 8, 8), (8, 8, 6, 8), (6, 8, 6, 6)]
    graph, sides = straight(*SQUARE, (5, 0, 5, 10), *inner)
    hole = graph.component[graph.first[5]]
    assert sides.enclosing[graph.component[0]] == -1
    right_half = sides.right[graph.first[4]]
    assert sides.enclosing[hole] == right_half


def test_what_lies_inside_an_arc_is_found() -> None:
    ends = np.array([[[-50.0, 0], [50, 0]], [[50, 0], [-50, 0]], [[-45, 5], [-40, 5]]])
    graph, sides = graph_and_faces(ends, np.array([1.0, 1.0, 0.0]))
    assert sides.area[sides.enclosing[graph.component[graph.first[2]]]] > 0.0


@pytest.mark.parametrize("bend", [1.0, 0.3])
def test_what_lies_between_an_arc_and_its_chord_is_held_by_their_face(bend: float) -> None:
    # The arc goes down and bulges to the left of its chord; the chord goes up again.
    belly = [[[0.0, 50], [0, -50]], [[0, -50], [0, 50]]]
    ends = np.array([*belly, [[-9, 0], [-7, 1]]])
    for turn, holds in ((bend, True), (-bend, False)):
        graph, sides = graph_and_faces(ends, np.array([turn, 0.0, 0.0]))
        within = sides.enclosing[graph.component[graph.first[2]]]
        assert (within >= 0 and sides.area[within] > 0.0) == holds


@pytest.mark.parametrize("seed", range(40))
def test_shapely_finds_the_same_faces(seed: int) -> None:
    drawing, _, _ = random_drawing(seed)
    # shapely flattens arcs and links no dashes, so only lines and their splits are compared.
    lines = np.flatnonzero(drawing.bulge == 0.0)
    ends = np.array(drawing.ends[lines])
    graph, sides = graph_and_faces(ends, np.zeros(len(ends)))
    own = graph.twin_piece == np.arange(len(graph.twin_piece))
    segments = shapely.linestrings(
        np.stack([graph.vertex[graph.start[own]], graph.vertex[graph.end[own]]], axis=1)
    )
    found = [shapely.Polygon(one.exterior).area for one in shapely.polygonize(segments).geoms]
    mine = sides.area[sides.area > 1e-6]
    # A polygon with a hole is a face whose outer walk has the area of its outline.
    np.testing.assert_allclose(np.sort(mine), np.sort(found), rtol=1e-6, atol=1e-6)
