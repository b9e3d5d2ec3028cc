"""Rings of tracks: reversals, and the local search that shortens them."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from knifetip.geometry.columns import I32
from knifetip.sequencing.nearest import find_neighbours
from knifetip.sequencing.order import axis_rates
from knifetip.sequencing.ring import (
    Ends,
    Ring,
    end_time,
    linked_end,
    make_ends,
    make_ring,
    record_reversal,
    reverse_path,
    undo_reversals,
)
from knifetip.sequencing.three_opt import queue_ends, shorten_ring

PACE = np.array([[1500.0, 1500.0, 3600.0], [8000.0, 8000.0, 36000.0]])


def ends_of(seed: int, count: int, one_way: bool = False) -> Ends:
    """Return the ends of random tracks and of an origin at 0; all ends are neighbours."""
    random = np.random.default_rng(seed)
    pose = np.column_stack(
        [random.uniform(0, 300, (2 * count + 2, 2)), np.zeros((2 * count + 2, 2))]
    )
    pose[:, 2] = pose[:, 3] = random.uniform(0, 360, len(pose))
    pose[-2:] = 0.0
    number = count if one_way else 2 * count
    near, _ = find_neighbours(pose[:, :2].copy(), False, one_way, number)
    return make_ends(pose, axis_rates(PACE, 360.0), near)


def ring_of(seed: int, ends: Ends, one_way: bool = False) -> Ring:
    random = np.random.default_rng(seed + 1)
    count = len(ends.pose) // 2
    side = np.zeros(count) if one_way else random.integers(0, 2, count)
    return make_ring((2 * random.permutation(count) + side).astype(np.int32), ends, 50)


def links(ring: Ring) -> set[frozenset[int]]:
    entered = ring.entered.tolist()
    return {frozenset((entered[at - 1] ^ 1, entered[at])) for at in range(len(entered))}


def check_consistent(ring: Ring, ends: Ends) -> None:
    """Check the arrays of the ring against its order."""
    np.testing.assert_array_equal(ring.place[ring.entered >> 1], np.arange(len(ring.entered)))
    for one, other in links(ring):
        assert linked_end(one, ring) == other
        assert linked_end(other, ring) == one
        assert ring.linked[one] == ring.linked[other] == end_time(one, other, ends)


@pytest.mark.parametrize("count", [4, 5, 12])
def test_a_reversed_path_is_linked_at_its_other_ends(count: int) -> None:
    ends = ends_of(count, count)
    for low, high in itertools.product(range(count + 1), repeat=2):
        ring = ring_of(3, ends)
        before = links(ring)
        if (high - low) % (count + 1) == count:
            continue
        first, last = int(ring.entered[low]), int(ring.entered[high]) ^ 1
        left, right = linked_end(first, ring), linked_end(last, ring)
        reverse_path(first, last, ring, ends)
        check_consistent(ring, ends)
        old = {frozenset((left, first)), frozenset((last, right))}
        new = {frozenset((left, last)), frozenset((first, right))}
        assert links(ring) == (before - old) | new


def test_reversals_are_undone() -> None:
    ends = ends_of(1, 20)
    ring = ring_of(1, ends)
    before = links(ring)
    random = np.random.default_rng(0)
    for done in range(30):
        low, size = random.integers(0, 21), random.integers(0, 19)
        last = int(ring.entered[(low + size) % 21]) ^ 1
        assert record_reversal(int(ring.entered[low]), last, done, ring, ends) == done + 1
    assert links(ring) != before
    undo_reversals(30, ring, ends)
    assert links(ring) == before
    check_consistent(ring, ends)


def time_of(entered: I32, ends: Ends) -> float:
    """Return the time of all air moves of a ring."""
    return sum(
        end_time(int(entered[at - 1]) ^ 1, int(entered[at]), ends) for at in range(len(entered))
    )


@pytest.mark.parametrize("one_way", [False, True])
@pytest.mark.parametrize("seed", range(4))
def test_no_change_of_three_links_shortens_a_searched_ring(seed: int, one_way: bool) -> None:
    ends = ends_of(seed, 11, one_way)
    ring = ring_of(seed, ends, one_way)
    first = time_of(ring.entered, ends)
    saved, _ = shorten_ring(queue_ends(ring.entered), 24, 1000, 0, ring, ends)
    check_consistent(ring, ends)
    tour = ring.entered
    least = time_of(tour, ends)
    assert saved == pytest.approx(first - least)
    assert saved > 0.2 * first
    assert not one_way or len(set((tour & 1).tolist())) == 1
    for i, j, k in itertools.combinations(range(13), 3):
        a, b, c = tour[i:j], tour[j:k], np.concatenate([tour[k:], tour[:i]])
        others = [(b, a)]
        if not one_way:
            back_a, back_b = a[::-1] ^ 1, b[::-1] ^ 1
            others += [(back_a, b), (a, back_b), (back_a, back_b), (back_b, a), (b, back_a)]
        for pair in others:
            assert time_of(np.concatenate([*pair, c]), ends) > least - 1e-8
