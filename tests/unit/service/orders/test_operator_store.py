"""Actions of operators on jobs: confirmation, hold, resume and cancel."""

from __future__ import annotations

import pytest
import sqlalchemy as sa

from knifetip.errors import (
    MachineBusy,
    RequestError,
    StaleEpoch,
    WrongState,
)
from knifetip.messages import hint
from knifetip.service.gateways.heartbeats import GatewayReport
from knifetip.service.lifecycle.transitions import LEASE
from knifetip.service.runs.stop_place import StopPlace
from knifetip.service.store import Store
from tests.support.job_states import (
    LINES,
    WAITING,
    confirm,
    course,
    execute,
    fed,
    hint_of,
    queued,
    running,
    waiting,
)
from tests.support.messages import stored
from tests.support.stored import Clock

# Start by the operator


def test_a_claim_by_hand_waits_and_runs_when_it_is_confirmed(store: Store) -> None:
    job = waiting(store)
    assert (job.state, job.owner, job.confirmation) == ("queued", "gateway", "awaited")
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "wait"
    assert store.machines.jobs_on_tables() == {}
    confirmed = confirm(store, job.id, by="Kim")
    assert (confirmed.state, confirmed.confirmation) == ("queued", "given")
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "start"
    assert store.jobs.get(job.id).state == "running"
    # The response that starts the job may be lost: it is repeated, and recorded once.
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "start"
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=1)) == "continue"
    assert course(store, job.id)[3:] == ["queued"] * 4 + ["running"]
    who = [(event.who, str(event.message)) for event in store.events.of_job(job.id)][-2:]
    assert who[-2:] == [
        (
            "operator Kim",
            "The operator confirmed that the table is clear and that the board on it is e-flute.",
        ),
        ("gateway gateway", "The job was started."),
    ]


def test_a_confirmation_that_is_repeated_changes_nothing(store: Store) -> None:
    job = waiting(store)
    confirm(store, job.id)
    events = len(course(store, job.id))
    assert confirm(store, job.id).confirmation == "given"
    assert len(course(store, job.id)) == events
    store.gateways.heartbeat(job.id, job.epoch, WAITING)
    assert confirm(store, job.id).state == "running"
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=5)) == "continue"


def test_a_job_that_does_not_wait_cannot_be_confirmed(store: Store) -> None:
    job = queued(store)
    with pytest.raises(WrongState, match="has not claimed it yet"):
        confirm(store, job.id)
    job = fed(store)
    store.operators.hold(job.id)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=5, held=True))
    with pytest.raises(WrongState, match="does not wait for a new sheet") as caught:
        confirm(store, job.id)
    assert caught.value.hint == "Resume the job."
    store.operators.cancel(job.id)
    with pytest.raises(WrongState, match="being cancelled"):
        confirm(store, job.id)
    store.gateways.finish(job.id, job.epoch, "cancelled")
    with pytest.raises(WrongState, match="is cancelled"):
        confirm(store, job.id)


def test_a_job_on_a_machine_that_feeds_itself_has_nothing_to_confirm(store: Store) -> None:
    job = running(store)
    with pytest.raises(WrongState, match="is running"):
        confirm(store, job.id)


def ids_of(store: Store, id: str) -> list[str]:
    return [check.id for check in store.operators.checks(store.jobs.get(id))]


def refuse_each_missing(store: Store, id: str) -> None:
    """Leave out each of the checks of a job; every confirmation is refused and names it."""
    ids = ids_of(store, id)
    for left_out in ids:
        with pytest.raises(WrongState) as refused:
            store.operators.confirm(id, [one for one in ids if one != left_out])
        assert refused.value.message.code == "job.not-checked"
        (missing,) = refused.value.message.arguments["missing"]
        assert missing.arguments["id"] == left_out


