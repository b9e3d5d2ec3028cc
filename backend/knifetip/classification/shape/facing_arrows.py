"""facing_arrows: find dimensions whose arrowheads lie beyond the lines that they measure.

The sides of such a head point away from the shaft, as those of the fork at the end of a slit do.
Two heads are a dimension if they face each other on one straight line and their sides end freely.
The shaft is one line from tip to tip, or a line at each tip with a space for a text between them.
The tips lie on other lines, which are measured, or the two parts of the shaft are equally long.
"""

from __future__ import annotations

import math
from itertools import combinations
from typing import Final, NamedTuple

import numpy as np

from knifetip.geometry.columns import F64, I64
from knifetip.topology.planar_graph import PlanarGraph

#: Greatest number of forks that are examined.
_MOST_FORKS: Final = 500
#: Greatest length of the side of a head (mm), and as a fraction of the length of its shaft.
_MAX_LENGTH: Final = 12.0
_MAX_FRACTION: Final = 0.75
#: Least and greatest angle between a side and the line of the shaft (radians).
_MIN_ANGLE: Final = math.radians(5.0)
_MAX_ANGLE: Final = math.radians(50.0)
#: Greatest difference between the lengths of equal sides, as a fraction.
_LENGTH_TOLERANCE: Final = 0.05
#: Greatest difference between the lengths of the two parts of a shaft, as a fraction.
_EQUAL: Final = 0.01
#: Greatest difference between directions of lines that are parallel (radians).
_PARALLEL: Final = math.radians(1.0)
#: Greatest distance between lines on one straight line (mm).
_BESIDE: Final = 0.2


class _Head(NamedTuple):
    """An arrowhead whose sides point away from its shaft."""

    tip: F64  #: (2,)
    along: F64  #: (2,) unit vector from the tip along the shaft
    shaft: int  #: edge that begins at the tip
    shaft_length: float
    sides: tuple[int, int]  #: edges of the head
    on_line: bool  #: whether the tip lies on another line


def find_facing_arrows(graph: PlanarGraph, fork: I64, unit: float) -> I64:
    """Return the edges of dimensions whose heads lie beyond the lines that they measure, (k,).

    Parameters
    ----------
    graph
        Planar graph of the edges.
    fork : (m,)
        Vertices at which two short edges of equal length with free ends begin, and a third edge
        from which they point away.
    unit
        Number of drawing units in a millimetre.
    """
    if not 2 <= len(fork) <= _MOST_FORKS:
        return np.zeros(0, np.int64)
    at_fork = np.zeros(len(graph.vertex), np.bool_)
    at_fork[fork] = True
    rows = np.flatnonzero(graph.first[1:] > graph.first[:-1])
    ends = np.column_stack([graph.start[graph.first[rows]], graph.end[graph.first[rows + 1] - 1]])
    straight = graph.bulge[graph.first[rows]] == 0.0
    beginning: dict[int, list[tuple[int, int]]] = {vertex: [] for vertex in fork.tolist()}
    for side in (0, 1):
        for k in np.flatnonzero(at_fork[ends[:, side]] & straight).tolist():
            beginning[int(ends[k, side])].append((int(rows[k]), int(ends[k, 1 - side])))
    ends_of_pieces = np.concatenate([graph.start, graph.end])
    degree = np.bincount(ends_of_pieces[at_fork[ends_of_pieces]], minlength=len(at_fork))
    heads = [
        head
        for vertex, edges in beginning.items()
        for head in _heads_at(graph.vertex, vertex, edges, bool(degree[vertex] > 3), unit)
    ]
    found: set[int] = set()
    for one, two in combinations(heads, 2):
        if _are_facing(one, two, unit):
            found.update((one.shaft, *one.sides, two.shaft, *two.sides))
    return np.array(sorted(found), np.int64)


def _heads_at(
    vertex: F64, tip: int, edges: list[tuple[int, int]], on_line: bool, unit: float
) -> list[_Head]:
    """Return the heads with a tip at a vertex.

    ``vertex`` (q, 2): position of each vertex of the graph.
    ``edges``: each edge that begins or ends at the vertex, and the vertex at its other end.
    ``on_line``: whether other lines than those of a head and its shaft meet at the vertex.
    ``unit``: number of drawing units in a millimetre.
    """
    heads = []
    reach = {edge: vertex[far] - vertex[tip] for edge, far in edges}
    length = {edge: math.hypot(*run) for edge, run in reach.items()}
    short = [edge for edge, _ in edges if 0.0 < length[edge] <= _MAX_LENGTH * unit]
    for one, two in combinations(short, 2):
        if abs(length[one] - length[two]) > _LENGTH_TOLERANCE * length[one]:
            continue
        back = reach[one] + reach[two]
        depth = math.hypot(*back)
        if not math.cos(_MAX_ANGLE) <= 0.5 * depth / length[one] <= math.cos(_MIN_ANGLE):
            continue
        along = -back / depth
        for shaft, _ in edges:
            run = reach[shaft]
            if length[one] > _MAX_FRACTION * length[shaft] or run @ along <= 0.0:
                continue
            if abs(run[0] * along[1] - run[1] * along[0]) <= _PARALLEL * length[shaft]:
                direction, sides = run / length[shaft], (one, two)
                heads.append(_Head(vertex[tip], direction, shaft, length[shaft], sides, on_line))
    return heads


def _are_facing(head_a: _Head, head_b: _Head, unit: float) -> bool:
    """Return whether two heads are the ends of one dimension."""
    apart = head_b.tip - head_a.tip
    across = abs(apart[0] * head_a.along[1] - apart[1] * head_a.along[0])
    if head_a.along @ head_b.along > -math.cos(_PARALLEL) or across > _BESIDE * unit:
        return False
    if head_a.shaft == head_b.shaft:
        return head_a.on_line and head_b.on_line
    lengths = head_a.shaft_length, head_b.shaft_length
    equal = max(lengths) - min(lengths) <= _EQUAL * max(lengths)
    return bool(apart @ head_a.along >= sum(lengths)) and (
        equal or (head_a.on_line and head_b.on_line)
    )
