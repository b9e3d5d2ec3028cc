"""Numbers of events that may still appear although greater numbers were read.

PostgreSQL gives an event its number before its transaction is committed, so of two events of two
servers the one with the greater number may appear first.  A number that was skipped is queried
again for some time; that of a transaction that was rolled back never appears.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Collection
from typing import Final

_PATIENCE: Final = 30.0  # seconds, longer than any transaction of a server
_MOST: Final = 1000


class EventGaps:
    """The numbers of events that were skipped recently.

    Parameters
    ----------
    clock
        Returns the present time (s).
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._since: dict[int, float] = {}

    @property
    def numbers(self) -> list[int]:
        """Numbers that may still appear, in increasing order."""
        return sorted(self._since)

    def read(self, last: int, numbers: Collection[int]) -> int:
        """Note the numbers of events that were read; return the greatest number read so far.

        Parameters
        ----------
        last
            The greatest number read before.
        numbers
            The numbers read now: greater ones, and some of ``self.numbers``.
        """
        now = self._clock()
        newest = max(last, *numbers) if numbers else last
        first = max(last + 1, newest - _MOST)
        self._since |= dict.fromkeys(range(first, newest), now)
        self._since = {
            number: since
            for number, since in self._since.items()
            if number not in numbers and now - since < _PATIENCE
        }
        return newest
