from __future__ import annotations

import json
import threading
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sqlalchemy as sa
from alembic import command
from alembic.autogenerate import compare_metadata
from alembic.config import Config
from alembic.migration import MigrationContext
from numpy.testing import assert_array_equal

from knifetip.errors import (
    KeyReused,
    MachineBusy,
    NoSuchJob,
    StaleEpoch,
    StaleRevision,
    StaleVersion,
    StoreError,
    WrongState,
)
from knifetip.jobs import migrations
from knifetip.jobs.compile_result import CompileResult
from knifetip.jobs.compile_store import ATTEMPTS
from knifetip.jobs.drawing_store import NewDrawing
from knifetip.jobs.gateway_store import GatewayReport
from knifetip.jobs.job_store import JobOrder
from knifetip.jobs.request_key import RequestKey
from knifetip.jobs.store import Store
from knifetip.jobs.tables import Base, Drawing, Job
from knifetip.jobs.transitions import LEASE
from knifetip.messages import Message, hint
from knifetip.model.interpretation import Interpretation
from knifetip.model.stage import Stage
from knifetip.presentation.columns import pack_columns, unpack_columns
from tests.support.messages import stored
from tests.support.stored import Clock, migrated_store

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
)


WAITING = GatewayReport(line=0, waiting=True)
MIGRATIONS = Path(migrations.__file__).parent


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def store(database_url: str, clock: Clock) -> Iterator[Store]:
    with migrated_store(database_url, clock) as store:
        yield store


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


def fed(store: Store, **more: Any) -> Job:
    """Return a confirmed job that runs on a machine with manual feed."""
    job = waiting(store, **more)
    store.operators.confirm(job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "start"
    return store.jobs.get(job.id)


def course(store: Store, id: str) -> list[str]:
    return [event.state for event in store.events.of_job(id)]


# States of a job


def test_a_job_goes_from_received_to_done_and_every_step_is_an_event(store: Store) -> None:
    job = running(store)
    assert (job.state, job.lines, job.program_sha256) == ("running", LINES, "ab" * 32)
    store.gateways.finish(job.id, job.epoch, "done")
    assert course(store, job.id) == [
        "received",
        "compiling",
        "ready",
        "queued",
        "running",
        "done",
    ]
    done = store.jobs.get(job.id)
    assert (done.line, done.copies_done, done.seconds_left) == (LINES, 1, 0.0)


def test_a_job_that_was_not_ordered_to_be_queued_waits_to_be_released(store: Store) -> None:
    job = compiling(store)
    store.compiles.save_result(job.id, job.epoch, RESULT)
    assert store.jobs.get(job.id).state == "ready"
    assert store.gateways.claim("table", "gateway", manual=False) is None
    assert store.operators.release(job.id).state == "queued"


def test_a_verdict_outside_tolerance_refuses_the_job_with_its_edges(store: Store) -> None:
    job = compiling(store, release=True)
    store.compiles.save_result(job.id, job.epoch, REFUSED)
    job = store.jobs.get(job.id)
    assert (job.state, str(job.message), job.source) == (
        "refused",
        "Edge 3 is 0.4 mm off.",
        ["2F4"],
    )


def test_the_event_is_written_with_the_move_or_not_at_all(store: Store) -> None:
    job = queued(store)
    with pytest.raises(WrongState):
        store.operators.release(job.id)
    assert course(store, job.id)[-1] == "queued"
    assert len(course(store, job.id)) == 4


@pytest.mark.parametrize("move", ["release", "requeue", "scrap", "hold", "resume"])
def test_a_received_job_can_only_be_cancelled(store: Store, move: str) -> None:
    job = ordered(store)
    with pytest.raises(WrongState, match="is received"):
        getattr(store.operators, move)(job.id)
    assert store.operators.cancel(job.id).state == "cancelled"


@pytest.mark.parametrize("move", ["release", "requeue", "scrap", "hold", "resume", "cancel"])
def test_a_job_that_is_done_stays_done(store: Store, move: str) -> None:
    job = running(store)
    store.gateways.finish(job.id, job.epoch, "done")
    with pytest.raises(WrongState, match="is done"):
        getattr(store.operators, move)(job.id)


def test_a_job_that_does_not_exist_is_named(store: Store) -> None:
    with pytest.raises(NoSuchJob, match="Job 'nothing' does not exist"):
        store.operators.cancel("nothing")
    with pytest.raises(NoSuchJob, match="does not exist"):
        store.drawings.get("nothing")


# One job per table


def test_two_claims_on_one_machine_give_one_job(store: Store) -> None:
    first, second = queued(store), queued(store)
    claimed = store.gateways.claim("table", "one", manual=False)
    assert claimed is not None
    assert claimed.id == first.id
    with pytest.raises(MachineBusy, match=first.id):
        store.gateways.claim("table", "two", manual=False)
    assert store.jobs.get(second.id).state == "queued"


@pytest.mark.parametrize("state", ["running", "held", "interrupted"])
def test_the_database_itself_refuses_a_second_job_on_a_table(store: Store, state: str) -> None:
    running(store)
    second = queued(store)
    with pytest.raises(sa.exc.IntegrityError, match=r"UNIQUE|one_job_on_a_table"):
        execute(store, "UPDATE job SET state = :state WHERE id = :id", state=state, id=second.id)


def test_ten_gateways_that_claim_at_once_get_one_job(store: Store) -> None:
    for _ in range(3):
        queued(store)
    got: list[Job | None] = []
    refused: list[Exception] = []
    start = threading.Barrier(10)

    def claim(name: str) -> None:
        start.wait()
        try:
            got.append(store.gateways.claim("table", name, manual=False))
        except MachineBusy as reason:
            refused.append(reason)

    threads = [threading.Thread(target=claim, args=(f"g{n}",)) for n in range(10)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    # PostgreSQL skips rows that another transaction claims, so None is returned instead of busy.
    assert len([job for job in got if job is not None]) == 1
    assert len(got) + len(refused) == 10


def test_machines_do_not_wait_for_each_other(store: Store) -> None:
    running(store)
    other = queued(store, machine="other")
    claimed = store.gateways.claim("other", "gateway", manual=False)
    assert claimed is not None
    assert claimed.id == other.id


def test_a_claim_takes_the_highest_priority_and_then_the_oldest(store: Store, clock: Clock) -> None:
    late = queued(store, priority=0)
    clock.now += 1.0
    urgent = queued(store, priority=5)
    clock.now += 1.0
    queued(store, priority=5)
    order = []
    for _ in range(3):
        job = store.gateways.claim("table", "gateway", manual=False)
        assert job is not None
        order.append(job.id)
        store.gateways.finish(job.id, job.epoch, "done")
    assert order[0] == urgent.id
    assert order[2] == late.id


# Epochs and leases


def test_each_claim_has_a_new_epoch_and_an_earlier_owner_is_refused(
    store: Store, clock: Clock
) -> None:
    job = running(store)
    clock.now += LEASE + 0.1
    store.leases.run()
    store.operators.requeue(job.id)
    again = store.gateways.claim("table", "other gateway", manual=False)
    assert again is not None
    assert again.epoch > job.epoch
    with pytest.raises(StaleEpoch, match=f"epoch {job.epoch}"):
        store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=5))
    with pytest.raises(StaleEpoch):
        store.gateways.finish(job.id, job.epoch, "done")
    assert store.jobs.get(job.id).state == "running"


