"""Routes for the use of the tools of a machine: worked length, life and changes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

from fastapi import Query, Request, Response

from knifetip.contract.job import Actor, ActorKind
from knifetip.errors import NotFound
from knifetip.model.machine import Machine
from knifetip.service.components import Service, ServiceDep
from knifetip.service.http.models import ListPage, PageQuery
from knifetip.service.http.pages import page_of, set_next_page
from knifetip.service.http.parameters import MachineName, StationNumber
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.tools.models import ToolChangeIn, ToolEventOut, ToolLifeIn, ToolUseOut
from knifetip.service.tools.store import ToolUse, warning_message

router = ScopedRouter(prefix="/machines/{name}/tools", tags=["tools"])


@router.get("")
@requires(AccessScope.VIEWER)
def list_machine_tools(
    service: ServiceDep,
    request: Request,
    response: Response,
    name: MachineName,
    wanted: Annotated[ListPage, Query()],
) -> list[ToolUseOut]:
    """List the tools of a machine with the lengths that they have worked, and their lives."""
    uses = service.store.tools.uses(_machine(service, name))
    return tools_out(page_of(request, response, uses, wanted))


@router.get("/events")
@requires(AccessScope.VIEWER)
def list_tool_events(
    service: ServiceDep,
    request: Request,
    response: Response,
    name: MachineName,
    wanted: Annotated[PageQuery, Query()],
) -> list[ToolEventOut]:
    """List the changes of the tools of a machine and of their lives, newest first.

    The header `Link` contains the URL of the next page.
    """
    _machine(service, name)
    events = service.store.tools.events(name, wanted.cursor, wanted.limit)
    last = events[-1].id if len(events) == wanted.limit else None
    set_next_page(request, response, last, wanted.limit)
    return [
        ToolEventOut.model_validate(
            {
                "station": event.station,
                "kind": event.kind,
                "at": event.at,
                "who": event.who,
                "length": event.length / 1000.0,
            }
        )
        for event in events
    ]


@router.post("/{station}/changed")
@requires(AccessScope.OPERATOR)
def record_tool_change(
    service: ServiceDep,
    name: MachineName,
    station: StationNumber,
    change: ToolChangeIn | None = None,
) -> list[ToolUseOut]:
    """Record that a person has put a new tool into a station; its used length is 0 again."""
    machine = _with_station(service, name, station)
    actor = Actor(ActorKind.OPERATOR, "" if change is None else change.by)
    return tools_out(service.store.tools.record_change(machine, station, actor))


@router.put("/{station}/life")
@requires(AccessScope.OPERATOR)
def set_tool_life(
    service: ServiceDep, name: MachineName, station: StationNumber, wanted: ToolLifeIn
) -> list[ToolUseOut]:
    """Set the life of the tool in a station; it replaces the life in the file of the machine."""
    machine = _with_station(service, name, station)
    actor = Actor(ActorKind.OPERATOR, wanted.by)
    return tools_out(service.store.tools.set_life(machine, station, wanted.life * 1000.0, actor))


def _machine(service: Service, name: str) -> Machine:
    return service.store.library.machine(name)


def _with_station(service: Service, name: str, station: int) -> Machine:
    """Return a machine that has a station with a number.

    Raises ``NotFound``: the machine has no such station.
    """
    machine = _machine(service, name)
    if station not in (one.number for one in machine.stations):
        raise NotFound("tool-life.no-station", machine=name, station=station)
    return machine


def worn_stations(service: Service, machine: str) -> set[int]:
    """Return the numbers of the stations of a machine whose tools are at the end of their lives."""
    return service.store.tools.worn_stations(_machine(service, machine))


def tools_out(uses: Sequence[ToolUse]) -> list[ToolUseOut]:
    """Return the API models of the uses of tools."""
    return [
        ToolUseOut.model_validate(
            {
                "station": use.station,
                "name": use.name,
                "kind": use.kind,
                "used": use.used / 1000.0,
                "life": use.life / 1000.0,
                "share": use.share,
                "changed": use.changed,
                "changed_by": use.changed_by,
                "warning": use.warning,
                "message": warning_message(use),
            }
        )
        for use in uses
    ]
