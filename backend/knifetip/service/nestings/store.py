"""Repository of nestings.

A running nesting has a lease, which its server renews.  If the server ends, the lease expires, and
the nesting is *interrupted*; its best arrangement so far is kept.
"""

from __future__ import annotations

from enum import StrEnum
from typing import Any, Final

import sqlalchemy as sa
from sqlalchemy.orm import Session

from knifetip.contract.job import new_id
from knifetip.errors import NotFound
from knifetip.messages import Message
from knifetip.service.database.acting import acting_owner
from knifetip.service.database.engine import Database, short
from knifetip.service.nestings.tables import Nesting

#: Seconds for which a running nesting is alive without a renewal.
LEASE: Final = 10.0
#: Nestings that are kept; older ones are deleted.
_KEPT: Final = 500


class NestingState(StrEnum):
    """State of a nesting."""

    RUNNING = "running"
    DONE = "done"  #: the time is over
    STOPPED = "stopped"  #: a user stopped it; the best arrangement is kept
    FAILED = "failed"
    INTERRUPTED = "interrupted"  #: the server ended


class NestingStore:
    """Repository of nestings."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def add(self, request: dict[str, Any]) -> Nesting:
        """Store a nesting that begins now, and return it; the oldest ones are deleted.

        Parameters
        ----------
        request
            JSON data of the ``NestingJob``.
        """
        row = Nesting(
            id=new_id(),
            owner=acting_owner(),
            created=self._db.clock(),
            state=NestingState.RUNNING,
            stop_requested=False,
            lease=self._db.timer() + LEASE,
            request=request,
            result=None,
            message=None,
        )
        with self._db.writing() as session:
            session.add(row)
            session.flush()
            session.execute(sa.delete(Nesting).where(Nesting.serial <= row.serial - _KEPT))
        return row

    def get(self, id: str) -> Nesting:
        """Return a nesting; it is *interrupted* if its lease has expired.

        Raises
        ------
        NotFound
            There is no nesting with this id.
        """
        with self._db.reading() as session:
            row = _find(session, id)
            session.expunge(row)
        if row.state == NestingState.RUNNING and row.lease < self._db.timer():
            row.state = NestingState.INTERRUPTED
        return row

    def renew(self, id: str, result: dict[str, Any] | None = None) -> bool:
        """Renew the lease of a running nesting; return whether it is to go on.

        Parameters
        ----------
        id
            Id of the nesting.
        result
            A better arrangement; None if there is none.
        """
        values: dict[str, Any] = {"lease": self._db.timer() + LEASE}
        if result is not None:
            values["result"] = result
        running = (Nesting.id == id, Nesting.state == NestingState.RUNNING)
        with self._db.writing() as session:
            session.execute(sa.update(Nesting).where(*running).values(values))
            stop = session.scalar(sa.select(Nesting.stop_requested).where(*running))
        return stop is False

    def end(self, id: str, state: NestingState, message: Message | None = None) -> None:
        """End a running nesting with a state and, if it failed, the reason."""
        statement = sa.update(Nesting).where(
            Nesting.id == id, Nesting.state == NestingState.RUNNING
        )
        with self._db.writing() as session:
            session.execute(statement.values(state=state, message=message))

    def request_stop(self, id: str) -> Nesting:
        """Ask the server of a running nesting to stop it, and return the nesting.

        Raises
        ------
        NotFound
            There is no nesting with this id.
        """
        with self._db.writing() as session:
            _find(session, id).stop_requested = True
        return self.get(id)

    def delete(self, id: str) -> None:
        """Delete a nesting; a running one ends.

        Raises
        ------
        NotFound
            There is no nesting with this id.
        """
        with self._db.writing() as session:
            session.delete(_find(session, id))


def _find(session: Session, id: str) -> Nesting:
    row = session.scalar(sa.select(Nesting).where(Nesting.id == id))
    if row is None:
        raise NotFound("nesting.unknown", id=short(id))
    return row
