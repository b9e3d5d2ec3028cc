"""Edges connected into paths."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from knifetip.geometry.chain import Chains, chain, continues_straight
from knifetip.geometry.tolerance import ANGLE
from knifetip.geometry.vertices import number_vertices
from tests.support.shapes import closed, edges

SQUARE = closed((0, 0), (100, 0), (100, 100), (0, 100))


def sizes(chains: Chains) -> list[int]:
    found: list[int] = np.diff(chains.first).tolist()
    return found


def test_a_square_of_loose_edges_is_one_closed_path() -> None:
    chains = chain(SQUARE, np.zeros(4))
    assert sizes(chains) == [4]
    assert chains.paths(SQUARE, np.zeros(4)).closed.tolist() == [True]


@given(seed=st.integers(0, 10_000))
def test_order_and_direction_of_the_edges_do_not_matter(seed: int) -> None:
    random = np.random.default_rng(seed)
    shuffled = SQUARE[random.permutation(4)]
    backwards = random.random(4) < 0.5
    shuffled[backwards] = shuffled[backwards][:, ::-1]
    paths = chain(shuffled, np.zeros(4)).paths(shuffled, np.zeros(4))
    assert len(paths) == 1
    np.testing.assert_allclose(paths.end[:-1], paths.start[1:])
    assert paths.lengths[0] == 400.0


def test_of_three_edges_at_a_point_the_two_straight_ones_are_connected() -> None:
    tee = edges(((0, 0), (50, 0)), ((50, 0), (100, 0)), ((50, 0), (50, 30)))
    assert sorted(sizes(chain(tee, np.zeros(3)))) == [1, 2]


def test_of_three_edges_at_angles_none_are_connected() -> None:
    star = edges(((0, 0), (50, 0)), ((0, 0), (-30, 40)), ((0, 0), (-30, -40)))
    assert sizes(chain(star, np.zeros(3))) == [1, 1, 1]


def test_an_end_with_two_straight_candidates_stays_open() -> None:
    fork = edges(((0, 0), (50, 0)), ((50, 0), (100, 0)), ((50, 0), (100, 0.2)))
    assert sizes(chain(fork, np.zeros(3))) == [1, 1, 1]


def test_a_corner_sharper_than_the_largest_turn_is_not_joined() -> None:
    corner = edges(((0, 0), (50, 0)), ((50, 0), (50, 50)))
    assert sizes(chain(corner, np.zeros(2), max_turn=89.0)) == [1, 1]
    assert sizes(chain(corner, np.zeros(2), max_turn=91.0)) == [2]


def test_a_line_and_a_tangent_arc_are_connected() -> None:
    # From the line's end due east an arc of a quarter turn to the left.
    smooth = edges(((0, 0), (50, 0)), ((50, 0), (60, 10)))
    assert sizes(chain(smooth, np.array([0.0, np.tan(np.pi / 8)]), max_turn=ANGLE)) == [2]


def test_ends_further_apart_than_the_gap_are_not_joined() -> None:
    apart = edges(((0, 0), (50, 0)), ((50.003, 0), (100, 0)))
    assert sizes(chain(apart, np.zeros(2))) == [1, 1]
    assert sizes(chain(apart, np.zeros(2), gap=0.004)) == [2]


@given(seed=st.integers(0, 1000), gap=st.sampled_from([0.05, 0.5, 2.0]))
def test_vertices_equal_those_of_an_exhaustive_search(seed: int, gap: float) -> None:
    points = np.random.default_rng(seed).uniform(-10, 10, (60, 2))
    near = np.hypot(*(points[:, None] - points[None]).transpose(2, 0, 1)) <= gap
    reach = np.linalg.matrix_power(near.astype(float), 60) > 0
    found = number_vertices(points, gap)
    np.testing.assert_array_equal(found[:, None] == found[None], reach)


def test_a_path_is_continued_by_one_that_leaves_straight() -> None:
    points = np.array([[0.0, 0.0], [0.01, 0.0], [50.0, 0.0]])
    directions = np.array([[1.0, 0.0], [-1.0, 0.0], [1.0, 0.0]])
    assert continues_straight(points, directions).tolist() == [True, True, False]


def test_no_edges_give_no_paths() -> None:
    assert sizes(chain(np.zeros((0, 2, 2)), np.zeros(0))) == []
