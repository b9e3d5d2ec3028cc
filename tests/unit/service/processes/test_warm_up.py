"""The warm-up compiles groups in order of need, reports progress, and lets requests wait for a
group.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import cast

import pytest

from knifetip.errors import CurvedGroove
from knifetip.model.stage import Stage
from knifetip.service.processes import warm_up
from knifetip.service.processes.kernel_groups import Part
from knifetip.service.processes.pool import ProcessPool, TaskCancelled, Watch
from knifetip.service.processes.warm_up import WarmUp, WarmUpProgress

PARTS = [
    Part("drawings", "scan", 4),
    Part("drawings", "faces", 2),
    Part("jobs", "plan", 3),
    Part("offsets", "trim", 1),
]


class FakePool:
    """A process pool that compiles a module as soon as the test permits it."""

    started: list[str]
    allowed: threading.Semaphore
    fails: set[str]

    def __init__(self, _size: int = 1) -> None:
        self.closed = threading.Event()

    def run(
        self,
        _task: Callable[..., object],
        first: object,
        *_: object,
        limit: float,
        watch: Watch | None = None,
    ) -> list[Part]:
        assert limit > 0.0
        if watch is None:
            return PARTS
        module = str(first)
        self.started.append(module)
        while not self.allowed.acquire(timeout=0.02):
            if self.closed.is_set() or not watch(Stage.PREPARE, 0.5):
                raise TaskCancelled
        if module in self.fails:
            raise CurvedGroove("groove.curved", count=1, edge=7)
        return []

    def close(self) -> None:
        self.closed.set()


@pytest.fixture
def pool(monkeypatch: pytest.MonkeyPatch) -> FakePool:
    monkeypatch.setattr(FakePool, "started", [], raising=False)
    monkeypatch.setattr(FakePool, "allowed", threading.Semaphore(0), raising=False)
    monkeypatch.setattr(FakePool, "fails", set(), raising=False)
    monkeypatch.setattr(warm_up, "ProcessPool", FakePool)
    monkeypatch.setattr(warm_up, "_AT_ONCE", 1)
    return FakePool()


def started(warm: WarmUp, pool: FakePool) -> None:
    warm.start(cast(ProcessPool, pool))


def until(condition: Callable[[], bool]) -> None:
    end = time.monotonic() + 60.0
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.01)


def waiting(warm: WarmUp, *groups: str) -> threading.Thread:
    thread = threading.Thread(target=warm.wait, args=groups, daemon=True)
    thread.start()
    return thread


def test_groups_are_compiled_in_order_and_each_ends_the_wait_for_it(pool: FakePool) -> None:
    warm = WarmUp()
    started(warm, pool)
    drawings, jobs = waiting(warm, "drawings"), waiting(warm, "drawings", "jobs")
    pool.allowed.release()
    until(lambda: pool.started == ["scan", "faces"])
    assert drawings.is_alive()
    pool.allowed.release()
    drawings.join(5.0)
    assert not drawings.is_alive()
    assert jobs.is_alive()
    pool.allowed.release()
    jobs.join(5.0)
    assert not jobs.is_alive()
    assert not warm.progress.finished
    pool.allowed.release()
    until(lambda: warm.progress.finished)
    assert pool.started == ["scan", "faces", "plan", "trim"]


def test_progress_counts_kernels(pool: FakePool) -> None:
    seen: list[WarmUpProgress] = []
    warm = WarmUp(on_progress=seen.append)
    started(warm, pool)
    until(lambda: warm.progress == WarmUpProgress(False, 2, 10))
    pool.allowed.release(4)
    until(lambda: warm.progress.finished)
    assert warm.progress == WarmUpProgress(True, 10, 10)
    counts = [progress.compiled for progress in seen]
    assert counts == sorted(counts)
    assert seen[-1] == warm.progress


def test_who_waits_gets_the_share_of_the_groups_and_may_give_up(pool: FakePool) -> None:
    warm = WarmUp()
    started(warm, pool)
    until(lambda: pool.started == ["scan"])
    seen: list[tuple[Stage, float]] = []

    def watch(stage: Stage, share: float) -> bool:
        seen.append((stage, share))
        return False

    until(lambda: warm.progress.compiled == 2)
    assert warm.fraction_compiled("drawings") == 2 / 6
    with pytest.raises(TaskCancelled):
        warm.wait("drawings", watch=watch)
    assert seen == [(Stage.PREPARE, 2 / 6)]
    warm.close()


def test_a_warm_up_that_was_never_started_delays_nothing() -> None:
    warm = WarmUp()
    warm.wait("drawings", "jobs", "offsets")
    assert warm.fraction_compiled("drawings") == 1.0
    assert warm.progress == WarmUpProgress(True, 0, 0)


@pytest.mark.parametrize("fails", [{"scan"}, set()])
def test_a_module_that_does_not_compile_does_not_stop_the_others(
    pool: FakePool, fails: set[str]
) -> None:
    pool.fails.update(fails)
    pool.allowed.release(4)
    warm = WarmUp()
    assert warm.run(cast(ProcessPool, pool)) is not bool(fails)
    warm.wait("drawings", "jobs", "offsets")
    assert warm.progress.finished
    assert pool.started == ["scan", "faces", "plan", "trim"]


def test_closing_cancels_compilers_and_waiting_requests(pool: FakePool) -> None:
    warm = WarmUp()
    started(warm, pool)
    until(lambda: pool.started == ["scan"])
    refused: list[type[BaseException]] = []

    def wait() -> None:
        try:
            warm.wait("offsets")
        except TaskCancelled:
            refused.append(TaskCancelled)

    thread = threading.Thread(target=wait)
    thread.start()
    warm.close()
    thread.join(5.0)
    assert refused == [TaskCancelled]
    until(lambda: warm.progress.finished)
    assert pool.started == ["scan"]
