"""Which cuts are made before which: layers from the outside inwards, on contours with gaps."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.errors import PlanError
from knifetip.geometry.columns import F64
from knifetip.geometry.tolerance import CONTOUR_GAP
from knifetip.planning import noding
from knifetip.planning.cut_sides import cut_sides
from knifetip.planning.gaps import closing_links
from knifetip.planning.layers import cut_layers
from tests.support.shapes import closed, edges, rotation


def box(x: float, y: float, wide: float, high: float) -> F64:
    return closed((x, y), (x + wide, y), (x + wide, y + high), (x, y + high))


def layers(*groups: F64, bulge: F64 | None = None) -> list[list[int]]:
    """Return the layers that each group's edges are of."""
    ends = np.concatenate(groups)
    bent = np.zeros(len(ends)) if bulge is None else bulge
    found = cut_layers(ends, bent, cut_sides(ends, bent).face)
    ends_at = np.cumsum([len(group) for group in groups])[:-1]
    return [sorted(set(part.tolist())) for part in np.split(found, ends_at)]


PANEL, WINDOW, PART, HOLE = (
    box(0, 0, 310, 230), box(55, 40, 150, 150), box(67, 52, 126, 126), box(112, 97, 36, 36),
)  # fmt: skip


@given(seed=st.integers(0, 1000), degrees=st.floats(0, 360))
def test_nested_contours_are_of_a_layer_each_however_they_are_drawn(
    seed: int, degrees: float
) -> None:
    chance = np.random.default_rng(seed)
    ends = np.concatenate([PANEL, WINDOW, PART, HOLE]) @ rotation(degrees).T
    order = chance.permutation(len(ends))
    ends = ends[order]
    back = chance.random(len(ends)) < 0.5
    ends[back] = ends[back][:, ::-1]
    nothing = np.zeros(len(ends))
    found = cut_sides(ends, nothing)
    np.testing.assert_array_equal(cut_layers(ends, nothing, found.face), order // 4)
    np.testing.assert_array_equal(found.waste != 0, order // 4 % 2 == 0)


def test_circles_are_nested_by_their_arcs_and_not_by_chords() -> None:
    # The inner one comes within 0.05 mm of the outer one, whose chords of 16 stand 2 mm off.
    outer = edges(((-500, 0), (500, 0)), ((500, 0), (-500, 0)))
    inner = edges(((-499.95, 0), (499.95, 0)), ((499.95, 0), (-499.95, 0)))
    assert layers(inner, outer, bulge=np.ones(4)) == [[1], [0]]


def test_slits_are_of_the_piece_of_board_that_they_lie_in() -> None:
    inside, outside = edges(((70, 60), (90, 60))), edges(((-50, 0), (-20, 0)))
    assert layers(PANEL, WINDOW, PART, inside, outside) == [[0], [1], [2], [3], [0]]


@pytest.mark.parametrize("gap", [0.1, 0.3, 0.5, 0.8, 1.4])
def test_gaps_at_corners_and_in_the_middle_are_closed(gap: float) -> None:
    blank = edges(
        ((gap, 0), (100, 0)), ((100, 0), (100, 50 - gap / 2)), ((100, 50 + gap / 2), (100, 100)),
        ((100 - gap, 100), (0, 100)), ((0, 100 - gap), (0, 0)),
    )  # fmt: skip
    assert layers(blank, box(20, 20, 10, 10)) == [[0], [1]]


def test_a_corner_that_both_edges_stop_short_of_is_closed_and_a_wider_gap_is_not() -> None:
    for gap, layer in ((1.5, 1), (2.0, 0)):
        blank = edges(
            ((0, 0), (100 - gap, 0)), ((100, gap), (100, 100)), ((100, 100), (0, 100)),
            ((0, 100), (0, 0)),
        )  # fmt: skip
        assert layers(blank, box(20, 20, 10, 10)) == [[0], [layer]]
    assert CONTOUR_GAP == 2.2


def test_an_end_short_of_the_middle_of_an_edge_closes_a_contour() -> None:
    wall = edges(((0, -20), (0, 120)))
    hook = edges(((1.0, 0), (100, 0)), ((100, 0), (100, 100)), ((100, 100), (1.0, 100)))
    assert layers(wall, hook, box(20, 20, 10, 10)) == [[0], [0], [1]]


def test_two_outlines_with_gaps_beside_each_other_are_both_closed() -> None:
    # The nearest point to each loose end is on the neighbour, 0.6 mm away.
    def blank(x: float, side: float) -> F64:
        return edges(
            ((x, 0), (x, 49.5)), ((x, 50.5), (x, 100)), ((x, 100), (x + side, 100)),
            ((x + side, 100), (x + side, 0)), ((x + side, 0), (x, 0)),
        )  # fmt: skip

    groups = blank(0, -100), box(-60, 20, 10, 10), blank(0.6, 100), box(60, 20, 10, 10)
    assert layers(*groups) == [[0], [1], [0], [1]]


def test_a_short_end_is_not_linked_to_the_corner_that_it_comes_from() -> None:
    hook = edges(((0, 0), (50, 0)), ((50, 0), (50, 0.8)))
    assert len(closing_links(hook, np.zeros(2))) == 0


def test_dense_ends_have_few_links() -> None:
    y = 0.3 * np.arange(400)
    comb = np.stack([np.stack([0.0 * y, y], axis=1), np.stack([20.0 + 0 * y, y], axis=1)], axis=1)
    assert len(closing_links(comb, np.zeros(400))) <= 4 * 400


def test_what_is_between_two_parts_comes_before_the_outline_of_both() -> None:
    rungs = edges(*(((0, y), (310, y)) for y in (60, 120, 180)))
    assert layers(PANEL, rungs, box(20, 70, 10, 10)) == [[0], [1], [1]]


def test_parts_that_share_a_piece_of_an_edge_and_holes_in_them() -> None:
    # The second part's contour is open: its fourth side is a piece of the first one's.
    other = edges(((310, 50), (400, 50)), ((400, 50), (400, 150)), ((400, 150), (310, 150)))
    found = layers(PANEL, other, box(20, 20, 10, 10), box(330, 70, 10, 10))
    assert found == [[1], [0], [2], [1]]


def test_a_contour_that_touches_its_hole_in_a_vertex() -> None:
    hole = closed((0, 0), (60, 20), (20, 60))
    assert layers(PANEL, hole, box(24, 24, 5, 5)) == [[0], [1], [2]]


def test_lines_drawn_across_each_other_are_cut_from_the_inside() -> None:
    up = [edges(((x, -5), (x, 35))) for x in (0, 10, 20, 30)]
    across = [edges(((-5, y), (35, y))) for y in (0, 10, 20, 30)]
    assert layers(*up, *across) == [[0], [1], [1], [0]] * 2


def test_lines_that_hold_each_other_in_a_ring_are_all_put_in_a_layer() -> None:
    # Each ends on the next: the ring round the middle is of four pieces, each of another line.
    ring = edges(
        ((-60, 0), (40, 0)), ((40, -60), (40, 40)), ((100, 40), (0, 40)), ((0, 100), (0, 0))
    )
    around = box(-60, -60, 160, 160)
    found = layers(around, ring, box(15, 15, 5, 5))
    assert found[0] == [0]
    assert found[2][0] > found[1][0]


def test_edges_that_lie_on_each_other_leave_the_faces_true() -> None:
    found = layers(PANEL, PANEL[:2], WINDOW, HOLE)
    assert found[0] == found[1] == [0]
    assert found[2:] == [[1], [2]]


def test_crossings_without_number_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(noding, "_MOST_PAIRS", 10)
    with pytest.raises(PlanError, match="pairs of cuts cross"):
        layers(PANEL, WINDOW, PART, HOLE)


def test_many_contours_side_by_side_and_nested_take_time_in_proportion() -> None:
    import time

    def seconds(count: int) -> float:
        cells = np.arange(count)
        corner = np.stack([12.0 * (cells % 100), 12.0 * (cells // 100)], axis=1)
        ends = np.concatenate(
            [box(inset, inset, 10.0 - 2 * inset, 10.0 - 2 * inset) for inset in (0.0, 2.5, 4.0)]
        )
        all_ends = (corner[:, None, None, None] + ends[None]).reshape(-1, 2, 2)
        nothing = np.zeros(len(all_ends))
        begin = time.process_time()
        found = cut_layers(all_ends, nothing, cut_sides(all_ends, nothing).face)
        took = time.process_time() - begin
        np.testing.assert_array_equal(
            found.reshape(count, 3, 4), [[[0] * 4, [1] * 4, [2] * 4]] * count
        )
        return took

    seconds(10)
    assert seconds(5_000) < 30.0 * seconds(500) + 0.1
