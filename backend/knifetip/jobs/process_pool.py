"""process_pool: worker processes for tasks that need much CPU time, with limits of time and memory.

    pool.run(task, *arguments, limit=120.0, watch=...)    returns the result of the task

A task is a function ``task(progress, *arguments)`` of an importable module.  It runs in a process
of its own: a drawing that hangs, exhausts memory or crashes the interpreter ends only that process.
``progress(stage, fraction)`` calls ``watch`` in the calling thread.

ADR 6 gives the reasons for not using pebble or loky.
"""

from __future__ import annotations

import contextlib
import logging
import multiprocessing
import os
import resource
import signal
import threading
import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from typing import Any, TypeAlias, TypeVar

from knifetip.errors import DrawingTooLarge, KnifetipError
from knifetip.model.stage import Progress, Stage

#: Called with the last stage and its fraction; returns False to cancel the task.
Watch: TypeAlias = Callable[[Stage, float], bool]
T = TypeVar("T")

MEMORY = 6 << 30  #: bytes of address space of a worker
IDLE = 60.0  #: seconds after which ``trim`` ends an idle worker
_WATCH_INTERVAL = 1.0  # seconds between two calls of ``watch`` without progress
_REPORT = 0.1  # seconds between two progress reports of one stage

_log = logging.getLogger("knifetip.jobs")


class TaskCancelled(Exception):
    """Raised when the caller of a task cancelled it, or when the pool was closed."""


class TaskFailed(Exception):
    """Raised when a task raised an unexpected exception, whose traceback is in the log."""


@dataclass(slots=True)
class _Worker:
    """One worker process, and the pipe on which it receives tasks and sends results."""

    process: BaseProcess
    pipe: Connection
    idle_since: float = 0.0  #: time.monotonic()

    def kill(self) -> None:
        self.process.kill()
        self.process.join()
        self.pipe.close()