def test_a_silent_gateway_interrupts_its_job_and_never_queues_it(
    store: Store, clock: Clock
) -> None:
    job = running(store)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=199))
    clock.now += LEASE - 0.1
    assert store.leases.run()
    assert store.jobs.get(job.id).state == "running"
    clock.now += 0.2
    assert store.leases.run()
    job = store.jobs.get(job.id)
    assert job.state == "interrupted"
    assert not store.leases.run()
    assert str(job.message) == (
        "The job was interrupted at program line 199 of 231. The gateway "
        "gateway stopped responding. The machine may have "
        "executed more program lines than the gateway reported."
    )
    assert store.machines.jobs_on_tables() == {"table": job.id}


def test_a_heartbeat_renews_the_lease(store: Store, clock: Clock) -> None:
    job = running(store)
    for line in range(20):
        clock.now += LEASE / 2
        assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=line)) == "continue"
        store.leases.run()
    assert store.jobs.get(job.id).state == "running"


def test_a_finish_that_is_said_twice_does_no_harm(store: Store) -> None:
    job = running(store)
    store.gateways.finish(job.id, job.epoch, "interrupted", stored("A belt tore."))
    again = store.gateways.finish(job.id, job.epoch, "interrupted", stored("A belt tore."))
    assert str(again.message) == "The job was interrupted at program line 0 of 231. A belt tore."
    assert course(store, job.id).count("interrupted") == 1


def test_an_interrupted_job_is_queued_again_from_its_first_line_or_scrapped(store: Store) -> None:
    job = running(store)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=100))
    store.gateways.finish(job.id, job.epoch, "interrupted", stored("A belt tore."))
    again = store.operators.requeue(job.id)
    assert (again.state, again.line, again.message) == ("queued", 0, None)
    second = store.gateways.claim("table", "gateway", manual=False)
    assert second is not None
    store.gateways.finish(second.id, second.epoch, "interrupted")
    assert store.operators.scrap(second.id).state == "scrapped"
    assert store.machines.jobs_on_tables() == {}


