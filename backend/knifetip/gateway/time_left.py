"""time_left: estimates the remaining time of the copies of a program.

The estimate begins with the duration that the job states.  While the machine runs, the measured
time is compared with the share of the stated duration that is done.  A difference of seconds is no
evidence of another pace: controllers need some time to begin, and reports come late.  A larger one
scales the rest.  Time in a hold does not count, and the estimate does not grow in a hold.  A feed
override scales the rest at once; the measured time counts as if it were 100 %.
"""

from __future__ import annotations

from knifetip.gateway.controller import State

#: Difference between measured and stated time of the executed part that is no evidence of another
#: pace (s); twice as much is full evidence.
LATE = 2.0
#: Executed time that the measured pace needs to outweigh the stated one (s).
_LEAST = 1.0


class TimeLeft:
    """Estimates the remaining time of the copies of one program.

    Parameters
    ----------
    stated
        Duration of a copy that the job states (s); 0 if it states none.
    """

    def __init__(self, stated: float = 0.0) -> None:
        self._expected = stated
        self._lines = 0.0  # duration of all lines, as computed
        self._scale = 1.0  # expected duration per computed one
        self._running = 0.0
        self._last: float | None = None
        self._left: float | None = None

    @property
    def expected(self) -> float | None:
        """Expected duration of a copy that has not begun (s); None if it is unknown."""
        return self._expected or None

    def begin(self, lines: float) -> None:
        """Begin a copy.

        Parameters
        ----------
        lines
            Duration of all lines of the program, as computed from the limits of the axes (s); 0
            if it is unknown.
        """
        self._lines = lines
        if self._expected <= 0.0:
            self._expected = lines
        self._scale = self._expected / lines if lines > 0.0 else 1.0
        self._running = 0.0
        self._last = self._left = None

    def update(self, done: float, state: State, now: float, override: int = 100) -> float | None:
        """Return the estimated remaining time of the copy (s); None if it is unknown.

        Parameters
        ----------
        done
            Computed duration of the executed part (s), of that of all lines.
        state
            Present state of the controller; time counts only while it runs.
        now
            Present time of a steady clock (s).
        override
            Present feed override (%).
        """
        if self._lines <= 0.0:
            return None
        if self._last is not None and state is State.RUN:
            self._running += (now - self._last) * override / 100.0
        self._last = now
        executed = min(done, self._lines) * self._scale
        left = (self._expected - executed) * self._pace(executed) * 100.0 / override
        if state is not State.RUN and self._left is not None:
            left = min(left, self._left)
        self._left = left
        return left

    def end(self) -> None:
        """End a copy that was executed to its last line; later copies take as long."""
        if self._lines > 0.0 and self._running > 0.0:
            self._expected *= self._pace(self._expected)

    def _pace(self, executed: float) -> float:
        """Return the real time per expected time of the executed part."""
        excess = self._running - executed
        evidence = min(max(abs(excess) / LATE - 1.0, 0.0), 1.0)
        return 1.0 + evidence * excess / (executed + _LEAST)
