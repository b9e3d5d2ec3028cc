"""Jobs that continue the work of another job, or make it again."""

from __future__ import annotations

import pytest

from knifetip.contract.job import OPERATOR, Confirmation, State
from knifetip.errors import KeyReused, WrongState
from knifetip.service.database.request_key import RequestKey
from knifetip.service.database.tables import Job
from knifetip.service.gateways.heartbeats import GatewayReport
from knifetip.service.orders.store import Continuation
from knifetip.service.processes.rest_record import ExecutedWork, RestRecord
from knifetip.service.queues.store import WaitingChange, check_transferable
from knifetip.service.runs.stop_place import StopPlace
from knifetip.service.store import Store
from tests.support.job_states import (
    RESULT,
    WAITING,
    confirm,
    course,
    ordered,
    queued,
    running,
)

LINE = 40


def interrupted(store: Store) -> Job:
    job = running(store, board="b-flute")
    store.gateways.finish(job.id, job.epoch, "interrupted", line=LINE)
    return store.jobs.get(job.id)


def record(job: Job) -> RestRecord:
    return RestRecord(((3, 7), (9, 9)), (ExecutedWork(job.id, ((8, 30),), ((31, 33),)),))


def rest(store: Store, job: Job, key: RequestKey | None = None) -> Job:
    wanted = Continuation(record(job), LINE, release=True)
    return store.jobs.add_continuation(job.id, wanted, key)


def compiled(store: Store, job: Job) -> Job:
    taken = store.compiles.begin("worker")
    assert taken is not None
    assert taken.id == job.id
    store.compiles.save_result(job.id, taken.epoch, RESULT)
    return store.jobs.get(job.id)


def test_a_rest_job_has_the_inputs_of_its_parent_and_its_own_progress(store: Store) -> None:
    parent = interrupted(store)
    job = rest(store, parent)
    assert (job.resumes, job.copies, job.line, job.lines) == (parent.id, 1, 0, 0)
    assert job.rest is not None
    assert RestRecord.from_json(job.rest) == record(parent)
    for name in ("drawing", "machine", "board", "profile", "rules", "unit_given", "options"):
        assert getattr(job, name) == getattr(parent, name)
    assert job.board == "b-flute"
    assert (job.state, parent.state) == (State.RECEIVED, State.INTERRUPTED)


def test_a_rest_job_has_not_stopped_where_its_parent_has(store: Store) -> None:
    job = running(store, board="b-flute")
    place = StopPlace((1.0, 2.0, 0.0, 0.0), 1)
    store.gateways.finish(job.id, job.epoch, "interrupted", line=LINE, place=place)
    parent = store.jobs.get(job.id)
    assert parent.stopped_at is not None
    made = rest(store, parent)
    assert (made.stopped_at, made.check_refusal) == (None, None)
    assert (made.feeds, made.awaits_end, made.begun) == (False, False, True)


def test_the_parent_blocks_the_table_until_its_rest_is_queued(store: Store) -> None:
    parent = interrupted(store)
    other = queued(store)
    job = rest(store, parent)
    assert store.machines.jobs_on_tables() == {"table": parent.id}
    compiled(store, job)
    assert store.machines.jobs_on_tables() == {}
    assert course(store, parent.id)[-1] == "continued"
    # The sheet of the rest lies on the table, so the rest comes first, with a confirmation also on
    # a machine that feeds sheets itself.
    claim = store.gateways.claim("table", "gateway", manual=False)
    assert claim is not None
    assert (claim.id, claim.confirmation) == (job.id, Confirmation.AWAITED)
    assert store.gateways.heartbeat(job.id, claim.epoch, WAITING) == "wait"
    confirm(store, job.id)
    assert store.gateways.heartbeat(job.id, claim.epoch, WAITING) == "start"
    store.gateways.finish(job.id, claim.epoch, "done")
    following = store.gateways.claim("table", "gateway", manual=False)
    assert following is not None
    assert (following.id, following.state) == (other.id, State.RUNNING)


def test_a_refused_rest_leaves_its_parent_on_the_table(store: Store) -> None:
    parent = interrupted(store)
    job = rest(store, parent)
    taken = store.compiles.begin("worker")
    assert taken is not None
    assert parent.message is not None
    store.compiles.refuse(job.id, taken.epoch, parent.message)
    assert store.jobs.get(parent.id).state == State.INTERRUPTED
    # Another choice may follow.
    assert rest(store, parent).id != job.id


