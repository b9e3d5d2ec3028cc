"""What the operator states about the tools of a job when it is confirmed, and its check.

A job does not start with a tool at the end of its life, unless the operator has put a new tool into
the station, or states why the tool stays in use.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

from sqlalchemy.orm import Session

from knifetip.contract.job import Actor
from knifetip.errors import LibraryError, NotFound, WrongState
from knifetip.messages import Message
from knifetip.model.machine import Machine
from knifetip.service.database.tables import Job
from knifetip.service.library.store import LibraryStore
from knifetip.service.tools.store import ToolStore, warning_message


@dataclass(frozen=True, slots=True)
class ToolCheck:
    """What the operator states about the tools of a job."""

    #: numbers of the stations into which the operator has put new tools
    changed: Collection[int] = ()
    #: why tools at the end of their lives stay in use; empty if they do not
    reason: str = ""


#: The operator states nothing about the tools.
NOTHING_STATED = ToolCheck()


class ToolGate:
    """Refuses to start a job with a worn-out tool, unless the operator accepts the tool.

    Parameters
    ----------
    tools
        Repository of the use of tools.
    library
        Repository of machines.
    """

    def __init__(self, tools: ToolStore, library: LibraryStore) -> None:
        self._tools = tools
        self._library = library

    def check(self, session: Session, row: Job, stated: ToolCheck, actor: Actor) -> list[Message]:
        """Check the tools of a job, record the changed ones, and return the events to write.

        Parameters
        ----------
        session, row
            Session with the transaction of the caller, and the job.
        stated
            What the operator states about the tools.
        actor
            The operator.

        Raises
        ------
        NotFound
            The machine has no station with a number in ``stated.changed``.
        WrongState
            The job uses a tool at the end of its life.
        """
        events = []
        try:
            machine = self._library.machine(row.machine)
        except LibraryError:
            return []  # a machine without a file has tools without lives
        for station in sorted(set(stated.changed)):
            name = _name_of(machine, station)
            use = self._tools.record_change_in(session, machine, station, actor)
            events.append(
                Message("job.tool-changed", station=station, name=name, used=use.used / 1000.0)
            )
        used = {tool["station"] for tool in row.tools}
        over = [
            message
            for use in self._tools.uses_in(session, machine)
            if use.station in used and use.warning == "over" and (message := warning_message(use))
        ]
        if over and not stated.reason:
            raise WrongState("job.worn-tools", job=row.id, tools=over)
        if over:
            events.append(Message("job.worn-tools-used", tools=over, reason=stated.reason))
        return events


def _name_of(machine: Machine, number: int) -> str:
    """Return the name of a station of a machine.

    Raises ``NotFound``: the machine has no station with this number.
    """
    for station in machine.stations:
        if station.number == number:
            return station.name
    raise NotFound("tool-life.no-station", machine=machine.name, station=number)
