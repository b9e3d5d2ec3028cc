"""held_jogs: moves an axis as long as a person holds a button, and stops it soon afterwards.

The page states again and again that a button is held.  If the page, the network or the server
fails, the statements stop, and the machine stops ``operations.JOG_RENEWAL`` after the last one.

If the gateway itself is killed, nobody stops the machine.  Most controllers therefore get a jog in
pieces (``Operable.jog_seconds``): another piece is sent while the button is held and the machine
has almost executed the last one, so that never more than two pieces are ahead of it.
"""

from __future__ import annotations

import asyncio
from contextlib import suppress
from dataclasses import dataclass

from knifetip.contract.operations import JOG_RENEWAL, Operation
from knifetip.errors import KnifetipError
from knifetip.gateway.controller import State
from knifetip.gateway.machine_link import MachineLink
from knifetip.gateway.motion import Pose
from knifetip.gateway.operations import AXES, OperableController, jog_piece

#: Time between two looks at a jog, and between two attempts to stop it (s).
_PAUSE = 0.1
#: Distance from its end at which a piece counts as executed (mm or degrees).
_AT_END = 0.05
#: Distance that is no move any more (mm or degrees).
_ROUNDING = 1e-4
#: Consecutive reports of rest elsewhere after which a jog has ended: the first may be from before
#: its begin.
_STOPPED = 4


@dataclass(slots=True)
class _Way:
    """The way of a jog, and how much of it the controller has got."""

    axis: str
    feed: float
    sent: float  #: position to which the controller was sent (mm or degrees)
    end: float
    at_rest: int = 0  #: consecutive reports of rest before ``sent``

    @property
    def rest(self) -> float:
        """Distance that was not sent yet."""
        return self.end - self.sent


class HeldJogs:
    """The jogs of one machine whose buttons are held.

    Parameters
    ----------
    link
        Connection to the controller of the machine.
    """

    def __init__(self, link: MachineLink) -> None:
        self._link = link
        self._ends: dict[str, float] = {}  # times at which jogs are stopped, by their ids
        self._sent: set[str] = set()  # jogs that the machine may execute
        self._ways: dict[str, _Way] = {}  # jogs that are sent in pieces
        self._watchers: set[asyncio.Task[None]] = set()  # one for each jog

    def begin(self, id: str, stated: float) -> None:
        """Watch a jog, before it is sent to the controller.

        Parameters
        ----------
        id
            Id of the operation.
        stated
            Time at which the person pressed the button, by the clock of the event loop.
        """
        self._ends[id] = stated + JOG_RENEWAL
        watcher = asyncio.create_task(self._follow(id), name="held jog")
        self._watchers.add(watcher)
        watcher.add_done_callback(self._watchers.discard)

    def renew(self, id: str, stated: float) -> None:
        """Extend a jog whose button was still held at the time ``stated``; an ended jog stays
        ended.
        """
        if not self.is_released(id):
            self._ends[id] = max(self._ends[id], stated + JOG_RENEWAL)

    def release_all(self) -> None:
        """End all jogs, because a person has stopped the machine."""
        self._ends = dict.fromkeys(self._ends, 0.0)

    def is_released(self, id: str) -> bool:
        """Return whether the button of a jog is not held any more."""
        return _now() >= self._ends.get(id, 0.0)

    def send(self, id: str) -> None:
        """Record that the machine may execute a jog from now on."""
        self._sent.add(id)

    def accept(self, id: str, operation: Operation, start: Pose) -> None:
        """Record that a machine, which was at rest, executes a new jog; earlier jogs have ended.

        Parameters
        ----------
        id
            Id of the operation.
        operation
            The jog, of which the first piece was sent.
        start
            Position when it began.
        """
        self._sent, self._ways = {id}, {}
        controller, feed = self._link.controller, operation.feed
        if isinstance(controller, OperableController):
            piece = jog_piece(operation.distance, feed, controller.jog_seconds)
            place = start[AXES.index(operation.axis)]
            self._ways = {id: _Way(operation.axis, feed, place + piece, place + operation.distance)}

    async def stop_all(self) -> None:
        """Stop the jogs that are held."""
        self.release_all()
        if self._watchers:
            await asyncio.wait(self._watchers, timeout=JOG_RENEWAL)
        for watcher in self._watchers:
            watcher.cancel()

    async def _follow(self, id: str) -> None:
        """Send further pieces of a jog while its button is held, then stop it."""
        while not self.is_released(id):
            await asyncio.sleep(min(max(self._ends[id] - _now(), 0.0), _PAUSE))
            if id in self._ways and not self.is_released(id):
                try:
                    goes_on = await self._extend(id, self._ways[id])
                except (KnifetipError, OSError):
                    goes_on = False
                if not goes_on:
                    del self._ways[id]
        del self._ends[id]
        self._ways.pop(id, None)
        controller = self._link.controller
        while (
            id in self._sent and isinstance(controller, OperableController) and controller.connected
        ):
            with suppress(KnifetipError, OSError):
                if (await controller.status()).state is not State.JOG:
                    break
            with suppress(KnifetipError, OSError):
                await controller.stop_jog()
            await asyncio.sleep(_PAUSE)
        self._sent.discard(id)

    async def _extend(self, id: str, way: _Way) -> bool:
        """Send another piece if the last one is almost executed; return whether the jog goes on.

        It has ended if all of it was sent, or if anything else uses the machine or has stopped it.
        """
        link, controller = self._link, self._link.controller
        if not isinstance(controller, OperableController) or abs(way.rest) < _ROUNDING:
            return False
        if link.in_use.locked() or link.runs_job:
            return False
        async with link.in_use:
            status = await controller.status()
            left = abs(way.sent - status.position[AXES.index(way.axis)])
            if status.state is State.IDLE and left > _AT_END:
                way.at_rest += 1
                return way.at_rest < _STOPPED
            if status.state not in (State.JOG, State.IDLE):
                return False
            way.at_rest = 0
            piece = jog_piece(way.rest, way.feed, controller.jog_seconds)
            # The last look: a stop or a start may have arrived during the request.
            if self.is_released(id) or link.runs_job:
                return False
            if left <= abs(jog_piece(left, way.feed, controller.jog_seconds)):
                await controller.jog(way.axis, piece, way.feed)
                way.sent += piece
            return True


def _now() -> float:
    return asyncio.get_running_loop().time()
