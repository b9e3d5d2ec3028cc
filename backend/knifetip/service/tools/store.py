"""Repository of the use of tools: the length that each has worked, its life, and its changes.

The use of a tool is the length of all runs of its machine that ended after the tool was changed,
and of the run that is not finished, without what the old tool had worked in that run.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final, Literal

import sqlalchemy as sa
from sqlalchemy.orm import Session

from knifetip.contract.job import LEASED, Actor
from knifetip.messages import Message
from knifetip.model.machine import Machine, Station
from knifetip.model.tool import kind_of
from knifetip.service.database.acting import signature
from knifetip.service.database.engine import Database
from knifetip.service.database.tables import Job, ToolEvent
from knifetip.service.tools.work import worked_lengths
from knifetip.service.tools.worked_lengths import lengths_of_copies

#: Share of the life from which the operator is warned.
WARNING_SHARE: Final = 0.9


@dataclass(frozen=True, slots=True)
class ToolUse:
    """The use of the tool of one station."""

    station: int  #: number of the station
    name: str  #: name of the station
    kind: str  #: kind of the tool
    used: float  #: worked length since the last change (mm)
    life: float  #: length that the tool may work (mm); 0 for no limit
    changed: float  #: time of the last change (seconds since 1970); 0 if there was none
    changed_by: str  #: who changed it; empty if it is not known

    @property
    def share(self) -> float:
        """Used fraction of the life; 0 if the life has no limit."""
        return self.used / self.life if self.life > 0.0 else 0.0

    @property
    def warning(self) -> Literal["", "near", "over"]:
        """``near`` from 90 % of the life on, ``over`` from its end on; the operator must then
        confirm the tool.
        """
        if self.share >= 1.0:
            return "over"
        return "near" if self.share >= WARNING_SHARE else ""


class ToolStore:
    """Repository of the use of the tools of machines."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def uses(self, machine: Machine) -> list[ToolUse]:
        """Return the use of the tool of each station of a machine, ordered by number."""
        with self._db.reading() as session:
            return self.uses_in(session, machine)

    def uses_in(self, session: Session, machine: Machine) -> list[ToolUse]:
        """Return the use of the tool of each station, within the transaction of ``session``."""
        worked = worked_lengths(session, machine.name)
        present = _present_lengths(session, machine.name)
        return [
            _tool_use(
                session,
                machine.name,
                station,
                worked.get(station.number, 0.0) + present.get(station.number, 0.0),
            )
            for station in sorted(machine.stations, key=lambda station: station.number)
        ]

    def worn_stations(self, machine: Machine) -> set[int]:
        """Return the numbers of the stations whose tools are at the end of their lives."""
        return {use.station for use in self.uses(machine) if use.warning == "over"}

    def record_change(self, machine: Machine, station: int, actor: Actor) -> list[ToolUse]:
        """Store that a person has put a new tool into a station; return the uses of all tools.

        Parameters
        ----------
        machine
            The machine.
        station
            Number of one of its stations.
        actor
            The person.
        """
        with self._db.writing() as session:
            self.record_change_in(session, machine, station, actor)
        return self.uses(machine)

    def record_change_in(
        self, session: Session, machine: Machine, station: int, actor: Actor
    ) -> ToolUse:
        """Store a new tool within the transaction of ``session``; return the use of the old one.

        The parameters are those of ``record_change``.
        """
        (use,) = (use for use in self.uses_in(session, machine) if use.station == station)
        changed = ToolEvent(
            machine=machine.name,
            station=station,
            kind="changed",
            length=use.used,
            unfinished=_present_lengths(session, machine.name).get(station, 0.0),
            worked_before=worked_lengths(session, machine.name).get(station, 0.0),
        )
        self._append(session, changed, actor)
        return use

    def set_life(self, machine: Machine, station: int, life: float, actor: Actor) -> list[ToolUse]:
        """Store the life of the tool of a station; return the uses of all tools.

        Parameters
        ----------
        machine
            The machine.
        station
            Number of one of its stations.
        life
            Length that the tool may work (mm); 0 for no limit.
        actor
            The person.
        """
        with self._db.writing() as session:
            changed = ToolEvent(machine=machine.name, station=station, kind="life", length=life)
            self._append(session, changed, actor)
        return self.uses(machine)

    def _append(self, session: Session, event: ToolEvent, actor: Actor) -> None:
        """Store an event with the present time and the person who caused it."""
        event.at, event.who = self._db.clock(), signature(actor)[:200]
        session.add(event)
        session.flush()

    def events(self, machine: str, before: int | None = None, limit: int = 200) -> list[ToolEvent]:
        """Return changes of the tools of a machine and of their lives, newest first.

        Parameters
        ----------
        machine
            Name of the machine.
        before
            Return only changes with a smaller id; None for all.
        limit
            Greatest number of changes.
        """
        query = sa.select(ToolEvent).where(ToolEvent.machine == machine)
        if before is not None:
            query = query.where(ToolEvent.id < before)
        with self._db.reading() as session:
            return list(session.scalars(query.order_by(ToolEvent.id.desc()).limit(limit)))


def warning_message(use: ToolUse) -> Message | None:
    """Return the warning about the life of a tool, None if there is none."""
    if not use.warning:
        return None
    return Message(
        "tool-life.over" if use.warning == "over" else "tool-life.near",
        name=use.name,
        station=use.station,
        used=use.used / 1000.0,
        life=use.life / 1000.0,
        percent=100.0 * use.share,
    )


def _tool_use(session: Session, machine: str, station: Station, worked: float) -> ToolUse:
    """Return the use of the tool of a station.

    ``worked``: length that the station has worked in all its runs, with the one that is not
    finished (mm).
    """
    changed = _last_event(session, machine, station.number, "changed")
    before = 0.0 if changed is None else changed.worked_before + changed.unfinished
    return ToolUse(
        station=station.number,
        name=station.name,
        kind=kind_of(station.tool).name,
        used=max(worked - before, 0.0),
        life=_life(session, machine, station),
        changed=0.0 if changed is None else changed.at,
        changed_by="" if changed is None else changed.who,
    )


def _life(session: Session, machine: str, station: Station) -> float:
    """Return the life of the tool of a station (mm); 0 for no limit."""
    life = _last_event(session, machine, station.number, "life")
    return station.life * 1000.0 if life is None else life.length


def _last_event(session: Session, machine: str, station: int, kind: str) -> ToolEvent | None:
    return session.scalar(
        sa.select(ToolEvent)
        .where(ToolEvent.machine == machine, ToolEvent.station == station, ToolEvent.kind == kind)
        .order_by(ToolEvent.id.desc())
        .limit(1)
    )


def _present_lengths(session: Session, machine: str) -> Mapping[int, float]:
    """Return the lengths that stations have worked in the run that is not finished (mm)."""
    columns = sa.select(Job.copies_done, Job.copies_before, Job.line, Job.lines, Job.lengths).where(
        Job.machine == machine, Job.state.in_(LEASED)
    )
    lengths: dict[int, float] = {}
    for done, before, line, lines, table in session.execute(columns):
        copies = done - before
        # Between two copies ``line`` is the last line of the completed copy.
        begun = 0 if copies and line >= lines else line
        for (station, _), length in lengths_of_copies(table, copies, begun).items():
            lengths[station] = lengths.get(station, 0.0) + length
    return lengths
