"""counts: how many copies of each part are placed, and how many are left."""

from __future__ import annotations

from collections.abc import Sequence

from knifetip.nesting.arrangement import FilledSheet
from knifetip.nesting.parts import Part


def by_area(parts: Sequence[Part], counts: Sequence[int]) -> list[int]:
    """Return the index of the part of each copy, largest first."""
    indices = sorted(range(len(parts)), key=lambda index: -parts[index].area.area)
    return [index for index in indices for _ in range(counts[index])]


def most_within(order: Sequence[int], parts: Sequence[Part], area: float) -> int:
    """Return how many of the first copies together have at most an area (mm²)."""
    total = 0.0
    for number, index in enumerate(order):
        total += parts[index].area.area
        if total > area:
            return number
    return len(order)


def counts_of(order: Sequence[int], count: int) -> list[int]:
    """Return how often each of ``count`` parts is among the copies."""
    counts = [0] * count
    for index in order:
        counts[index] += 1
    return counts


def placed_counts(sheet: FilledSheet, count: int) -> list[int]:
    """Return how often each of ``count`` parts is on a sheet."""
    return counts_of([place.part for place in sheet.places], count)


def is_prefix(sheet: FilledSheet, order: Sequence[int]) -> bool:
    """Return whether a sheet has the first of the sorted copies, and no others."""
    return sorted(place.part for place in sheet.places) == sorted(order[: len(sheet.places)])


def without(remaining: Sequence[int], sheet: FilledSheet) -> list[int]:
    """Return how many copies of each part are left after those on a sheet."""
    placed = placed_counts(sheet, len(remaining))
    return [count - done for count, done in zip(remaining, placed, strict=True)]
