"""Reports on machines and operations of persons in the store: each is handed out once, or never."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from knifetip.errors import NotFound, WrongState
from knifetip.messages import Message, hint
from knifetip.service.gateways.heartbeats import GatewayReport
from knifetip.service.machines.station_store import OperationResult, StationReport
from knifetip.service.store import Store
from tests.support.controller_states import STATES
from tests.support.job_states import (
    WAITING,
    confirm,
    fed,
    queued,
    running,
    waiting,
)
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


def test_the_feed_may_be_changed_while_a_job_runs(store: Store) -> None:
    can = (*IDLE.operations, "feed_override")
    store.stations.report(MACHINE, replace(IDLE, operations=can, override=90))
    assert store.stations.get(MACHINE).row.override == 90
    running(store)
    asked = store.stations.ask(MACHINE, {"operation": "feed_override", "percent": 80})
    assert [one.id for one in store.stations.hand_out(MACHINE)] == [asked.id]
    with pytest.raises(WrongState) as refused:
        store.stations.ask(MACHINE, JOG)
    assert refused.value.message.code == "operation.job-running"


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
    with pytest.raises(NotFound):
        reported.stations.operation("router-table", asked.id)
    assert reported.stations.hand_out("router-table") == []
    clock.now += 700.0
    reported.stations.report(MACHINE, IDLE)
    reported.stations.ask(MACHINE, JOG)
    with pytest.raises(NotFound):
        reported.stations.operation(MACHINE, asked.id)


def test_a_machine_is_watched_for_a_while_after_a_look(reported: Store, clock: Clock) -> None:
    assert not reported.stations.is_watched(MACHINE)
    reported.stations.get(MACHINE)
    clock.now += 11.0
    assert reported.stations.is_watched(MACHINE)
    clock.now += 2.0
    assert not reported.stations.is_watched(MACHINE)


DRY = {"operation": "dry_run", "share": 0.5}
ABLE = replace(IDLE, operations=("dry_run", "frame", "hold", "resume", "stop_jog"))


def test_a_run_above_the_board_needs_a_job_that_waits(store: Store) -> None:
    store.stations.report(MACHINE, ABLE)
    with pytest.raises(WrongState) as refused:
        store.stations.ask(MACHINE, DRY, hands_clear=True)
    assert refused.value.message.code == "dry-run.no-job"
    job = waiting(store)
    assert store.stations.waiting_job(MACHINE) is not None
    store.stations.ask(MACHINE, DRY, hands_clear=True)
    assert [one.request for one in store.stations.hand_out(MACHINE)] == [DRY]
    store.operators.cancel(job.id)
    assert store.stations.waiting_job(MACHINE) is None


@pytest.mark.parametrize("state", ["asked", "running", "held"])
def test_a_job_is_not_started_while_its_machine_runs_above_the_board(
    store: Store, clock: Clock, state: str
) -> None:
    store.stations.report(MACHINE, ABLE)
    job = waiting(store)
    if state == "asked":
        store.stations.ask(MACHINE, DRY, hands_clear=True)
    else:
        activity = {"kind": "dry_run", "job": job.id, "state": state}
        store.stations.report(MACHINE, replace(ABLE, activity=activity))
    with pytest.raises(WrongState) as refused:
        confirm(store, job.id)
    assert refused.value.message.code == "dry-run.in-progress"
    assert store.jobs.get(job.id).confirmation == "awaited"
    clock.now += 7.0  # the gateway is silent, so the run has stopped
    store.gateways.heartbeat(job.id, job.epoch, WAITING)
    assert confirm(store, job.id).confirmation == "given"


@pytest.mark.parametrize("state", ["done", "stopped", "failed"])
def test_a_run_above_the_board_that_has_ended_does_not_hinder_the_start(
    store: Store, state: str
) -> None:
    job = waiting(store)
    activity = {"kind": "frame", "job": job.id, "state": state}
    store.stations.report(MACHINE, replace(ABLE, activity=activity))
    assert store.stations.get(MACHINE).row.activity == activity
    assert confirm(store, job.id).confirmation == "given"


#: Arguments of the messages besides the name of the controller.
ARGUMENTS: dict[str, dict[str, Any]] = {
    "controller.in-alarm": {"code": 1, "alarm": Message("grbl.alarm-1")},
    "linuxcnc.not-homed": {"joints": ["1"]},
    "obstacle.limit-pressed": {"axes": ["X"]},
}
OBSTACLES = sorted({one.free.code for one in STATES} - {""})


@pytest.mark.parametrize("code", OBSTACLES)
@pytest.mark.parametrize("following", [False, True])
def test_no_copy_is_started_while_an_alarm_or_obstacle_is_in_the_way(
    store: Store, clock: Clock, code: str, *, following: bool
) -> None:
    message = Message(code, name="grbl", **ARGUMENTS.get(code, {}))
    if following:
        job = fed(store, copies=2)
        between = GatewayReport(line=job.lines, copies_done=1, held=True)
        store.gateways.heartbeat(job.id, job.epoch, between)
        assert store.jobs.get(job.id).confirmation == "sheet"
    else:
        job = waiting(store)
    is_obstacle = code.startswith("obstacle.")
    blocked = replace(
        IDLE,
        obstacle=message if is_obstacle else None,
        alarm=None if is_obstacle else message,
    )
    store.stations.report(MACHINE, blocked)
    with pytest.raises(WrongState) as refused:
        confirm(store, job.id)
    assert refused.value.message.code == "job.machine-not-free"
    assert str(message) in str(refused.value.message)
    assert hint(refused.value.message) == hint(message)
    assert store.jobs.get(job.id).confirmation == ("sheet" if following else "awaited")
    clock.now += 1.5  # the machine is freed
    store.stations.report(MACHINE, IDLE)
    assert confirm(store, job.id).confirmation == "given"


def test_a_job_that_went_back_to_the_queue_is_refused_with_the_obstacle(store: Store) -> None:
    job = queued(store)
    store.stations.report(MACHINE, replace(IDLE, obstacle=Message("obstacle.held", name="grbl")))
    with pytest.raises(WrongState) as refused:
        confirm(store, job.id)
    assert refused.value.message.code == "job.machine-not-free"


def test_a_machine_that_feeds_its_sheets_waits_for_a_person_if_something_is_in_the_way(
    store: Store,
) -> None:
    queued(store, copies=3)
    job = store.gateways.claim(MACHINE, "gateway", manual=False, feeds=True)
    assert job is not None
    confirm(store, job.id)
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "start"
    store.stations.report(MACHINE, replace(IDLE, obstacle=Message("obstacle.held", name="grbl")))
    between = GatewayReport(line=job.lines, copies_done=1, held=True)
    assert store.gateways.heartbeat(job.id, job.epoch, between) == "continue"
    assert store.jobs.get(job.id).confirmation == "sheet"


def test_a_controller_that_reports_nothing_refuses_with_a_hint(store: Store) -> None:
    store.stations.report(MACHINE, StationReport("gw", True, "unreported"))
    with pytest.raises(WrongState) as refused:
        store.stations.ask(MACHINE, DRY, hands_clear=True)
    assert refused.value.message.code == "operation.unreported"
    assert hint(refused.value.message)


MOVES: list[dict[str, Any]] = [
    {"operation": "home"},
    {"operation": "zero", "axes": "XY"},
    {"operation": "park"},
    {"operation": "frame"},
    {"operation": "dry_run", "share": 0.5},
    {"operation": "tool_check", "station": 1, "point": [0.0, 0.0]},
    {"operation": "resume"},
    {"operation": "switch", "output": 1, "on": True},
    {"operation": "spindle", "station": 1, "on": True},
]
STAYS: list[dict[str, Any]] = [
    {"operation": "unlock"},
    {"operation": "stop_jog"},
    {"operation": "lift"},
    {"operation": "hold"},
    {"operation": "switch", "output": 1, "on": False},
    {"operation": "spindle", "station": 1, "on": False},
    JOG,
]


def report_able(store: Store) -> None:
    """Report a controller that can do everything."""
    names = sorted({one["operation"] for one in MOVES + STAYS})
    store.stations.report(MACHINE, StationReport("gw", True, "idle", operations=names))


@pytest.mark.parametrize("request_", MOVES, ids=lambda one: str(one["operation"]))
def test_what_moves_the_machine_needs_hands_clear_of_the_last_minute(
    store: Store, clock: Clock, request_: dict[str, Any]
) -> None:
    report_able(store)
    waiting(store)
    with pytest.raises(WrongState) as refused:
        store.stations.ask(MACHINE, request_)
    assert refused.value.message.code == "operation.hands-not-clear"
    assert "press Hands clear" in refused.value.hint
    assert store.stations.hand_out(MACHINE) == []
    assert store.stations.state_hands_clear(MACHINE) == 60.0
    clock.now += 59.0
    report_able(store)
    store.stations.ask(MACHINE, request_)
    clock.now += 1.5
    report_able(store)
    with pytest.raises(WrongState, match="hands are clear"):
        store.stations.ask(MACHINE, request_)
    store.stations.ask(MACHINE, request_, hands_clear=True)
    # The statement in a request counts for no other one.
    with pytest.raises(WrongState, match="hands are clear"):
        store.stations.ask(MACHINE, request_)
    # A statement that was withdrawn counts no more.
    store.stations.state_hands_clear(MACHINE)
    store.stations.withdraw_hands_clear(MACHINE)
    with pytest.raises(WrongState, match="hands are clear"):
        store.stations.ask(MACHINE, request_)


@pytest.mark.parametrize(
    "request_", STAYS, ids=lambda one: f"{one['operation']} {one.get('on', '')}".strip()
)
def test_what_stops_or_is_held_by_hand_needs_no_statement(
    store: Store, request_: dict[str, Any]
) -> None:
    report_able(store)
    waiting(store)
    assert store.stations.ask(MACHINE, request_).state == "waiting"


def test_a_jog_is_renewed_while_its_button_is_held(reported: Store, clock: Clock) -> None:
    stations = reported.stations
    id = stations.ask(MACHINE, JOG).id
    clock.now += 0.25
    held = stations.held_jog(MACHINE)
    assert held is not None
    assert held.id == id
    assert held.age == pytest.approx(0.25)
    clock.now += 0.5
    assert stations.renew(MACHINE, id).id == id
    held = stations.held_jog(MACHINE)
    assert held is not None
    assert held.age == 0.0
    # Nobody held it for a second: it does not begin again.
    clock.now += 1.25
    assert stations.held_jog(MACHINE) is None
    with pytest.raises(WrongState) as refused:
        stations.renew(MACHINE, id)
    assert refused.value.message.code == "operation.jog-ended"


def test_only_a_jog_is_renewed(reported: Store) -> None:
    id = reported.stations.ask(MACHINE, {"operation": "unlock"}).id
    with pytest.raises(WrongState):
        reported.stations.renew(MACHINE, id)
    with pytest.raises(NotFound):
        reported.stations.renew(MACHINE, "nothing")
