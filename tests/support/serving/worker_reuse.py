"""Worker processes that one server of a test after the other uses.

A new process imports the engine, which takes more than a second of CPU time, and a server keeps a
second one ready.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Callable
from typing import Any, ClassVar

from knifetip.service.processes.pool import ProcessPool, _Worker

#: Most processes that are kept for the next pool.
_MOST = 2


class ReusingPool(ProcessPool):
    """A pool that starts with the idle processes of an earlier one with the same surroundings."""

    _lock: ClassVar[threading.Lock] = threading.Lock()
    _kept: ClassVar[list[_Worker]] = []
    _kept_for: ClassVar[object] = None

    def __init__(self, size: int = 2, **options: Any) -> None:
        super().__init__(size, **options)
        prepare: Callable[[], object] | None = options.get("prepare")
        self._surroundings = (self._memory, prepare, _surroundings())

    def _spawn_worker(self) -> _Worker:
        cls = type(self)
        with cls._lock:
            while cls._kept and cls._kept_for == self._surroundings:
                worker = cls._kept.pop()
                if worker.process.is_alive():
                    # Its answer is received in place of that of a new process.
                    worker.pipe.send((bool, ()))
                    return worker
                worker.pipe.close()
        return super()._spawn_worker()

    def close(self) -> None:
        """Keep some idle processes, and kill the others."""
        cls = type(self)
        with self._changed, cls._lock:
            ended: list[_Worker] = []
            if cls._kept_for != self._surroundings:
                ended, cls._kept = cls._kept, []
                cls._kept_for = self._surroundings
            while self._idle and len(cls._kept) < _MOST:
                cls._kept.append(self._idle.pop())
        for worker in ended:
            worker.kill()
        super().close()


def _surroundings() -> object:
    """Return what a process takes over from this one at its start."""
    variables = {name: value for name, value in os.environ.items() if "PYTEST" not in name}
    return os.getcwd(), variables
