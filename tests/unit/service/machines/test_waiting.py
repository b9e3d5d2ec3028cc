"""The reason why a job waits, as a code and as text, from the records of a database."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from knifetip.messages import hint
from knifetip.model.interpretation import Interpretation
from knifetip.model.job_options import JobOptions
from knifetip.model.sheet import Sheet
from knifetip.service.database.tables import Job
from knifetip.service.gateways.heartbeats import GatewayReport
from knifetip.service.lifecycle.transitions import LEASE
from knifetip.service.machines.waiting import ABSENT, WaitReason, waiting_of
from knifetip.service.processes.compile_result import CompileResult
from knifetip.service.store import Store
from tests.support.job_states import confirm
from tests.support.stored import Clock, add_job, migrated_store

TITLE = "Demo table 1600 × 1200"
TOOLS = [
    {"station": 1, "name": "Oscillating knife", "kind": "knife"},
    {"station": 2, "name": "Crease wheel", "kind": "crease-wheel"},
]


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def store(migrated_sqlite: str, clock: Clock) -> Iterator[Store]:
    with migrated_store(migrated_sqlite, clock) as store:
        yield store


def queued(store: Store, **more: Any) -> Job:
    row = add_job(store, release=True, **more)
    job = store.compiles.begin("worker")
    assert job is not None
    verdict = {"seconds": 1.0, "accepted": True}
    made = CompileResult(True, None, b"M30\n", "ab", 90, b"", b"", verdict, tools=TOOLS)
    store.compiles.save_result(row.id, job.epoch, made)
    return store.jobs.get(row.id)


def claimed(store: Store) -> Job:
    job = store.gateways.claim("demo-table", "gateway", manual=True)
    assert job is not None
    return job


def hint_of(waiting: WaitReason) -> str:
    """Return the hint in the reason why a job waits."""
    assert waiting.message is not None
    return hint(waiting.message)


def shown(store: Store, job: Job) -> tuple[str, str, str]:
    """Return the reason why a job waits: its code, its text and its hint."""
    found = waits(store, job)
    return found.waiting_for, str(found.message), hint_of(found)


def waits(store: Store, job: Job) -> WaitReason:
    (found,) = waiting_of(store, [store.jobs.get(job.id)])
    return found


def test_a_job_that_waits_for_the_operator_lists_board_tools_and_stations(store: Store) -> None:
    job = queued(store)
    claimed(store)
    assert shown(store, job) == (
        "confirmation",
        f"The job waits until the operator of {TITLE} confirms that "
        "the table is clear. Required: board 'Corrugated, E-flute 1.6 mm'. Tools: "
        "Oscillating knife (station 1), Crease wheel (station 2).",
        "Check the table, then confirm the job to start it.",
    )
    confirm(store, job.id)
    assert shown(store, job) == (
        "machine",
        f"The operator confirmed the job, and {TITLE} is starting.",
        "",
    )


@pytest.mark.parametrize(
    ("sheet", "expected"),
    [
        (
            Sheet(width=400.0, height=300.5, margin=10.0),
            "E-flute 1.6 mm'. The sheet must be cut to 400 × 300.5 mm. Tools",
        ),
        (Sheet(), "E-flute 1.6 mm'. The sheet must be cut to the outline of the drawing. Tools"),
    ],
)
def test_the_operator_learns_which_sheet_to_load(store: Store, sheet: Sheet, expected: str) -> None:
    job = queued(store, interpretation=Interpretation("mm", options=JobOptions(sheet=sheet)))
    claimed(store)
    assert expected in shown(store, job)[1]


def test_a_machine_without_a_gateway_is_named(store: Store, clock: Clock) -> None:
    job = queued(store)
    absent = (
        "machine",
        f"The job waits, because the gateway of {TITLE} (the program "
        f"that sends jobs to the machine) is not connected to the server.",
    )
    assert shown(store, job)[:2] == absent
    store.machines.record_contact("demo-table", "gateway")
    assert shown(store, job) == (
        "machine",
        f"The job waits until the gateway of {TITLE} (the program that sends jobs to the machine) "
        "takes the job from the queue.",
        "",
    )
    clock.now += ABSENT + 0.1
    assert shown(store, job)[:2] == absent


def test_the_first_in_the_queue_waits_for_the_job_ahead_and_the_others_for_their_turn(
    store: Store, clock: Clock
) -> None:
    jobs = [queued(store) for _ in range(3)]
    job = claimed(store)
    assert job.id == jobs[0].id
    assert shown(store, jobs[1]) == (
        "machine",
        (
            f"The job waits, because {TITLE} is occupied by job {job.id}, "
            "which waits for its confirmation."
        ),
        "Confirm or cancel that job.",
    )
    assert waits(store, jobs[2]).waiting_for == "turn"
    confirm(store, job.id)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=1))
    assert str(waits(store, jobs[1]).message).endswith("which is running.")
    clock.now += LEASE + 1.0
    store.leases.run()
    assert hint_of(waits(store, jobs[1])).startswith("Mark that job finished")
    assert waits(store, jobs[2]).waiting_for == "turn"


def test_between_two_copies_the_next_sheet_is_asked_for(store: Store) -> None:
    job = queued(store, copies=2)
    held = claimed(store)
    confirm(store, job.id)
    store.gateways.heartbeat(job.id, held.epoch, GatewayReport(line=0, waiting=True))
    assert waits(store, job) == WaitReason()
    store.gateways.heartbeat(job.id, held.epoch, GatewayReport(line=90, copies_done=1, held=True))
    assert shown(store, job) == (
        "sheet",
        "Copy 1 of 2 of the job is finished. The next copy needs a new sheet.",
        "Put a new sheet of Corrugated, E-flute 1.6 mm on the table, "
        "then confirm the new sheet. The machine then starts the next copy.",
    )
    confirm(store, job.id)
    assert waits(store, job) == WaitReason()


def test_a_board_and_a_machine_that_the_library_has_no_more_are_named(store: Store) -> None:
    job = queued(store, machine="gone", board="old-board")
    store.gateways.claim("gone", "gateway", manual=True)
    assert "of gone confirms that the table is clear. Required: board 'old-board'. Tools:" in str(
        waits(store, job).message
    )


def test_a_job_of_before_tools_were_kept_is_described_without_them(store: Store) -> None:
    job = queued(store)
    claimed(store)
    row = store.jobs.get(job.id)
    row.tools = []
    (found,) = waiting_of(store, [row])
    assert str(found.message).endswith(
        "table is clear. Required: board 'Corrugated, E-flute 1.6 mm'."
    )


def test_a_machine_whose_language_is_not_streamed_has_its_program_downloaded(store: Store) -> None:
    row = queued(store, machine="flat-cutter-hpgl")
    waiting = waiting_of(store, [row])[0]
    assert (
        str(waiting.message) == "The job waits, because the gateway of Flat cutter 1300 × "
        "900 (HPGL) (the program that sends"
        " jobs to the machine) is not connected to the server."
    )
    assert hint_of(waiting).startswith("Download the program")


@pytest.mark.parametrize(("awaits_end", "code"), [(True, "waiting.for-end"), (False, None)])
@pytest.mark.parametrize("machine", ["demo-table", "flat-cutter-hpgl"])
def test_the_end_is_confirmed_where_the_gateway_reports_that_it_waits_for_it(
    store: Store, machine: str, awaits_end: bool, code: str | None
) -> None:
    """A hot folder takes programs of every language; what the gateway reports decides."""
    row = queued(store, machine=machine)
    job = store.gateways.claim(machine, "gateway", manual=False)
    assert job is not None
    report = GatewayReport(line=0, held=True, awaits_end=awaits_end)
    store.gateways.heartbeat(job.id, job.epoch, report)
    found = waits(store, row)
    assert (found.message.code if found.message else None) == code