def test_copies_that_were_cut_before_an_interruption_count(store: Store) -> None:
    job = fed(store, copies=3)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=LINES, copies_done=1, held=True))
    assert (
        str(store.events.of_job(job.id)[-1].message)
        == "Copy 1 of 3 of the job is finished. The next copy needs a new sheet of board."
    )
    store.gateways.finish(job.id, job.epoch, "interrupted")
    store.operators.requeue(job.id)
    again = store.gateways.claim("table", "gateway", manual=False)
    assert again is not None
    store.gateways.heartbeat(
        again.id, again.epoch, GatewayReport(line=LINES, copies_done=1, held=True)
    )
    assert store.jobs.get(job.id).copies_done == 2


def test_a_resume_starts_one_copy_and_not_the_one_after(store: Store) -> None:
    job = fed(store, copies=3)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=LINES, copies_done=1, held=True))
    store.operators.resume(job.id)
    assert (
        store.gateways.heartbeat(
            job.id, job.epoch, GatewayReport(line=LINES, copies_done=1, held=True)
        )
        == "resume"
    )
    # The second copy was so short that no heartbeat was sent during it.
    answer = store.gateways.heartbeat(
        job.id, job.epoch, GatewayReport(line=LINES, copies_done=2, held=True)
    )
    assert answer == "continue"
    assert str(store.events.of_job(job.id)[-1].message).startswith(
        "Copy 2 of 3 of the job is finished"
    )


# Start by the operator


def test_a_claim_by_hand_waits_and_runs_when_it_is_confirmed(store: Store) -> None:
    job = waiting(store)
    assert (job.state, job.owner, job.confirmation) == ("queued", "gateway", "awaited")
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "wait"
    assert store.machines.jobs_on_tables() == {}
    confirmed = store.operators.confirm(job.id, board="e-flute", by="Kim")
    assert (confirmed.state, confirmed.confirmation) == ("queued", "given")
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "start"
    assert store.jobs.get(job.id).state == "running"
    # The response that starts the job may be lost: it is repeated, and recorded once.
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "start"
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=1)) == "continue"
    assert course(store, job.id)[3:] == ["queued", "queued", "queued", "running"]
    who = [(event.who, str(event.message)) for event in store.events.of_job(job.id)][-2:]
    assert who == [
        (
            "operator Kim",
            "The operator confirmed that the table is clear and that the board on it is e-flute.",
        ),
        ("gateway gateway", "The job was started."),
    ]


def test_a_confirmation_that_is_repeated_changes_nothing(store: Store) -> None:
    job = waiting(store)
    store.operators.confirm(job.id)
    events = len(course(store, job.id))
    assert store.operators.confirm(job.id).confirmation == "given"
    assert len(course(store, job.id)) == events
    store.gateways.heartbeat(job.id, job.epoch, WAITING)
    assert store.operators.confirm(job.id).state == "running"
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=5)) == "continue"


def test_a_job_that_does_not_wait_cannot_be_confirmed(store: Store) -> None:
    job = queued(store)
    with pytest.raises(WrongState, match="has not claimed it yet"):
        store.operators.confirm(job.id)
    job = fed(store)
    store.operators.hold(job.id)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=5, held=True))
    with pytest.raises(WrongState, match="does not wait for a new sheet") as caught:
        store.operators.confirm(job.id)
    assert caught.value.hint == "Resume the job."
    store.operators.cancel(job.id)
    with pytest.raises(WrongState, match="being cancelled"):
        store.operators.confirm(job.id)
    store.gateways.finish(job.id, job.epoch, "cancelled")
    with pytest.raises(WrongState, match="is cancelled"):
        store.operators.confirm(job.id)


def test_a_job_on_a_machine_that_feeds_itself_has_nothing_to_confirm(store: Store) -> None:
    job = running(store)
    with pytest.raises(WrongState, match="is running"):
        store.operators.confirm(job.id)


def test_another_board_on_the_table_is_refused(store: Store) -> None:
    job = waiting(store)
    with pytest.raises(
        WrongState,
        match=r"needs the board e-flute, but the confirmation names the board 'greyboard-2\.0'",
    ):
        store.operators.confirm(job.id, board="greyboard-2.0")
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "wait"


def test_a_machine_whose_job_waits_gives_no_other_job_to_another_gateway(store: Store) -> None:
    first = waiting(store)
    second = queued(store, priority=50)
    with pytest.raises(MachineBusy, match="table"):
        store.gateways.claim("table", "other", manual=True)
    with pytest.raises(MachineBusy):
        store.gateways.claim("table", "other", manual=False)
    again = store.gateways.claim("table", "gateway", manual=True)
    assert again is not None
    assert (again.id, again.epoch) == (first.id, first.epoch + 1)
    with pytest.raises(StaleEpoch):
        store.gateways.heartbeat(first.id, first.epoch, WAITING)
    assert store.jobs.get(second.id).state == "queued"


