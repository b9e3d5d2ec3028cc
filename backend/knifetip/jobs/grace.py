"""Detects when this process has missed heartbeats, so that gateways must not count as silent."""

from __future__ import annotations

from knifetip.jobs.transitions import LEASE


class Grace:
    """Decides whether a gateway without a valid lease counts as silent.

    A process has missed heartbeats if it has just started, was suspended, or had its clock set.
    For the duration of one lease after that, no gateway counts as silent.
    """

    def __init__(self) -> None:
        self._began = self._last = float("-inf")

    def is_over(self, now: float) -> bool:
        """Return whether this process has run without a pause for longer than a lease.

        This method must be called several times in the duration of a lease, to detect pauses.

        Parameters
        ----------
        now
            Wall-clock time (s).
        """
        if not 0.0 <= now - self._last < LEASE / 2.0:
            self._began = now
        self._last = now
        return now - self._began > LEASE
