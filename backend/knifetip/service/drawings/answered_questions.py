"""Cache of orders about whose drawings no question is open.

A worker process determines the questions, which takes longer than storing the job.  With this
cache, repeated orders of a drawing need no worker process.
"""

from __future__ import annotations

import asyncio
import threading
from collections import OrderedDict
from typing import Final
from weakref import WeakValueDictionary

_REMEMBERED: Final = 4096


class AnsweredQuestions:
    """Keys of orders without open questions; see ``job_creation.PreparedOrder.questions_key``."""

    def __init__(self) -> None:
        self._answered: OrderedDict[str, None] = OrderedDict()
        self._lock = threading.Lock()
        self._alone: WeakValueDictionary[str, asyncio.Lock] = WeakValueDictionary()

    def __contains__(self, key: str) -> bool:
        """Return whether the cache contains a key, so that no question is open for its orders."""
        with self._lock:
            if key not in self._answered:
                return False
            self._answered.move_to_end(key)
            return True

    def add(self, key: str) -> None:
        """Add a key to the cache; the least recently used key is removed if the cache is full."""
        with self._lock:
            self._answered[key] = None
            if len(self._answered) > _REMEMBERED:
                self._answered.popitem(last=False)

    def lock_of(self, key: str) -> asyncio.Lock:
        """Return the lock of a key; call this method in the event loop.

        An order determines the questions while it holds the lock, so only one of several
        simultaneous orders with the same key needs a worker process.
        """
        return self._alone.setdefault(key, asyncio.Lock())
