"""parallel: distribute compiled work to all cores of the machine.

    a kernel, chunks of its work -> the results in order

The kernel must release the GIL; otherwise the threads wait for each other.
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


def core_count() -> int:
    """Return the number of cores of the machine."""
    return os.cpu_count() or 1


def chunks(count: int, worth: int, most: int | None = None) -> list[tuple[int, int]]:
    """Split ``range(count)`` into chunks of equal size, at most one per core.

    Parameters
    ----------
    worth
        Smallest chunk worth handing to another thread.
    most
        Largest number of chunks; may exceed the number of cores if other work runs beside them.
    """
    shares = max(1, min(most or core_count(), count // worth))
    return list(pairwise(count * share // shares for share in range(shares + 1)))


def parallel_pair(one: Callable[[], _Run], other: Callable[[], _Done]) -> tuple[_Run, _Done]:
    """Call two independent functions on two cores; return both results."""
    done, beside = parallel_map(lambda work: work(), (other, one))
    return cast(tuple[_Run, _Done], (beside, done))


def parallel_map(done: Callable[[_Run], _Done], work: Sequence[_Run]) -> list[_Done]:
    """Map a function over chunks on all cores; return the results in order.

    The calling thread takes the first chunk, and every chunk that no other thread has started.
    Re-raises the first exception.
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
    """Return a pool of idle threads for the other cores, since starting one takes milliseconds.

    Cached per process: a forked process does not inherit threads.
    """
    return ThreadPoolExecutor(max(core_count() - 1, 1), "core")
