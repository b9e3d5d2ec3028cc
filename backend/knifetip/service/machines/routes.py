"""Routes for machines: their stations and tools, their state, and operations of persons at them."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Any, get_args

from fastapi import Query, Request, Response

from knifetip.library.definition import Shelf
from knifetip.messages import from_json
from knifetip.model.dieline import LineType
from knifetip.model.edge_choice import MadeType
from knifetip.model.machine import Machine
from knifetip.model.tool import kind_of
from knifetip.planning.tool_steps import makers
from knifetip.presentation.machine import machine_json, station_json
from knifetip.service.components import Service, ServiceDep
from knifetip.service.database.tables import Operation
from knifetip.service.http.conditional import NOT_MODIFIED
from knifetip.service.http.models import ListPage
from knifetip.service.http.pages import page_of
from knifetip.service.http.parameters import MachineName, OperationId
from knifetip.service.http.principal import PrincipalDep
from knifetip.service.http.routing import ScopedRouter, requires, unaudited
from knifetip.service.http.scopes import AccessScope
from knifetip.service.http.times import rfc3339
from knifetip.service.library.machine_models import MachineOut
from knifetip.service.machines.station_models import (
    HandsClearOut,
    OperationIn,
    OperationOut,
    StationOut,
)
from knifetip.service.machines.station_store import StationView
from knifetip.service.machines.waiting import ABSENT

router = ScopedRouter(prefix="/machines", tags=["machines"])

#: Share of the velocities of the axes in a frame, unless a person asks for another.
FRAME_SHARE = 0.1


@router.get("", responses=NOT_MODIFIED)
@requires(AccessScope.VIEWER)
def list_machines(
    service: ServiceDep,
    principal: PrincipalDep,
    request: Request,
    response: Response,
    wanted: Annotated[ListPage, Query()],
) -> list[MachineOut]:
    """List the machines with their current jobs: those of users and those of the library.

    A key that is limited to machines gets these only.  The header `Link` contains the URL of the
    next page.
    """
    machines = [
        machine
        for machine in service.store.library.machines()
        if principal.limits.sees_machine(machine.name)
    ]
    connected = service.store.machines.connected_machines(ABSENT)
    on_table = service.store.machines.jobs_on_tables()
    return [
        _machine_out(machine, machine.name in connected, on_table.get(machine.name))
        for machine in page_of(request, response, machines, wanted)
    ]


@router.get("/{name}")
@requires(AccessScope.VIEWER)
def get_machine(service: ServiceDep, response: Response, name: MachineName) -> MachineOut:
    """Get a machine of a user or of knifetip's library, with its current job."""
    machine = service.store.library.machine(name)
    response.headers["ETag"] = f'"{machine.version}"'
    return _machine_out(
        machine,
        name in service.store.machines.connected_machines(ABSENT),
        service.store.machines.jobs_on_tables().get(name),
    )


async def _check_machine(service: Service, name: str) -> None:
    """Raise LibraryError if there is no machine with a name."""
    await service.threads.reports(service.store.library.definition, Shelf.MACHINES, name)


@router.get("/{name}/station")
@requires(AccessScope.VIEWER)
async def get_station(
    service: ServiceDep, principal: PrincipalDep, name: MachineName
) -> StationOut:
    """Get the state of a machine for the person at it: its controller, its alarm and its position.

    While this request is repeated every few seconds, the gateway reports more often, and the stream
    of events contains an event ``station`` for each change.
    """
    await _check_machine(service, name)
    found = station_out(await service.threads.reports(service.store.stations.get, name))
    # The job may be one of another customer.
    return found.model_copy(update={"job": ""}) if principal.limits.customer else found


@router.post("/{name}/hands-clear")
@requires(AccessScope.STATION)
async def state_hands_clear(service: ServiceDep, name: MachineName) -> HandsClearOut:
    """State that hands are clear of a machine.

    Operations that move the machine need such a statement that is younger than a minute. It ends
    when a job starts or is resumed, and when it is withdrawn. A request can contain the statement
    itself, for this request only: `hands_clear`.
    """
    await _check_machine(service, name)
    seconds = await service.threads.reports(service.store.stations.state_hands_clear, name)
    until = service.store.database.clock() + seconds
    return HandsClearOut(until=rfc3339(until), seconds=seconds)


@router.delete("/{name}/hands-clear", status_code=204)
@requires(AccessScope.STATION)
async def withdraw_hands_clear(service: ServiceDep, name: MachineName) -> None:
    """Withdraw the statement that hands are clear of a machine, whoever has made it.

    Operations that move the machine are refused from now on, until it is stated again. A motion
    that was asked for before goes on: `hold` of the job or `stop_jog` of the machine ends it. The
    status is 204 also if nothing was stated.
    """
    await _check_machine(service, name)
    await service.threads.reports(service.store.stations.withdraw_hands_clear, name)


