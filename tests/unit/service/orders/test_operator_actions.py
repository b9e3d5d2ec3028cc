"""Allowed actions: every listed action is accepted in its state, and every other one is refused."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest

from knifetip.contract.job import OPERATOR, State
from knifetip.errors import WrongState
from knifetip.service.database.tables import Job
from knifetip.service.gateways.heartbeats import GatewayReport
from knifetip.service.orders.operator_actions import OperatorAction, allowed_actions
from knifetip.service.orders.store import Continuation
from knifetip.service.processes.compile_result import CompileResult, VerdictColumns
from knifetip.service.processes.rest_record import ExecutedWork, RestRecord
from knifetip.service.store import Store
from tests.support.job_states import confirm
from tests.support.messages import stored
from tests.support.stored import add_job, migrated_store

LINES = 90
WAITING = GatewayReport(line=0, waiting=True)


@pytest.fixture
def store(migrated_url: str) -> Iterator[Store]:
    with migrated_store(migrated_url) as store:
        yield store


def received(store: Store) -> str:
    return add_job(store, machine="table", copies=2).id


def compiling(store: Store) -> str:
    id = received(store)
    store.compiles.begin("worker")
    return id


def compiled(store: Store, *, accepted: bool = True) -> str:
    id = compiling(store)
    refusal = None if accepted else stored("Edge 3 is 0.4 mm off.")
    found = 0 if accepted else 1
    verdict = {"seconds": 1.0, "accepted": accepted, "faults": found, "shortfalls": found}
    result = CompileResult(accepted, refusal, b"M30\n", "ab", LINES, b"", b"", verdict)
    store.compiles.save_result(id, store.jobs.get(id).epoch, result)
    return id


def refused(store: Store) -> str:
    """Return a job that is refused for a fault and a shortfall."""
    return compiled(store, accepted=False)


def short(store: Store) -> str:
    """Return a job that is refused only for a shortfall."""
    id = compiling(store)
    summary = {"seconds": 1.0, "accepted": False, "faults": 0, "shortfalls": 1}
    result = CompileResult(
        False, stored("A slit is wide."), b"M30\n", "ab", LINES, b"", b"", summary
    )
    store.compiles.save_result(id, store.jobs.get(id).epoch, result)
    return id


def accept(store: Store, id: str) -> Job:
    columns = VerdictColumns(b"", {"seconds": 1.0, "accepted": True}, None, [], [])
    return store.programs.accept(
        id, lambda _block, _summary: columns, OPERATOR, stored("Accepted.")
    )


def queued(store: Store) -> str:
    return store.programs.release(compiled(store)).id


def claimed(store: Store, *, manual: bool = True) -> str:
    id = queued(store)
    assert store.gateways.claim("table", "gateway", manual=manual) is not None
    return id


def report(store: Store, id: str, progress: GatewayReport) -> None:
    store.gateways.heartbeat(id, store.jobs.get(id).epoch, progress)


def ended(store: Store, id: str, outcome: str, line: int = 5, copies_done: int = 0) -> str:
    epoch = store.jobs.get(id).epoch
    store.gateways.finish(id, epoch, outcome, line=line, copies_done=copies_done)
    return id


def running(store: Store) -> str:
    return claimed(store, manual=False)


def refused_in_check(store: Store) -> str:
    return ended(store, running(store), "refused", 0)


def running_unconfirmed(store: Store) -> str:
    id = claimed(store)
    report(store, id, GatewayReport(line=1))
    return id


def hold_requested(store: Store) -> str:
    return store.operators.hold(running(store)).id


def held(store: Store) -> str:
    id = hold_requested(store)
    report(store, id, GatewayReport(line=5, held=True))
    return id


def resume_requested(store: Store) -> str:
    return store.operators.resume(held(store), hands_clear=True).id


def needing_sheet(store: Store) -> str:
    id = claimed(store)
    confirm(store, id)
    report(store, id, WAITING)
    report(store, id, GatewayReport(line=LINES, copies_done=1, held=True))
    return id


def awaiting_end(store: Store) -> str:
    id = claimed(store)
    confirm(store, id)
    report(store, id, WAITING)
    report(store, id, GatewayReport(line=0, held=True, phase=1, awaits_end=True))
    return id


def cancel_requested(store: Store) -> str:
    return store.operators.cancel(running(store)).id


def interrupted(store: Store) -> str:
    return ended(store, running(store), "interrupted")


def executed(store: Store) -> str:
    return ended(store, running(store), "interrupted", LINES, 1)


def done(store: Store) -> str:
    return ended(store, running(store), "done")


def scrapped(store: Store) -> str:
    return store.interrupted.scrap(interrupted(store)).id


def continued(store: Store) -> str:
    id = interrupted(store)
    rest_of(store, id)
    return id


def interrupted_rest(store: Store) -> str:
    id = rest_of(store, interrupted(store))
    assert store.gateways.claim("table", "gateway", manual=False) is not None
    confirm(store, id)
    report(store, id, WAITING)
    return ended(store, id, "interrupted")


def rest_of(store: Store, id: str) -> str:
    """Return a queued job that makes the rest of the sheet of an interrupted job."""
    record = RestRecord(((1, 4),), (ExecutedWork(id, ((1, 3),)),))
    line = store.jobs.get(id).line
    rest = store.jobs.add_continuation(id, Continuation(record, line, release=True)).id
    store.compiles.begin("worker")
    verdict = {"seconds": 1.0, "accepted": True, "faults": 0, "shortfalls": 0}
    result = CompileResult(True, None, b"M30\n", "ab", LINES, b"", b"", verdict)
    store.compiles.save_result(rest, store.jobs.get(rest).epoch, result)
    return rest


def cancelled(store: Store) -> str:
    return store.operators.cancel(received(store)).id


Make = Callable[[Store], str]
EXPECTED: dict[Make, tuple[State, str]] = {
    received: (State.RECEIVED, "cancel"),
    compiling: (State.COMPILING, "cancel"),
    compiled: (State.READY, "release recompile cancel"),
    refused: (State.REFUSED, ""),
    short: (State.REFUSED, "accept"),
    queued: (State.QUEUED, "recompile cancel"),
    refused_in_check: (State.QUEUED, "recheck recompile cancel"),
    claimed: (State.QUEUED, "confirm recompile cancel"),
    running: (State.RUNNING, "hold cancel"),
    running_unconfirmed: (State.RUNNING, "confirm hold cancel"),
    hold_requested: (State.RUNNING, "hold resume cancel"),
    held: (State.HELD, "resume cancel"),
    resume_requested: (State.HELD, "hold resume cancel"),
    needing_sheet: (State.HELD, "confirm cancel"),
    awaiting_end: (State.HELD, "end cancel"),
    cancel_requested: (State.RUNNING, "cancel"),
    interrupted: (State.INTERRUPTED, "rest requeue finish scrap"),
    executed: (State.INTERRUPTED, "rest finish scrap"),
    interrupted_rest: (State.INTERRUPTED, "rest finish scrap"),
    done: (State.DONE, "rest"),
    scrapped: (State.SCRAPPED, "rest"),
    continued: (State.CONTINUED, "rest"),
    cancelled: (State.CANCELLED, ""),
}
METHODS: dict[OperatorAction, Callable[[Store, str], Job]] = {
    OperatorAction.ACCEPT: accept,
    OperatorAction.RECOMPILE: lambda store, id: store.programs.recompile(id),
    OperatorAction.RELEASE: lambda store, id: store.programs.release(id),
    OperatorAction.CONFIRM: lambda store, id: confirm(store, id),
    OperatorAction.HOLD: lambda store, id: store.operators.hold(id),
    OperatorAction.RESUME: lambda store, id: store.operators.resume(id, hands_clear=True),
    OperatorAction.END: lambda store, id: store.operators.confirm_end(id),
    OperatorAction.REST: lambda store, id: store.jobs.add_continuation(id, Continuation(None)),
    OperatorAction.RECHECK: lambda store, id: store.programs.recheck(id),
    OperatorAction.REQUEUE: lambda store, id: store.interrupted.requeue(id),
    OperatorAction.FINISH: lambda store, id: store.interrupted.declare_finished(id),
    OperatorAction.SCRAP: lambda store, id: store.interrupted.scrap(id),
    OperatorAction.CANCEL: lambda store, id: store.operators.cancel(id),
}


def test_every_state_and_every_action_is_covered() -> None:
    assert {state for state, _ in EXPECTED.values()} == set(State)
    assert METHODS.keys() == set(OperatorAction)


#: Actions that a client may repeat after a lost answer: they succeed and change nothing.
REPEATED = {
    *(
        (state, OperatorAction.RELEASE)
        for state in (State.QUEUED, State.RUNNING, State.HELD, State.DONE)
    ),
    (State.HELD, OperatorAction.HOLD),
    (State.CANCELLED, OperatorAction.CANCEL),
    (State.SCRAPPED, OperatorAction.SCRAP),
    (State.DONE, OperatorAction.FINISH),
}


@pytest.mark.parametrize("make", EXPECTED)
def test_the_allowed_actions_of_a_state_are_listed_and_every_other_one_is_refused(
    store: Store, make: Make
) -> None:
    state, actions = EXPECTED[make]
    id = make(store)
    before = store.jobs.get(id)
    listed = [action.value for action in allowed_actions(before, store.database.clock())]
    assert (before.state, listed) == (state, actions.split())
    events = len(store.events.of_job(id))
    for action in set(OperatorAction).difference(listed):
        if (State(before.state), action) in REPEATED:
            METHODS[action](store, id)
        else:
            with pytest.raises(WrongState):
                METHODS[action](store, id)
        after = store.jobs.get(id)
        assert (after.state, after.requested_action) == (before.state, before.requested_action)
        assert len(store.events.of_job(id)) == events, action


LISTED = [(make, action) for make, (_, actions) in EXPECTED.items() for action in actions.split()]


@pytest.mark.parametrize(("make", "action"), LISTED)
def test_a_listed_action_is_accepted(store: Store, make: Make, action: str) -> None:
    METHODS[OperatorAction(action)](store, make(store))


def test_a_claim_whose_gateway_is_silent_cannot_be_confirmed(store: Store) -> None:
    row = store.jobs.get(claimed(store))
    allowed = allowed_actions(row, row.lease + 0.1)
    assert allowed == [OperatorAction.RECOMPILE, OperatorAction.CANCEL]