def test_each_missing_check_refuses_the_first_start(store: Store) -> None:
    job = waiting(store)
    assert ids_of(store, job.id) == ["board", "sheet", "table-clear", "hands-clear"]
    refuse_each_missing(store, job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "wait"


def test_each_missing_check_refuses_the_next_copy(store: Store) -> None:
    job = fed(store, copies=2)
    between = GatewayReport(line=LINES, copies_done=1, held=True)
    store.gateways.heartbeat(job.id, job.epoch, between)
    assert ids_of(store, job.id) == ["board", "sheet", "table-clear", "hands-clear"]
    refuse_each_missing(store, job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, between) == "continue"


def test_a_job_that_is_claimed_again_needs_all_checks_again(store: Store) -> None:
    job = waiting(store)
    confirm(store, job.id)
    again = store.gateways.claim("table", "gateway", manual=True)
    assert again is not None
    refuse_each_missing(store, again.id)
    assert store.gateways.heartbeat(again.id, again.epoch, WAITING) == "wait"


def test_an_unknown_check_is_refused_with_the_known_ones(store: Store) -> None:
    job = waiting(store)
    with pytest.raises(RequestError, match=r"no check 'all'\. Its checks are board, sheet"):
        store.operators.confirm(job.id, ["all"])


def test_the_feed_states_its_checks_and_the_rest_is_left_to_a_person(store: Store) -> None:
    queued(store, copies=2)
    # The first sheet of a batch: a person confirms what the feed does not know.
    job = store.gateways.claim("table", "gateway", manual=False, feeds=True)
    assert job is not None
    assert ids_of(store, job.id) == ["board", "hands-clear"]
    refuse_each_missing(store, job.id)
    confirm(store, job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "start"
    between = GatewayReport(line=LINES, copies_done=1, held=True)
    assert store.gateways.heartbeat(job.id, job.epoch, between) == "resume"
    stated = [
        (event.who, str(event.message))
        for event in store.events.of_job(job.id)
        if event.message is not None and event.message.code == "job.stated-by-feed"
    ]
    text = (
        "The automatic sheet feed confirmed: sheet (a sheet of the stack lies in its place); "
        "table-clear (the sheet before it was removed)."
    )
    assert stated == [("operator", text), ("gateway gateway", text)]


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
    confirm(store, job.id)
    again = store.gateways.claim("table", "gateway", manual=True)
    assert again is not None
    assert store.gateways.heartbeat(again.id, again.epoch, WAITING) == "wait"


def test_a_waiting_claim_whose_gateway_falls_silent_is_given_back(
    store: Store, clock: Clock
) -> None:
    job = waiting(store)
    confirm(store, job.id)
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


def test_a_confirmation_does_not_start_the_machine_after_the_lease(
    store: Store, clock: Clock
) -> None:
    job = waiting(store)
    confirm(store, job.id)
    # The server was down; it takes no job back soon after its start.
    clock.now += LEASE + 0.1
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "wait"
    row = store.jobs.get(job.id)
    assert (row.state, row.confirmation, row.epoch) == ("queued", "awaited", job.epoch)
    assert str(store.events.of_job(job.id)[-1].message).endswith("confirmation of the operator.")
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "wait"
    confirm(store, job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "start"


def test_a_start_that_did_not_arrive_is_not_repeated_after_the_lease(
    store: Store, clock: Clock
) -> None:
    job = waiting(store)
    confirm(store, job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "start"
    clock.now += LEASE + 0.1
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "wait"
    assert store.jobs.get(job.id).state == "held"
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "wait"
    confirm(store, job.id)
    clock.now += LEASE + 0.1
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "wait"
    with pytest.raises(WrongState, match="has not confirmed"):
        store.operators.resume(job.id, hands_clear=True)
    confirm(store, job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "start"
    assert store.jobs.get(job.id).state == "running"


def test_a_resume_does_not_move_a_held_machine_after_the_lease(store: Store, clock: Clock) -> None:
    job = running(store)
    held = GatewayReport(line=7, held=True)
    store.gateways.heartbeat(job.id, job.epoch, held)
    store.operators.resume(job.id, hands_clear=True)
    clock.now += LEASE + 0.1
    assert store.gateways.heartbeat(job.id, job.epoch, held) == "continue"
    row = store.jobs.get(job.id)
    assert (row.state, row.requested_action) == ("held", "")
    store.operators.resume(job.id, hands_clear=True)
    assert store.gateways.heartbeat(job.id, job.epoch, held) == "resume"


def test_a_job_is_resumed_only_with_clear_hands(store: Store, clock: Clock) -> None:
    job = running(store)
    held = GatewayReport(line=7, held=True)
    store.gateways.heartbeat(job.id, job.epoch, held)

    def refusal() -> str:
        with pytest.raises(WrongState) as refused:
            store.operators.resume(job.id)
        assert hint(refused.value.message)
        assert store.jobs.get(job.id).requested_action == ""
        return refused.value.message.code

    assert refusal() == "operation.hands-not-clear"
    store.stations.state_hands_clear(job.machine)
    clock.now += 60.0
    assert refusal() == "operation.hands-not-clear"
    store.stations.state_hands_clear(job.machine)
    clock.now += 59.0
    store.gateways.heartbeat(job.id, job.epoch, held)
    assert store.operators.resume(job.id).requested_action == "resume"
    # A statement in the request itself counts, too.
    store.operators.hold(job.id)
    store.gateways.heartbeat(job.id, job.epoch, held)
    clock.now += 60.0
    store.gateways.heartbeat(job.id, job.epoch, held)
    assert refusal() == "operation.hands-not-clear"
    assert store.operators.resume(job.id, hands_clear=True).requested_action == "resume"


def test_a_statement_of_clear_hands_ends_when_a_job_goes_on(store: Store) -> None:
    job = running(store)
    held = GatewayReport(line=7, held=True)
    for stated in (True, False):
        store.gateways.heartbeat(job.id, job.epoch, held)
        store.stations.state_hands_clear(job.machine)
        store.operators.resume(job.id, hands_clear=stated)
        store.operators.hold(job.id)
        store.gateways.heartbeat(job.id, job.epoch, held)
        with pytest.raises(WrongState, match="hands are clear"):
            store.operators.resume(job.id)


def test_a_statement_of_clear_hands_ends_when_a_job_starts(store: Store) -> None:
    job = waiting(store)
    store.stations.state_hands_clear(job.machine)
    confirm(store, job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "start"
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=7, held=True))
    with pytest.raises(WrongState, match="hands are clear"):
        store.operators.resume(job.id)


@pytest.mark.parametrize("command", ["hold", "cancel"])
def test_a_request_to_stop_counts_after_the_lease(store: Store, clock: Clock, command: str) -> None:
    job = running(store)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=7))
    getattr(store.operators, command)(job.id)
    clock.now += LEASE + 0.1
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=8)) == command


