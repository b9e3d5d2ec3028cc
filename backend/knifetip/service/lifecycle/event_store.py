"""Repository of events: the log of changes to jobs and drawings, which only grows."""

from __future__ import annotations

from collections.abc import Collection

import sqlalchemy as sa

from knifetip.service.database.acting import acting_limits
from knifetip.service.database.engine import Database
from knifetip.service.database.tables import Event, Job
from knifetip.service.lifecycle.transitions import unknown_job_error


class EventStore:
    """Repository for reading events; ``Transitions`` writes them."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def of_job(self, id: str) -> list[Event]:
        """Return the events of a job, oldest first; those of a deleted job remain.

        Raises
        ------
        NotFound
            There is and was no job with this id, or the acting key may not see it; a key with
            limits sees no deleted job.
        """
        query = sa.select(Event).where(Event.subject == id, Event.kind == "job").order_by(Event.id)
        if visible := acting_limits().job_conditions():
            query = query.where(sa.select(Job.id).where(Job.id == id, *visible).exists())
        with self._db.reading() as session:
            found = list(session.scalars(query))
        if not found:
            raise unknown_job_error(id)
        return found

    def after(self, last: int, limit: int = 1000, late: Collection[int] = ()) -> list[Event]:
        """Return at most ``limit`` events with ids above ``last`` or in ``late``, oldest first."""
        wanted = sa.or_(Event.id > last, Event.id.in_(late)) if late else Event.id > last
        query = sa.select(Event).where(wanted).order_by(Event.id).limit(limit)
        with self._db.reading() as session:
            return list(session.scalars(query))

    def last_id(self) -> int:
        """Return the id of the newest event, 0 if there is none."""
        with self._db.reading() as session:
            return session.scalar(sa.select(sa.func.max(Event.id))) or 0
