"""parallel: call a compiled kernel for chunks of its input on all cores of the machine.

The kernel must release the GIL; otherwise the threads wait for each other.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import lru_cache
from itertools import pairwise
from typing import TypeVar, cast

_Item = TypeVar("_Item")
_Result = TypeVar("_Result")
_Other = TypeVar("_Other")


def core_count() -> int:
    """Return the number of cores of the machine."""
    return os.cpu_count() or 1


def chunks(count: int, min_size: int, max_chunks: int | None = None) -> list[tuple[int, int]]:
    """Split ``range(count)`` into contiguous chunks of nearly equal size, as (first, end) pairs.

    The number ``end`` itself is not in the chunk.

    Parameters
    ----------
    count
        Number of items to split.
    min_size
        Smallest size of a chunk that is worth handing to another thread.
    max_chunks
        Largest number of chunks; None means the number of cores.
    """
    number = max(1, min(max_chunks or core_count(), count // min_size))
    return list(pairwise(count * chunk // number for chunk in range(number + 1)))


def parallel_pair(
    func: Callable[[], _Result], other: Callable[[], _Other]
) -> tuple[_Result, _Other]:
    """Call two functions on two cores, and return the results of ``func`` and of ``other``.

    The functions must not depend on each other.
    """
    second, first = parallel_map(lambda call: call(), (other, func))
    return cast(tuple[_Result, _Other], (first, second))


def parallel_map(func: Callable[[_Item], _Result], items: Sequence[_Item]) -> list[_Result]:
    """Call ``func`` with each of the items, on all cores, and return the results in item order.

    The calling thread takes the first item, and every item that no other thread has started.  If
    calls fail, the exception of the first item that failed is raised after all calls.
    """
    futures = [_thread_pool(os.getpid()).submit(func, item) for item in items[1:]]
    results: list[_Result] = []
    failure: Exception | None = None
    for item, future in zip(items, (None, *futures), strict=False):
        try:
            results.append(func(item) if future is None or future.cancel() else future.result())
        except Exception as error:
            failure = failure or error
    if failure is not None:
        raise failure
    return results


@lru_cache(maxsize=1)
def _thread_pool(_process: int) -> ThreadPoolExecutor:
    """Return the pool of threads for all cores but one; the calling thread uses the remaining core.

    The pool is cached, because starting threads is slow.  ``_process``, the process id, is the key
    of the cache, because a forked process does not inherit threads.
    """
    return ThreadPoolExecutor(max(core_count() - 1, 1), "core")
