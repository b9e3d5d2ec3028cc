"""Compilations as workflows of DBOS, in SQLite or, if there is a server, in PostgreSQL."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from knifetip.jobs.compile_queue import TableQueue, queue_of
from knifetip.jobs.durable_queue import DurableQueue
from knifetip.jobs.store import Store
from knifetip.jobs.tables import Job
from tests.support.stored import add_job, migrated_store

# Only one DBOS can run in a process.
pytestmark = pytest.mark.xdist_group("crew")


@pytest.fixture
def store(database_url: str) -> Iterator[Store]:
    with migrated_store(database_url) as store:
        yield store


def until(condition: Callable[[], bool]) -> None:
    end = time.monotonic() + 20.0
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.02)


def test_each_received_job_is_compiled_once(store: Store) -> None:
    compiled: list[tuple[str, int]] = []
    queue = DurableQueue(store, "a worker", 1)
    before = add_job(store)
    queue.start(lambda job: compiled.append((job.id, job.epoch)))
    try:
        until(lambda: len(compiled) == 1)
        later = add_job(store)
        until(lambda: len(compiled) == 2)
        time.sleep(1.2)
        assert compiled == [(before.id, before.epoch + 1), (later.id, later.epoch + 1)]
        assert store.jobs.get(later.id).state == "compiling"
    finally:
        queue.stop()


def test_a_job_given_back_is_compiled_as_another_attempt(store: Store) -> None:
    attempts: list[int] = []

    def compile(job: Job) -> None:
        attempts.append(job.attempt)
        if job.attempt == 1:
            store.compiles.give_back(job.id, job.epoch)

    queue = DurableQueue(store, "a worker", 1)
    job = add_job(store)
    queue.start(compile)
    try:
        until(lambda: len(attempts) == 2)
        assert attempts == [1, 2]
        # The workflow of the first attempt finds nothing to do.
        queue.compile(job.id, 1)
        assert attempts == [1, 2]
    finally:
        queue.stop()


def test_a_process_that_only_receives_jobs_compiles_none(store: Store) -> None:
    compiled = threading.Event()
    queue = DurableQueue(store, "a server", 0)
    job = add_job(store)
    queue.start(lambda _job: compiled.set())
    try:
        assert not compiled.wait(2.5)
        assert store.jobs.get(job.id).state == "received"
    finally:
        queue.stop()


def test_the_database_decides_on_the_queue(tmp_path: Path) -> None:
    store = Store(f"sqlite:///{tmp_path}/shop.sqlite")
    assert isinstance(queue_of(store, "a", 1, compiles=True), TableQueue)
    assert queue_of(store, "a", 1, compiles=False) is None
    store.database.url = "postgresql+psycopg://somewhere/shop"
    assert isinstance(queue_of(store, "a", 1, compiles=True), DurableQueue)
    assert isinstance(queue_of(store, "a", 1, compiles=False), DurableQueue)
    store.close()
