"""box_tree: a packed tree of bounding boxes, to find the boxes that overlap a given box.

Each node of the tree contains up to eight boxes that follow one another in the array of boxes, so
neighbours in the array must be neighbours in the plane: in the order of a path, or in Morton order.
Then building the tree takes O(n), and a query O(log n + k) for k boxes that it finds.  The tree has
no pointers: the boxes of each level follow the boxes of the level below.

A query in a kernel::

    depth = start_query(tree, stack)
    while True:
        i, depth = next_overlap(tree.boxes, tree.level, stack, depth, (x0, y0, x1, y1), -1)
        if i < 0:
            break

Source: packed Hilbert R-tree (Kamel and Faloutsos 1993), but with the boxes in the caller's order.
"""

from __future__ import annotations

from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.kernels import F64_2, I64_1, OutF64_2, OutI64_1, OutI64_2, kernel

#: Binary logarithm of the number of boxes in a node.
_NODE_BITS: Final = 3
#: Number of boxes in a node.
NODE_SIZE: Final = 1 << _NODE_BITS
#: Largest number of levels, enough for 8²³ boxes.
_LEVELS: Final = 24
#: Length of the stack of a query, enough for all levels.
_STACK_LENGTH: Final = 16 * NODE_SIZE


class BoxTree(NamedTuple):
    """A packed tree over n bounding boxes.

    Its array of boxes has t rows: the n given boxes, then the boxes of the tree's nodes.
    """

    boxes: F64_2  #: (t, 4) x0, y0, x1, y1 of the n given boxes, then of the nodes above them
    level: I64_1  #: (24,) row in ``boxes`` of the first box of each level
    height: int  #: level of the root, at least 1


@kernel
def build_tree(boxes: F64_2) -> BoxTree:
    """Return the tree over n ≥ 1 bounding boxes, (n, 4): x min, y min, x max, y max."""
    count = len(boxes)
    remaining = (count + NODE_SIZE - 1) // NODE_SIZE
    total = count + remaining
    while remaining > 1:
        remaining = (remaining + NODE_SIZE - 1) // NODE_SIZE
        total += remaining
    nodes = np.empty((total, 4))
    for i in range(count):
        for side in range(4):
            nodes[i, side] = boxes[i, side]
    level = np.empty(_LEVELS, np.int64)
    return BoxTree(nodes, level, _fill_levels(nodes, count, level))


@kernel(allocates=False)
def _fill_levels(nodes: OutF64_2, count: int, level: OutI64_1) -> int:
    """Write the boxes of all nodes of a tree, level by level, and return the level of the root.

    ``nodes`` (t, 4): all boxes of the tree.  The caller has filled the first ``count`` rows; this
    function fills the other rows with the boxes of the nodes.
    ``count``: number of boxes over which the tree is built.
    ``level`` (24,): gets the row in ``nodes`` of the first box of each level.
    """
    level[0] = 0
    height = 0
    begin = 0
    # A tree of one box needs a root too: only boxes below a node are compared with a query.
    while count > 1 or height == 0:
        above = begin + count
        level[height + 1] = above
        height += 1
        parents = (count + NODE_SIZE - 1) // NODE_SIZE
        for i in range(parents):
            low = begin + i * NODE_SIZE
            x0, y0, x1, y1 = nodes[low, 0], nodes[low, 1], nodes[low, 2], nodes[low, 3]
            for j in range(low + 1, min(low + NODE_SIZE, above)):
                x0 = min(x0, nodes[j, 0])
                y0 = min(y0, nodes[j, 1])
                x1 = max(x1, nodes[j, 2])
                y1 = max(y1, nodes[j, 3])
            nodes[above + i, 0] = x0
            nodes[above + i, 1] = y0
            nodes[above + i, 2] = x1
            nodes[above + i, 3] = y1
        begin = above
        count = parents
    level[height + 1] = begin + count
    return height


@kernel
def new_stack() -> Any:
    """Return an empty stack for searches in a ``BoxTree``, a two-column array of integers.

    During a search it contains the nodes that are still to be visited.  The same stack may be used
    for one search after another.
    """
    return np.empty((_STACK_LENGTH, 2), np.int64)


@kernel(allocates=False)
def start_query(tree: BoxTree, stack: OutI64_2) -> int:
    """Begin a search in a tree, and return the depth of ``stack``.

    ``next_overlap`` continues the search.  The depth is the number of nodes on the stack, which is
    1: the function writes the root of the tree to ``stack``, an array from ``new_stack``.
    """
    stack[0, 0] = tree.height
    stack[0, 1] = 0
    return 1


@kernel(allocates=False)
def next_overlap(
    boxes: F64_2,
    level: I64_1,
    stack: OutI64_2,
    depth: int,
    box: tuple[float, float, float, float],
    previous: int,
) -> tuple[int, int]:
    """Return the next result of a search for the bounding boxes that overlap a given box.

    ``start_query`` begins the search.  Each call returns one box, in ascending order of row
    numbers.

    Parameters
    ----------
    boxes, level
        Arrays of the ``BoxTree``, passed separately because a tuple of arrays takes time in each
        call.
    stack, depth
        Nodes still to be visited, and their number, from ``start_query`` or the previous call.  The
        function overwrites ``stack``.
    box
        The given box: x min, y min, x max, y max.  It may shrink from call to call.
    previous
        Only boxes with a greater row number are returned; -1 for all.

    Returns
    -------
    box, depth
        Row number of the box in ``boxes``, -1 if there are no more, and the new depth of the stack.
    """
    x0, y0, x1, y1 = box
    while depth > 0:
        depth -= 1
        height = stack[depth, 0]
        number = stack[depth, 1]
        if height == 0:
            if number > previous:
                return number, depth
            continue
        # Number of given boxes below a node of the next lower level.
        width = 1 << (_NODE_BITS * (height - 1))
        low = level[height - 1]
        first = number * NODE_SIZE
        for child in range(min(first + NODE_SIZE, level[height] - low) - 1, first - 1, -1):
            if (child + 1) * width - 1 <= previous:
                break
            at = low + child
            if boxes[at, 0] > x1 or boxes[at, 2] < x0 or boxes[at, 1] > y1 or boxes[at, 3] < y0:
                continue
            stack[depth, 0] = height - 1
            stack[depth, 1] = child
            depth += 1
    return -1, 0
