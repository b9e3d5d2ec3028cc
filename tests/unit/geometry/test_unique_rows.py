"""Distinct rows of integers, compared with numpy's result."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip.geometry.unique_rows import _slot, unique_rows


@pytest.mark.parametrize("kinds", [1, 3, 700, 40_000])
def test_few_and_many_distinct_rows_are_found(kinds: int) -> None:
    rng = np.random.default_rng(kinds)
    table = rng.integers(-(1 << 40), 1 << 40, (kinds, 3))[rng.integers(0, kinds, 60_000)]
    first, kind = unique_rows(table)
    _, expected, inverse = np.unique(table, axis=0, return_index=True, return_inverse=True)
    # Ordered by row, while numpy orders by value.
    np.testing.assert_array_equal(first, np.sort(expected))
    np.testing.assert_array_equal(first[kind], expected[inverse.ravel()])


def test_a_table_gives_the_same_result_as_its_columns() -> None:
    one, two = np.array([5, 5, 5, 7]), np.array([1, 2, 1, 1], np.int32)
    for result in (unique_rows(one, two), unique_rows(np.column_stack([one, two]))):
        assert [column.tolist() for column in result] == [[0, 1, 3], [0, 1, 0, 2]]


def test_no_rows_give_no_distinct_rows() -> None:
    assert [len(column) for column in unique_rows(np.zeros(0, np.int64))] == [0, 0]


@pytest.mark.parametrize("shift", [0, 20, 32, 45])
def test_numbers_that_differ_in_a_few_bits_have_different_slots(shift: int) -> None:
    table = (np.arange(1 << 16, dtype=np.int64) << shift).reshape(-1, 1)
    slots = np.full(1 << 18, -1, np.int32)
    used = {_slot(table, row, slots) for row in range(len(table))}
    # Random slots would be 88 % different.
    assert len(used) > 0.8 * len(table)
