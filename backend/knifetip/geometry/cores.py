"""cores: work that is shared out to all the cores of the machine.

    a compiled function, runs of its work -> what it gives for each run, in order

The function must be compiled with ``nogil``; else the cores wait for each other.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from typing import TypeVar

_Run = TypeVar("_Run")
_Done = TypeVar("_Done")


def number() -> int:
    """Return how many cores the machine has."""
    return os.cpu_count() or 1


def runs(count: int, worth: int) -> list[tuple[int, int]]:
    """Return runs of ``range(count)`` of one size, one for each core that is ``worth`` its start.

    Parameters
    ----------
    worth
        So much one core has done before another has begun.
    """
    shares = max(1, min(number(), count // worth))
    return list(pairwise(count * share // shares for share in range(shares + 1)))


def both(one: Callable[[], _Run], other: Callable[[], _Done]) -> tuple[_Run, _Done]:
    """Return what is done of two things that do not need each other, one to a core."""
    if number() < 2:
        return one(), other()
    with ThreadPoolExecutor(1) as core:
        beside = core.submit(one)
        done = other()
        return beside.result(), done


def each(done: Callable[[_Run], _Done], work: Sequence[_Run]) -> list[_Done]:
    """Return what is done of each run, in order; the first that fails raises its error."""
    if len(work) == 1:
        return [done(work[0])]
    with ThreadPoolExecutor(len(work)) as cores:
        return list(cores.map(done, work))
