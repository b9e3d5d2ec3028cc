"""Results of parallel calls are in order, and exceptions are raised again."""

from __future__ import annotations

import pytest

from knifetip.geometry import parallel


def _fails() -> int:
    raise ZeroDivisionError


def test_chunks_cover_the_range_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(parallel, "core_count", lambda: 3)
    assert parallel.chunks(10, 2) == [(0, 3), (3, 6), (6, 10)]
    assert parallel.chunks(10, 6) == [(0, 10)]
    assert parallel.chunks(0, 6) == [(0, 0)]


def test_results_are_in_the_order_of_the_items() -> None:
    assert parallel.parallel_map(lambda run: run * run, [3, 1, 2]) == [9, 1, 4]


@pytest.mark.parametrize("machine", [1, 2])
def test_a_pair_returns_the_results_in_order(machine: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(parallel, "core_count", lambda: machine)
    assert parallel.parallel_pair(lambda: "one", lambda: "other") == ("one", "other")
    for pair in ((_fails, int), (int, _fails)):
        with pytest.raises(ZeroDivisionError):
            parallel.parallel_pair(*pair)


def test_no_items_give_no_results() -> None:
    assert parallel.parallel_map(lambda _: _fails(), []) == []


def test_all_items_are_processed_before_the_first_error_is_raised() -> None:
    seen = []

    def done(run: int) -> None:
        seen.append(run)
        if run in (1, 2):
            raise ValueError(run)

    with pytest.raises(ValueError, match="1"):
        parallel.parallel_map(done, [0, 1, 2, 3])
    assert sorted(seen) == [0, 1, 2, 3]


def test_nested_calls_do_not_deadlock() -> None:
    def outer(run: int) -> int:
        return sum(parallel.parallel_map(lambda inner: run * inner, [1, 2, 3]))

    # More items than cores, each with a parallel call of its own.
    assert parallel.parallel_map(outer, list(range(40))) == [6 * run for run in range(40)]
