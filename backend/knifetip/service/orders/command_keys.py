"""Keys of commands: a client that repeats a command with its key changes nothing a second time.

The key is stored in the transaction of the command.  If the server or the connection fails, either
both are stored or neither is, so a client may repeat the command until it gets an answer.
"""

from __future__ import annotations

from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session

from knifetip.errors import KeyReused
from knifetip.service.database.engine import Database, short
from knifetip.service.database.request_key import RequestKey
from knifetip.service.database.tables import CommandKey, Job
from knifetip.service.lifecycle.transitions import Transitions


class CommandKeys:
    """Repository of the keys of commands about jobs."""

    def __init__(self, database: Database, transitions: Transitions) -> None:
        self._db = database
        self._transitions = transitions

    def repeated(self, session: Session, id: str, key: RequestKey | None) -> Job | None:
        """Return the job of a command that was executed before, or None after storing its key.

        Parameters
        ----------
        session
            Session with the transaction of the command.
        id
            Id of the job.
        key
            Key of the command; None if it has none.

        Raises
        ------
        NotFound
            There is no job with this id.
        KeyReused
            The key was used for another command, or for another job.
        """
        if key is None:
            return None
        row = self._transitions.lock(session, id)
        earlier = session.get(CommandKey, key.stored)
        if earlier is not None:
            key.check(earlier)
            return row
        session.add(
            CommandKey(
                key=key.stored,
                fingerprint=key.fingerprint,
                job=id,
                created=self._db.clock(),
            )
        )
        try:
            session.flush()
        except IntegrityError as reason:
            # Another command has stored it meanwhile, about another job: this one is locked.
            raise KeyReused("request.key-reused", key=short(key.text)) from reason
        return None
