"""Claims of jobs by gateways: states, one job on each table, epochs and leases."""

from __future__ import annotations

import threading
from collections.abc import Callable
from operator import attrgetter

import pytest
import sqlalchemy as sa

from knifetip.errors import (
    MachineBusy,
    NotFound,
    StaleEpoch,
    WrongState,
)
from knifetip.service.database.tables import Job
from knifetip.service.gateways.heartbeats import GatewayReport
from knifetip.service.lifecycle.transitions import LEASE
from knifetip.service.orders.operator_actions import allowed_actions
from knifetip.service.runs.stop_place import StopPlace, executed_at_most
from knifetip.service.store import Store
from tests.support.job_states import (
    LINES,
    REFUSED,
    RESULT,
    compiling,
    confirm,
    course,
    execute,
    fed,
    ordered,
    queued,
    running,
    waiting,
)
from tests.support.messages import stored
from tests.support.stored import Clock

#: The machine was observed until it stopped, at the reported line.
EXACT = StopPlace(at_most=0)

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
    assert store.programs.release(job.id).state == "queued"


def test_a_verdict_outside_tolerance_refuses_the_job_with_its_edges(store: Store) -> None:
    job = compiling(store, release=True)
    store.compiles.save_result(job.id, job.epoch, REFUSED)
    job = store.jobs.get(job.id)
    assert (job.state, str(job.message), job.source, job.edges) == (
        "refused",
        "Edge 3 is 0.4 mm off.",
        ["2F4"],
        [3],
    )


def test_the_event_is_written_with_the_move_or_not_at_all(store: Store) -> None:
    job = queued(store)
    with pytest.raises(WrongState):
        store.interrupted.scrap(job.id)
    assert course(store, job.id)[-1] == "queued"
    assert len(course(store, job.id)) == 4


@pytest.mark.parametrize("at", [queued, running])
def test_a_repeated_release_changes_nothing(store: Store, at: Callable[[Store], Job]) -> None:
    job = at(store)
    before = course(store, job.id)
    assert store.programs.release(job.id).state == before[-1]
    assert course(store, job.id) == before


@pytest.mark.parametrize(
    "move",
    [
        "programs.release",
        "interrupted.requeue",
        "interrupted.scrap",
        "operators.hold",
        "operators.resume",
    ],
)
def test_a_received_job_can_only_be_cancelled(store: Store, move: str) -> None:
    job = ordered(store)
    with pytest.raises(WrongState, match="is received"):
        attrgetter(move)(store)(job.id)
    assert store.operators.cancel(job.id).state == "cancelled"


@pytest.mark.parametrize(
    "move",
    [
        "interrupted.requeue",
        "interrupted.scrap",
        "operators.hold",
        "operators.resume",
        "operators.cancel",
    ],
)
def test_a_job_that_is_done_stays_done(store: Store, move: str) -> None:
    job = running(store)
    store.gateways.finish(job.id, job.epoch, "done")
    with pytest.raises(WrongState, match="is done"):
        attrgetter(move)(store)(job.id)
    # The answer to the release was lost, and it was sent again.
    assert store.programs.release(job.id).state == "done"
    assert course(store, job.id)[-1] == "done"


def test_a_job_that_does_not_exist_is_named(store: Store) -> None:
    with pytest.raises(NotFound, match="Job 'nothing' does not exist"):
        store.operators.cancel("nothing")
    with pytest.raises(NotFound, match="does not exist"):
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
    store.interrupted.requeue(job.id)
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
        "The job was interrupted at program line 199 of 231 or later: nobody observed the machine "
        "then, so it may have executed the program to its end. The gateway gateway stopped "
        "responding."
    )
    assert store.machines.jobs_on_tables() == {"table": job.id}


def test_a_heartbeat_renews_the_lease(store: Store, clock: Clock) -> None:
    job = running(store)
    for line in range(20):
        clock.now += LEASE / 2
        assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=line)) == "continue"
        store.leases.run()
    assert store.jobs.get(job.id).state == "running"


def test_a_repeated_finish_does_no_harm(store: Store) -> None:
    job = running(store)
    store.gateways.finish(job.id, job.epoch, "interrupted", stored("A belt tore."), place=EXACT)
    again = store.gateways.finish(
        job.id, job.epoch, "interrupted", stored("A belt tore."), place=EXACT
    )
    assert str(again.message) == (
        "The job was interrupted before its first program line of 231 was complete. It is not "
        "known whether the machine has moved. A belt tore."
    )
    assert course(store, job.id).count("interrupted") == 1


