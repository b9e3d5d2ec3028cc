"""The process pool with real worker processes, which take a second to start."""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from knifetip.errors import CurvedGroove, DrawingTooLarge
from knifetip.jobs.process_pool import ProcessPool, TaskCancelled, TaskFailed
from knifetip.model.stage import Stage
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


def test_an_unexpected_failure_leaves_the_process_alive(pool: ProcessPool) -> None:
    before = pool.run(crew_tasks.process_id, limit=30.0)
    with pytest.raises(TaskFailed, match="one by none"):
        pool.run(crew_tasks.fail, limit=30.0)
    assert pool.run(crew_tasks.process_id, limit=30.0) == before


def test_a_task_that_hangs_is_killed_and_another_process_takes_its_place(pool: ProcessPool) -> None:
    before = pool.run(crew_tasks.process_id, limit=30.0)
    began = time.monotonic()
    with pytest.raises(
        DrawingTooLarge, match="Processing the drawing took longer than 0 s in the stage plan"
    ):
        pool.run(crew_tasks.hang, limit=0.4)
    assert time.monotonic() - began < 15.0
    assert gone(before)
    assert pool.run(crew_tasks.double, 1, limit=30.0) == 2


def test_a_cancelled_task_is_killed(pool: ProcessPool) -> None:
    with pytest.raises(TaskCancelled):
        pool.run(crew_tasks.hang, limit=30.0, watch=lambda *_: False)


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
