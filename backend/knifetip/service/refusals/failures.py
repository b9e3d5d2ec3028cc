"""What an answer states about an exception that is no ``KnifetipError``."""

from __future__ import annotations

from typing import Final, NamedTuple

import sqlalchemy.exc

from knifetip.messages import Message
from knifetip.service.database.damage import is_damaged, is_disk_full
from knifetip.service.processes.pool import TaskCancelled

#: Errors of the database: what it reported, and that no connection became free in time.
DATABASE_ERRORS: Final = (sqlalchemy.exc.DBAPIError, sqlalchemy.exc.TimeoutError)


class Failure(NamedTuple):
    """A failure of the server, as an answer states it."""

    status: int  #: HTTP status
    message: Message
    is_logged: bool = False  #: whether the log gets the traceback
    affects_all: bool = True  #: whether other requests fail as well until it is repaired


def failure_of(error: Exception) -> Failure:
    """Return the failure of the server that an exception shows."""
    match error:
        case TaskCancelled():
            return Failure(503, Message("server.stopping"))
        case sqlalchemy.exc.DataError():
            return Failure(422, Message("request.not-storable"), affects_all=False)
        # A body is kept in a temporary file while it arrives.
        case sqlalchemy.exc.DBAPIError() | OSError() if is_disk_full(error):
            return Failure(507, Message("limit.disk-full"), is_logged=True)
        case sqlalchemy.exc.DBAPIError() if is_damaged(error):
            return Failure(503, Message("server.database-damaged"), is_logged=True)
        # Only this row cannot be stored; the next one may be.
        case sqlalchemy.exc.IntegrityError() | sqlalchemy.exc.ProgrammingError():
            silent = Message("server.database-silent")
            return Failure(503, silent, is_logged=True, affects_all=False)
        case sqlalchemy.exc.DBAPIError() | sqlalchemy.exc.TimeoutError():
            return Failure(503, Message("server.database-silent"), is_logged=True)
    return Failure(500, Message("server.internal-error"), is_logged=True, affects_all=False)