def test_an_interrupted_job_is_queued_again_from_its_first_line_or_scrapped(store: Store) -> None:
    job = running(store)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=100))
    store.gateways.finish(job.id, job.epoch, "interrupted", stored("A belt tore."))
    again = store.interrupted.requeue(job.id)
    assert (again.state, again.line, again.message) == ("queued", 0, None)
    second = store.gateways.claim("table", "gateway", manual=False)
    assert second is not None
    store.gateways.finish(second.id, second.epoch, "interrupted")
    assert store.interrupted.scrap(second.id).state == "scrapped"
    assert store.machines.jobs_on_tables() == {}


def test_copies_that_were_cut_before_an_interruption_count(store: Store, clock: Clock) -> None:
    job = fed(store, copies=3)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=LINES, copies_done=1, held=True))
    assert (
        str(store.events.of_job(job.id)[-1].message)
        == "Copy 1 of 3 of the job is finished. The next copy needs a new sheet of board."
    )
    store.gateways.finish(job.id, job.epoch, "interrupted")
    begun = store.jobs.get(job.id).started
    clock.now += 1.0
    store.interrupted.requeue(job.id)
    again = store.gateways.claim("table", "gateway", manual=False)
    assert again is not None
    store.gateways.heartbeat(
        again.id, again.epoch, GatewayReport(line=LINES, copies_done=1, held=True)
    )
    # The time is that of the first copy.
    assert store.jobs.get(job.id).started == begun > 0.0
    assert store.jobs.get(job.id).copies_done == 2


def test_a_resume_starts_one_copy_and_not_the_one_after(store: Store) -> None:
    job = fed(store, copies=3)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=LINES, copies_done=1, held=True))
    confirm(store, job.id)
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


def test_a_resume_counts_only_in_the_phase_in_which_it_was_asked(store: Store) -> None:
    job = fed(store, copies=2)
    between = GatewayReport(line=LINES, copies_done=1, held=True, phase=1)
    store.gateways.heartbeat(job.id, job.epoch, between)
    confirm(store, job.id)
    # The answer ``resume`` reached the gateway, and then the server was lost.  Its next report is
    # that the second copy is handed over, and that a person must confirm its end.
    at_end = GatewayReport(line=0, copies_done=1, held=True, phase=3, awaits_end=True)
    assert store.gateways.heartbeat(job.id, job.epoch, at_end) == "continue"
    assert store.jobs.get(job.id).requested_action == ""
    store.operators.confirm_end(job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, at_end) == "end"


def test_a_resume_that_withdrew_a_hold_does_not_confirm_the_end(store: Store) -> None:
    job = fed(store)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=2))
    store.operators.hold(job.id)
    store.operators.resume(job.id, hands_clear=True)
    # The machine was held as requested: that is the hold which the resume was for.
    held = GatewayReport(line=3, held=True)
    assert store.gateways.heartbeat(job.id, job.epoch, held) == "resume"
    at_end = GatewayReport(line=3, held=True, phase=1, awaits_end=True)
    assert store.gateways.heartbeat(job.id, job.epoch, at_end) == "continue"


def test_a_request_for_another_phase_is_refused(store: Store) -> None:
    job = fed(store)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=2, held=True, phase=1))
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=2, held=True, phase=2))
    with pytest.raises(WrongState, match="has continued since"):
        store.operators.resume(job.id, phase=1, hands_clear=True)
    assert store.jobs.get(job.id).requested_action == ""
    assert store.operators.resume(job.id, phase=2, hands_clear=True).requested_action == "resume"


def test_a_new_claim_begins_with_the_first_phase(store: Store) -> None:
    job = fed(store)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=2, held=True, phase=4))
    store.gateways.finish(job.id, job.epoch, "interrupted")
    store.interrupted.requeue(job.id)
    again = store.gateways.claim("table", "gateway", manual=False)
    assert again is not None
    assert again.phase == 0


# Programs that the check run of the machine refuses


def test_a_refused_program_leaves_the_table_and_waits_for_a_person(store: Store) -> None:
    job = running(store)
    reason = stored("Line 3 is not known.")
    row = store.gateways.finish(job.id, job.epoch, "refused", reason, line=0)
    assert (row.state, str(row.check_refusal), row.message) == ("queued", str(reason), None)
    assert (row.lease, row.stopped_at, store.machines.jobs_on_tables()) == (0.0, None, {})
    # It is not claimed again by itself, and other jobs go on.
    assert store.gateways.claim("table", "gateway", manual=False) is None
    other = queued(store)
    claimed = store.gateways.claim("table", "gateway", manual=False)
    assert claimed is not None
    assert claimed.id == other.id
    store.gateways.finish(claimed.id, claimed.epoch, "done")
    assert "recheck" in allowed_actions(row, 0.0)
    assert store.programs.recheck(job.id).check_refusal is None
    again = store.gateways.claim("table", "gateway", manual=False)
    assert again is not None
    assert again.id == job.id


