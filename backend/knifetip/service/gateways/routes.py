"""Routes for gateways: claim a job, download its program, send heartbeats and finish the job.

A gateway also reports the state of its machine, and gets the operations that a person at the
machine has asked for.

A gateway is a program that fetches jobs from the server and controls one machine.
"""

from __future__ import annotations

import time
from functools import partial
from typing import Any

from fastapi import Request, Response
from fastapi.responses import PlainTextResponse

from knifetip.contract.job import ON_TABLE, State
from knifetip.errors import AccessDenied, MachineBusy, StaleVersion, WrongState
from knifetip.library.definition import Shelf, machine_of
from knifetip.messages import Message
from knifetip.messages.codes import STORED
from knifetip.model.machine import Machine
from knifetip.service.components import Service, ServiceDep
from knifetip.service.database.acting import acting_owner
from knifetip.service.database.change_event import event_on_change
from knifetip.service.database.change_notifier import machine_topic
from knifetip.service.database.tables import Job
from knifetip.service.gateways.heartbeats import GatewayReport
from knifetip.service.gateways.models import Claim, ClaimIn, FinishIn, HeartbeatIn, HeartbeatOut
from knifetip.service.http.conditional import NOT_MODIFIED
from knifetip.service.http.downloads import bytes_response
from knifetip.service.http.message_models import MessageIn
from knifetip.service.http.parameters import JobId
from knifetip.service.http.principal import bind_to_machine, permission_of, principal_of
from knifetip.service.http.routing import ScopedRouter, requires, unaudited
from knifetip.service.http.scopes import AccessScope
from knifetip.service.lifecycle.transitions import LEASE
from knifetip.service.machines.station_models import ActivityIn, StationAnswer, StationIn
from knifetip.service.machines.station_store import (
    HeldJog,
    OperationResult,
    RequestedOperation,
    StationReport,
)
from knifetip.service.orders.job_answers import job_out
from knifetip.service.orders.models import JobOut
from knifetip.service.runs.stop_place import StopPlace
from knifetip.service.tools.routes import worn_stations

router = ScopedRouter(prefix="/gateway", tags=["gateway"])

_QUEUE_POLL = 2.0  # seconds between two queries of the queue for changes by other servers
_CONTACT_INTERVAL = 2.0  # seconds between two records of a gateway's contact
# Seconds between two queries for operations that were asked of other servers, while a person looks
# at the machine, and otherwise.
_OPERATION_POLL, _IDLE_POLL = 0.3, 1.0


@router.post("/claim", response_model=Claim, responses={204: {"description": "No job"}})
@requires(AccessScope.GATEWAY)
@unaudited
async def claim(service: ServiceDep, request: Request, claimant: ClaimIn) -> Claim | Response:
    """Claim the next job of a machine for a gateway, and wait for one if there is none yet.

    The status is 204 if no job is available within ``wait`` seconds, a field of the request.  If
    ``confirm`` is true in the response, the gateway must send nothing to the machine before the
    operator confirms the job.  The status is 412 if the machine has changed since the gateway
    loaded its definition.
    """
    await _check_machine(service, request, claimant.machine)
    deadline = time.monotonic() + claimant.wait
    recorded_at = -_CONTACT_INTERVAL
    permission = permission_of(request)
    with event_on_change(service.store.changes, machine_topic(claimant.machine)) as changed:
        while not service.stopping.is_set():
            if time.monotonic() - recorded_at >= _CONTACT_INTERVAL:
                recorded_at = time.monotonic()
                await service.threads.claims(
                    service.store.machines.record_contact, claimant.machine, claimant.gateway
                )
            # A disconnected gateway would never start the job; one with a revoked key must not.
            if await request.is_disconnected() or not await permission():
                break
            job = await service.threads.claims(_claim_next, service, claimant)
            if job is not None:
                return Claim(
                    job=job.id,
                    epoch=job.epoch,
                    lease=LEASE,
                    program=f"/api/gateway/program/{job.id}",
                    sha256=job.program_sha256,
                    lines=job.lines,
                    copies=job.copies - job.copies_done,
                    seconds=job.seconds,
                    confirm=job.state == State.QUEUED,
                    traceparent=job.traceparent,
                )
            remaining = deadline - time.monotonic()
            if remaining <= 0:
                break
            await changed.wait(min(_QUEUE_POLL, remaining))
    return Response(status_code=204)