def test_the_database_itself_refuses_a_second_claim_that_waits(store: Store) -> None:
    waiting(store)
    second = queued(store)
    with pytest.raises(sa.exc.IntegrityError, match=r"UNIQUE|one_job_on_a_table"):
        execute(store, "UPDATE job SET confirmation = 'awaited' WHERE id = :id", id=second.id)


def test_a_confirmation_counts_for_its_claim_only(store: Store) -> None:
    job = waiting(store)
    store.operators.confirm(job.id)
    again = store.gateways.claim("table", "gateway", manual=True)
    assert again is not None
    assert store.gateways.heartbeat(again.id, again.epoch, WAITING) == "wait"


def test_a_waiting_claim_whose_gateway_falls_silent_is_given_back(
    store: Store, clock: Clock
) -> None:
    job = waiting(store)
    store.operators.confirm(job.id)
    clock.now += LEASE + 0.1
    store.leases.run()
    with pytest.raises(StaleEpoch):
        store.gateways.heartbeat(job.id, job.epoch, WAITING)
    row = store.jobs.get(job.id)
    assert (row.state, row.confirmation, row.owner) == ("queued", "", "")
    assert str(store.events.of_job(job.id)[-1].message) == (
        "The gateway put the job back into the queue. The gateway gateway stopped responding."
    )
    again = store.gateways.claim("table", "other", manual=True)
    assert again is not None
    assert (again.id, again.confirmation) == (job.id, "awaited")


def test_a_waiting_claim_that_has_run_out_is_not_confirmed_and_goes_to_another_gateway(
    store: Store, clock: Clock
) -> None:
    job = waiting(store)
    clock.now += LEASE + 0.1
    with pytest.raises(WrongState, match="does not respond"):
        store.operators.confirm(job.id)
    again = store.gateways.claim("table", "other", manual=True)
    assert again is not None
    assert (again.id, again.owner) == (job.id, "other")
    assert again.epoch > job.epoch


def test_a_heartbeat_keeps_a_waiting_claim_alive_and_its_machine_connected(
    store: Store, clock: Clock
) -> None:
    job = waiting(store)
    for _ in range(5):
        clock.now += LEASE / 2
        assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "wait"
        store.leases.run()
        assert store.machines.connected_machines(1.0) == {"table"}
    assert store.jobs.get(job.id).owner == "gateway"


def test_a_waiting_job_is_cancelled_at_once_and_its_gateway_drops_it(store: Store) -> None:
    job = waiting(store)
    assert store.operators.cancel(job.id).state == "cancelled"
    with pytest.raises(StaleEpoch):
        store.gateways.heartbeat(job.id, job.epoch, WAITING)
    other = queued(store)
    claimed = store.gateways.claim("table", "gateway", manual=True)
    assert claimed is not None
    assert claimed.id == other.id


def test_a_claim_that_its_gateway_returns_is_queued_and_never_interrupted(store: Store) -> None:
    job = waiting(store)
    row = store.gateways.finish(
        job.id, job.epoch, "returned", stored("The controller is not idle.")
    )
    assert (row.state, row.confirmation, row.epoch) == ("queued", "", job.epoch + 1)
    with pytest.raises(StaleEpoch):
        store.gateways.finish(job.id, job.epoch, "returned")


def test_a_started_job_that_its_gateway_returns_waits_for_the_operator(store: Store) -> None:
    job = fed(store)
    row = store.gateways.finish(job.id, job.epoch, "returned", stored("Nothing was sent."))
    assert (row.state, str(row.message)) == (
        "interrupted",
        "The job was interrupted at program line 0 of 231. Nothing was sent.",
    )


def test_a_gateway_that_runs_without_a_confirmation_is_held_until_somebody_confirms(
    store: Store,
) -> None:
    job = waiting(store)
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=1)) == "hold"
    assert store.jobs.get(job.id).state == "running"
    assert (
        str(store.events.of_job(job.id)[-1].message)
        == "The job was started without the confirmation of the operator."
    )
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=2, held=True)) == "hold"
    with pytest.raises(WrongState, match="has not confirmed"):
        store.operators.resume(job.id)
    store.operators.confirm(job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=2, held=True)) == "resume"
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=3)) == "continue"


