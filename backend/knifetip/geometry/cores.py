"""cores: work that is shared out to all the cores of the machine.

    a compiled function, runs of its work -> what it gives for each run, in order

The function must be compiled with ``nogil``; else the cores wait for each other.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import lru_cache
from itertools import pairwise
from typing import TypeVar, cast

_Run = TypeVar("_Run")
_Done = TypeVar("_Done")


def number() -> int:
    """Return how many cores the machine has."""
    return os.cpu_count() or 1


def runs(count: int, worth: int, most: int | None = None) -> list[tuple[int, int]]:
    """Return runs of ``range(count)`` of one size, one for each core that is ``worth`` its start.

    Parameters
    ----------
    worth
        So much one core has done before another has begun.
    most
        So many runs, though there be fewer cores: what is done besides takes a part of one.
    """
    shares = max(1, min(most or number(), count // worth))
    return list(pairwise(count * share // shares for share in range(shares + 1)))


def both(one: Callable[[], _Run], other: Callable[[], _Done]) -> tuple[_Run, _Done]:
    """Return what is done of two things that do not need each other, one to a core."""
    done, beside = each(lambda work: work(), (other, one))
    return cast(tuple[_Run, _Done], (beside, done))


def each(done: Callable[[_Run], _Done], work: Sequence[_Run]) -> list[_Done]:
    """Return what is done of each run, in order; the first that fails raises its error.

    The first is done here, and so is whatever no other core has begun by then.
    """
    beside = [_others(os.getpid()).submit(done, run) for run in work[1:]]
    results: list[_Done] = []
    wrong: Exception | None = None
    for run, future in zip(work, (None, *beside), strict=False):
        try:
            results.append(done(run) if future is None or future.cancel() else future.result())
        except Exception as error:
            wrong = wrong or error
    if wrong is not None:
        raise wrong
    return results


@lru_cache(maxsize=1)
def _others(_process: int) -> ThreadPoolExecutor:
    """Return threads for the other cores, which wait for work: to start one takes milliseconds.

    A process that was forked has none of those of its parent.
    """
    return ThreadPoolExecutor(max(number() - 1, 1), "core")