async def _check_machine(service: Service, request: Request, machine: str) -> None:
    """Raise ``AccessDenied`` if the key of a gateway is for another machine.

    A key without a machine is bound to the one for which it is used first.
    """
    principal = principal_of(request)
    principal.limits.check_machine(machine)
    if principal.binds and not principal.limits.machines:
        await service.threads.reports(service.store.library.definition, Shelf.MACHINES, machine)
        await service.threads.reports(service.store.keys.bind, principal.id, machine)
        request.app.state.accounts.clear_cache()
        # A claim that waits is permitted as long as its principal stays the same.
        bind_to_machine(request, machine)


def _current_machine(service: ServiceDep, claimant: ClaimIn) -> Machine:
    """Return the machine of a gateway.

    Raises ``LibraryError``: there is no such machine.
    Raises ``StaleVersion``: the machine has changed since the gateway loaded its definition.
    """
    machine = service.store.library.definition(Shelf.MACHINES, claimant.machine)
    if claimant.machine_version not in (None, machine.version):
        raise StaleVersion(
            "gateway.outdated-machine",
            gateway=claimant.gateway,
            machine=claimant.machine,
            version=claimant.machine_version,
            newest=machine.version,
        )
    return machine_of(machine)


def _claim_next(service: ServiceDep, claimant: ClaimIn) -> Job | None:
    manual = _current_machine(service, claimant).feed == "manual"
    try:
        if not manual and service.store.stations.was_operated(claimant.machine):
            return None  # no job starts by itself while a person uses the machine
        return service.store.gateways.claim(
            claimant.machine,
            claimant.gateway,
            manual=manual,
            feeds=not manual,
            announces=claimant.announces_begin,
            worn=partial(worn_stations, service),
        )
    except MachineBusy:
        return None


@router.get("/program/{id}", response_class=PlainTextResponse, responses=NOT_MODIFIED)
@requires(AccessScope.GATEWAY)
async def get_gateway_program(service: ServiceDep, id: JobId) -> Response:
    """Download the program of a job that the gateway has claimed with its key."""
    job = await service.threads.claims(service.store.jobs.get, id)
    if job.state not in ON_TABLE and not job.confirmation:
        raise WrongState("job.not-running", job=id, state=job.state)
    if job.claimed_by != acting_owner():
        raise AccessDenied("gateway.not-claimed", job=id)
    text = await service.threads.claims(service.store.jobs.column, id, "program")
    return bytes_response(text, job.program_sha256, "text/plain; charset=utf-8")


@router.post("/heartbeat")
@requires(AccessScope.GATEWAY)
@unaudited
async def heartbeat(service: ServiceDep, report: HeartbeatIn) -> HeartbeatOut:
    """Report the progress of a job, renew its lease and get the next command for the machine.

    The lease is the time for which a gateway owns the job without a new heartbeat.
    """
    command = await service.threads.reports(
        service.store.gateways.heartbeat,
        report.job,
        report.epoch,
        GatewayReport(
            line=report.line,
            copies_done=report.copies_done,
            held=report.held,
            waiting=report.waiting,
            position=report.position,
            seconds_left=report.seconds_left,
            phase=report.phase,
            awaits_end=report.awaits_end,
            begun=report.begun,
        ),
        partial(worn_stations, service),
    )
    return HeartbeatOut.model_validate({"command": command, "lease": LEASE})


@router.post("/finish")
@requires(AccessScope.GATEWAY)
async def finish(service: ServiceDep, report: FinishIn) -> JobOut:
    """Report that a job has ended, with its outcome.

    The server interrupts a job if it receives no heartbeats from the gateway.  The gateway may
    still report the end of the interrupted job: the outcome ``done`` ends the job, ``returned`` and
    ``refused`` put it back into the queue if no program line was executed, and any other outcome
    corrects the last executed line and the message of the job.
    """
    return await service.threads.reports(_finish_job, service, report)