class ProcessPool:
    """A pool of worker processes, each of which is started when it is first needed.

    Parameters
    ----------
    size
        Greatest number of worker processes.
    memory
        Greatest address space of a worker process (bytes).
    clock
        Clock by which the time of a task is limited (s).
    """

    def __init__(
        self,
        size: int = 2,
        memory: int = MEMORY,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.size = size
        self._memory = memory
        self._clock = clock
        self._spawn = multiprocessing.get_context("spawn")
        self._idle: list[_Worker] = []
        self._busy: list[_Worker] = []
        self._free = threading.BoundedSemaphore(size)
        self._lock = threading.Lock()
        self._closed = False

    @property
    def busy(self) -> int:
        """Number of worker processes that execute a task."""
        return len(self._busy)

    def run(
        self,
        task: Callable[..., T],
        *arguments: object,
        limit: float,
        watch: Watch = lambda _stage, _fraction: True,
    ) -> T:
        """Execute ``task(progress, *arguments)`` in a worker process and return its result.

        Blocks the calling thread.

        Parameters
        ----------
        task
            Function of an importable module; it calls ``progress(stage, fraction)``.
        *arguments
            Further arguments of the task.
        limit
            Seconds after which the worker process is killed.
        watch
            Called with each stage and fraction that the task reports, and with the last report
            again at least once per second.  It returns False to cancel the task.

        Raises
        ------
        KnifetipError
            Raised by the task.
        DrawingTooLarge
            The task exceeded its time or memory, or its process died.
        TaskCancelled
            ``watch`` returned False, or the pool was closed.
        TaskFailed
            The task raised an exception that is not a ``KnifetipError``.
        """
        with self._free:
            with self._lock:
                if self._closed:
                    raise TaskCancelled
                worker = self._idle.pop() if self._idle else self._start_worker()
                self._busy.append(worker)
            reusable = False
            try:
                worker.pipe.send((task, arguments))
                kind, value = self._receive(worker, self._clock() + limit, limit, watch)
                reusable = True
            except (EOFError, OSError) as reason:
                if self._closed:
                    raise TaskCancelled from reason
                worker.process.join(5.0)
                raise DrawingTooLarge("worker.died", code=worker.process.exitcode) from reason
            finally:
                with self._lock:
                    self._busy.remove(worker)
                    reusable = reusable and not self._closed
                    if reusable:
                        worker.idle_since = time.monotonic()
                        self._idle.append(worker)
                if not reusable:
                    worker.kill()
        if kind == "result":
            result: T = value
            return result
        if isinstance(value, KnifetipError):
            raise value
        _log.error("a task failed:\n%s", value)
        raise TaskFailed(str(value).strip().rsplit("\n", 1)[-1])

    def _receive(
        self, worker: _Worker, deadline: float, limit: float, watch: Watch
    ) -> tuple[str, Any]:
        """Wait for the result of a task; pass the progress reports of the task to ``watch``.

        Parameters
        ----------
        worker
            Worker process that executes the task.
        deadline
            Time at which to stop waiting (s, clock of the pool).
        limit
            Time allowed for the task (s), for the error message.
        watch
            Called with each stage and fraction that the task reports, and with the last report
            again at least once per second.  It returns False to cancel the task.

        Returns
        -------
        kind
            "result" or "error".
        value
            The result of the task; after an error, a ``KnifetipError`` or the text of a traceback.

        Raises
        ------
        DrawingTooLarge
            The deadline has passed.
        TaskCancelled
            ``watch`` returned False.
        """
        stage, fraction = Stage.READ, 0.0
        while True:
            remaining = deadline - self._clock()
            if remaining <= 0:
                raise DrawingTooLarge("worker.timeout", stage=stage, seconds=limit)
            if worker.pipe.poll(min(remaining, _WATCH_INTERVAL)):
                kind, value = worker.pipe.recv()
                if kind != "progress":
                    return kind, value
                stage, fraction = value
            if not watch(stage, fraction):
                raise TaskCancelled

    def _start_worker(self) -> _Worker:
        parent_end, worker_end = self._spawn.Pipe()
        process = self._spawn.Process(
            target=_serve_tasks,
            args=(worker_end, self._memory),
            name="knifetip worker",
            daemon=True,
        )
        process.start()
        worker_end.close()
        return _Worker(process, parent_end)

    def trim(self, idle: float = IDLE) -> None:
        """End the worker processes that have had no task for ``idle`` seconds.

        The process that was used last is never ended.
        """
        with self._lock:
            # The worker that was used last is the first to be used again.
            before = time.monotonic() - idle
            ended = [one for one in self._idle[:-1] if one.idle_since < before]
            self._idle = [one for one in self._idle if one not in ended]
        for worker in ended:
            worker.kill()

    def close(self) -> None:
        """Kill all worker processes; running calls of ``run`` raise ``TaskCancelled``."""
        with self._lock:
            self._closed = True
            idle, self._idle = self._idle, []
            busy = list(self._busy)
        for worker in busy:
            worker.process.kill()
        for worker in idle:
            worker.kill()


def _serve_tasks(pipe: Connection, memory: int) -> None:
    """Execute the tasks that arrive on a pipe until the pipe closes; called in a worker process.

    Parameters
    ----------
    pipe
        Pipe from which tasks are read, and to which results and progress are written.
    memory
        Greatest address space of this process (bytes).
    """
    # Ctrl-C is sent to the whole process group; the server decides when its workers end.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    hard = resource.getrlimit(resource.RLIMIT_AS)[1]
    allowed = memory if hard == resource.RLIM_INFINITY else min(memory, hard)
    resource.setrlimit(resource.RLIMIT_AS, (allowed, hard))
    threading.Thread(target=_exit_with_parent, daemon=True).start()
    reported = 0.0
    last: Stage | None = None

    def progress(stage: Stage, fraction: float) -> None:
        nonlocal reported, last
        if stage != last or time.monotonic() - reported > _REPORT:
            reported, last = time.monotonic(), stage
            pipe.send(("progress", (stage, float(fraction))))

    with contextlib.suppress(EOFError, OSError):
        while True:
            task, arguments = pipe.recv()
            last = None
            pipe.send(_outcome(task, progress, arguments))


def _outcome(task: Callable[..., Any], progress: Progress, arguments: Any) -> tuple[str, Any]:
    try:
        return "result", task(progress, *arguments)
    except KnifetipError as reason:
        return "error", reason
    except MemoryError:
        return "error", DrawingTooLarge("worker.memory", limit=MEMORY >> 30)
    except Exception:
        return "error", traceback.format_exc()


def _exit_with_parent() -> None:
    """End this worker process as soon as the server process is gone, even if it was killed."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        wait([parent.sentinel])
        os._exit(0)
