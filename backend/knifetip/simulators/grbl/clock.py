"""clock: advances the simulated time of a table with the real time.

A burst of work in the process is caught up only in part, and the event loop is never blocked for
long.
"""

from __future__ import annotations

import asyncio
from typing import Protocol

#: Real time between two steps while the machine moves (s).
TICK = 0.002
#: Longest real time of one step, so that a high speed does not block the port (s).
STINT = 0.01
#: Real time that the machine may catch up after the process was busy (s).
LAG = 0.1


class ClockedTable(Protocol):
    """Interface of a simulated table whose time the clock advances."""

    speed: float  #: simulated seconds per second of real time
    time: float  #: simulated seconds of motion and dwell
    awake: asyncio.Event  #: set when something was received

    @property
    def busy(self) -> bool:
        """Whether an axis moves or the table dwells."""
        ...

    def elapse(self, seconds: float) -> None:
        """Advance the simulated time by ``seconds``, or until nothing moves or dwells."""
        ...


class Clock:
    """Clock of one simulated table."""

    def __init__(self, table: ClockedTable) -> None:
        self._table = table
        self._pending_time = 0.0  # simulated seconds that are due, but not simulated yet

    async def run(self) -> None:
        """Advance the simulated time with the real time until cancelled."""
        table, loop = self._table, asyncio.get_running_loop()
        last = loop.time()
        while True:
            if not table.busy:
                self._pending_time = 0.0
                table.awake.clear()
                await table.awake.wait()
                # Time in which nothing could move is skipped.
                last = loop.time() - TICK
                continue
            now = loop.time()
            self._pending_time = min(
                self._pending_time + (now - last) * table.speed, LAG * table.speed
            )
            last = now
            self._advance_pending(now + STINT, loop)
            await asyncio.sleep(TICK if table.busy else 0.0)

    def _advance_pending(self, deadline: float, loop: asyncio.AbstractEventLoop) -> None:
        """Simulate the time that is not simulated yet, but return at ``deadline`` at the latest.

        The time that is left at ``deadline`` is simulated by the next call.

        ``deadline``: real time at which to return (s, clock of ``loop``).
        """
        table = self._table
        part = max(self._pending_time / 16.0, 1e-4)  # checks the clock from time to time
        while self._pending_time > 0.0 and table.busy and loop.time() < deadline:
            step = min(part, self._pending_time)
            before = table.time
            table.elapse(step)
            self._pending_time -= step
            if table.time == before:
                return
