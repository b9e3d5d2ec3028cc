"""Delay sign-ins after repeated failures, for each pair of an account and an address.

Failed attempts of an attacker do not lock out the user, who signs in from another address.
"""

from __future__ import annotations

import math
from collections import OrderedDict
from typing import Final, NamedTuple

#: Failures without a pause.
FREE: Final = 5
#: Longest pause between two attempts (s).
LONGEST: Final = 15.0
#: Failures expire after this time (s).
FORGOTTEN: Final = 3600.0
_PAIRS: Final = 10_000


class _Failures(NamedTuple):
    times: int
    last: float


class SignInThrottle:
    """Counts failed sign-ins by account and address, in the memory of this process."""

    def __init__(self) -> None:
        self._failures: OrderedDict[tuple[str, str], _Failures] = OrderedDict()

    def pause(self, account: str, address: str, now: float) -> int:
        """Return the time (s) until a sign-in is permitted, rounded up; 0 if it is permitted now.

        Parameters
        ----------
        account
            Name of the account, whether it exists or not.
        address
            Address of the sender.
        now
            Present time of a clock that does not jump (s).
        """
        found = self._failures.get((account, address))
        if found is None or found.times < FREE or now - found.last > FORGOTTEN:
            return 0
        pause = min(2.0 ** (found.times - FREE), LONGEST)
        return max(math.ceil(found.last + pause - now), 0)

    def failed(self, account: str, address: str, now: float) -> None:
        """Record a failed sign-in."""
        pair = account, address
        found = self._failures.pop(pair, _Failures(0, now))
        count = found.times if now - found.last <= FORGOTTEN else 0
        self._failures[pair] = _Failures(min(count + 1, 1000), now)
        if len(self._failures) > _PAIRS:
            self._failures.popitem(last=False)

    def succeeded(self, account: str, address: str) -> None:
        """Clear the failed sign-ins of an account from an address."""
        self._failures.pop((account, address), None)