def test_a_sheet_is_continued_by_one_job(store: Store) -> None:
    parent = interrupted(store)
    job = rest(store, parent)
    with pytest.raises(WrongState, match=job.id):
        rest(store, parent)
    store.operators.cancel(job.id)
    second = compiled(store, rest(store, parent))
    claim = store.gateways.claim("table", "gateway", manual=True)
    assert claim is not None
    confirm(store, second.id)
    store.gateways.heartbeat(second.id, claim.epoch, WAITING)
    store.gateways.heartbeat(second.id, claim.epoch, GatewayReport(line=5))
    store.operators.cancel(second.id)
    store.gateways.finish(second.id, claim.epoch, "cancelled", line=6)
    # It has cut a part of the rest, so the parent no longer tells what is uncut.
    with pytest.raises(WrongState, match=second.id):
        rest(store, parent)


def test_an_unfinished_sheet_is_known_after_its_rest_was_cancelled(store: Store) -> None:
    parent = interrupted(store)
    following = queued(store)
    rest_job = compiled(store, rest(store, parent))
    assert store.gateways.unfinished_sheet(rest_job) == ""  # it needs the sheet on the table
    assert store.gateways.unfinished_sheet(following) == parent.id
    store.operators.cancel(rest_job.id)
    claim = store.gateways.claim("table", "gateway", manual=False, feeds=True)
    assert claim is not None
    assert (claim.id, claim.confirmation) == (following.id, Confirmation.AWAITED)
    assert store.gateways.unfinished_sheet(claim) == parent.id
    confirm(store, claim.id)
    assert store.gateways.heartbeat(claim.id, claim.epoch, WAITING) == "start"
    store.gateways.finish(claim.id, claim.epoch, "done")
    assert store.gateways.unfinished_sheet(queued(store)) == ""


def test_a_batch_does_not_go_on_by_itself_over_an_unfinished_sheet(store: Store) -> None:
    batch = running(store, copies=3)
    store.gateways.finish(batch.id, batch.epoch, "interrupted", line=0, copies_done=1)
    store.interrupted.requeue(batch.id)
    other = queued(store, priority=1)
    claim = store.gateways.claim("table", "gateway", manual=False)
    assert claim is not None
    assert claim.id == other.id
    store.operators.cancel(other.id)
    store.gateways.finish(other.id, claim.epoch, "cancelled", line=LINE)
    again = store.gateways.claim("table", "gateway", manual=False, feeds=True)
    assert again is not None
    assert (again.id, again.confirmation) == (batch.id, Confirmation.AWAITED)


@pytest.mark.parametrize("action", ["scrap", "requeue", "declare_finished"])
def test_an_operator_who_ends_an_interrupted_job_clears_the_table(
    store: Store, action: str
) -> None:
    parent = interrupted(store)
    getattr(store.interrupted, action)(parent.id)
    assert store.gateways.unfinished_sheet(queued(store)) == ""


def test_a_copy_of_the_whole_may_be_made_at_any_time(store: Store) -> None:
    parent = interrupted(store)
    compiled(store, rest(store, parent))
    copy = store.jobs.add_continuation(parent.id, Continuation(None, copies=3))
    assert (copy.resumes, copy.rest, copy.copies) == (parent.id, None, 3)


def batch(store: Store) -> Job:
    """Return a job that was interrupted in the second of five copies."""
    job = running(store, copies=5)
    store.gateways.finish(job.id, job.epoch, "interrupted", line=LINE, copies_done=1)
    return store.jobs.get(job.id)


def remaining(store: Store, id: str) -> int:
    return store.jobs.remaining_copies([store.jobs.get(id)]).get(id, 0)


def order_remaining(store: Store, id: str) -> Job:
    return store.jobs.add_continuation(id, Continuation(None, copies=None))


def run(store: Store, job: Job, outcome: str = "done", copies_done: int = 1) -> None:
    claim = store.gateways.claim("table", "gateway", manual=True)
    assert claim is not None
    assert claim.id == job.id
    confirm(store, job.id)
    store.gateways.heartbeat(job.id, claim.epoch, WAITING)
    store.gateways.finish(job.id, claim.epoch, outcome, line=LINE, copies_done=copies_done)


