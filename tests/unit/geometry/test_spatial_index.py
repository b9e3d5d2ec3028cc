"""The searches for boxes against shapely's STRtree, and the lists of cells."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from shapely import STRtree, box

from knifetip.geometry.columns import F64, I64
from knifetip.geometry.spatial_index.box_grid import build_grid
from knifetip.geometry.spatial_index.box_pairs import box_pairs
from knifetip.geometry.spatial_index.box_tree import (
    NODE_SIZE,
    build_tree,
    new_stack,
    next_overlap,
    start_query,
)
from knifetip.geometry.spatial_index.cells import cell_of, group_by_cell
from knifetip.geometry.spatial_index.morton import morton_code, order_boxes


def some_boxes(random: np.random.Generator, count: int) -> F64:
    """Return ``count`` random boxes with integer coordinates, so that many touch exactly, (n,
    4).
    """
    low = random.integers(0, 60, (count, 2))
    return np.hstack([low, low + random.integers(0, 6, (count, 2))]).astype(np.float64)


def overlaps(tree_boxes: F64, query_box: F64, after: int) -> list[int]:
    tree, stack = build_tree(tree_boxes), new_stack()
    depth = start_query(tree, stack)
    found: list[int] = []
    x0, y0, x1, y1 = query_box.tolist()
    wanted = (x0, y0, x1, y1)
    while True:
        i, depth = next_overlap(tree.boxes, tree.level, stack, depth, wanted, after)
        if i < 0:
            return found
        found.append(i)


@given(seed=st.integers(0, 10_000), count=st.integers(1, 3 * NODE_SIZE**2))
def test_a_query_finds_the_boxes_that_shapely_finds_in_ascending_order(
    seed: int, count: int
) -> None:
    random = np.random.default_rng(seed)
    boxes = some_boxes(random, count)
    reference = STRtree([box(*row) for row in boxes])
    for query_box in some_boxes(random, 4):
        expected = sorted(reference.query(box(*query_box)).tolist())
        assert overlaps(boxes, query_box, -1) == expected
        after = int(random.integers(0, count))
        assert overlaps(boxes, query_box, after) == [i for i in expected if i > after]


@given(
    seed=st.integers(0, 10_000),
    gap=st.sampled_from([0.0, 1.0, 2.5]),
    spread=st.sampled_from([1.0, 0.1, 0.0]),
    far=st.booleans(),
)
def test_pairs_are_those_of_shapely_by_row_and_left_side(
    seed: int, gap: float, spread: float, far: bool
) -> None:
    # Crowded boxes, and a box far away, are searched with a tree instead of a grid.
    random = np.random.default_rng(seed)
    boxes, others = some_boxes(random, 50) * spread, some_boxes(random, 180) * spread
    others[0] += 1e6 * far
    assert build_grid(others)[0] == (spread > 0.0 and not far)
    reference = STRtree([box(*row) for row in others])
    wide = [box(x0 - gap, y0 - gap, x1 + gap, y1 + gap) for x0, y0, x1, y1 in boxes.tolist()]
    expected = sorted(reference.query(wide).T.tolist(), key=lambda p: (p[0], others[p[1], 0], p[1]))
    found = np.stack(box_pairs(boxes, others, gap), axis=1)
    assert found.tolist() == expected


@pytest.mark.parametrize("sizes", [(0, 3), (3, 0)])
def test_no_boxes_have_no_pairs(sizes: tuple[int, int]) -> None:
    one, other = (some_boxes(np.random.default_rng(0), size) for size in sizes)
    assert [len(rows) for rows in box_pairs(one, other, 1.0)] == [0, 0]


def test_morton_codes_interleave_the_bits() -> None:
    assert [morton_code(1, 0), morton_code(0, 1), morton_code(3, 5)] == [1, 2, 0b100111]
    last = (1 << 16) - 1
    assert morton_code(last, last) == (1 << 32) - 1


def test_boxes_are_ordered_by_quarters_of_the_plane() -> None:
    corners = np.array([[9, 9], [0, 9], [9, 0], [0, 0]], np.float64)
    order: I64 = order_boxes(np.tile(corners, 2))
    assert order.tolist() == [3, 2, 1, 0]


def test_entries_keep_their_order_in_a_cell_and_those_without_a_cell_are_left_out() -> None:
    cell = np.array([2, -1, 0, 2, 0], np.int32)
    first, grouped = group_by_cell(cell, 3, np.arange(10, 15, dtype=np.int32))
    assert (first.tolist(), grouped.tolist()) == ([0, 2, 2, 4], [12, 14, 10, 13])


def test_outside_the_grid_the_nearest_cell_counts() -> None:
    assert [cell_of(x, 0.0, 2.0, 5) for x in (-9.0, 0.0, 3.9, 9.9, 99.0)] == [0, 0, 1, 4, 4]