def test_a_hold_between_confirmation_and_start_keeps_the_machine_waiting(store: Store) -> None:
    job = fed(store)
    store.operators.hold(job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "wait"
    assert store.jobs.get(job.id).state == "held"
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "wait"
    store.operators.resume(job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "start"
    assert store.jobs.get(job.id).state == "running"
    store.operators.cancel(job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "cancel"


@pytest.mark.parametrize("command", ["confirm", "resume"])
def test_a_new_sheet_is_confirmed_by_either_command(store: Store, command: str) -> None:
    job = fed(store, copies=2)
    between = GatewayReport(line=LINES, copies_done=1, held=True)
    assert store.gateways.heartbeat(job.id, job.epoch, between) == "continue"
    assert (store.jobs.get(job.id).state, store.jobs.get(job.id).confirmation) == ("held", "sheet")
    getattr(store.operators, command)(job.id)
    assert store.operators.confirm(job.id).requested_action == "resume"
    assert store.gateways.heartbeat(job.id, job.epoch, between) == "resume"
    assert (
        store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=1, copies_done=1))
        == "continue"
    )


def test_a_copy_that_begins_without_its_sheet_confirmed_is_held(store: Store) -> None:
    job = fed(store, copies=2)
    assert (
        store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=1, copies_done=1)) == "hold"
    )
    assert (
        store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=2, copies_done=1)) == "hold"
    )
    store.operators.confirm(job.id)
    assert (
        store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=2, copies_done=1))
        == "continue"
    )


def test_a_machine_that_feeds_itself_goes_on_to_the_next_copy_unless_it_is_held(
    store: Store,
) -> None:
    job = running(store, copies=3)
    between = GatewayReport(line=LINES, copies_done=1, held=True)
    assert store.gateways.heartbeat(job.id, job.epoch, between) == "resume"
    assert (
        store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=5, copies_done=1))
        == "continue"
    )
    store.operators.hold(job.id)
    between = GatewayReport(line=LINES, copies_done=2, held=True)
    assert store.gateways.heartbeat(job.id, job.epoch, between) == "continue"
    assert store.jobs.get(job.id).state == "held"


def test_an_interrupted_job_that_is_queued_again_keeps_its_place(
    store: Store, clock: Clock
) -> None:
    job = running(store)
    clock.now += 1.0
    queued(store)
    store.gateways.finish(job.id, job.epoch, "interrupted")
    store.operators.requeue(job.id)
    again = store.gateways.claim("table", "gateway", manual=True)
    assert again is not None
    assert again.id == job.id


# Late reports of the last gateway


def interrupted(store: Store, clock: Clock, line: int, **more: Any) -> Job:
    """Return a job whose gateway stopped reporting at a program line."""
    job = fed(store, **more)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=line))
    clock.now += LEASE + 0.1
    store.leases.run()
    assert store.jobs.get(job.id).state == "interrupted"
    return job


def test_a_late_report_that_the_job_is_done_ends_it(store: Store, clock: Clock) -> None:
    job = interrupted(store, clock, 56, copies=2)
    row = store.gateways.finish(job.id, job.epoch, "done")
    assert (row.state, row.line, row.copies_done) == ("done", LINES, 2)
    assert row.message is None
    last = store.events.of_job(job.id)[-1]
    assert (last.who, str(last.message)) == (
        "gateway gateway",
        "A late report of the gateway arrived: The machine executed every line of the program.",
    )
    assert store.gateways.finish(job.id, job.epoch, "done").state == "done"
    assert store.machines.jobs_on_tables() == {}


@pytest.mark.parametrize("outcome", ["interrupted", "cancelled"])
def test_a_late_report_of_another_end_corrects_the_line(
    store: Store, clock: Clock, outcome: str
) -> None:
    job = interrupted(store, clock, 56)
    row = store.gateways.finish(job.id, job.epoch, outcome, stored("A belt tore."), line=77)
    assert (row.state, row.line) == ("interrupted", 77)
    assert str(row.message) == "The job was interrupted at program line 77 of 231. A belt tore."
    events = len(course(store, job.id))
    store.gateways.finish(job.id, job.epoch, outcome, stored("A belt tore."), line=77)
    assert len(course(store, job.id)) == events


def test_a_late_report_counts_only_while_the_job_is_interrupted(store: Store, clock: Clock) -> None:
    job = interrupted(store, clock, 56)
    with pytest.raises(StaleEpoch):
        store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=60))
    with pytest.raises(StaleEpoch):
        store.gateways.finish(job.id, job.epoch - 1, "done")
    store.operators.requeue(job.id)
    with pytest.raises(StaleEpoch):
        store.gateways.finish(job.id, job.epoch, "done")
    again = store.gateways.claim("table", "gateway", manual=False)
    assert again is not None
    store.gateways.finish(again.id, again.epoch, "interrupted")
    with pytest.raises(StaleEpoch):
        store.gateways.finish(job.id, job.epoch, "done")
    store.operators.scrap(job.id)
    with pytest.raises(StaleEpoch):
        store.gateways.finish(again.id, again.epoch, "done")


def test_a_job_interrupted_at_its_last_line_is_not_offered_to_be_cut_again(
    store: Store, clock: Clock
) -> None:
    job = interrupted(store, clock, LINES)
    row = store.jobs.get(job.id)
    assert str(row.message).startswith("The job was interrupted at program line 231 of 231. ")
    assert "again" not in hint_of(row)
    assert "finished" in hint_of(row)
    with pytest.raises(WrongState) as caught:
        store.operators.cancel(job.id)
    assert "again" not in caught.value.hint


