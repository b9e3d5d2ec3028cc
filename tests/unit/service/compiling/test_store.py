"""Compiles of jobs: cancelled, lost, repeated and refused."""

from __future__ import annotations

import pytest

from knifetip.errors import (
    StaleEpoch,
    WrongState,
)
from knifetip.model.stage import Stage
from knifetip.service.compiling.store import ATTEMPTS
from knifetip.service.lifecycle.transitions import LEASE
from knifetip.service.store import Store
from tests.support.job_states import (
    RESULT,
    compiling,
    ordered,
)
from tests.support.messages import stored
from tests.support.stored import Clock


def test_a_compile_that_was_cancelled_cannot_leave_its_result(store: Store) -> None:
    job = compiling(store)
    store.operators.cancel(job.id)
    assert not store.compiles.report_progress(job.id, job.epoch, Stage.PLAN, 0.1)
    with pytest.raises(WrongState):
        store.compiles.save_result(job.id, job.epoch, RESULT)
    assert store.jobs.get(job.id).state == "cancelled"


def test_a_compile_whose_worker_fell_silent_is_tried_again_and_the_old_one_is_fenced(
    store: Store, clock: Clock
) -> None:
    job = compiling(store)
    store.compiles.report_progress(job.id, job.epoch, Stage.VERIFY, 0.7)
    clock.now += LEASE + 0.1
    store.leases.run()
    again = store.compiles.begin("a new worker")
    assert again is not None
    assert (again.id, again.attempt) == (job.id, 2)
    with pytest.raises(StaleEpoch):
        store.compiles.save_result(job.id, job.epoch, RESULT)
    store.compiles.save_result(job.id, again.epoch, RESULT)
    assert store.jobs.get(job.id).state == "ready"


def test_a_worker_that_is_started_again_takes_back_what_it_was_compiling(store: Store) -> None:
    job = compiling(store)
    store.compiles.recover("another worker")
    assert store.jobs.get(job.id).state == "compiling"
    store.compiles.recover("worker")
    again = store.compiles.begin("worker")
    assert again is not None
    assert (again.id, again.epoch, again.attempt) == (job.id, job.epoch + 1, 2)
    with pytest.raises(StaleEpoch):
        store.compiles.refuse(job.id, job.epoch, stored("late"))


def test_received_jobs_are_compiled_in_the_order_in_which_they_came(store: Store) -> None:
    jobs = [ordered(store).id for _ in range(3)]
    taken = [store.compiles.begin("worker") for _ in range(4)]
    assert [None if one is None else one.id for one in taken] == [*jobs, None]


def test_a_drawing_that_kills_every_compile_is_refused_in_the_end(
    store: Store, clock: Clock
) -> None:
    job = compiling(store)
    for attempt in range(2, ATTEMPTS + 1):
        clock.now += LEASE + 0.1
        store.leases.run()
        again = store.compiles.begin("worker")
        assert again is not None
        assert again.attempt == attempt
    clock.now += LEASE + 0.1
    store.leases.run()
    assert store.jobs.get(job.id).state == "refused"
    assert "ended unexpectedly 5 times" in str(store.jobs.get(job.id).message)


def test_every_change_calls_its_subscribers_and_progress_does_not(store: Store) -> None:
    calls: list[None] = []
    with store.changes.subscribed(lambda: calls.append(None)):
        job = compiling(store)
        changes = len(calls)
        store.compiles.report_progress(job.id, job.epoch, Stage.PLAN, 0.1)
    store.operators.cancel(job.id)
    # A drawing, an order and the start of its compilation.
    assert (changes, len(calls)) == (3, 3)
