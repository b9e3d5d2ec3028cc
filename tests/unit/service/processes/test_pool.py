"""The process pool with real worker processes, which take a second to start."""

from __future__ import annotations

import contextlib
import os
import threading
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import pytest

from knifetip.errors import CurvedGroove, DrawingTooLarge
from knifetip.model.stage import Stage
from knifetip.service.processes.pool import ProcessPool, TaskCancelled, TaskFailed
from tests.support.serving import crew_tasks

pytestmark = pytest.mark.xdist_group("crew")


@pytest.fixture(scope="module")
def pool() -> Iterator[ProcessPool]:
    pool = ProcessPool(size=1, memory=3 << 30)
    yield pool
    pool.close()


def gone(process: int) -> bool:
    for _ in range(100):
        try:
            os.kill(process, 0)
        except ProcessLookupError:
            return True
        time.sleep(0.05)
    return False


def test_a_task_runs_in_another_process_and_reports_its_progress(pool: ProcessPool) -> None:
    heard: list[tuple[str, float]] = []

    def watch(stage: str, share: float) -> bool:
        heard.append((stage, share))
        return True

    assert pool.run(crew_tasks.double, 21, limit=30.0, watch=watch) == 42
    assert heard[-1] == (Stage.PLAN, 0.5)
    assert pool.run(crew_tasks.process_id, limit=30.0) != os.getpid()


def test_a_process_is_kept_for_the_next_task(pool: ProcessPool) -> None:
    first = pool.run(crew_tasks.process_id, limit=30.0)
    assert pool.run(crew_tasks.process_id, limit=30.0) == first


def test_an_error_comes_back_with_mend_and_source(pool: ProcessPool) -> None:
    with pytest.raises(CurvedGroove) as caught:
        pool.run(crew_tasks.refuse, limit=30.0)
    assert caught.value.hint == (
        "Draw the V-grooves with straight lines, permit chords in the board file (groove_curve), "
        "or choose another line type for them."
    )
    assert caught.value.source == ("2F4",)
    assert caught.value.edges == (7, 8)


def test_an_unexpected_failure_leaves_the_process_alive(
    pool: ProcessPool, caplog: pytest.LogCaptureFixture
) -> None:
    before = pool.run(crew_tasks.process_id, limit=30.0)
    with caplog.at_level("ERROR"), pytest.raises(TaskFailed, match="one by none") as failed:
        pool.run(crew_tasks.fail, limit=30.0)
    # The number that users get leads to the traceback.
    assert failed.value.incident in caplog.text
    assert "Traceback" in caplog.text
    assert pool.run(crew_tasks.process_id, limit=30.0) == before


def test_a_task_that_hangs_is_killed_and_another_process_takes_its_place(pool: ProcessPool) -> None:
    before = pool.run(crew_tasks.process_id, limit=30.0)
    began = time.monotonic()
    with pytest.raises(
        DrawingTooLarge, match="Processing the drawing took longer than 0 s in the stage plan"
    ):
        pool.run(crew_tasks.hang, limit=0.4)
    assert time.monotonic() - began < 60.0
    assert gone(before)
    assert pool.run(crew_tasks.double, 1, limit=30.0) == 2


def until(condition: Callable[[], object]) -> None:
    """Wait for a condition that other threads and processes bring about."""
    for _ in range(3000):
        if condition():
            return
        time.sleep(0.01)
    raise AssertionError("nothing happened for half a minute")


class Asking(threading.Thread):
    """A thread that runs a task and keeps the result."""

    def __init__(self, pool: ProcessPool, task: Callable[..., object], *arguments: object) -> None:
        super().__init__(daemon=True)
        self._call: Callable[[], object] = partial(pool.run, task, *arguments, limit=100.0)
        self.found: object = 0
        self.start()

    def run(self) -> None:
        with contextlib.suppress(DrawingTooLarge, TaskCancelled):
            self.found = self._call()

    def result(self) -> object:
        self.join(60.0)
        return self.found


def test_a_cancelled_task_ends_for_its_caller_and_keeps_its_process(
    pool: ProcessPool, tmp_path: Path
) -> None:
    gate = tmp_path / "gate"
    before = pool.run(crew_tasks.process_id, limit=30.0)
    # The task has not ended, so the caller did not wait for it.
    with pytest.raises(TaskCancelled):
        pool.run(crew_tasks.wait_for, str(gate), limit=100.0, watch=lambda *_: False)
    assert pool.busy == 1
    waiting = Asking(pool, crew_tasks.process_id)
    gate.touch()
    assert waiting.result() == before


def test_a_watch_that_fails_keeps_the_process(pool: ProcessPool) -> None:
    before = pool.run(crew_tasks.process_id, limit=30.0)

    def watch(*_: object) -> bool:
        raise OSError("the database does not answer")

    with pytest.raises(OSError, match="does not answer"):
        pool.run(crew_tasks.double, 21, limit=30.0, watch=watch)
    assert pool.run(crew_tasks.process_id, limit=30.0) == before


def test_a_cancelled_task_is_killed_only_when_others_have_waited_for_it() -> None:
    now = [0.0]
    pool = ProcessPool(size=1, clock=lambda: now[0])
    before = pool.run(crew_tasks.process_id, limit=30.0)
    with pytest.raises(TaskCancelled):
        pool.run(crew_tasks.hang, limit=100.0, watch=lambda *_: False)
    now[0] = 30.0
    assert pool._may_still_run(pool._busy[0])  # nobody waits
    now[0] = 4.0
    waiting = Asking(pool, crew_tasks.process_id)
    until(lambda: pool._waiting)
    assert pool._may_still_run(pool._busy[0])  # it may still end
    now[0] = 6.0
    assert waiting.result() not in (0, before)
    assert gone(before)
    pool.close()


