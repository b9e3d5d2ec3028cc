"""The clock of a database server, which all processes that use the database share.

Leases are stored as times.  If each process compared them with the clock of its own computer, a
computer whose clock is ahead by more than a lease would take jobs from working gateways.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from contextlib import suppress
from typing import Final

import sqlalchemy as sa

#: Time after which the clock of the server is read again (s).
_READ_AGAIN: Final = 10.0


def _uptime() -> float:
    """Return the seconds since the computer started, including those in which it was suspended."""
    if hasattr(time, "CLOCK_BOOTTIME"):
        return time.clock_gettime(time.CLOCK_BOOTTIME)
    return time.monotonic()


class SharedClock:
    """A clock that shows the time of a server without a request to the server at each call.

    Between two readings of the server's clock, the time passes as on this computer.  A change of
    this computer's own date and time has no effect.

    Parameters
    ----------
    read
        Returns the time of the server: seconds since 1970.
    uptime
        Returns the seconds since any fixed time; it must not jump.
    """

    def __init__(self, read: Callable[[], float], uptime: Callable[[], float] = _uptime) -> None:
        self._read = read
        self._uptime = uptime
        self._lock = threading.Lock()
        self._offset: float | None = None  # server time minus uptime (s)
        self._read_at = 0.0  # uptime of the last reading (s)

    def __call__(self) -> float:
        """Return the time of the server: seconds since 1970.

        If the server cannot be read, its last reading is used.

        Raises
        ------
        sqlalchemy.exc.SQLAlchemyError
            The server cannot be read, and was never read before.
        """
        offset = self._offset
        if offset is None:
            with self._lock:
                offset = self._read_offset() if self._offset is None else self._offset
                self._offset = offset
        elif self._uptime() - self._read_at > _READ_AGAIN and self._lock.acquire(blocking=False):
            # The other threads do not wait: they may have the connections for which this one waits.
            try:
                with suppress(sa.exc.SQLAlchemyError):
                    offset = self._offset = self._read_offset()
            finally:
                self._lock.release()
        return self._uptime() + offset

    def _read_offset(self) -> float:
        before = self._uptime()
        # After a failure, too, the next reading waits.
        self._read_at = before
        shared = self._read()
        return shared - 0.5 * (before + self._uptime())