@router.post("/station")
@requires(AccessScope.GATEWAY)
@unaudited
async def report_station(
    service: ServiceDep, request: Request, station: StationIn
) -> StationAnswer:
    """Report the state of a machine, and get the operations that a person has asked for.

    The response is sent as soon as there is an operation or a person begins to look at the machine,
    at the latest after ``wait`` seconds, a field of the request.  Each operation is sent only once,
    and only if it is younger than 3 s.
    """
    await _check_machine(service, request, station.machine)
    began = time.monotonic()
    threads = service.threads
    changes = service.store.changes
    with event_on_change(changes, machine_topic(station.machine)) as changed:
        watched = await threads.reports(_store_report, service, station)
        poll = changes.poll(_OPERATION_POLL if watched else _IDLE_POLL)
        while True:
            # A disconnected gateway would never execute the operation.
            gone = service.stopping.is_set() or await request.is_disconnected()
            asked: list[RequestedOperation] = []
            looked, jog = watched, None
            if not gone:
                asked, looked, jog = await threads.reports(
                    _requests_of_persons, service, station.machine
                )
            remaining = began + station.wait - time.monotonic()
            # A person who begins to look at the machine should not see an old report.
            renewed = jog is not None and jog.age < time.monotonic() - began
            if gone or asked or renewed or (looked and not watched) or remaining <= 0.0:
                break
            await changed.wait(min(poll, remaining))
    return StationAnswer.model_validate(
        {
            "operations": [{**one.request, "id": one.id, "age": one.age} for one in asked],
            "waited": time.monotonic() - began,
            "watched": looked,
            "jog": None if jog is None else {"id": jog.id, "age": jog.age},
        }
    )


def _store_report(service: Service, station: StationIn) -> bool:
    """Store the state of a machine; return whether a person looks at the machine.

    Raises ``NotFound``: there is no such machine.
    """
    service.store.library.definition(Shelf.MACHINES, station.machine)
    report = StationReport(
        station.gateway,
        station.connected,
        station.state,
        None if station.alarm is None else station.alarm.message,
        station.position,
        station.outputs,
        station.operations,
        None if station.activity is None else _activity(station.activity),
        station.spindle,
        [notice.message for notice in station.notices],
        None if station.obstacle is None else station.obstacle.message,
        station.override,
        station.outputs_known,
    )
    results = [
        OperationResult(
            result.id,
            result.state,
            None if result.message is None else result.message.message,
        )
        for result in station.results
    ]
    service.store.stations.report(station.machine, report, results)
    return service.store.stations.is_watched(station.machine)


def _requests_of_persons(
    service: Service, machine: str
) -> tuple[list[RequestedOperation], bool, HeldJog | None]:
    """Return what the persons at a machine have requested.

    Returns the operations that wait for it, whether a person looks at it, and the jog that a person
    holds.
    """
    stations = service.store.stations
    return stations.hand_out(machine), stations.is_watched(machine), stations.held_jog(machine)


def _activity(reported: ActivityIn) -> dict[str, Any]:
    """Return a run above the board as the database stores it."""
    message = None if reported.message is None else reported.message.message
    stored = reported.model_dump(mode="json", exclude={"message"})
    return stored | {"message": None if message is None else message.as_json()}


def _cause(reported: str | MessageIn) -> Message | None:
    """Return the cause that a gateway reported for the end of a job; None if it reported none.

    ``reported``: the cause as a message, or as plain text; "" for no cause.
    """
    if isinstance(reported, MessageIn):
        return reported.message
    return Message(STORED, text=reported, hint="") if reported else None


def _finish_job(service: ServiceDep, report: FinishIn) -> JobOut:
    row = service.store.gateways.finish(
        report.job,
        report.epoch,
        report.outcome,
        _cause(report.why),
        line=report.line,
        copies_done=report.copies_done,
        place=None
        if report.position is None and report.line_at_most is None
        else StopPlace(report.position, report.station, report.line_at_most),
    )
    return job_out(service.store, row)