def test_a_cancelled_task_is_killed_at_its_limit_of_time() -> None:
    now = [0.0]
    pool = ProcessPool(size=1, clock=lambda: now[0])
    with pytest.raises(TaskCancelled):
        pool.run(crew_tasks.hang, limit=100.0, watch=lambda *_: False)
    process = pool._busy[0].worker.process.pid
    now[0] = 101.0
    assert process is not None
    assert gone(process)
    until(lambda: not pool.busy)
    pool.close()


def test_a_spare_process_is_ready_before_a_task_needs_it(tmp_path: Path) -> None:
    pool = ProcessPool(size=2, spare=1)
    gate = tmp_path / "gate"
    first = Asking(pool, crew_tasks.wait_for, str(gate))
    until(lambda: pool.busy and pool._idle)
    spare = pool._idle[0].process.pid
    assert pool.run(crew_tasks.process_id, limit=30.0) == spare
    gate.touch()
    assert first.result() != spare
    # Neither of them is ended while there is nothing to do.
    pool.trim(idle=0.0)
    assert len(pool._idle) == 2
    # A killed process is replaced before the next task.
    with pytest.raises(DrawingTooLarge, match="longer than"):
        pool.run(crew_tasks.hang, limit=0.1)
    until(lambda: len(pool._idle) == 1)
    pool.close()


def test_a_task_that_may_be_killed_has_a_replacement_beyond_the_size(tmp_path: Path) -> None:
    now = [0.0]
    pool = ProcessPool(size=1, clock=lambda: now[0], spare=1)
    late = Asking(pool, crew_tasks.hang)
    until(lambda: pool.busy)
    assert not pool._idle
    now[0] = 51.0  # of 100 s
    until(lambda: pool._idle)
    replacement = pool._idle[0].process.pid
    waiting = Asking(pool, crew_tasks.process_id)
    assert pool.busy == 1  # more tasks than ``size`` are never executed
    now[0] = 101.0
    assert waiting.result() == replacement
    late.join(30.0)
    pool.close()


def test_a_caller_takes_a_process_that_becomes_free_while_another_starts(tmp_path: Path) -> None:
    started, gate = tmp_path / "started", tmp_path / "gate"
    started.touch()
    pool = ProcessPool(size=2, prepare=crew_tasks.GatedPreparation(str(started)))
    first = pool.run(crew_tasks.process_id, limit=30.0)
    started.unlink()  # the next process is never ready
    working = Asking(pool, crew_tasks.wait_for, str(gate))
    until(lambda: pool.busy)
    waiting = Asking(pool, crew_tasks.process_id)
    until(lambda: pool._starting)
    gate.touch()
    assert working.result() == waiting.result() == first
    pool.close()


def test_an_idle_process_that_was_killed_is_not_used(pool: ProcessPool) -> None:
    before = pool.run(crew_tasks.process_id, limit=30.0)
    pool._idle[0].process.kill()
    pool._idle[0].process.join()
    assert pool.run(crew_tasks.process_id, limit=30.0) != before


def test_a_process_that_cannot_start_fails_its_task_only() -> None:
    pool = ProcessPool(size=1, prepare=crew_tasks.fail_to_start)
    with pytest.raises(DrawingTooLarge, match="exit code 4"):
        pool.run(crew_tasks.double, 1, limit=30.0)
    pool.close()


def test_a_task_that_eats_all_memory_is_refused(pool: ProcessPool) -> None:
    with pytest.raises(DrawingTooLarge, match="GB"):
        pool.run(crew_tasks.eat, 8, limit=30.0)


def test_a_process_that_died_is_distinguished_from_one_that_answers(pool: ProcessPool) -> None:
    with pytest.raises(DrawingTooLarge, match="exit code 3"):
        pool.run(crew_tasks.die, limit=30.0)
    assert pool.run(crew_tasks.double, 4, limit=30.0) == 8


def test_a_pool_that_closes_cancels_its_tasks(tmp_path: Path) -> None:
    pool = ProcessPool(size=1)
    note = tmp_path / "process"
    ends: list[BaseException] = []

    def work() -> None:
        try:
            pool.run(crew_tasks.hang, str(note), limit=60.0)
        except TaskCancelled as reason:
            ends.append(reason)

    thread = threading.Thread(target=work)
    thread.start()
    while not note.exists() or not note.read_text():
        time.sleep(0.02)
    pool.close()
    thread.join(5.0)
    assert len(ends) == 1
    assert gone(int(note.read_text()))
    with pytest.raises(TaskCancelled):
        pool.run(crew_tasks.double, 1, limit=1.0)


def test_trimming_ends_idle_workers_but_the_last_one_used() -> None:
    pool = ProcessPool(size=2)
    found: list[int] = []

    def slow() -> None:
        found.append(pool.run(crew_tasks.slow_process_id, limit=30.0))

    threads = [threading.Thread(target=slow) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    pool.trim(idle=60.0)
    assert len(set(found)) == 2
    pool.trim(idle=0.0)
    kept = pool.run(crew_tasks.process_id, limit=30.0)
    assert kept in found
    assert gone(next(one for one in found if one != kept))
    pool.close()
