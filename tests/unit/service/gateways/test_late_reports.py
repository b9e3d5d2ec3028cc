"""Interrupted jobs: late reports of their gateways, and what operators may do."""

from __future__ import annotations

from typing import Any

import pytest

from knifetip.errors import (
    StaleEpoch,
    WrongState,
)
from knifetip.service.database.tables import Job
from knifetip.service.gateways.heartbeats import GatewayReport
from knifetip.service.lifecycle.transitions import LEASE
from knifetip.service.runs.stop_place import StopPlace
from knifetip.service.store import Store
from tests.support.job_states import (
    LINES,
    compiling,
    course,
    fed,
    hint_of,
    queued,
    running,
)
from tests.support.messages import stored
from tests.support.stored import Clock

#: The machine was observed until it stopped, at the reported line.
EXACT = StopPlace(at_most=0)


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
    torn = stored("A belt tore.")
    row = store.gateways.finish(job.id, job.epoch, outcome, torn, line=77, place=EXACT)
    assert (row.state, row.line) == ("interrupted", 77)
    assert str(row.message) == "The job was interrupted at program line 77 of 231. A belt tore."
    events = len(course(store, job.id))
    store.gateways.finish(job.id, job.epoch, outcome, torn, line=77, place=EXACT)
    assert len(course(store, job.id)) == events


def test_a_late_report_counts_only_while_the_job_is_interrupted(store: Store, clock: Clock) -> None:
    job = interrupted(store, clock, 56)
    with pytest.raises(StaleEpoch):
        store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=60))
    with pytest.raises(StaleEpoch):
        store.gateways.finish(job.id, job.epoch - 1, "done")
    store.interrupted.requeue(job.id)
    with pytest.raises(StaleEpoch):
        store.gateways.finish(job.id, job.epoch, "done")
    again = store.gateways.claim("table", "gateway", manual=False)
    assert again is not None
    store.gateways.finish(again.id, again.epoch, "interrupted")
    with pytest.raises(StaleEpoch):
        store.gateways.finish(job.id, job.epoch, "done")
    store.interrupted.scrap(job.id)
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
    row = store.gateways.finish(
        job.id, job.epoch, "interrupted", line=0, copies_done=2, place=StopPlace(at_most=0)
    )
    assert row.copies_done == 2
    assert "remaining copies" in hint_of(row)
    assert str(row.message).startswith("The job was interrupted after copy 2 of 3")


def test_a_copy_that_was_cut_to_its_last_line_is_counted(store: Store, clock: Clock) -> None:
    job = interrupted(store, clock, LINES, copies=3)
    assert (store.jobs.get(job.id).line, store.jobs.get(job.id).copies_done) == (0, 1)


def test_an_operator_declares_an_interrupted_job_finished(store: Store, clock: Clock) -> None:
    job = interrupted(store, clock, 200, copies=2)
    row = store.interrupted.declare_finished(job.id)
    assert (row.state, row.line, row.copies_done, row.message) == ("done", LINES, 2, None)
    last = store.events.of_job(job.id)[-1]
    assert (last.who, str(last.message)) == (
        "operator",
        "The operator marked the job as finished, after the machine "
        "had stopped at program line 200 of 231.",
    )
    # The answer was lost, and the request is sent again.
    assert store.interrupted.declare_finished(job.id).state == "done"
    assert store.events.of_job(job.id)[-1].id == last.id


@pytest.mark.parametrize("state", ["ready", "queued", "running"])
def test_only_an_interrupted_job_can_be_declared_finished(store: Store, state: str) -> None:
    job = {"ready": compiling, "queued": queued, "running": running}[state](store)
    with pytest.raises(WrongState):
        store.interrupted.declare_finished(job.id)


def test_a_service_that_could_not_be_reached_takes_nothing_from_gateways(
    store: Store, clock: Clock
) -> None:
    job = running(store)
    clock.now += LEASE + 0.1
    store.leases.run(gateways=False)
    assert store.jobs.get(job.id).state == "running"
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=9)) == "continue"
