"""gateway_watchdog: brings the machine into its safe state if the gateway sends no requests."""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.simulators.mcx314.execution import Execution
from knifetip.simulators.mcx314.outputs import OSCILLATION
from knifetip.simulators.mcx314.parts import BoardParts

#: Time without a request after which a move that was requested is stopped (real s).
MOVE_PATIENCE = 1.0


@dataclass(frozen=True, slots=True)
class Guard:
    """Settings of the safe state when the gateway is gone."""

    time_limit: float = 0.0  #: s; 0 for nothing
    lift: int = 0  #: least Z in work coordinates (pulses)
    outputs: tuple[int, ...] = ()


class GatewayWatchdog:
    """Brings the machine into its safe state after too long a silence of the gateway.

    A move is only stopped, after ``MOVE_PATIENCE``: nobody may hold its button any more.  The guard
    has no effect until the gateway sets it.

    Parameters
    ----------
    parts
        The parts of the board.
    execution
        Execution that is then aborted.
    """

    def __init__(self, parts: BoardParts, execution: Execution) -> None:
        self.guard = Guard()
        self.given_up = False  #: the present or last program was aborted by the board
        self._parts = parts
        self._execution = execution
        self._silence = 0.0  # real time since the last request (s)

    def record_request(self) -> None:
        """Record that a request has arrived."""
        self._silence = 0.0

    def watch(self, seconds: float) -> None:
        """Bring the machine into the safe state if the gateway is gone.

        ``seconds`` is the real time since the last call.
        """
        self._silence += seconds
        if self._execution.jogs and self._silence > MOVE_PATIENCE:
            self._execution.abort()
            return
        time_limit = self.guard.time_limit
        working = self._parts.queue.runs or self._execution.holding
        may_move = not self._parts.interlock.alarm
        if time_limit > 0.0 and working and may_move and self._silence > time_limit:
            self._execution.abort()
            self.given_up = True
            self._execution.at_rest.extend((self._lift, self._release))

    def _lift(self) -> None:
        self._execution.lift(self.guard.lift + self._parts.stretches.zero[2])

    def _release(self) -> None:
        self._parts.outputs.switch(OSCILLATION, False)
        for output in self.guard.outputs:
            self._parts.outputs.switch(output, False)