def test_the_copies_after_the_finished_sheet_are_ordered_by_one_call(store: Store) -> None:
    parent = batch(store)
    assert remaining(store, parent.id) == 4  # without the rest, the second copy is lost, too
    with pytest.raises(WrongState, match="occupies the table"):
        order_remaining(store, parent.id)
    sheet = compiled(store, rest(store, parent))
    assert [remaining(store, id) for id in (parent.id, sheet.id)] == [3, 3]
    run(store, sheet)
    # They are not ordered by themselves, and stay in sight at both jobs.
    assert store.jobs.search((State.QUEUED,)) == []
    assert [remaining(store, id) for id in (parent.id, sheet.id)] == [3, 3]
    copies = order_remaining(store, sheet.id)
    assert (copies.resumes, copies.rest, copies.copies) == (parent.id, None, 3)
    assert [remaining(store, id) for id in (parent.id, sheet.id, copies.id)] == [0, 0, 0]
    with pytest.raises(WrongState, match="No copy"):
        order_remaining(store, parent.id)


def test_copies_that_were_cancelled_remain(store: Store) -> None:
    parent = batch(store)
    run(store, compiled(store, rest(store, parent)))
    copies = order_remaining(store, parent.id)
    store.operators.cancel(copies.id)
    assert remaining(store, parent.id) == 3
    store.jobs.add_continuation(parent.id, Continuation(None, copies=1))
    assert remaining(store, parent.id) == 2


def test_a_sheet_that_is_lost_after_all_remains(store: Store) -> None:
    parent = batch(store)
    first = compiled(store, rest(store, parent))
    run(store, first, "interrupted", 0)
    # As long as it is not given up, its sheet may be finished.
    assert remaining(store, parent.id) == 3
    again = rest(store, store.jobs.get(first.id))
    compiled(store, again)
    assert [remaining(store, id) for id in (parent.id, first.id, again.id)] == [3, 3, 3]
    store.operators.cancel(again.id)
    assert remaining(store, parent.id) == 4


def test_one_copy_or_a_running_batch_leaves_no_copies(store: Store) -> None:
    single = interrupted(store)
    sheet = compiled(store, rest(store, single))
    store.operators.cancel(sheet.id)
    assert [remaining(store, id) for id in (single.id, sheet.id)] == [0, 0]
    assert remaining(store, running(store, copies=5).id) == 0


def test_a_report_between_choice_and_order_refuses_the_rest(store: Store) -> None:
    parent = interrupted(store)
    store.gateways.finish(parent.id, parent.epoch, "interrupted", line=LINE + 9)
    with pytest.raises(WrongState, match=str(LINE + 9)):
        rest(store, parent)


def test_a_running_job_cannot_be_continued(store: Store) -> None:
    job = running(store)
    with pytest.raises(WrongState):
        store.jobs.add_continuation(job.id, Continuation(None))
    with pytest.raises(WrongState):
        store.jobs.add_continuation(ordered(store).id, Continuation(None))


def test_a_repeated_request_returns_the_first_job(store: Store) -> None:
    parent = interrupted(store)
    key = RequestKey("again", "1")
    first = store.jobs.add_continuation(parent.id, Continuation(None), key)
    assert store.jobs.add_continuation(parent.id, Continuation(None), key).id == first.id
    with pytest.raises(KeyReused):
        store.jobs.add_continuation(parent.id, Continuation(None), RequestKey("again", "2"))
    assert len(store.jobs.search()) == 2


def test_an_interrupted_rest_cannot_be_queued_from_its_start(store: Store) -> None:
    job = compiled(store, rest(store, interrupted(store)))
    claim = store.gateways.claim("table", "gateway", manual=True)
    assert claim is not None
    confirm(store, job.id)
    store.gateways.heartbeat(job.id, claim.epoch, WAITING)
    store.gateways.finish(job.id, claim.epoch, "interrupted", line=3)
    with pytest.raises(WrongState, match="rest"):
        store.interrupted.requeue(job.id)


def test_a_rest_stays_on_its_machine_and_makes_one_sheet(store: Store) -> None:
    job = compiled(store, rest(store, interrupted(store)))
    with pytest.raises(WrongState, match="completes the sheet"):
        check_transferable(job)
    with pytest.raises(WrongState, match="completes the sheet"):
        store.queues.change(job.id, WaitingChange(copies=2), OPERATOR)
    assert store.jobs.get(job.id).copies == 1