def test_between_two_copies_the_remaining_ones_are_offered(store: Store, clock: Clock) -> None:
    job = fed(store, copies=3)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=LINES, copies_done=1, held=True))
    clock.now += LEASE + 0.1
    store.leases.run()
    row = store.jobs.get(job.id)
    assert (row.line, row.copies_done) == (0, 1)
    assert str(row.message).startswith(
        "The job was interrupted after copy 1 of 3, before the first "
        "program line of the next copy. "
    )
    assert "remaining copies" in hint_of(row)
    # The gateway reports that the second copy was cut to its end.
    row = store.gateways.finish(job.id, job.epoch, "interrupted", line=0, copies_done=2)
    assert row.copies_done == 2
    assert str(row.message).startswith("The job was interrupted after copy 2 of 3")


def test_a_copy_that_was_cut_to_its_last_line_is_counted(store: Store, clock: Clock) -> None:
    job = interrupted(store, clock, LINES, copies=3)
    assert (store.jobs.get(job.id).line, store.jobs.get(job.id).copies_done) == (0, 1)


def test_an_operator_declares_an_interrupted_job_finished(store: Store, clock: Clock) -> None:
    job = interrupted(store, clock, 200, copies=2)
    row = store.operators.declare_finished(job.id)
    assert (row.state, row.line, row.copies_done, row.message) == ("done", LINES, 2, None)
    last = store.events.of_job(job.id)[-1]
    assert (last.who, str(last.message)) == (
        "operator",
        "The operator marked the job as finished, after the machine "
        "had stopped at program line 200 of 231.",
    )
    with pytest.raises(WrongState, match="is done"):
        store.operators.declare_finished(job.id)


@pytest.mark.parametrize("state", ["ready", "queued", "running"])
def test_only_an_interrupted_job_can_be_declared_finished(store: Store, state: str) -> None:
    job = {"ready": compiling, "queued": queued, "running": running}[state](store)
    with pytest.raises(WrongState):
        store.operators.declare_finished(job.id)


def test_a_service_that_could_not_be_reached_takes_nothing_from_gateways(
    store: Store, clock: Clock
) -> None:
    job = running(store)
    clock.now += LEASE + 0.1
    store.leases.run(gateways=False)
    assert store.jobs.get(job.id).state == "running"
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=9)) == "continue"


# Requested actions of the operator


def test_hold_and_resume_go_through_the_gateway(store: Store) -> None:
    job = running(store)
    assert store.operators.hold(job.id).state == "running"
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=5)) == "hold"
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=6)) == "hold"
    assert (
        store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=6, held=True)) == "continue"
    )
    assert store.jobs.get(job.id).state == "held"
    assert store.operators.resume(job.id).requested_action == "resume"
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=6, held=True)) == "resume"
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=7)) == "continue"
    assert store.jobs.get(job.id).state == "running"


def test_a_running_job_is_cancelled_by_its_gateway(store: Store) -> None:
    job = running(store)
    assert store.operators.cancel(job.id).state == "running"
    with pytest.raises(WrongState, match="being cancelled"):
        store.operators.resume(job.id)
    assert store.operators.cancel(job.id).requested_action == "cancel"
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=5)) == "cancel"
    assert store.gateways.finish(job.id, job.epoch, "cancelled").state == "cancelled"


def test_an_interrupted_job_cannot_be_cancelled_away_from_its_table(store: Store) -> None:
    job = running(store)
    store.gateways.finish(job.id, job.epoch, "interrupted")
    with pytest.raises(WrongState) as caught:
        store.operators.cancel(job.id)
    assert caught.value.hint == hint_of(store.jobs.get(job.id))
    assert caught.value.hint.startswith(
        "Look for the cause in the log of the gateway. Check the "
        "table. Then either queue the job again"
    )


# Compiles


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


# Drawings, keys, events


def test_a_key_answers_with_the_first_result_and_refuses_another_request(store: Store) -> None:
    key, reused = RequestKey("k", "f"), RequestKey("k", "another")
    first = drawing(store, key)
    assert drawing(store, key).id == first.id
    with pytest.raises(KeyReused):
        drawing(store, reused)
    job = ordered(store, key)
    assert ordered(store, key).id == job.id
    with pytest.raises(KeyReused):
        store.jobs.find(reused)


def test_a_change_to_a_drawing_that_changed_meanwhile_is_refused(store: Store) -> None:
    row = drawing(store)
    assert (
        store.drawings.change(row.id, row.version, stored("first"), overrides=b"\x01").version == 2
    )
    with pytest.raises(StaleRevision, match="revision 2") as stale:
        store.drawings.change(row.id, row.version, stored("second"), overrides=b"\x02")
    assert stale.value.revision == 2
    assert store.drawings.column(row.id, "overrides") == b"\x01"


