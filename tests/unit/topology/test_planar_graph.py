"""``build_graph``: edges are split where they meet, gaps are linked, and duplicates count once."""

from __future__ import annotations

import numpy as np

from knifetip.topology.planar_graph import PlanarGraph, _dangling_vertices, build_graph

TOUCH, REACH = 0.05, 1.0


def graph_of(*lines: tuple[float, float, float, float], bulge: object = None) -> PlanarGraph:
    ends = np.array(lines, float).reshape(-1, 2, 2)
    bent = np.zeros(len(ends)) if bulge is None else np.array(bulge, float)
    graph = build_graph(ends, bent, TOUCH, REACH)
    assert graph is not None
    return graph


def test_ends_within_the_tolerance_are_one_place() -> None:
    made = graph_of((0, 0, 10, 0), (10.04, 0, 20, 0), (10.2, 5, 10.2, 9))
    assert len(made.vertex) == 5
    assert made.end[0] == made.start[1]


def test_an_edge_is_parted_where_another_ends_on_it() -> None:
    made = graph_of((0, 0, 10, 0), (4, 0, 4, 8))
    assert made.first.tolist() == [0, 2, 3]
    np.testing.assert_allclose(made.vertex[made.end[0]], [4, 0])
    np.testing.assert_allclose(made.parameter[:2], [0.0, 0.4])


def test_an_arc_is_parted_where_another_ends_on_it() -> None:
    # Half a turn from (10, 0) over (0, 10) to (-10, 0); the line ends on its highest point.
    made = graph_of((10, 0, -10, 0), (0, 30, 0, 10), bulge=[1.0, 0.0])
    assert made.first.tolist() == [0, 2, 3]
    np.testing.assert_allclose(made.bulge[:2], np.tan(np.pi / 8), atol=1e-9)


def test_lines_that_cross_part_each_other() -> None:
    made = graph_of((0, 0, 10, 0), (5, -5, 5, 5))
    assert made.first.tolist() == [0, 2, 4]
    assert made.end[0] == made.end[2]


def test_a_loose_end_that_stops_short_is_linked_to_what_lies_ahead() -> None:
    made = graph_of((0, 0, 0, 10), (-5, 10.8, 5, 10.8))
    assert (made.edge < 0).sum() == 1
    link = np.flatnonzero(made.edge < 0)[0]
    np.testing.assert_allclose(made.vertex[made.end[link]], [0, 10.8])


def test_a_loose_end_is_not_linked_to_what_lies_beside_or_far_ahead() -> None:
    assert (graph_of((0, 0, 0, 10), (-5, 11.2, 5, 11.2)).edge >= 0).all()
    assert (graph_of((0, 0, 0, 10), (0.5, -5, 0.5, 30)).edge >= 0).all()


def test_dashes_in_a_row_are_linked_and_two_alone_are_not() -> None:
    row = [(9.0 * i, 0.0, 9.0 * i + 6.0, 0.0) for i in range(5)]
    made = graph_of(*row)
    assert made.dashed.all()
    assert (made.edge < 0).sum() == 4
    assert not graph_of(*row[:2]).dashed.any()


def test_uneven_gaps_are_no_row_of_dashes() -> None:
    assert not graph_of((0, 0, 6, 0), (9, 0, 15, 0), (25, 0, 31, 0)).dashed.any()


def test_dashes_drawn_twice_are_a_row_all_the_same() -> None:
    row = [(9.0 * i, 0.0, 9.0 * i + 6.0, 0.0) for i in range(4)]
    assert graph_of(*row, (15, 0, 9, 0)).dashed.all()


def test_a_line_through_the_gaps_of_dashes_crosses_them() -> None:
    row = [(9.0 * i, 0.0, 9.0 * i + 6.0, 0.0) for i in range(4)]
    made = graph_of(*row, (7.5, -10, 7.5, 10))
    assert made.first[5] - made.first[4] == 2
    assert (made.edge < 0).sum() == 4


def test_lines_that_lie_on_each_other_count_once() -> None:
    made = graph_of((0, 0, 10, 0), (10, 0, 0, 0), (0, 0, 10, 5))
    assert made.twin_piece.tolist() == [0, 0, 2]


def test_arcs_between_the_same_places_count_by_their_bend() -> None:
    made = graph_of((0, 0, 10, 0), (0, 0, 10, 0), (10, 0, 0, 0), bulge=[0.5, -0.5, -0.5])
    assert made.twin_piece.tolist() == [0, 1, 0]


def test_a_tangle_is_left_alone_and_so_is_nothing() -> None:
    count = 3000
    ends = np.random.default_rng(0).uniform(0.0, 1000.0, (count, 2, 2))
    assert build_graph(ends, np.zeros(count), TOUCH, REACH) is None
    assert build_graph(np.zeros((0, 2, 2)), np.zeros(0), TOUCH, REACH) is None


def test_a_speck_far_away_does_not_make_a_tangle_of_the_rest() -> None:
    count = 2000
    at = np.random.default_rng(0).uniform(0.0, 1000.0, (count, 1, 2))
    ends = np.concatenate([at, at + np.array([3.0, 0.0])], axis=1)
    ends[0] += 1e9
    made = build_graph(ends, np.zeros(count), TOUCH, REACH)
    assert made is not None
    assert made.first[-1] >= count


def test_loose_is_where_one_line_ends_and_nothing_else_is() -> None:
    # Lines 0-1, 1-2, the first drawn again, 3-4 and 5-6; end 3 lies on a line, one crosses at 6.
    node = np.array([0, 1, 1, 2, 0, 1, 3, 4, 5, 6], np.int32)
    twin = np.array([0, 1, 0, 3, 4], np.int32)
    found = _dangling_vertices(node, twin, np.array([3], np.int32), np.array([6], np.int32), 8)
    assert np.flatnonzero(found).tolist() == [0, 2, 4, 5]