def checking(store: Store) -> Job:
    """A job whose gateway announces the begin of the program, and has not begun it."""
    queued(store)
    job = store.gateways.claim("table", "gateway", manual=True, announces=True)
    assert job is not None
    confirm(store, job.id)
    unbegun = GatewayReport(line=0, waiting=True, begun=False)
    assert store.gateways.heartbeat(job.id, job.epoch, unbegun) == "start"
    return job


BEFORE_BEGIN = GatewayReport(line=0, begun=False)


def test_a_gateway_that_is_lost_in_its_check_run_leaves_the_job_in_the_queue(
    store: Store, clock: Clock
) -> None:
    job = checking(store)
    assert store.gateways.heartbeat(job.id, job.epoch, BEFORE_BEGIN) == "continue"
    assert store.jobs.get(job.id).state == "running"
    clock.now += LEASE + 1.0
    store.leases.run()
    row = store.jobs.get(job.id)
    assert (row.state, row.message, row.stopped_at) == ("queued", None, None)
    assert "stopped responding" in str(store.events.of_job(job.id)[-1].message)
    assert store.machines.jobs_on_tables() == {}
    # A person confirms the sheet again.
    again = store.gateways.claim("table", "gateway", manual=True)
    assert again is not None
    assert (again.id, again.confirmation) == (job.id, "awaited")
    with pytest.raises(StaleEpoch):
        store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=0))


@pytest.mark.parametrize("announces", [True, False])
def test_a_gateway_that_may_have_begun_leaves_an_interrupted_job(
    store: Store, clock: Clock, *, announces: bool
) -> None:
    """A gateway that does not announce the begin may have begun at any time."""
    job = checking(store) if announces else running(store)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=0, begun=announces))
    # What was begun once stays so, whatever a later report states.
    store.gateways.heartbeat(job.id, job.epoch, BEFORE_BEGIN)
    clock.now += LEASE + 1.0
    store.leases.run()
    assert store.jobs.get(job.id).state == "interrupted"


def test_a_late_report_of_a_refused_program_returns_an_interrupted_job_to_the_queue(
    store: Store, clock: Clock
) -> None:
    job = running(store)
    clock.now += LEASE + 1.0
    store.leases.run()
    assert store.jobs.get(job.id).state == "interrupted"
    for _ in range(2):  # it is repeated
        row = store.gateways.finish(
            job.id, job.epoch, "refused", stored("No."), line=0, place=EXACT
        )
        assert (row.state, str(row.check_refusal), row.message) == ("queued", "No.", None)
    assert store.machines.jobs_on_tables() == {}
    assert course(store, job.id)[-2:] == ["interrupted", "queued"]


def test_an_interrupted_job_that_is_returned_late_waits_for_a_person(
    store: Store, clock: Clock
) -> None:
    job = running(store)
    clock.now += LEASE + 1.0
    store.leases.run()
    row = store.gateways.finish(job.id, job.epoch, "returned", stored("No server."), line=0)
    assert (row.state, str(row.check_refusal)) == ("queued", "No server.")


def test_a_late_refusal_lets_a_returned_job_wait_for_a_person(store: Store, clock: Clock) -> None:
    job = checking(store)
    clock.now += LEASE + 1.0
    store.leases.run()
    row = store.gateways.finish(job.id, job.epoch, "returned", stored("Gone."), line=0)
    assert (row.state, row.check_refusal) == ("queued", None)
    for _ in range(2):  # it is repeated
        row = store.gateways.finish(job.id, job.epoch, "refused", stored("Error 20."), line=0)
        assert (row.state, str(row.check_refusal)) == ("queued", "Error 20.")
    events = store.events.of_job(job.id)
    assert sum("Error 20." in str(event.message) for event in events) == 1
    # Not any more when a person has decided.
    store.programs.recheck(job.id)
    with pytest.raises(StaleEpoch):
        store.gateways.finish(job.id, job.epoch, "refused", stored("Error 20."), line=0)


def test_a_late_refusal_does_not_reach_a_new_claim(store: Store, clock: Clock) -> None:
    job = checking(store)
    clock.now += LEASE + 1.0
    store.leases.run()
    assert store.gateways.claim("table", "gateway", manual=True) is not None
    with pytest.raises(StaleEpoch):
        store.gateways.finish(job.id, job.epoch, "refused", stored("Error 20."), line=0)