def test_a_change_to_a_drawing_that_was_deleted_meanwhile_is_refused(store: Store) -> None:
    row = drawing(store)
    store.drawings.delete(row.id)
    with pytest.raises(NoSuchJob):
        store.drawings.change(row.id, row.version, stored("late"), overrides=b"\x01")


def test_what_is_read_of_a_drawing_is_of_one_revision(store: Store) -> None:
    row = drawing(store)
    store.drawings.change(
        row.id, 1, stored("second"), overrides=b"\x02", edges=b"two", unit_given="in"
    )
    read = store.drawings.get_with(row.id, "overrides", "edges")
    store.drawings.change(
        row.id, 2, stored("third"), overrides=b"\x03", edges=b"three", unit_given="mm"
    )
    seen = (read.version, read.overrides, read.edges, read.unit_given)
    assert seen == (2, b"\x02", b"two", "in")


def test_a_drawing_with_jobs_is_kept(store: Store) -> None:
    job = ordered(store)
    with pytest.raises(WrongState, match=job.id):
        store.drawings.delete(job.drawing)
    free = drawing(store)
    store.drawings.delete(free.id)
    with pytest.raises(NoSuchJob):
        store.drawings.get(free.id)


def test_events_are_numbered_upwards_and_never_twice(store: Store) -> None:
    job = queued(store)
    last = store.events.last_id()
    store.operators.cancel(job.id)
    (event,) = store.events.after(last)
    assert (event.subject, event.state, event.who) == (job.id, "cancelled", "operator")
    assert event.id > last


def test_a_gateway_is_connected_while_it_asks_and_while_it_works(
    store: Store, clock: Clock
) -> None:
    assert store.machines.connected_machines(6.0) == set()
    store.machines.record_contact("table", "gateway")
    store.machines.record_contact("table", "gateway")
    assert store.machines.connected_machines(6.0) == {"table"}
    clock.now += 7.0
    assert store.machines.connected_machines(6.0) == set()
    job = running(store)
    assert store.machines.connected_machines(6.0) == {"table"}
    clock.now += LEASE + 1.0
    assert store.machines.connected_machines(6.0) == set()
    assert store.jobs.get(job.id).state == "running"


# The database


def test_the_migrations_make_the_tables_that_the_code_expects(store: Store, tmp_path: Path) -> None:
    engine = sa.create_engine(store.database.url)
    with engine.connect() as connection:
        assert compare_metadata(MigrationContext.configure(connection), Base.metadata) == []
    engine.dispose()


def test_to_migrate_twice_changes_nothing(store: Store) -> None:
    job = queued(store)
    store.migrate()
    assert store.jobs.get(job.id).state == "queued"


def test_a_database_of_before_corners_could_be_chosen_keeps_its_jobs(store: Store) -> None:
    job = queued(store)
    settings = Config()
    settings.set_main_option("script_location", str(MIGRATIONS))
    engine = sa.create_engine(store.database.url)
    with engine.begin() as connection:
        settings.attributes["connection"] = connection
        command.downgrade(settings, "0001")
        assert "corners" not in {row["name"] for row in sa.inspect(connection).get_columns("job")}
    engine.dispose()
    store.migrate()
    kept = store.jobs.get(job.id)
    assert (kept.state, kept.corners) == ("queued", None)


def test_texts_of_before_there_were_codes_become_messages_and_back(store: Store) -> None:
    first, second = running(store), ordered(store)
    store.gateways.finish(first.id, first.epoch, "interrupted", stored("A belt tore."), line=5)
    shown = store.jobs.get(first.id)
    text, advice = str(shown.message), hint_of(shown)
    events = [str(event.message) for event in store.events.of_job(first.id)]
    settings = Config()
    settings.set_main_option("script_location", str(MIGRATIONS))
    engine = sa.create_engine(store.database.url)
    with engine.begin() as connection:
        settings.attributes["connection"] = connection
        command.downgrade(settings, "0007")
        columns = sa.text("SELECT reason, hint FROM job ORDER BY serial")
        assert connection.execute(columns).all() == [(text, advice), ("", "")]
        texts = connection.execute(sa.text("SELECT why FROM event ORDER BY id")).scalars().all()
        assert set(events) < set(texts)
        connection.execute(sa.text("UPDATE event SET why = '' WHERE id = 1"))
    engine.dispose()
    store.migrate()
    kept = store.jobs.get(first.id)
    assert kept.message == Message("stored.text", text=text, hint=advice)
    assert store.jobs.get(second.id).message is None
    kept_events = [event.message for event in store.events.after(0)]
    assert kept_events[0] is None
    assert stored(events[-1]) in kept_events


