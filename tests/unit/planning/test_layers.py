"""Order of cuts: layers of nested contours, also of contours with gaps."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.errors import PlanError
from knifetip.geometry.columns import F64
from knifetip.geometry.tolerance import CONTOUR_GAP
from knifetip.planning.cut_sides import cut_sides
from knifetip.planning.layers import cut_layers
from knifetip.planning.necks import _face_widths
from knifetip.topology import noding
from knifetip.topology.contour_gaps import closing_links, find_dangling_ends
from tests.support.shapes import closed, edges, rotation


def box(x: float, y: float, wide: float, high: float) -> F64:
    return closed((x, y), (x + wide, y), (x + wide, y + high), (x, y + high))


def layers(*groups: F64, bulge: F64 | None = None) -> list[list[int]]:
    """Return the sorted layer numbers of the cuts in each group, (n, 2, 2) per group."""
    ends = np.concatenate(groups)
    bent = np.zeros(len(ends)) if bulge is None else bulge
    found = cut_layers(ends, bent, cut_sides(ends, bent).face).number
    ends_at = np.cumsum([len(group) for group in groups])[:-1]
    return [sorted(set(part.tolist())) for part in np.split(found, ends_at)]


PANEL, WINDOW, PART, HOLE = (
    box(0, 0, 310, 230), box(55, 40, 150, 150), box(67, 52, 126, 126), box(112, 97, 36, 36),
)  # fmt: skip


@given(seed=st.integers(0, 1000), degrees=st.floats(0, 360))
def test_each_nested_contour_has_its_own_layer(seed: int, degrees: float) -> None:
    chance = np.random.default_rng(seed)
    ends = np.concatenate([PANEL, WINDOW, PART, HOLE]) @ rotation(degrees).T
    order = chance.permutation(len(ends))
    ends = ends[order]
    back = chance.random(len(ends)) < 0.5
    ends[back] = ends[back][:, ::-1]
    nothing = np.zeros(len(ends))
    found = cut_sides(ends, nothing)
    np.testing.assert_array_equal(cut_layers(ends, nothing, found.face).number, order // 4)
    np.testing.assert_array_equal(found.waste != 0, order // 4 % 2 == 0)


def test_nesting_of_circles_is_decided_by_arcs() -> None:
    # The distance of the circles is 0.05 mm; 16 chords of the outer one would deviate by 2 mm.
    outer = edges(((-500, 0), (500, 0)), ((500, 0), (-500, 0)))
    inner = edges(((-499.95, 0), (499.95, 0)), ((499.95, 0), (-499.95, 0)))
    assert layers(inner, outer, bulge=np.ones(4)) == [[1], [0]]


def test_slits_have_the_layer_of_the_board_around_them() -> None:
    inside, outside = edges(((70, 60), (90, 60))), edges(((-50, 0), (-20, 0)))
    assert layers(PANEL, WINDOW, PART, inside, outside) == [[0], [1], [2], [3], [0]]


@pytest.mark.parametrize("gap", [0.1, 0.3, 0.5, 0.8, 1.4])
def test_gaps_at_corners_and_in_the_middle_are_closed(gap: float) -> None:
    blank = edges(
        ((gap, 0), (100, 0)), ((100, 0), (100, 50 - gap / 2)), ((100, 50 + gap / 2), (100, 100)),
        ((100 - gap, 100), (0, 100)), ((0, 100 - gap), (0, 0)),
    )  # fmt: skip
    assert layers(blank, box(20, 20, 10, 10)) == [[0], [1]]


def test_a_corner_is_closed_unless_the_gap_is_too_wide() -> None:
    for gap, layer in ((1.5, 1), (3.0, 1), (3.5, 0)):
        blank = edges(
            ((0, 0), (100 - gap, 0)), ((100, gap), (100, 100)), ((100, 100), (0, 100)),
            ((0, 100), (0, 0)),
        )  # fmt: skip
        assert layers(blank, box(20, 20, 10, 10)) == [[0], [layer]]
    assert CONTOUR_GAP == 2.2


def frame(neck: float) -> F64:
    """Return four slits round a square of 80 mm, with a neck between each slit and the next one."""
    low, high = 100.0, 180.0
    return edges(
        ((low, low), (high - neck, low)), ((high, low), (high, high - neck)),
        ((high, high), (low + neck, high)), ((low, high), (low, low + neck)),
    )  # fmt: skip


@pytest.mark.parametrize(("neck", "before"), [(3.0, True), (4.2, True), (4.6, False)])
def test_the_inside_of_a_piece_on_necks_comes_before_the_cuts_round_it(
    neck: float, before: bool
) -> None:
    panel, hole, beside = box(0, 0, 300, 300), box(130, 130, 20, 20), box(230, 130, 20, 20)
    found = layers(panel, hole, beside, frame(neck))
    assert found == [[0], [2] if before else [1], [1], [1]]


def test_slits_near_each_other_are_one_layer() -> None:
    slits = edges(
        *(((20 + 40 * (j % 2), 20 + 2.5 * j), (60, 20 + 2.5 * j)) for j in range(0, 20, 2))
    )
    assert layers(box(0, 0, 110, 110), slits) == [[0], [1]]


def test_the_mean_width_of_a_face_counts_its_arcs() -> None:
    disc = edges(((0, 0), (10, 0)), ((10, 0), (0, 0)))
    inside = np.array([[1, 0]])
    width = _face_widths(disc, np.ones(2), inside.repeat(2, axis=0), 2)
    assert width == pytest.approx([np.inf, 5.0])
    # A square of 10 mm whose lower side is half a circle that bulges inwards.
    bulge = np.array([-1.0, 0.0, 0.0, 0.0])
    width = _face_widths(box(7, 9, 10, 10), bulge, inside.repeat(4, axis=0), 2)
    assert width[1] == pytest.approx(2.0 * (100.0 - 12.5 * np.pi) / (30.0 + 5.0 * np.pi))


def test_a_wide_gap_in_an_outline_is_a_neck() -> None:
    blank = edges(
        ((0, 0), (100, 0)), ((100, 0), (100, 48)), ((100, 52), (100, 100)), ((100, 100), (0, 100)),
        ((0, 100), (0, 0)),
    )  # fmt: skip
    assert layers(blank, box(20, 20, 10, 10), box(150, 20, 10, 10)) == [[0], [1], [0]]


def test_an_end_short_of_the_middle_of_an_edge_closes_a_contour() -> None:
    wall = edges(((0, -20), (0, 120)))
    hook = edges(((1.0, 0), (100, 0)), ((100, 0), (100, 100)), ((100, 100), (1.0, 100)))
    assert layers(wall, hook, box(20, 20, 10, 10)) == [[0], [0], [1]]


def test_two_close_outlines_with_gaps_are_both_closed() -> None:
    # The nearest point to each loose end is on the neighbour, 0.6 mm away.
    def blank(x: float, side: float) -> F64:
        return edges(
            ((x, 0), (x, 49.5)), ((x, 50.5), (x, 100)), ((x, 100), (x + side, 100)),
            ((x + side, 100), (x + side, 0)), ((x + side, 0), (x, 0)),
        )  # fmt: skip

    groups = blank(0, -100), box(-60, 20, 10, 10), blank(0.6, 100), box(60, 20, 10, 10)
    assert layers(*groups) == [[0], [1], [0], [1]]


def links_of(cuts: F64) -> F64:
    straight = np.zeros(len(cuts))
    return closing_links(cuts, straight, find_dangling_ends(cuts, straight), CONTOUR_GAP)


def test_an_end_is_not_linked_to_its_own_corner() -> None:
    hook = edges(((0, 0), (50, 0)), ((50, 0), (50, 0.8)))
    assert len(links_of(hook)) == 0


def test_dense_ends_have_few_links() -> None:
    y = 0.3 * np.arange(400)
    comb = np.stack([np.stack([0.0 * y, y], axis=1), np.stack([20.0 + 0 * y, y], axis=1)], axis=1)
    assert len(links_of(comb)) <= 4 * 400


def test_a_line_between_two_parts_comes_before_their_outline() -> None:
    rungs = edges(*(((0, y), (310, y)) for y in (60, 120, 180)))
    assert layers(PANEL, rungs, box(20, 70, 10, 10)) == [[0], [1], [1]]


def test_layers_of_parts_that_share_a_piece_of_an_edge() -> None:
    # The second part's contour is open: its fourth side is a piece of the first one's.
    other = edges(((310, 50), (400, 50)), ((400, 50), (400, 150)), ((400, 150), (310, 150)))
    found = layers(PANEL, other, box(20, 20, 10, 10), box(330, 70, 10, 10))
    assert found == [[1], [0], [2], [1]]


def test_layers_of_a_contour_that_touches_its_hole_in_a_vertex() -> None:
    hole = closed((0, 0), (60, 20), (20, 60))
    assert layers(PANEL, hole, box(24, 24, 5, 5)) == [[0], [1], [2]]


def test_lines_drawn_across_each_other_are_cut_from_the_inside() -> None:
    up = [edges(((x, -5), (x, 35))) for x in (0, 10, 20, 30)]
    across = [edges(((-5, y), (35, y))) for y in (0, 10, 20, 30)]
    assert layers(*up, *across) == [[0], [1], [1], [0]] * 2


def test_lines_in_a_cycle_all_get_a_layer() -> None:
    # Each line ends on the next one; the inner ring consists of a piece of each of the four lines.
    ring = edges(
        ((-60, 0), (40, 0)), ((40, -60), (40, 40)), ((100, 40), (0, 40)), ((0, 100), (0, 0))
    )
    around = box(-60, -60, 160, 160)
    found = layers(around, ring, box(15, 15, 5, 5))
    assert found[0] == [0]
    assert found[2][0] > found[1][0]


def test_coincident_edges_do_not_change_the_faces() -> None:
    found = layers(PANEL, PANEL[:2], WINDOW, HOLE)
    assert found[0] == found[1] == [0]
    assert found[2:] == [[1], [2]]


def test_too_many_crossings_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(noding, "_MOST_PAIRS", 10)
    with pytest.raises(PlanError, match="pairs of cuts that cross"):
        layers(PANEL, WINDOW, PART, HOLE)


def test_layers_of_many_contours_take_linear_time() -> None:
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
        found = cut_layers(all_ends, nothing, cut_sides(all_ends, nothing).face).number
        took = time.process_time() - begin
        np.testing.assert_array_equal(
            found.reshape(count, 3, 4), [[[0] * 4, [1] * 4, [2] * 4]] * count
        )
        return took

    seconds(10)
    assert seconds(5_000) < 30.0 * seconds(500) + 0.1