@pytest.mark.parametrize(("line", "at_most", "copies"), [(4, 0, 0), (0, 1, 0), (0, 0, 1)])
def test_a_late_report_of_executed_lines_leaves_the_job_interrupted(
    store: Store, clock: Clock, line: int, at_most: int, copies: int
) -> None:
    job = running(store)
    clock.now += LEASE + 1.0
    store.leases.run()
    place = StopPlace(at_most=at_most)
    row = store.gateways.finish(
        job.id, job.epoch, "refused", stored("No."), line=line, copies_done=copies, place=place
    )
    assert (row.state, row.check_refusal) == ("interrupted", None)


def test_a_late_report_does_not_contradict_the_lines_of_heartbeats(
    store: Store, clock: Clock
) -> None:
    job = running(store)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=3))
    clock.now += LEASE + 1.0
    store.leases.run()
    row = store.gateways.finish(job.id, job.epoch, "refused", stored("No."), line=0, place=EXACT)
    assert (row.state, row.check_refusal) == ("interrupted", None)


def test_a_late_report_leaves_a_job_whose_sheet_is_continued(store: Store, clock: Clock) -> None:
    job = running(store)
    clock.now += LEASE + 1.0
    store.leases.run()
    rest = ordered(store)
    with store.database.writing() as session:
        session.execute(sa.update(Job).where(Job.id == rest.id).values(resumes=job.id))
    row = store.gateways.finish(job.id, job.epoch, "refused", stored("No."), line=0, place=EXACT)
    assert (row.state, row.check_refusal) == ("interrupted", None)


def test_a_job_of_which_something_was_executed_is_not_returned(store: Store) -> None:
    job = running(store)
    row = store.gateways.finish(job.id, job.epoch, "refused", stored("No."), line=4)
    assert (row.state, row.check_refusal) == ("interrupted", None)


def test_a_returned_job_of_which_nothing_was_executed_is_claimed_again(store: Store) -> None:
    job = running(store)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=0))
    row = store.gateways.finish(job.id, job.epoch, "returned", stored("The door is open."), line=0)
    assert (row.state, row.check_refusal, row.epoch) == ("queued", None, job.epoch + 1)
    again = store.gateways.claim("table", "gateway", manual=False)
    assert again is not None
    assert again.id == job.id


@pytest.mark.parametrize("outcome", ["returned", "refused"])
def test_a_line_of_the_last_heartbeat_keeps_a_job_from_the_queue(
    store: Store, outcome: str
) -> None:
    job = running(store)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=3))
    row = store.gateways.finish(job.id, job.epoch, outcome, stored("No."))
    assert (row.state, row.line) == ("interrupted", 3)


def test_a_job_that_no_machine_has_refused_is_not_checked_again(store: Store) -> None:
    job = queued(store)
    with pytest.raises(WrongState):
        store.programs.recheck(job.id)


# Where a job stopped


@pytest.mark.parametrize("outcome", ["cancelled", "interrupted"])
def test_the_place_where_a_job_stopped_is_stored(store: Store, outcome: str) -> None:
    job = running(store)
    place = StopPlace((10.0, 20.0, -0.3, 90.0), 2)
    store.gateways.finish(job.id, job.epoch, outcome, line=7, place=place)
    stopped = {"line": 7, "at_most": LINES, "position": [10.0, 20.0, -0.3, 90.0], "station": 2}
    row = store.jobs.get(job.id)
    assert row.stopped_at == stopped
    assert row.position == stopped["position"]
    if outcome == "interrupted":
        assert store.interrupted.requeue(job.id).stopped_at is None


def test_a_silent_gateway_stops_its_job_at_the_last_heartbeat(store: Store, clock: Clock) -> None:
    job = running(store)
    report = GatewayReport(line=5, position=(1.0, 2.0, 3.0, 4.0))
    store.gateways.heartbeat(job.id, job.epoch, report)
    clock.now += LEASE + 1.0
    store.leases.run()
    stopped = {"line": 5, "at_most": LINES, "position": [1.0, 2.0, 3.0, 4.0], "station": None}
    assert store.jobs.get(job.id).stopped_at == stopped


def test_lines_that_were_not_observed_are_an_upper_bound(store: Store) -> None:
    job = running(store)
    end = StopPlace(at_most=40)
    row = store.gateways.finish(job.id, job.epoch, "interrupted", line=7, place=end)
    assert row.stopped_at == {"line": 7, "at_most": 40, "position": None, "station": None}
    assert executed_at_most(row) == 40
    assert str(row.message).startswith(
        "The job was interrupted at program line 7 of 231 or later: nobody observed the machine "
        "then, so it may have executed lines up to line 40. "
    )
    assert executed_at_most(store.interrupted.declare_finished(job.id)) == LINES