def test_a_waiting_claim_that_has_run_out_is_not_confirmed_and_goes_to_another_gateway(
    store: Store, clock: Clock
) -> None:
    job = waiting(store)
    clock.now += LEASE + 0.1
    with pytest.raises(WrongState, match="does not respond"):
        confirm(store, job.id)
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
    events = len(store.events.of_job(job.id))
    again = store.gateways.finish(job.id, job.epoch, "returned")  # the answer was lost
    assert (again.state, again.confirmation, again.epoch) == ("queued", "", row.epoch)
    assert len(store.events.of_job(job.id)) == events
    assert store.gateways.claim("table", "another", manual=True) is not None
    with pytest.raises(StaleEpoch):
        store.gateways.finish(job.id, job.epoch, "returned")


def test_a_started_job_of_which_nothing_was_sent_is_queued_and_confirmed_again(
    store: Store,
) -> None:
    job = waiting(store)
    confirm(store, job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "start"
    assert store.jobs.get(job.id).started > 0.0
    reason = stored("The controller is not idle.")
    row = store.gateways.finish(job.id, job.epoch, "returned", reason, place=StopPlace(at_most=0))
    assert (row.state, row.confirmation, row.message) == ("queued", "", None)
    assert row.started == 0.0
    again = store.gateways.claim("table", "gateway", manual=True)
    assert again is not None
    assert (again.id, again.confirmation) == (job.id, "awaited")


def test_a_gateway_that_runs_without_a_confirmation_is_held_until_an_operator_confirms(
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
        store.operators.resume(job.id, hands_clear=True)
    confirm(store, job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=2, held=True)) == "resume"
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=3)) == "continue"


def test_a_hold_between_confirmation_and_start_keeps_the_machine_waiting(store: Store) -> None:
    job = fed(store)
    store.operators.hold(job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "wait"
    assert store.jobs.get(job.id).state == "held"
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "wait"
    with pytest.raises(WrongState, match="has not confirmed"):
        store.operators.resume(job.id, hands_clear=True)
    confirm(store, job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "start"
    assert store.jobs.get(job.id).state == "running"
    store.operators.cancel(job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "cancel"


def test_between_two_copies_a_resume_is_refused_and_the_next_sheet_confirmed(store: Store) -> None:
    job = fed(store, copies=2)
    between = GatewayReport(line=LINES, copies_done=1, held=True)
    assert store.gateways.heartbeat(job.id, job.epoch, between) == "continue"
    assert (store.jobs.get(job.id).state, store.jobs.get(job.id).confirmation) == ("held", "sheet")
    for phase in (None, 0):
        with pytest.raises(WrongState, match="waits for a new sheet") as refused:
            store.operators.resume(job.id, phase, hands_clear=True)
        assert "confirm the job" in refused.value.hint
    assert store.gateways.heartbeat(job.id, job.epoch, between) == "continue"
    assert confirm(store, job.id).requested_action == "resume"
    assert store.gateways.heartbeat(job.id, job.epoch, between) == "resume"
    assert (
        store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=1, copies_done=1))
        == "continue"
    )


def test_a_hold_in_the_last_second_of_a_copy_does_not_make_resume_start_the_next_one(
    store: Store,
) -> None:
    job = fed(store, copies=2)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=LINES - 1))
    store.operators.hold(job.id)
    # The copy has ended before the hold arrived.
    between = GatewayReport(line=LINES, copies_done=1, held=True, phase=1)
    assert store.gateways.heartbeat(job.id, job.epoch, between) == "continue"
    with pytest.raises(WrongState, match="waits for a new sheet"):
        store.operators.resume(job.id, hands_clear=True)
    assert store.gateways.heartbeat(job.id, job.epoch, between) == "continue"


