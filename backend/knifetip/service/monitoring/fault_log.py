"""fault_log: one log entry when the database fails, and one when it answers again.

A database that is silent, full or damaged fails every request and every report of a gateway,
several times a second; the log shows the first failure of each kind with its traceback.
"""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from contextlib import suppress

import sqlalchemy.exc

#: Time between two attempts to write while the database fails (s).
_PAUSE = 5.0

_log = logging.getLogger("knifetip.api")


class FaultLog:
    """Logs the failures of a database that affect all requests.

    Parameters
    ----------
    probe
        Writes to the database in the thread that calls it; raises the error of the database.
    pause
        Time between two attempts to write while the database fails (s).
    """

    def __init__(self, probe: Callable[[], None], pause: float = _PAUSE) -> None:
        self._probe = probe
        self._pause = pause
        self._present: set[str] = set()  # codes of the failures since the database last answered
        self._waiting: asyncio.Task[None] | None = None

    def note(self, code: str, error: Exception, request: str) -> None:
        """Log a failure, unless one of its kind is logged since the database last answered.

        Parameters
        ----------
        code
            Code of the message that the answer contains.
        error
            The failure.
        request
            Method and path of the request.
        """
        if code not in self._present:
            self._present.add(code)
            _log.error("%s: %s", code, request, exc_info=error)
        if self._waiting is None or self._waiting.done():
            self._waiting = asyncio.create_task(self._wait(), name="database fault")

    async def close(self) -> None:
        """Stop waiting for the database."""
        if self._waiting is not None:
            self._waiting.cancel()
            with suppress(asyncio.CancelledError):
                await self._waiting

    async def _wait(self) -> None:
        """Log that the database answers again as soon as it stores a change."""
        while True:
            await asyncio.sleep(self._pause)
            try:
                await asyncio.to_thread(self._probe)
            except (sqlalchemy.exc.SQLAlchemyError, OSError):
                continue
            _log.warning("the database answers again after %s", ", ".join(sorted(self._present)))
            self._present.clear()
            return
