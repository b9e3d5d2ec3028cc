"""The end of compilations in real processes: success, refusal, failure, timeout and
cancellation.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any, NoReturn

import pytest

from knifetip.errors import ContentLost
from knifetip.library import load
from knifetip.messages import Message, hint
from knifetip.model.stage import Stage
from knifetip.service.compiling import service as compile_service
from knifetip.service.compiling.service import CompileService
from knifetip.service.database.tables import Job
from knifetip.service.processes import tasks
from knifetip.service.processes.pool import ProcessPool, Watch
from knifetip.service.processes.warm_up import WarmUp
from knifetip.service.store import Store
from tests.support.job_states import ended
from tests.support.serving import crew_tasks
from tests.support.stored import add_job, migrated_store

pytestmark = pytest.mark.xdist_group("crew")


@pytest.fixture
def store(migrated_sqlite: str) -> Iterator[Store]:
    with migrated_store(migrated_sqlite) as store:
        yield store


@pytest.fixture
def service(store: Store) -> Iterator[CompileService]:
    service = CompileService(store, ProcessPool(1), "a worker", limit=30.0)
    yield service
    service.pool.close()


@pytest.fixture
def job(store: Store) -> Job:
    return add_job(store)


@pytest.fixture
def compiles_by(monkeypatch: pytest.MonkeyPatch) -> Callable[[object], None]:
    """Return a function that makes the service run another task in place of the compilation."""
    monkeypatch.setattr(tasks, "missing_kernels", crew_tasks.nothing_missing)
    return lambda task: monkeypatch.setattr(tasks, "compile", task)


class UnreadyWarmUp(WarmUp):
    """A warm-up that has compiled the kernels of some groups only."""

    def __init__(self, *compiled: str) -> None:
        super().__init__()
        self.compiled = set(compiled)

    def fraction_compiled(self, *groups: str) -> float:
        return len(self.compiled.intersection(groups)) / len(groups)


def test_a_job_whose_kernels_are_not_compiled_lets_ready_jobs_pass(
    store: Store, compiles_by: Callable[[object], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("knifetip.service.compiling.queue._PATIENCE", 0.0)
    compiles_by(crew_tasks.refuse)
    warm_up = UnreadyWarmUp("drawings", "jobs")
    routed, cut = add_job(store, machine="router-table"), add_job(store)
    service = CompileService(store, ProcessPool(1), "a worker", warm_up=warm_up)
    service.start()
    try:
        ended(store, cut.id, "refused")
        waiting = store.jobs.get(routed.id)
        assert (waiting.state, waiting.attempt) == ("received", 1)
        assert waiting.message == Message("job.awaits-kernels", machine="router-table")
        assert (waiting.stage, waiting.progress) == (Stage.PREPARE, 2.0 / 3.0)
        messages = [event.message for event in store.events.of_job(routed.id)]
        assert messages.count(waiting.message) == 1
        warm_up.compiled.add("offsets")
        ended(store, routed.id, "refused")
        assert store.jobs.get(routed.id).message != waiting.message
    finally:
        service.stop()


def begin(store: Store, service: CompileService) -> Job:
    job = store.compiles.begin(service.name)
    assert job is not None
    return job


def begun(store: Store, id: str) -> Job:
    while (job := store.jobs.get(id)).stage != "verify":
        time.sleep(0.02)
    return job


def test_a_refusal_keeps_reason_mend_and_source(
    store: Store, service: CompileService, job: Job, compiles_by: Callable[[object], None]
) -> None:
    compiles_by(crew_tasks.refuse)
    service.compile(begin(store, service))
    job = store.jobs.get(job.id)
    assert job.message is not None
    assert (job.state, str(job.message), hint(job.message), job.source) == (
        "refused",
        "1 V-groove is an arc (first: edge 7), which a straight blade cannot follow.",
        "Draw the V-grooves with straight lines, permit chords in the board file (groove_curve), "
        "or choose another line type for them.",
        ["2F4"],
    )
    assert job.edges == [7, 8]


@pytest.mark.parametrize(
    ("task", "words"),
    [(crew_tasks.fail, "Internal error"), (crew_tasks.die, "exit code 3")],
)
def test_a_compile_that_breaks_down_refuses_the_job(
    store: Store,
    service: CompileService,
    job: Job,
    compiles_by: Callable[[object], None],
    task: Callable[..., Any],
    words: str,
) -> None:
    compiles_by(task)
    service.compile(begin(store, service))
    assert store.jobs.get(job.id).state == "refused"
    assert words in str(store.jobs.get(job.id).message)


def test_a_compile_that_takes_too_long_refuses_the_job(
    store: Store, job: Job, compiles_by: Callable[[object], None]
) -> None:
    compiles_by(crew_tasks.hang_in_verify)

    def clock() -> float:
        return 4.0 if store.jobs.get(job.id).stage == "verify" else 0.0

    service = CompileService(store, ProcessPool(1, clock=clock), "a worker", limit=4.0)
    try:
        service.compile(begin(store, service))
    finally:
        service.pool.close()
    assert (
        str(store.jobs.get(job.id).message)
        == "Processing the drawing took longer than 4 s in the stage verify."
    )


def test_a_compile_reports_its_stage_and_is_aborted_when_its_job_is_cancelled(
    store: Store, service: CompileService, job: Job, compiles_by: Callable[[object], None]
) -> None:
    compiles_by(crew_tasks.hang_in_verify)
    thread = threading.Thread(target=service.compile, args=(begin(store, service),))
    thread.start()
    assert begun(store, job.id).progress == 0.7
    store.operators.cancel(job.id)
    thread.join(5.0)
    assert not thread.is_alive()
    assert store.jobs.get(job.id).state == "cancelled"


def test_a_silent_compile_keeps_its_lease(
    store: Store, service: CompileService, job: Job, compiles_by: Callable[[object], None]
) -> None:
    compiles_by(crew_tasks.hang_in_verify)
    thread = threading.Thread(target=service.compile, args=(begin(store, service),))
    thread.start()
    lease = begun(store, job.id).lease
    time.sleep(2.2)
    assert store.jobs.get(job.id).lease > lease + 1.0
    store.operators.cancel(job.id)
    thread.join(5.0)


@pytest.fixture
def lease_passes(monkeypatch: pytest.MonkeyPatch, store: Store) -> Callable[[str], None]:
    """Return a function that waits until the lease of a compile was renewed by its service."""
    monkeypatch.setattr(compile_service, "_KEEP", 0.05)

    def wait(id: str) -> None:
        lease, until = store.jobs.get(id).lease, time.monotonic() + 60.0
        while store.jobs.get(id).lease <= lease:
            assert time.monotonic() < until
            time.sleep(0.02)

    return wait


def test_a_compile_keeps_its_lease_while_requests_occupy_all_processes(
    store: Store,
    service: CompileService,
    job: Job,
    compiles_by: Callable[[object], None],
    lease_passes: Callable[[str], None],
    tmp_path: Path,
) -> None:
    compiles_by(crew_tasks.refuse)
    gate = tmp_path / "gate"
    occupying = (crew_tasks.wait_for, str(gate))
    request = threading.Thread(
        target=partial(service.pool.run, limit=100.0), args=occupying, daemon=True
    )
    request.start()
    while not service.pool.busy:
        time.sleep(0.01)
    thread = threading.Thread(target=service.compile, args=(begin(store, service),))
    thread.start()
    lease_passes(job.id)
    assert store.jobs.get(job.id).stage == "read"
    gate.touch()
    request.join(60.0)
    thread.join(60.0)
    assert store.jobs.get(job.id).state == "refused"


def test_a_compile_keeps_its_lease_while_a_bucket_is_slow(
    store: Store,
    service: CompileService,
    job: Job,
    monkeypatch: pytest.MonkeyPatch,
    lease_passes: Callable[[str], None],
) -> None:
    read = threading.Event()

    def slowly(*_: object) -> NoReturn:
        assert read.wait(60.0)
        raise ContentLost("content.missing", owner=job.drawing, address="5e" * 32)

    monkeypatch.setattr(compile_service, "compile_arguments", slowly)
    thread = threading.Thread(target=service.compile, args=(begin(store, service),))
    thread.start()
    lease_passes(job.id)
    read.set()
    thread.join(60.0)
    assert store.jobs.get(job.id).state == "refused"


def test_a_service_that_stops_gives_its_compile_back(
    store: Store, service: CompileService, job: Job, compiles_by: Callable[[object], None]
) -> None:
    compiles_by(crew_tasks.hang_in_verify)
    thread = threading.Thread(target=service.compile, args=(begin(store, service),))
    thread.start()
    begun(store, job.id)
    service._stopping.set()
    service.pool.close()
    thread.join(5.0)
    given = store.jobs.get(job.id)
    assert (given.state, given.attempt, given.owner) == ("received", 2, "")


def test_received_jobs_are_compiled_without_waiting_for_the_next_poll(
    store: Store,
    service: CompileService,
    job: Job,
    compiles_by: Callable[[object], None],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("knifetip.service.compiling.service._SERVER_POLL", 60.0)
    compiles_by(crew_tasks.refuse)
    service.start()
    ended(store, job.id, "refused")
    later = add_job(store)
    ended(store, later.id, "refused")
    service.stop()


def test_a_service_takes_up_what_it_was_compiling_when_it_was_killed(
    store: Store, service: CompileService, job: Job, compiles_by: Callable[[object], None]
) -> None:
    assert store.compiles.begin("a worker") is not None
    compiles_by(crew_tasks.refuse)
    service.start()
    assert ended(store, job.id, "refused").attempt == 2
    service.stop()


@pytest.mark.parametrize("gateways", [True, False])
def test_only_a_process_that_gateways_reach_takes_jobs_from_them(
    store: Store, service: CompileService, monkeypatch: pytest.MonkeyPatch, gateways: bool
) -> None:
    asked: list[bool] = []
    monkeypatch.setattr(
        "knifetip.service.compiling.service.GracePeriod.is_over",
        lambda _grace, _now: len(asked) >= 1,
    )

    def sweep(*, gateways: bool) -> bool:
        asked.append(gateways)
        if len(asked) == 2:
            service._stopping.set()
        return True

    monkeypatch.setattr(store.leases, "run", sweep)
    service.gateways = gateways
    service._sweep()
    assert asked == [False, gateways]


def test_a_job_waits_for_the_kernels_that_its_machine_needs(
    store: Store,
    service: CompileService,
    job: Job,
    compiles_by: Callable[[object], None],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    compiles_by(crew_tasks.refuse)
    compiled = threading.Event()
    groups: list[tuple[str, ...]] = []

    def wait(_warm_up: WarmUp, *needed: str, watch: Watch) -> None:
        groups.append(needed)
        assert watch(Stage.PREPARE, 0.25)
        assert compiled.wait(10.0)

    monkeypatch.setattr(WarmUp, "wait", wait)
    thread = threading.Thread(target=service.compile, args=(begin(store, service),))
    thread.start()
    while (waits := store.jobs.get(job.id)).stage != "prepare":
        time.sleep(0.02)
    assert (waits.state, waits.progress) == ("compiling", 0.25)
    compiled.set()
    thread.join(20.0)
    assert store.jobs.get(job.id).state == "refused"
    assert groups == [("drawings", "jobs")]
    router = load.machine("router-table")
    assert compile_service.kernels_for(router) == ("drawings", "jobs", "offsets")
