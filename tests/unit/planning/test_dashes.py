"""Dashed creases are merged; repeated edges are removed."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.geometry.columns import F64
from knifetip.planning.dashes import merge_dashes
from tests.support.shapes import edges, rotation

NO_CUTS = (np.zeros((0, 2, 2)), np.zeros(0))


def dashes(count: int, length: float, gap: float) -> F64:
    begin = np.arange(count) * (length + gap)
    return edges(*[((x, 0.0), (x + length, 0.0)) for x in begin])


def stretches(
    ends: F64, cuts: tuple[F64, F64] = NO_CUTS, bulge: list[float] | None = None
) -> tuple[F64, list[int]]:
    bent = np.zeros(len(ends)) if bulge is None else np.array(bulge, float)
    new, _, row = merge_dashes(ends, bent, cuts)
    return new, row.tolist()


def test_three_dashes_become_one_line_with_its_gaps_filled() -> None:
    new, row = stretches(dashes(3, 4.0, 3.0))
    assert sorted(new[:, 0, 0].tolist()) == [0.0, 4.0, 7.0, 11.0, 14.0]
    assert sorted(new[:, 1, 0].tolist()) == [4.0, 7.0, 11.0, 14.0, 18.0]
    # A gap belongs to the dash before it.
    assert row == [0, 0, 1, 1, 2]


@pytest.mark.parametrize(
    ("count", "length", "gap"),
    [(2, 4.0, 3.0), (5, 4.0, 6.1), (5, 20.0, 12.1), (5, 4.0, 0.001)],
    ids=["only two", "gaps of more than 1.5 dashes", "gaps of more than 12 mm", "no gaps"],
)
def test_pieces_that_are_no_row_of_dashes_are_kept(count: int, length: float, gap: float) -> None:
    drawn = dashes(count, length, gap)
    new, row = stretches(drawn)
    np.testing.assert_array_equal(new, drawn)
    assert row == list(range(count))


def test_irregular_gaps_are_no_dashes() -> None:
    drawn = edges(((0, 0), (50, 0)), ((53, 0), (90, 0)), ((100, 0), (150, 0)))
    np.testing.assert_array_equal(stretches(drawn)[0], drawn)


def test_creases_between_slots_are_no_dashes() -> None:
    # Flaps of a case: the slot's walls end on the ends of the creases.
    drawn = dashes(4, 100.0, 6.0)
    walls = edges(*[((x, 0.0), (x, 80.0)) for x in (100.0, 106.0, 206.0, 212.0, 312.0, 318.0)])
    new, _ = stretches(drawn, (walls, np.zeros(6)))
    np.testing.assert_array_equal(new, drawn)


def test_dashes_on_either_side_of_a_cut_are_two_creases() -> None:
    # The cut runs through the gap between the fourth dash and the fifth, at 34.5.
    cut = edges(((34.5, -9.0), (34.5, 9.0)))
    new, _ = stretches(dashes(8, 6.0, 3.0), (cut, np.zeros(1)))
    filled = sorted(new[:, 0, 0].tolist())
    assert len(new) == 8 + 2 * 3
    assert 33.0 not in filled
    assert (24.0 in filled, 42.0 in filled) == (True, True)


@pytest.mark.parametrize(("into", "filled"), [(0.9, False), (1.6, True)])
def test_creases_that_reach_into_a_slot_are_no_dashes(into: float, filled: bool) -> None:
    # The creases reach into the slot from both sides, and 3 mm between them are not drawn.
    drawn = edges(((0, 0), (50, 0)), ((53, 0), (100, 0)), ((103, 0), (150, 0)))
    sides = edges(((100 - into, -9), (100 - into, 9)), ((103 + into, 9), (103 + into, -9)))
    new, _ = stretches(drawn, (sides, np.zeros(2)))
    assert (100.0 in new[:, 0, 0]) == filled


def test_a_piece_beside_the_line_is_no_dash() -> None:
    drawn = dashes(4, 4.0, 3.0)
    drawn[1, :, 1] += 0.01
    np.testing.assert_array_equal(stretches(drawn)[0], drawn)


def test_repeated_and_overlapping_lines_are_merged() -> None:
    drawn = edges(((0, 0), (50, 0)), ((50, 0), (0, 0)), ((40, 0), (70, 0)), ((60, 5), (90, 5)))
    new, row = stretches(drawn)
    np.testing.assert_array_equal(
        new, edges(((0, 0), (50, 0)), ((50, 0), (70, 0)), ((60, 5), (90, 5)))
    )
    assert row == [0, 2, 3]


def test_a_repeated_arc_is_merged() -> None:
    arcs = edges(((0, 0), (10, 0)), ((10, 0), (0, 0)), ((0, 0), (10, 0)))
    # The second is the first one backwards; the third bends the other way.
    assert stretches(arcs, bulge=[0.5, -0.5, -0.5])[1] == [0, 2]


@given(
    cuts=st.lists(st.tuples(st.integers(0, 40), st.integers(1, 30)), min_size=1, max_size=12),
    degrees=st.floats(0.0, 360.0),
    seed=st.integers(0, 99),
)
def test_each_stretch_is_covered_exactly_once(
    cuts: list[tuple[int, int]], degrees: float, seed: int
) -> None:
    turn = rotation(degrees)
    random = np.random.default_rng(seed)
    drawn = np.array([[[a, 3.0], [a + b, 3.0]] for a, b in cuts], float)
    back = random.random(len(drawn)) < 0.5
    drawn[back] = drawn[back][:, ::-1]
    new, _, row = merge_dashes(drawn @ turn.T, np.zeros(len(drawn)))
    flat = new @ turn
    np.testing.assert_allclose(flat[..., 1], 3.0, atol=1e-9)
    places = np.arange(80) + 0.5
    low, high = flat[..., 0].min(axis=1)[:, None], flat[..., 0].max(axis=1)[:, None]
    asked = [any(a < x < a + b for a, b in cuts) for x in places]
    np.testing.assert_array_equal(((low < places) & (places < high)).sum(axis=0), asked)
    assert set(row.tolist()) <= set(range(len(cuts)))


@given(count=st.integers(3, 30), length=st.floats(2.0, 10.0), degrees=st.floats(0.0, 360.0))
def test_dashes_at_every_azimuth_become_one_line(count: int, length: float, degrees: float) -> None:
    turn = rotation(degrees)
    new, bulge, _ = merge_dashes(dashes(count, length, length) @ turn.T, np.zeros(count), NO_CUTS)
    flat = new @ turn
    assert len(new) == 2 * count - 1
    assert not bulge.any()
    np.testing.assert_allclose(flat[..., 1], 0.0, atol=1e-9)
    assert np.abs(np.diff(flat[..., 0])).sum() == pytest.approx((2 * count - 1) * length)
