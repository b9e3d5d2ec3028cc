"""Repository of events, the append-only log of changes to jobs and drawings."""

from __future__ import annotations

import sqlalchemy as sa

from knifetip.jobs.database import Database
from knifetip.jobs.tables import Event, Job
from knifetip.jobs.transitions import no_job


class EventStore:
    """Repository of events, which ``Transitions`` writes."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def of_job(self, id: str) -> list[Event]:
        """Return the events of a job in order."""
        with self._db.reading() as session:
            if session.scalar(sa.select(Job.id).where(Job.id == id)) is None:
                raise no_job(id)
            return list(
                session.scalars(sa.select(Event).where(Event.subject == id).order_by(Event.id))
            )

    def after(self, last: int, limit: int = 1000) -> list[Event]:
        """Return the events after an event in order."""
        query = sa.select(Event).where(Event.id > last).order_by(Event.id).limit(limit)
        with self._db.reading() as session:
            return list(session.scalars(query))

    def last_id(self) -> int:
        """Return the id of the newest event, 0 if there is none."""
        with self._db.reading() as session:
            return session.scalar(sa.select(sa.func.max(Event.id))) or 0