def test_a_resume_on_its_way_when_the_copy_ends_does_not_start_the_next_one(store: Store) -> None:
    job = fed(store, copies=2)
    store.operators.hold(job.id)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=LINES - 1, held=True))
    store.operators.resume(job.id, hands_clear=True)
    between = GatewayReport(line=LINES, copies_done=1, held=True, phase=1)
    assert store.gateways.heartbeat(job.id, job.epoch, between) == "continue"
    assert store.jobs.get(job.id).confirmation == "sheet"


def test_a_hold_after_the_sheet_was_confirmed_needs_a_new_confirmation(store: Store) -> None:
    job = fed(store, copies=2)
    between = GatewayReport(line=LINES, copies_done=1, held=True, phase=1)
    store.gateways.heartbeat(job.id, job.epoch, between)
    confirm(store, job.id)
    store.operators.hold(job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, between) == "continue"
    with pytest.raises(WrongState, match="waits for a new sheet"):
        store.operators.resume(job.id, hands_clear=True)
    confirm(store, job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, between) == "resume"


def test_the_end_that_a_person_confirms_does_not_start_the_next_copy(store: Store) -> None:
    job = fed(store, copies=2)
    at_end = GatewayReport(line=0, held=True, phase=1, awaits_end=True)
    assert store.gateways.heartbeat(job.id, job.epoch, at_end) == "continue"
    with pytest.raises(WrongState, match="nothing to resume"):
        store.operators.resume(job.id, hands_clear=True)
    with pytest.raises(WrongState, match="has continued since"):
        store.operators.confirm_end(job.id, phase=0)
    assert store.operators.confirm_end(job.id, phase=1).requested_action == "end"
    assert store.gateways.heartbeat(job.id, job.epoch, at_end) == "end"
    between = GatewayReport(line=LINES, copies_done=1, held=True, phase=2)
    assert store.gateways.heartbeat(job.id, job.epoch, between) == "continue"
    for refused in (store.operators.resume, store.operators.confirm_end):
        with pytest.raises(WrongState):
            refused(job.id)
    confirm(store, job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, between) == "resume"


def test_a_copy_that_begins_without_its_sheet_confirmed_is_held(store: Store) -> None:
    job = fed(store, copies=2)
    assert (
        store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=1, copies_done=1)) == "hold"
    )
    assert (
        store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=2, copies_done=1)) == "hold"
    )
    confirm(store, job.id)
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
    store.interrupted.requeue(job.id)
    again = store.gateways.claim("table", "gateway", manual=True)
    assert again is not None
    assert again.id == job.id


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
    assert store.operators.resume(job.id, hands_clear=True).requested_action == "resume"
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=6, held=True)) == "resume"
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=7)) == "continue"
    assert store.jobs.get(job.id).state == "running"


def test_a_running_job_is_cancelled_by_its_gateway(store: Store) -> None:
    job = running(store)
    assert store.operators.cancel(job.id).state == "running"
    with pytest.raises(WrongState, match="being cancelled"):
        store.operators.resume(job.id, hands_clear=True)
    assert store.operators.cancel(job.id).requested_action == "cancel"
    assert store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=5)) == "cancel"
    assert store.gateways.finish(job.id, job.epoch, "cancelled").state == "cancelled"


def test_an_interrupted_job_cannot_be_cancelled_away_from_its_table(store: Store) -> None:
    job = running(store)
    store.gateways.finish(job.id, job.epoch, "interrupted", place=StopPlace(at_most=0))
    with pytest.raises(WrongState) as caught:
        store.operators.cancel(job.id)
    assert caught.value.hint == hint_of(store.jobs.get(job.id))
    assert caught.value.hint.startswith(
        "Look for the cause in the log of the gateway. Check the "
        "table. If the sheet is untouched and has not moved, continue it"
    )
