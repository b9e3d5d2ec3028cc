"""The number of jobs that a process has taken back from silent owners."""

from __future__ import annotations

from knifetip.service.store import Store
from tests.support.job_states import RESULT, compiling
from tests.support.stored import Clock


def test_a_job_that_was_finished_before_it_could_be_taken_back_is_not_counted(
    store: Store, clock: Clock
) -> None:
    lost, finished = compiling(store), compiling(store)
    store.compiles.save_result(finished.id, finished.epoch, RESULT)
    clock.now += 1000.0
    for job in (lost, finished):
        store.leases._take_back(job.id, clock.now)
    assert store.leases.taken_back == 1
    assert store.jobs.get(lost.id).state == "received"
    assert store.jobs.get(finished.id).state == "ready"
