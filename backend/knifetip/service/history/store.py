"""Repository of ended jobs: find them, and delete old ones."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, field
from typing import Final

import sqlalchemy as sa

from knifetip.contract.job import ENDED, State
from knifetip.service.database.acting import acting_limits
from knifetip.service.database.engine import Database, rows
from knifetip.service.database.tables import Job
from knifetip.service.order_details.details import DetailsFilter

_BATCH: Final = 200  # jobs that one transaction deletes, so that gateways do not wait


@dataclass(frozen=True, slots=True)
class HistoryFilter:
    """Conditions on ended jobs; an empty value is no condition."""

    states: Sequence[str] = ()
    machine: str = ""
    board: str = ""
    drawing: str = ""  #: part of the name of the drawing, in any case
    since: float | None = None  #: earliest end (seconds since 1970)
    until: float | None = None  #: end before this time (seconds since 1970)
    details: DetailsFilter = field(default_factory=DetailsFilter)

    def conditions(self) -> list[sa.ColumnElement[bool]]:
        """Return the conditions as SQL expressions."""
        # Jobs are read in the order of their ends: for ``IN``, SQLite would sort all of them.
        others = [state for state in State if state not in (self.states or ENDED)]
        found: list[sa.ColumnElement[bool]] = [Job.state.not_in(others)]
        if self.machine:
            found.append(Job.machine == self.machine)
        if self.board:
            found.append(Job.board == self.board)
        if self.drawing:
            found.append(Job.drawing_name.icontains(self.drawing, autoescape=True))
        if self.since is not None:
            found.append(Job.ended >= self.since)
        if self.until is not None:
            found.append(Job.ended < self.until)
        return [*found, *self.details.conditions(Job)]


class HistoryStore:
    """Repository of ended jobs."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def search(
        self, conditions: HistoryFilter, after: tuple[float, int] | None, limit: int
    ) -> list[Job]:
        """Return the ended jobs that meet conditions, the last ended first.

        Parameters
        ----------
        conditions
            Conditions on the jobs.
        after
            End and serial number of the last job of the previous page; None for the first page.
        limit
            Greatest number of jobs.
        """
        query = sa.select(Job).where(*conditions.conditions(), *acting_limits().job_conditions())
        if after is not None:
            query = query.where(sa.tuple_(Job.ended, Job.serial) < after)
        with self._db.reading() as session:
            return list(
                session.scalars(query.order_by(Job.ended.desc(), Job.serial.desc()).limit(limit))
            )

    def delete_before(
        self, end: float, save: Callable[[Sequence[str]], Collection[str]] | None = None
    ) -> int:
        """Delete the jobs that ended before a time; return their number.

        Interrupted jobs are kept, because their board may be on the table.  The events and the runs
        of deleted jobs remain, so statistics and the use of tools do not change.

        Parameters
        ----------
        end
            Jobs that ended before this time are deleted (seconds since 1970).
        save
            Called with the ids of jobs before they are deleted; returns those that it has saved.
            The others are kept, and all of them after an error of it.
        """
        final = [state for state in ENDED if state is not State.INTERRUPTED]
        is_old = sa.and_(Job.state.in_(final), Job.ended < end)
        place = sa.tuple_(Job.ended, Job.serial)
        # In the order of the index ``job_by_end``: the planner cannot choose to read all jobs.
        page = sa.select(Job.id, Job.ended, Job.serial).where(is_old)
        page = page.order_by(Job.ended, Job.serial).limit(_BATCH)
        last = (0.0, 0)
        deleted = 0
        while True:
            with self._db.reading() as session:
                found = session.execute(page.where(place > last)).all()
            if not found:
                return deleted
            ids: Collection[str] = [row.id for row in found]
            if save is not None:
                ids = save(list(ids))
            with self._db.writing() as session:
                # A job may have been requeued meanwhile.
                deleted += rows(session, sa.delete(Job).where(Job.id.in_(ids), is_old))
            last = (found[-1].ended, found[-1].serial)
