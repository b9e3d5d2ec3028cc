"""Jobs of a store in the states that tests of the store need."""

from __future__ import annotations

import time
from typing import Any

import sqlalchemy as sa

from knifetip.messages import hint
from knifetip.model.interpretation import Interpretation
from knifetip.service.database.request_key import RequestKey
from knifetip.service.database.tables import Drawing, Job
from knifetip.service.drawings.store import NewDrawing
from knifetip.service.gateways.heartbeats import GatewayReport
from knifetip.service.orders.store import JobOrder
from knifetip.service.processes.compile_result import CompileResult
from knifetip.service.store import Store
from tests.support.messages import stored

LINES = 231
RESULT = CompileResult(
    accepted=True,
    message=None,
    program=b"G0 X0\n" * LINES,
    sha256="ab" * 32,
    lines=LINES,
    toolpath=b"KTIP",
    verdict=b"KTIP",
    verdict_summary={"seconds": 12.5, "accepted": True},
)
REFUSED = CompileResult(
    accepted=False,
    message=stored("Edge 3 is 0.4 mm off."),
    program=b"",
    sha256="",
    lines=0,
    toolpath=b"",
    verdict=b"",
    verdict_summary={"seconds": 0.0, "accepted": False},
    source=["2F4"],
    edges=[3],
)


WAITING = GatewayReport(line=0, waiting=True)


def drawing(store: Store, key: RequestKey | None = None) -> Drawing:
    new = NewDrawing(
        name="tray.dxf",
        content=b"0\nEOF\n",
        sha256="0" * 64,
        interpretation=Interpretation("mm", overrides=b"\xff"),
        summary={"unit": "mm"},
        edges=b"KTIP",
        import_report=b"",
    )
    return store.drawings.add(new, key)


def execute(store: Store, statement: str, **parameters: str) -> None:
    """Execute one SQL statement past the store."""
    engine = sa.create_engine(store.database.url)
    try:
        with engine.begin() as connection:
            connection.execute(sa.text(statement), parameters)
    finally:
        engine.dispose()


def hint_of(job: Job) -> str:
    """Return the hint in the message of a job."""
    assert job.message is not None
    return hint(job.message)


def ordered(store: Store, key: RequestKey | None = None, **more: Any) -> Job:
    fields: dict[str, Any] = {
        "machine": "table",
        "board": "e-flute",
        "interpretation": Interpretation("mm"),
    }
    return store.jobs.add(drawing(store), JobOrder(**{**fields, **more}), key)


def compiling(store: Store, **more: Any) -> Job:
    id = ordered(store, **more).id
    job = store.compiles.begin("worker")
    assert job is not None
    assert job.id == id
    return job


def queued(store: Store, **more: Any) -> Job:
    job = compiling(store, release=True, **more)
    store.compiles.save_result(job.id, job.epoch, RESULT)
    return store.jobs.get(job.id)


def running(store: Store, **more: Any) -> Job:
    queued(store, **more)
    job = store.gateways.claim("table", "gateway", manual=False)
    assert job is not None
    return job


def waiting(store: Store, **more: Any) -> Job:
    """Return a job that a gateway has claimed on a machine with manual feed."""
    queued(store, **more)
    job = store.gateways.claim("table", "gateway", manual=True)
    assert job is not None
    return job


def confirm(store: Store, id: str, **more: Any) -> Job:
    """Confirm a job with all its checks, and return it."""
    checks = store.operators.checks(store.jobs.get(id))
    return store.operators.confirm(id, [check.id for check in checks], **more)


def fed(store: Store, **more: Any) -> Job:
    """Return a confirmed job that runs on a machine with manual feed."""
    job = waiting(store, **more)
    confirm(store, job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "start"
    return store.jobs.get(job.id)


def course(store: Store, id: str) -> list[str]:
    return [event.state for event in store.events.of_job(id)]


def ended(store: Store, id: str, state: str) -> Job:
    """Wait until a job is in a state, and return the job."""
    until = time.monotonic() + 60.0
    while (job := store.jobs.get(id)).state != state:
        assert time.monotonic() < until
        time.sleep(0.02)
    return job
