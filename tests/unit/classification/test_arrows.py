"""Arrows are found, notches and corners are not."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from knifetip.classification.shape.arrows import find_arrow_edges
from knifetip.topology.planar_graph import build_graph


def found(lines: Sequence[tuple[float, ...]], unit: float = 1.0) -> list[bool]:
    ends = np.array(lines, np.float64).reshape(-1, 2, 2)
    graph = build_graph(ends, np.zeros(len(lines)), 0.05 * unit, 1.0 * unit)
    assert graph is not None
    seen: list[bool] = find_arrow_edges(graph, len(lines), unit).tolist()
    return seen


#: A shaft of 50 mm with two heads of 3 mm, between two extension lines.
DIMENSION = [
    (0, 0, 50, 0), (0, 0, 3, 1), (0, 0, 3, -1), (50, 0, 47, 1), (50, 0, 47, -1),
    (0, 20, 0, -3), (50, 20, 50, -3),
]  # fmt: skip


def test_a_dimension_has_a_shaft_heads_and_extension_lines() -> None:
    assert found(DIMENSION) == [True] * 7


def test_arrows_are_found_in_any_unit() -> None:
    inches = [tuple(value / 25.4 for value in line) for line in DIMENSION]
    assert found(inches, 1.0 / 25.4) == [True] * 7


def test_a_crease_at_the_tip_of_an_arrow_is_no_arrow() -> None:
    creases = [(0, 90, 0, -90), (50, 90, 50, -90)]
    assert found([*DIMENSION[:5], *creases]) == [True] * 5 + [False] * 2


def test_a_triangular_head_includes_its_back() -> None:
    assert found([(0, 0, 50, 0), (0, 0, 3, 1), (0, 0, 3, -1), (3, 1, 3, -1)]) == [True] * 4


def test_a_notch_at_the_end_of_a_crease_is_no_arrow() -> None:
    assert found([(0, 0, 50, 0), (0, 0, -3, 1), (0, 0, -3, -1)]) == [False] * 3


def test_sides_of_different_lengths_or_angles_are_no_head() -> None:
    assert found([(0, 0, 50, 0), (0, 0, 3, 1), (0, 0, 5, -1.7)]) == [False] * 3
    assert found([(0, 0, 50, 0), (0, 0, 3, 1), (0, 0, 2, -2.45)]) == [False] * 3


def test_the_tip_of_a_flap_is_no_arrow() -> None:
    flap = [(0, 0, 50, 0), (0, 0, 8, 4), (0, 0, 8, -4), (8, 4, 50, 30), (8, -4, 50, -30)]
    assert found(flap) == [False] * 5


def test_an_arrow_drawn_twice_with_small_differences_is_found() -> None:
    again = [(47, 1.02, 50, 0.01), (3.01, -1, 0.02, 0), (50, 0, 0, 0)]
    assert found([*DIMENSION, *again]) == [True] * 10