@router.post("/{name}/operations", status_code=202)
@requires(AccessScope.STATION)
async def ask_for_operation(
    service: ServiceDep, name: MachineName, request: OperationIn
) -> OperationOut:
    """Ask for an operation of a machine, such as unlock, home or jog; the machine does it at once.

    It is refused with status 409 while a job is running or held on the machine, and if it moves the
    machine and nobody has stated that hands are clear.  A jog moves while it is renewed.  An
    operation expires 3 s after the request, and is never executed later.  The emergency stop of the
    machine does not depend on this route.
    """
    await _check_machine(service, name)
    asked = request.model_dump(exclude_none=True, exclude={"hands_clear"})
    if request.operation == "frame":
        asked |= {"share": request.share or FRAME_SHARE}
        asked |= await service.threads.reports(_box_of_sheet, service, name)
    if request.operation == "tool_check":
        asked |= await service.threads.reports(_height_above_board, service, name)
    ask = partial(service.store.stations.ask, hands_clear=request.hands_clear)
    return _operation_out(await service.threads.reports(ask, name, asked))


@router.post("/{name}/operations/{id}/renew")
@requires(AccessScope.STATION)
@unaudited
async def renew_jog(service: ServiceDep, name: MachineName, id: OperationId) -> OperationOut:
    """State that the button of a jog is still held.

    Repeat it about every 0.3 s.  The machine stops 1 s after the last statement, or earlier at the
    end of the distance, or with `stop_jog` when the button is released.  The status is 409 if the
    jog was stopped or refused.
    """
    await _check_machine(service, name)
    return _operation_out(await service.threads.reports(service.store.stations.renew, name, id))


def _box_of_sheet(service: Service, machine: str) -> dict[str, Any]:
    """Return the box of the sheet of the job that waits at a machine, as argument of a frame.

    The result is empty if the sheet has no size; the gateway then takes the box of the work.
    """
    job = service.store.stations.waiting_job(machine)
    sheet = None if job is None else job.options.sheet
    if sheet is None or sheet.size is None:
        return {}
    x, y = sheet.corner(service.store.library.machine(machine).origin)
    return {"box": [x, y, x + sheet.size[0], y + sheet.size[1]]}


def _height_above_board(service: Service, machine: str) -> dict[str, Any]:
    """Return the height of the tip in a tool check, above the board of the job that waits."""
    job = service.store.stations.waiting_job(machine)
    if job is None:
        return {}
    library = service.store.library
    height = library.board(job.board).caliper + library.machine(machine).clearance
    return {"height": height}


@router.get("/{name}/operations/{id}")
@requires(AccessScope.VIEWER)
async def get_operation(service: ServiceDep, name: MachineName, id: OperationId) -> OperationOut:
    """Get the state of an operation of a machine; operations are kept for some minutes."""
    await _check_machine(service, name)
    return _operation_out(await service.threads.reports(service.store.stations.operation, name, id))


def station_out(view: StationView) -> StationOut:
    """Return the state of a station for clients."""
    row, alive = view.row, view.alive
    return StationOut.model_validate(
        {
            "machine": row.machine,
            "gateway": row.gateway if alive else "",
            "connected": alive and row.connected,
            "state": row.state if alive else "",
            "alarm": row.alarm if alive else None,
            "obstacle": row.obstacle if alive else None,
            "position": row.position if alive else None,
            "outputs": row.outputs if alive else [],
            "outputs_known": alive and row.outputs_known,
            "operations": row.operations if alive else [],
            "spindle": row.spindle if alive else None,
            "override": row.override if alive else None,
            "activity": _activity(row.activity) if alive and row.activity else None,
            "notices": row.notices if alive else [],
            "job": view.job,
            "seen_seconds_ago": view.age,
        }
    )


def _activity(stored: dict[str, Any]) -> dict[str, Any]:
    message = stored.get("message")
    return {**stored, "message": None if message is None else from_json(message)}


def _operation_out(row: Operation) -> OperationOut:
    return OperationOut.model_validate({"id": row.id, "state": row.state, "message": row.message})


def _machine_out(machine: Machine, connected: bool, job: str | None) -> MachineOut:
    stations_of = {word: makers(machine, LineType.from_word(word)) for word in get_args(MadeType)}
    result: MachineOut = MachineOut.model_validate(
        {
            **machine_json(machine),
            "offset_cuts": machine.offset_cuts,
            "stations": [
                {
                    **station_json(station),
                    "tool": {
                        "kind": kind_of(station.tool).name,
                        "dimensions": station.tool.dimensions,
                        "footprint": station.tool.footprint,
                    },
                    "line_types": [
                        word for word, stations in stations_of.items() if station in stations
                    ],
                }
                for station in machine.stations
            ],
            "gateway": "connected" if connected else "absent",
            "job": job,
        }
    )
    return result
