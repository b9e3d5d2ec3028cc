"""Compilations as workflows of DBOS, in SQLite or, if there is a server, in PostgreSQL."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from dbos import DBOS

from knifetip.messages import Message
from knifetip.service.compiling.durable_queue import DurableQueue
from knifetip.service.compiling.queue import TableQueue
from knifetip.service.compiling.queue_selection import select_queue
from knifetip.service.database.tables import Job
from knifetip.service.store import Store
from tests.support.stored import add_job, migrated_store

# Only one DBOS can run in a process.
pytestmark = pytest.mark.xdist_group("crew")


@pytest.fixture
def store(migrated_url: str) -> Iterator[Store]:
    with migrated_store(migrated_url) as store:
        yield store


def until(condition: Callable[[], bool]) -> None:
    end = time.monotonic() + 60.0
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.02)


def durable_queue(store: Store, worker: str = "a worker") -> DurableQueue:
    return DurableQueue(store, worker, TableQueue(store, worker, 1, poll=0.1))


def test_each_received_job_is_compiled_once(store: Store) -> None:
    compiled: list[tuple[str, int]] = []
    queue = durable_queue(store)
    before = add_job(store)
    queue.start(lambda job: compiled.append((job.id, job.epoch)))
    try:
        until(lambda: len(compiled) == 1)
        later = add_job(store)
        until(lambda: len(compiled) == 2)
        assert compiled == [(before.id, before.epoch + 1), (later.id, later.epoch + 1)]
        assert store.jobs.get(later.id).state == "compiling"
        until(lambda: {one.status for one in DBOS.list_workflows()} == {"SUCCESS"})
        assert [one.executor_id for one in DBOS.list_workflows()] == ["a worker"] * 2
    finally:
        queue.stop()


def test_a_job_given_back_is_compiled_as_another_attempt(store: Store) -> None:
    attempts: list[int] = []

    def compile(job: Job) -> None:
        attempts.append(job.attempt)
        if job.attempt == 1:
            store.compiles.give_back(job.id, job.epoch)

    queue = durable_queue(store)
    job = add_job(store)
    queue.start(compile)
    try:
        until(lambda: len(attempts) == 2)
        assert attempts == [1, 2]
        # The workflow of the first attempt finds nothing to do.
        queue.compile(job.id, job.epoch + 1)
        assert attempts == [1, 2]
    finally:
        queue.stop()


def test_the_workflow_of_a_lost_compile_is_deleted_and_that_of_a_running_one_kept(
    store: Store,
) -> None:
    began, end = threading.Event(), threading.Event()

    def compile(_job: Job) -> None:
        began.set()
        end.wait(20.0)

    queue = durable_queue(store)
    job = add_job(store)
    queue.start(compile)
    try:
        assert began.wait(20.0)
        soon = datetime.now(UTC) + timedelta(minutes=2)
        assert queue.delete_old_workflows(soon) == 0
        taken = store.jobs.get(job.id)
        store.compiles.refuse(job.id, taken.epoch, Message("job.verified"))
        assert queue.delete_old_workflows(soon) == 1
        assert not DBOS.list_workflows()
    finally:
        end.set()
        queue.stop()


def test_records_are_deleted_until_few_are_left(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with migrated_store(f"sqlite:///{tmp_path}/shop.sqlite") as store:
        queue = durable_queue(store)
        left = [500, 500, 3, 500]
        monkeypatch.setattr(queue, "delete_old_workflows", lambda _now: left.pop(0))
        waits = [False, True]
        monkeypatch.setattr(queue._stopping, "wait", lambda _seconds: waits.pop(0))
        queue._tidy()
        assert left == [500]


def test_the_database_decides_on_the_queue(tmp_path: Path) -> None:
    store = Store(f"sqlite:///{tmp_path}/shop.sqlite")
    assert isinstance(select_queue(store, "a", 1), TableQueue)
    store.database.url = "postgresql+psycopg://somewhere/shop"
    assert isinstance(select_queue(store, "a", 1), DurableQueue)
    store.close()
