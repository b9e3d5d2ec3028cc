"""grace: the time that gateways get to report again after this process could not be reached.

Grace().over(now) -> False for a lease's time after the start and after every pause
"""

from __future__ import annotations

from knifetip.jobs.transitions import LEASE


class Grace:
    """Tells whether a gateway without a valid lease is silent, or could not be heard.

    A process that has just started, was suspended, or whose clock was set has not listened; for
    one lease after that no gateway counts as silent.
    """

    def __init__(self) -> None:
        self._began = self._last = float("-inf")

    def over(self, now: float) -> bool:
        """Return True if this process has listened without a pause for longer than a lease.

        To be called several times within a lease; ``now`` in seconds of the wall clock.
        """
        if not 0.0 <= now - self._last < LEASE / 2.0:
            self._began = now
        self._last = now
        return now - self._began > LEASE
