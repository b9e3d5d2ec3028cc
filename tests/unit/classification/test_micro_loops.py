"""Loops of a tenth of a millimetre at the corners of an outline."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from knifetip.classification.shape.features import extract_shape_features
from knifetip.classification.shape.micro_loops import contract_micro_loops
from knifetip.classification.shape.roles import Role
from knifetip.geometry.columns import F64

CORNERS = np.array([(0.0, 0.0), (80.0, 0.0), (80.0, 50.0), (0.0, 50.0)])


def with_loops(size: float, scale: float = 1.0) -> F64:
    """Return a rectangle whose corners each have a square loop, (20, 2, 2)."""
    edges = []
    for corner, following in zip(CORNERS, np.roll(CORNERS, -1, axis=0), strict=True):
        square = corner + size * np.array([(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)])
        edges += [*pairwise(square), (corner, following)]
    return np.array(edges) * scale


def roles(ends: F64, unit_known: bool = True) -> set[Role]:
    features = extract_shape_features(ends, np.zeros(len(ends)), (), unit_known)
    return {Role(role) for role in features.role.tolist()}


@pytest.mark.parametrize("size", [0.02, 0.05, 0.1, 0.15])
def test_an_outline_with_micro_loops_closes_and_the_loops_belong_to_it(size: float) -> None:
    assert roles(with_loops(size)) == {Role.OUTLINE}


def test_the_size_of_a_micro_loop_follows_the_unit() -> None:
    ends = with_loops(0.1, 25.4)
    assert contract_micro_loops(ends, np.zeros(20), 1.0) is None
    found = contract_micro_loops(ends, np.zeros(20), 25.4)
    assert found is not None
    assert found.rows.tolist() == [4, 9, 14, 19]
    # The loop takes the features of the longest edge that ends at it.
    assert found.host.tolist() == [4] * 4 + [4] * 4 + [14] * 4 + [14] * 4


def test_larger_loops_and_chains_of_short_edges_remain() -> None:
    assert contract_micro_loops(with_loops(0.5), np.zeros(20), 1.0) is None
    turn = np.linspace(0.0, 0.5 * np.pi, 6)
    arc = 0.3 * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    path = np.array([(0.3, -40.0), *arc, (-40.0, 0.3)])
    chain = np.stack([path[:-1], path[1:]], axis=1)
    assert contract_micro_loops(chain, np.zeros(len(chain)), 1.0) is None


def test_specks_without_a_longer_edge_remain() -> None:
    speck = with_loops(0.1)[:4]
    line = np.array([[(20.0, 20.0), (60.0, 20.0)]])
    assert contract_micro_loops(np.concatenate([speck, line]), np.zeros(5), 1.0) is None