def test_a_stop_that_an_older_version_stored_is_a_lower_bound(store: Store) -> None:
    job = running(store)
    store.gateways.finish(job.id, job.epoch, "interrupted", line=7, place=EXACT)
    row = store.jobs.get(job.id)
    assert executed_at_most(row) == 7
    row.stopped_at = {"line": 7, "position": None, "station": None}
    assert executed_at_most(row) == LINES


def test_a_job_that_is_done_stopped_nowhere(store: Store) -> None:
    job = running(store)
    store.gateways.finish(job.id, job.epoch, "done", place=StopPlace((0.0, 0.0, 20.0, 0.0)))
    assert store.jobs.get(job.id).stopped_at is None


# Machines that feed their sheets themselves


def fed_claim(store: Store) -> Job:
    job = store.gateways.claim("table", "gateway", manual=False, feeds=True)
    assert job is not None
    return job


def confirmed(store: Store, job: Job) -> Job:
    assert (job.state, job.confirmation) == ("queued", "awaited")
    confirm(store, job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(0, waiting=True)) == "start"
    return store.jobs.get(job.id)


def test_the_first_sheet_of_a_batch_is_confirmed_and_the_next_job_follows(store: Store) -> None:
    queued(store)
    first = confirmed(store, fed_claim(store))
    store.gateways.finish(first.id, first.epoch, "done")
    queued(store)
    assert fed_claim(store).state == "running"


def test_another_board_begins_a_new_batch(store: Store) -> None:
    queued(store)
    first = confirmed(store, fed_claim(store))
    store.gateways.finish(first.id, first.epoch, "done")
    queued(store, board="greyboard-2.0")
    assert store.gateways.begins_batch(fed_claim(store))


def test_after_a_job_that_was_cancelled_the_next_one_is_confirmed(store: Store) -> None:
    queued(store)
    first = confirmed(store, fed_claim(store))
    store.gateways.finish(first.id, first.epoch, "cancelled")
    queued(store)
    assert fed_claim(store).confirmation == "awaited"


def test_the_copies_of_a_confirmed_job_follow_each_other(store: Store) -> None:
    queued(store, copies=3)
    job = confirmed(store, fed_claim(store))
    done = GatewayReport(line=LINES, copies_done=1, held=True)
    assert store.gateways.heartbeat(job.id, job.epoch, done) == "resume"


def with_tool(store: Store, job: Job) -> Job:
    tools = '[{"station": 1, "name": "Knife", "kind": "knife"}]'
    execute(store, "UPDATE job SET tools = :tools WHERE id = :id", tools=tools, id=job.id)
    return store.jobs.get(job.id)


def test_a_job_with_a_worn_tool_is_confirmed(store: Store) -> None:
    queued(store)
    first = confirmed(store, fed_claim(store))
    store.gateways.finish(first.id, first.epoch, "done")
    with_tool(store, queued(store))
    job = store.gateways.claim("table", "g", manual=False, feeds=True, worn=lambda _: {1})
    assert job is not None
    assert (job.state, job.confirmation) == ("queued", "awaited")


def test_the_next_copy_with_a_worn_tool_is_confirmed(store: Store) -> None:
    with_tool(store, queued(store, copies=3))
    job = confirmed(store, fed_claim(store))
    done = GatewayReport(line=LINES, copies_done=1, held=True)
    assert store.gateways.heartbeat(job.id, job.epoch, done, lambda _: {1}) == "continue"
    assert store.jobs.get(job.id).confirmation == "sheet"
    confirm(store, job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, done, lambda _: {1}) == "resume"


# What the operator confirms


def test_a_confirmation_names_the_stations_that_were_checked(store: Store) -> None:
    job = waiting(store)
    execute(
        store,
        "UPDATE job SET tools = :tools",
        tools='[{"station": 1, "name": "Knife", "kind": "knife"},'
        ' {"station": 2, "name": "Wheel", "kind": "crease-wheel"}]',
    )
    checked = ["board", "sheet", "station-1", "table-clear", "hands-clear"]
    with pytest.raises(WrongState) as refused:
        store.operators.confirm(job.id, checked)
    assert refused.value.message.code == "job.not-checked"
    assert "station-2 (Station 2 holds Wheel, and the tool is not damaged.)" in str(refused.value)
    assert store.jobs.get(job.id).confirmation == "awaited"
    assert store.operators.confirm(job.id, [*checked, "station-2"]).confirmation == "given"
