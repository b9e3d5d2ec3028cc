"""Workers that are killed while they compile: another one, or the same, finishes the job once."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from itertools import groupby

import pytest

from knifetip.service.compiling.service import CompileService
from knifetip.service.processes import tasks
from knifetip.service.processes.pool import ProcessPool
from knifetip.service.store import Store
from tests.support.job_states import ended
from tests.support.serving import crew_tasks
from tests.support.stored import add_job, migrated_store

# Only one DBOS can run in a process.
pytestmark = pytest.mark.xdist_group("crew")

_STUCK_WORKER = """
import sys, time
from knifetip.service.compiling import store as compile_store
from knifetip.service.compiling.queue_selection import select_queue
from knifetip.service.database.process_link import join
from knifetip.service.store import Store
compile_store.LEASE = float(sys.argv[3])
store = Store(sys.argv[1])
link = join(store.database.url, store.changes, sys.argv[2], "worker")
def compile(job):
    print(job.id, flush=True)
    time.sleep(600)
select_queue(store, link.name, 1, 0.1).start(compile)
time.sleep(600)
"""


@pytest.fixture
def store(postgresql_url: str) -> Iterator[Store]:
    with migrated_store(postgresql_url, None) as store:
        yield store


def kill_while_compiling(store: Store, worker: str, job: str, lease: float) -> None:
    """Run a worker in another process until it compiles a job, then kill it (SIGKILL)."""
    process = subprocess.Popen(
        [sys.executable, "-c", _STUCK_WORKER, store.database.url, worker, str(lease)],
        stdout=subprocess.PIPE,
        text=True,
    )
    assert process.stdout is not None
    try:
        assert process.stdout.readline() == f"{job}\n"
    finally:
        process.kill()
        process.wait()
        process.stdout.close()


@pytest.mark.parametrize(
    ("worker", "lease"),
    [
        pytest.param("another", 1.0, id="another worker, when the lease expires"),
        # It is identified by its name, so the lease of an hour need not expire.
        pytest.param("killed", 3600.0, id="the same worker, at once"),
    ],
)
def test_the_job_of_a_killed_worker_is_compiled_once_to_its_end(
    store: Store, worker: str, lease: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tasks, "missing_kernels", crew_tasks.nothing_missing)
    monkeypatch.setattr(tasks, "compile", crew_tasks.refuse)
    job = add_job(store)
    kill_while_compiling(store, "killed", job.id, lease)
    lost = store.jobs.get(job.id)
    assert (lost.state, lost.owner, lost.attempt) == ("compiling", "killed", 1)
    service = CompileService(store, ProcessPool(1), worker, gateways=False)
    service.start()
    try:
        done = ended(store, job.id, "refused")
    finally:
        service.stop()
    assert done.attempt == 2
    # While the worker looks for kernels, a received job may have a second event.
    states = [state for state, _ in groupby(event.state for event in store.events.of_job(job.id))]
    assert states == ["received", "compiling", "received", "compiling", "refused"]
