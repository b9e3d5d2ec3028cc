"""Detects that this process could not receive heartbeats for some time.

A gateway must then not count as silent, because it may have sent heartbeats in that time.
"""

from __future__ import annotations

from knifetip.service.lifecycle.transitions import LEASE


class GracePeriod:
    """Decides whether a gateway whose lease has expired may count as silent.

    A process cannot receive heartbeats, which renew leases, before its start and while it is
    suspended.  A lease may then expire although its gateway has sent heartbeats.  Therefore no
    gateway counts as silent for the duration of one lease after a start, a suspension or a change
    of the clock.
    """

    def __init__(self) -> None:
        self._began = self._last = float("-inf")

    def is_over(self, now: float) -> bool:
        """Return whether this process has run without a pause for longer than a lease.

        This method must be called several times in the duration of a lease, to detect pauses.

        Parameters
        ----------
        now
            Time of the database's clock (s).
        """
        if not 0.0 <= now - self._last < LEASE / 2.0:
            self._began = now
        self._last = now
        return now - self._began > LEASE
