"""A compile's ends, good and bad, in real processes but without DBOS around them."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from knifetip.jobs import tasks
from knifetip.jobs.crew import Crew
from knifetip.jobs.store import Store
from knifetip.jobs.tables import Job
from knifetip.jobs.work import Workshop
from knifetip.model.interpretation import Interpretation
from tests.support.serving import crew_tasks

pytestmark = pytest.mark.xdist_group("crew")


@pytest.fixture
def store(tmp_path: Path) -> Iterator[Store]:
    store = Store(f"sqlite:///{tmp_path}/shop.sqlite")
    store.migrate()
    yield store
    store.close()


@pytest.fixture
def workshop(store: Store) -> Iterator[Workshop]:
    workshop = Workshop(store, Crew(1), "a worker", limit=30.0)
    yield workshop
    workshop.crew.close()


@pytest.fixture
def job(store: Store) -> Job:
    drawing = store.add_drawing(
        name="tray.dxf",
        content=b"",
        sha256="0" * 64,
        interpretation=Interpretation("mm"),
        summary={},
        edges=b"",
        ledger=b"",
    )
    return store.add_job(
        drawing, machine="demo-table", board="e-flute", interpretation=Interpretation("mm")
    )


@pytest.fixture
def compiles_by(monkeypatch: pytest.MonkeyPatch) -> Callable[[object], None]:
    """Put another task in the place of the compile."""
    return lambda task: monkeypatch.setattr(tasks, "compile", task)


def begun(store: Store, id: str) -> Job:
    while (job := store.job(id)).stage != "verify":
        time.sleep(0.02)
    return job


def test_a_refusal_keeps_reason_mend_and_source(
    store: Store, workshop: Workshop, job: Job, compiles_by: Callable[[object], None]
) -> None:
    compiles_by(crew_tasks.refuse)
    workshop.compile(job.id, 1)
    job = store.job(job.id)
    assert (job.state, job.reason, job.hint, job.source) == (
        "refused",
        "Edge 7 is an arc.",
        "Make it straight.",
        ["2F4"],
    )


@pytest.mark.parametrize(
    ("task", "words"),
    [(crew_tasks.fail, "nobody foresaw: ZeroDivisionError"), (crew_tasks.die, "exit code 3")],
)
def test_a_compile_that_breaks_down_refuses_the_job(
    store: Store,
    workshop: Workshop,
    job: Job,
    compiles_by: Callable[[object], None],
    task: Callable[..., Any],
    words: str,
) -> None:
    compiles_by(task)
    workshop.compile(job.id, 1)
    assert store.job(job.id).state == "refused"
    assert words in store.job(job.id).reason


def test_a_compile_that_takes_too_long_refuses_the_job(
    store: Store, workshop: Workshop, job: Job, compiles_by: Callable[[object], None]
) -> None:
    compiles_by(crew_tasks.hang_in_verify)
    workshop.limit = 4.0
    workshop.compile(job.id, 1)
    assert store.job(job.id).reason == "Stage verify was not finished after 4 s."


def test_a_compile_tells_its_stage_and_is_broken_off_when_its_job_is_cancelled(
    store: Store, workshop: Workshop, job: Job, compiles_by: Callable[[object], None]
) -> None:
    compiles_by(crew_tasks.hang_in_verify)
    thread = threading.Thread(target=workshop.compile, args=(job.id, 1))
    thread.start()
    assert begun(store, job.id).progress == 0.7
    store.cancel(job.id)
    thread.join(5.0)
    assert not thread.is_alive()
    assert store.job(job.id).state == "cancelled"


def test_a_silent_compile_keeps_its_lease(
    store: Store, workshop: Workshop, job: Job, compiles_by: Callable[[object], None]
) -> None:
    compiles_by(crew_tasks.hang_in_verify)
    thread = threading.Thread(target=workshop.compile, args=(job.id, 1))
    thread.start()
    lease = begun(store, job.id).lease
    time.sleep(2.2)
    assert store.job(job.id).lease > lease + 1.0
    store.cancel(job.id)
    thread.join(5.0)


def test_a_workshop_that_stops_gives_its_compile_back(
    store: Store, workshop: Workshop, job: Job, compiles_by: Callable[[object], None]
) -> None:
    compiles_by(crew_tasks.hang_in_verify)
    thread = threading.Thread(target=workshop.compile, args=(job.id, 1))
    thread.start()
    begun(store, job.id)
    workshop._stopping.set()
    workshop.crew.close()
    thread.join(5.0)
    given = store.job(job.id)
    assert (given.state, given.attempt, given.owner) == ("received", 2, "")


def test_an_attempt_that_was_given_to_another_is_left_alone(
    store: Store, workshop: Workshop, job: Job, compiles_by: Callable[[object], None]
) -> None:
    compiles_by(crew_tasks.refuse)
    workshop.compile(job.id, 2)
    assert store.job(job.id).state == "received"


@pytest.mark.parametrize("gateways", [True, False])
def test_only_a_process_that_gateways_reach_takes_jobs_from_them(
    store: Store, workshop: Workshop, monkeypatch: pytest.MonkeyPatch, gateways: bool
) -> None:
    asked: list[bool] = []
    monkeypatch.setattr("knifetip.jobs.work.Grace.over", lambda _grace, _now: len(asked) >= 1)

    def sweep(_patience: float, *, gateways: bool) -> list[tuple[str, int]]:
        asked.append(gateways)
        if len(asked) == 2:
            workshop._stopping.set()
        return []

    monkeypatch.setattr(store, "sweep", sweep)
    workshop.gateways = gateways
    workshop._sweep()
    assert asked == [False, gateways]
