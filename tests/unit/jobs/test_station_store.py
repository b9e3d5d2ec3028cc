"""Reports on machines and operations of persons in the store: each is handed out once, or never."""

from __future__ import annotations

import pytest

from knifetip.errors import NoSuchJob, WrongState
from knifetip.jobs.station_store import OperationResult, StationReport
from knifetip.jobs.store import Store
from knifetip.messages import Message
from tests.support.job_states import running
from tests.support.stored import Clock

MACHINE = "table"
IDLE = StationReport(
    "gw", True, "idle", position=(1.0, 2.0, 20.0, 0.0), operations=("jog", "unlock", "stop_jog")
)
JOG = {"operation": "jog", "axis": "X", "distance": 10.0, "feed": 600.0}


@pytest.fixture
def reported(store: Store) -> Store:
    store.stations.report(MACHINE, IDLE)
    return store


def test_a_station_is_shown_as_its_gateway_reports_it(reported: Store, clock: Clock) -> None:
    clock.now += 2.5
    view = reported.stations.get(MACHINE)
    assert (view.row.gateway, view.row.state, view.row.connected) == ("gw", "idle", True)
    assert view.row.position == [1.0, 2.0, 20.0, 0.0]
    assert view.age == pytest.approx(2.5)
    assert view.alive
    clock.now += 4.0
    assert not reported.stations.get(MACHINE).alive


def test_a_machine_without_reports_is_not_connected(store: Store) -> None:
    view = store.stations.get(MACHINE)
    assert (view.age, view.alive, view.job) == (None, False, "")
    with pytest.raises(WrongState) as refused:
        store.stations.ask(MACHINE, JOG)
    assert refused.value.message.code == "operation.gateway-absent"


def test_an_operation_is_handed_out_once_with_its_age(reported: Store, clock: Clock) -> None:
    asked = reported.stations.ask(MACHINE, JOG)
    clock.now += 1.25
    (handed,) = reported.stations.hand_out(MACHINE)
    assert (handed.id, handed.request) == (asked.id, JOG)
    assert handed.age == pytest.approx(1.25)
    assert reported.stations.hand_out(MACHINE) == []
    assert reported.stations.operation(MACHINE, asked.id).state == "waiting"
    refusal = Message("operation.expired", seconds=3.0)
    reported.stations.report(MACHINE, IDLE, [OperationResult(asked.id, "refused", refusal)])
    row = reported.stations.operation(MACHINE, asked.id)
    assert (row.state, row.message) == ("refused", refusal)
    # A later result of the same operation changes nothing.
    reported.stations.report(MACHINE, IDLE, [OperationResult(asked.id, "done")])
    assert reported.stations.operation(MACHINE, asked.id).state == "refused"


@pytest.mark.parametrize("seconds", [3.0, 60.0, -5.0])
def test_a_late_operation_is_never_handed_out(
    reported: Store, clock: Clock, seconds: float
) -> None:
    """A negative age means that the computer was started again since the operation was asked."""
    asked = reported.stations.ask(MACHINE, JOG)
    clock.now += seconds
    assert reported.stations.hand_out(MACHINE) == []
    row = reported.stations.operation(MACHINE, asked.id)
    assert row.state == "expired"
    assert row.message is not None
    assert row.message.code == "operation.expired"
    clock.now -= seconds
    assert reported.stations.hand_out(MACHINE) == []


def test_an_operation_expires_without_its_gateway(reported: Store, clock: Clock) -> None:
    asked = reported.stations.ask(MACHINE, JOG)
    clock.now += 2.9
    assert reported.stations.operation(MACHINE, asked.id).state == "waiting"
    clock.now += 0.2
    assert reported.stations.operation(MACHINE, asked.id).state == "expired"


def test_an_operation_whose_gateway_falls_silent_has_no_result(
    reported: Store, clock: Clock
) -> None:
    asked = reported.stations.ask(MACHINE, JOG)
    reported.stations.hand_out(MACHINE)
    clock.now += 5.0
    assert reported.stations.operation(MACHINE, asked.id).state == "waiting"
    clock.now += 5.0
    row = reported.stations.operation(MACHINE, asked.id)
    assert row.state == "expired"
    assert row.message == Message("operation.no-result")


def test_nothing_can_be_asked_of_a_machine_that_runs_a_job(reported: Store) -> None:
    job = running(reported)
    with pytest.raises(WrongState) as refused:
        reported.stations.ask(MACHINE, JOG)
    assert refused.value.message.code == "operation.job-running"
    assert reported.stations.get(MACHINE).job == job.id
    assert reported.stations.hand_out(MACHINE) == []


def test_only_what_the_controller_can_do_is_asked(reported: Store) -> None:
    with pytest.raises(WrongState) as refused:
        reported.stations.ask(MACHINE, {"operation": "home"})
    assert refused.value.message.code == "operation.unsupported"
    reported.stations.report(MACHINE, StationReport("gw", False, ""))
    with pytest.raises(WrongState) as refused:
        reported.stations.ask(MACHINE, JOG)
    assert refused.value.message.code == "operation.no-controller"


def test_operations_belong_to_their_machine_and_are_removed_later(
    reported: Store, clock: Clock
) -> None:
    asked = reported.stations.ask(MACHINE, JOG)
    with pytest.raises(NoSuchJob):
        reported.stations.operation("router-table", asked.id)
    assert reported.stations.hand_out("router-table") == []
    clock.now += 700.0
    reported.stations.report(MACHINE, IDLE)
    reported.stations.ask(MACHINE, JOG)
    with pytest.raises(NoSuchJob):
        reported.stations.operation(MACHINE, asked.id)


def test_a_machine_is_watched_for_a_while_after_a_look(reported: Store, clock: Clock) -> None:
    assert not reported.stations.is_watched(MACHINE)
    reported.stations.get(MACHINE)
    clock.now += 11.0
    assert reported.stations.is_watched(MACHINE)
    clock.now += 2.0
    assert not reported.stations.is_watched(MACHINE)
