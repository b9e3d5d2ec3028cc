"""box_pairs: find the pairs of bounding boxes that are near each other."""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.geometry.columns import F64, I64
from knifetip.geometry.spatial_index.box_grid import BoxGrid, build_grid
from knifetip.geometry.spatial_index.box_tree import (
    NODE_SIZE,
    BoxTree,
    build_tree,
    new_stack,
    start_query,
)
from knifetip.geometry.spatial_index.cells import cell_of
from knifetip.geometry.spatial_index.morton import order_boxes
from knifetip.kernels import F64_2, OutI64_1, OutI64_2, kernel

#: Largest number of cells that the boxes of a search may cover, per box; beyond it a tree is used.
_CELLS_PER_SEARCH: Final = 16
#: More results of one box are sorted by NumPy.
_FEW: Final = 32


def box_pairs(boxes: F64, others: F64, gap: float) -> tuple[I64, I64]:
    """Return the pairs of boxes of two sets that are at most ``gap`` mm apart in x and in y.

    Parameters
    ----------
    boxes, others : (n, 4) and (m, 4) mm
        The two sets of boxes: x min, y min, x max, y max of each box.

    Returns
    -------
    row, other_row : (k,) and (k,)
        For each of k pairs the row in ``boxes`` and the row in ``others``.  The pairs are sorted by
        ``row``, and pairs with equal ``row`` by x min of the other box.
    """
    if len(boxes) == 0 or len(others) == 0:
        return np.zeros(0, np.int64), np.zeros(0, np.int64)
    suits, one, other = _pairs_by_grid(boxes, others, gap)
    if suits:
        return one, other
    order = order_boxes(others)
    one, other = _pairs_by_tree(boxes, others[order], gap)
    other = order[other]
    rank = np.empty(len(others), np.int64)
    rank[np.argsort(others[:, 0], kind="stable")] = np.arange(len(others))
    by_rank = np.argsort(one * len(others) + rank[other], kind="stable")
    return one[by_rank], other[by_rank]


@kernel
def _pairs_by_grid(boxes: F64_2, others: F64_2, gap: float) -> Any:
    """Return whether a grid suits two sets of boxes, and the result of ``box_pairs``.

    The result is empty if no grid suits the boxes.
    """
    suits, grid = build_grid(others)
    if not suits or _covered_cells(boxes, gap, grid.size) > _CELLS_PER_SEARCH * len(boxes):
        return False, np.empty(0, np.int64), np.empty(0, np.int64)
    one = np.empty(2 * len(boxes) + 16, np.int64)
    other = np.empty_like(one)
    row, found = 0, 0
    while True:
        row, found, crowd = _search_grid(boxes, row, gap, others, grid, one, other, found)
        if crowd >= 0:
            rows = np.sort(other[crowd:found])
            other[crowd:found] = rows[np.argsort(others[rows, 0], kind="mergesort")]
        elif row == len(boxes):
            return True, one[:found].copy(), other[:found].copy()
        else:
            # The pairs of this row did not fit.
            one = np.concatenate((one, np.empty_like(one)))
            other = np.concatenate((other, np.empty_like(other)))


@kernel(allocates=False)
def _covered_cells(boxes: F64_2, gap: float, size: float) -> float:
    """Return about how many cells of width ``size`` boxes cover, enlarged by ``gap`` mm."""
    count = 0.0
    for i in range(len(boxes)):
        wide, tall = boxes[i, 2] - boxes[i, 0], boxes[i, 3] - boxes[i, 1]
        count += ((wide + 2.0 * gap) / size + 1.0) * ((tall + 2.0 * gap) / size + 1.0)
    return count