def test_a_database_of_before_confirmations_keeps_what_runs_and_who_runs_it(store: Store) -> None:
    job = running(store)
    settings = Config()
    settings.set_main_option("script_location", str(MIGRATIONS))
    engine = sa.create_engine(store.database.url)
    with engine.begin() as connection:
        settings.attributes["connection"] = connection
        command.downgrade(settings, "0003")
    engine.dispose()
    store.migrate()
    kept = store.jobs.get(job.id)
    assert (kept.state, kept.confirmation, kept.tools) == ("running", "given", [])
    assert kept.owner_epoch == job.epoch
    second = queued(store)
    with pytest.raises(MachineBusy, match=job.id):
        store.gateways.claim("table", "other", manual=True)
    assert store.jobs.get(second.id).state == "queued"


def test_a_database_with_the_former_names_of_the_import_report_keeps_its_drawings(
    store: Store,
) -> None:
    job = queued(store)
    ends = np.arange(8.0).reshape(2, 2, 2)
    block = pack_columns({"ends": ends, "fate": np.array([0, 2], np.uint8)}, {"fates": ["kept"]})
    rows = [{"handle": "1F", "fate": "kept"}, {"handle": "fate", "fate": "dropped"}]
    former: dict[str, Any] = {
        "summary": json.dumps(
            {
                "unit": "mm",
                "ledger": {"kept": 1, "merged": 0, "dropped": 1},
                "report": {"groups": [{"fate": "dropped", "kinds": ["fate"]}]},
            }
        ),
        "edges": block,
        "ledger": zlib.compress(json.dumps(rows).encode()),
    }
    settings = Config()
    settings.set_main_option("script_location", str(MIGRATIONS))
    engine = sa.create_engine(store.database.url)
    with engine.begin() as connection:
        settings.attributes["connection"] = connection
        command.downgrade(settings, "0006")
        connection.execute(
            sa.text("UPDATE drawing SET summary = :summary, edges = :edges, ledger = :ledger"),
            former,
        )
        command.upgrade(settings, "head")
    row = store.drawings.get_with(job.drawing, "edges", "import_report")
    assert row.summary == {
        "unit": "mm",
        "import_report": {"kept": 1, "merged": 0, "dropped": 1},
        "report": {"groups": [{"outcome": "dropped", "kinds": ["fate"]}]},
    }
    assert json.loads(zlib.decompress(row.import_report)) == [
        {"handle": "1F", "outcome": "kept"},
        {"handle": "fate", "outcome": "dropped"},
    ]
    columns, meta = unpack_columns(row.edges)
    assert (list(columns), meta) == (["ends", "outcome"], {"outcomes": ["kept"]})
    assert_array_equal(columns["ends"], ends)
    assert columns["outcome"].tolist() == [0, 2]
    assert store.jobs.get(job.id).verdict_summary == RESULT.verdict_summary
    with engine.begin() as connection:
        settings.attributes["connection"] = connection
        command.downgrade(settings, "0006")
        query = sa.text("SELECT summary, edges FROM drawing").columns(
            summary=sa.JSON, edges=sa.LargeBinary
        )
        again = connection.execute(query).one()
    engine.dispose()
    assert again.summary == json.loads(former["summary"])
    assert unpack_columns(bytes(again.edges))[1] == {"fates": ["kept"]}


@pytest.mark.parametrize("url", ["nonsense", "sqlite://", "sqlite:///:memory:", "mysql://h/d", ""])
def test_a_database_that_cannot_be_used_is_refused_with_a_mend(url: str) -> None:
    with pytest.raises(StoreError) as caught:
        Store(url)
    assert "sqlite:///FILE" in caught.value.hint


def test_a_profile_counts_its_changes_and_is_never_overwritten_unseen(store: Store) -> None:
    first = store.profiles.save("acme", "Acme", "title = 'Acme'", None)
    assert first.version == 1
    with pytest.raises(WrongState, match="already exists, at version 1"):
        store.profiles.save("acme", "Other", "", None)
    assert store.profiles.save("acme", "B", "title = 'B'", 1).version == 2
    with pytest.raises(StaleVersion, match=r"at version 2.*on version 1") as caught:
        store.profiles.save("acme", "C", "", 1)
    assert 'If-Match: "2"' in caught.value.hint
    kept = store.profiles.get("acme")
    assert kept is not None
    assert (kept.title, kept.text) == ("B", "title = 'B'")
    with pytest.raises(StaleVersion):
        store.profiles.delete("acme", 1)
    store.profiles.delete("acme", 2)
    assert store.profiles.get("acme") is None
    with pytest.raises(NoSuchJob):
        store.profiles.save("acme", "C", "", 2)
    assert store.profiles.save("acme", "D", "", None, anyway=True).version == 1