@kernel(allocates=False)
def _search_grid(
    boxes: F64_2,
    begin: int,
    gap: float,
    others: F64_2,
    grid: BoxGrid,
    pair_a: OutI64_1,
    pair_b: OutI64_1,
    found: int,
) -> tuple[int, int, int]:
    """Append the pairs of the boxes from row ``begin`` on to the ``found`` pairs in two columns.

    The search ends early when the arrays are full, and after a row with more than ``_FEW`` pairs.
    The pairs of this row are not sorted; those of the other rows are.

    Returns number of rows that are finished, number of pairs, and the index of the first pair of a
    row whose pairs are not sorted, -1 if there is none.
    """
    wide, tall = grid.wide, grid.tall
    for i in range(begin, len(boxes)):
        x0, y0 = boxes[i, 0] - gap, boxes[i, 1] - gap
        x1, y1 = boxes[i, 2] + gap, boxes[i, 3] + gap
        c0 = cell_of(x0, grid.low_x, grid.size, wide)
        c1 = cell_of(x1, grid.low_x, grid.size, wide)
        r0 = cell_of(y0, grid.low_y, grid.size, tall)
        r1 = cell_of(y1, grid.low_y, grid.size, tall)
        done = found
        for c in range(c0, c1 + 1):
            for r in range(r0, r1 + 1):
                cell = c * tall + r
                for k in range(grid.first[cell], grid.first[cell + 1]):
                    j = grid.listed[k]
                    # One branch instead of four, which would often be mispredicted.
                    overlaps = (others[j, 0] <= x1) & (others[j, 2] >= x0)
                    overlaps &= (others[j, 1] <= y1) & (others[j, 3] >= y0)
                    if not overlaps:
                        continue
                    # Boxes with several common cells: only the first cell of both gives the pair.
                    if c > c0 and cell_of(others[j, 0], grid.low_x, grid.size, wide) != c:
                        continue
                    if r > r0 and cell_of(others[j, 1], grid.low_y, grid.size, tall) != r:
                        continue
                    if found == len(pair_a):
                        return i, done, -1
                    slot = found
                    if found - done < _FEW:
                        while slot > done and _is_left(others, j, pair_b[slot - 1]):
                            pair_b[slot] = pair_b[slot - 1]
                            slot -= 1
                    pair_a[found], pair_b[slot] = i, j
                    found += 1
        if found - done > _FEW:
            return i + 1, found, done
    return len(boxes), found, -1


@kernel(allocates=False)
def _is_left(boxes: F64_2, i: int, j: int) -> bool:
    """Return whether box i begins farther left than box j, or equally far and i < j."""
    return boxes[i, 0] < boxes[j, 0] or (boxes[i, 0] == boxes[j, 0] and i < j)


@kernel
def _pairs_by_tree(boxes: F64_2, others: F64_2, gap: float) -> Any:
    """Return the pairs of boxes that are at most ``gap`` mm apart in x and in y, unsorted.

    The result has two arrays: the row in ``boxes`` and the row in ``others`` of each of k pairs,
    (k,) each.  ``boxes`` (n, 4) and ``others`` (m, 4), in Morton order, are x min, y min, x max and
    y max.
    """
    tree, stack = build_tree(others), new_stack()
    one = np.empty(2 * len(boxes) + 16, np.int64)
    other = np.empty_like(one)
    row, found = 0, 0
    while True:
        row, found = _append_pairs(boxes, row, gap, tree, stack, one, other, found)
        if row == len(boxes):
            return one[:found].copy(), other[:found].copy()
        # The pairs of this row did not fit.
        one = np.concatenate((one, np.empty_like(one)))
        other = np.concatenate((other, np.empty_like(other)))


@kernel(allocates=False)
def _append_pairs(
    boxes: F64_2,
    begin: int,
    gap: float,
    tree: BoxTree,
    stack: OutI64_2,
    pair_a: OutI64_1,
    pair_b: OutI64_1,
    found: int,
) -> tuple[int, int]:
    """Append the pairs of the boxes from row ``begin`` on to the ``found`` pairs in two columns.

    Returns the number of rows that are finished, and the number of pairs.  The search ends early
    when the arrays are full.
    """
    nodes, level = tree.boxes, tree.level
    for i in range(begin, len(boxes)):
        x0, y0 = boxes[i, 0] - gap, boxes[i, 1] - gap
        x1, y1 = boxes[i, 2] + gap, boxes[i, 3] + gap
        depth = start_query(tree, stack)
        done = found
        # As in ``next_overlap``, but the boxes of a node are compared without using the stack.
        while depth > 0:
            depth -= 1
            height = stack[depth, 0]
            low = level[height - 1]
            first = stack[depth, 1] * NODE_SIZE
            for child in range(first, min(first + NODE_SIZE, level[height] - low)):
                at = low + child
                # One branch instead of four, which would often be mispredicted.
                overlaps = (nodes[at, 0] <= x1) & (nodes[at, 2] >= x0)
                overlaps &= (nodes[at, 1] <= y1) & (nodes[at, 3] >= y0)
                if not overlaps:
                    continue
                if height > 1:
                    stack[depth, 0] = height - 1
                    stack[depth, 1] = child
                    depth += 1
                    continue
                if found == len(pair_a):
                    return i, done
                pair_a[found] = i
                pair_b[found] = child
                found += 1
    return len(boxes), found
