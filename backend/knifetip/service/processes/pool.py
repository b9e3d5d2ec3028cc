"""pool: worker processes for tasks that need much CPU time, with limits of time and memory.

    pool.run(task, *arguments, limit=120.0, watch=...)    returns the result of the task

A task is a function ``task(progress, *arguments)`` of an importable module.  It runs in a process
of its own: a drawing that hangs, exhausts memory or crashes the interpreter ends only that process.
``progress(stage, fraction)`` calls ``watch`` in the calling thread.

A process that has loaded its modules is worth seconds, so it is killed only by the limits of time
and memory and when the pool closes.  A task that its caller cancels runs to its end, and its result
is discarded (ADR 102).  ADR 6 gives the reasons for not using pebble or loky.
"""

from __future__ import annotations

import contextlib
import gc
import logging
import multiprocessing
import os
import resource
import secrets
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
#: Seconds for which a cancelled task may run on while other tasks wait for its process.
CANCELLED = 5.0
_WATCH_INTERVAL = 1.0  # seconds between two calls of ``watch`` without progress
_REPORT = 0.1  # seconds between two progress reports of one stage

_log = logging.getLogger("knifetip.jobs")


class TaskCancelled(Exception):
    """Raised when the caller of a task cancelled it, or when the pool was closed."""


class TaskFailed(Exception):
    """Raised when a task raised an unexpected exception, whose traceback is in the log.

    Attributes
    ----------
    incident
        Number under which the log contains the exception.  Its text is not for users.
    """

    def __init__(self, cause: str) -> None:
        super().__init__(cause)
        self.incident = secrets.token_hex(4)


@dataclass(slots=True, eq=False)
class _Worker:
    """One worker process, and the pipe on which it receives tasks and sends results."""

    process: BaseProcess
    pipe: Connection
    idle_since: float = 0.0  #: time.monotonic()

    def kill(self) -> None:
        self.process.kill()
        self.process.join()
        self.pipe.close()


@dataclass(slots=True, eq=False)
class _RunningTask:
    """A task that a worker executes; the times are of the clock of the pool (s)."""

    worker: _Worker
    begun: float
    limit: float
    stage: Stage = Stage.READ  #: that the task reported last
    fraction: float = 0.0
    is_late: bool = False  #: half of the time is over: the process may be killed
    cancelled: float | None = None  #: when the caller cancelled it


def _do_nothing() -> None:
    pass


class ProcessPool:
    """A pool of worker processes, each of which is started when it is first needed.

    Parameters
    ----------
    size
        Greatest number of tasks that are executed at the same time.
    memory
        Greatest address space of a worker process (bytes).
    clock
        Clock by which the time of a task is limited (s).
    prepare
        Function of an importable module that each worker process calls before its first task.
    spare
        Number of idle processes that are kept ready for the next tasks, as far as ``size`` permits.
        While a task is late, one is kept beyond ``size``.
    """

    def __init__(
        self,
        size: int = 2,
        memory: int = MEMORY,
        clock: Callable[[], float] = time.monotonic,
        *,
        prepare: Callable[[], object] = _do_nothing,
        spare: int = 0,
    ) -> None:
        self.size = size
        self._memory = memory
        self._clock = clock
        self._prepare = prepare
        self._spare = spare
        self._spawn = multiprocessing.get_context("spawn")
        self._spawning = threading.Lock()
        self._changed = threading.Condition()
        # All that follows is protected by ``_changed``.
        self._idle: list[_Worker] = []  # the one that was used last is the last
        self._busy: list[_RunningTask] = []
        self._new: list[_Worker] = []  # that do not accept tasks yet
        self._starting = 0  # threads that start a process
        self._started = 0  # processes so far
        self._waiting = 0  # callers without a process
        self._failures = 0  # number of processes that could not be started
        self._failure = Exception()  # of the last of them
        self._closed = False

    @property
    def busy(self) -> int:
        """Number of worker processes that execute a task."""
        return len(self._busy)

    @property
    def processes_started(self) -> int:
        """Number of worker processes that were started since the pool exists."""
        return self._started

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
            again at least once per second.  It returns False to cancel the task: its process is
            kept, and is killed only if the task still runs some seconds later while others wait.

        Raises
        ------
        KnifetipError
            Raised by the task.
        DrawingTooLarge
            The task exceeded its time or memory, or its process died.
        TaskCancelled
            ``watch`` returned False, or the pool was closed.
        TaskFailed
            The task raised an exception that is not a ``KnifetipError``, or no process could be
            started.
        """
        running = self._take_worker(limit)
        kind, value = self._execute(running, (task, arguments), watch)
        if kind == "result":
            result: T = value
            return result
        if isinstance(value, KnifetipError):
            raise value
        failure = TaskFailed(str(value).strip().rsplit("\n", 1)[-1])
        _log.error("error %s: a task failed:\n%s", failure.incident, value)
        raise failure

    def _take_worker(self, limit: float) -> _RunningTask:
        """Wait for a process that may execute a task, and return it with that task.

        A process that another task leaves is as good as one that is started meanwhile.
        """
        with self._changed:
            self._waiting += 1
            failures = self._failures
            try:
                while not self._closed:
                    self._drop_dead()
                    if self._idle and len(self._busy) < self.size:
                        running = _RunningTask(self._idle.pop(), self._clock(), limit)
                        self._busy.append(running)
                        return running
                    if self._failures > failures and not self._starting:
                        raise self._failure
                    self._start_missing()
                    self._changed.wait()
                raise TaskCancelled
            finally:
                self._waiting -= 1
                self._start_missing()

    def _drop_dead(self) -> None:
        """Drop idle processes that the system has killed; locked."""
        dead = [worker for worker in self._idle if not worker.process.is_alive()]
        for worker in dead:
            self._idle.remove(worker)
            worker.pipe.close()

    def _start_missing(self) -> None:
        """Begin to start the processes that callers wait for or that should be ready; locked."""
        if self._closed:
            return
        free = max(self.size - len(self._busy), 0)
        wanted = min(max(self._waiting, self._spare), free)
        if self._spare and any(running.is_late for running in self._busy):
            wanted = max(wanted, 1)
        for _ in range(wanted - len(self._idle) - self._starting):
            self._starting += 1
            self._started += 1
            threading.Thread(target=self._start_worker, name="start-worker", daemon=True).start()

    def _start_worker(self) -> None:
        """Start a process; it is idle as soon as it has called ``prepare``."""
        worker: _Worker | None = None
        failure: Exception | None = None
        try:
            worker = self._spawn_worker()
            with self._changed:
                self._new.append(worker)
                if self._closed:
                    worker.process.kill()
            worker.pipe.recv()
        except EOFError:
            assert worker is not None
            worker.process.join(5.0)
            failure = DrawingTooLarge("worker.died", code=worker.process.exitcode)
        except Exception as reason:
            failure = TaskFailed(str(reason) or type(reason).__name__)
            _log.exception("error %s: a worker process was not started", failure.incident)
        with self._changed:
            self._starting -= 1
            if worker in self._new:
                self._new.remove(worker)
            if failure is not None:
                self._failures, self._failure = self._failures + 1, failure
            usable = failure is None and not self._closed
            if usable and worker is not None:
                worker.idle_since = time.monotonic()
                self._idle.insert(0, worker)
            self._changed.notify_all()
        if worker is not None and not usable:
            worker.kill()

    def _spawn_worker(self) -> _Worker:
        parent_end, worker_end = self._spawn.Pipe()
        process = self._spawn.Process(
            target=_serve_tasks,
            args=(worker_end, self._memory, self._prepare),
            name="knifetip worker",
            daemon=True,
        )
        with self._spawning:
            process.start()
        worker_end.close()
        return _Worker(process, parent_end)

    def _execute(self, running: _RunningTask, sent: object, watch: Watch) -> tuple[str, Any]:
        """Send a task and return its outcome; let it run on alone if its caller cancels it."""

        def watch_alone() -> bool:
            try:
                goes_on = watch(running.stage, running.fraction)
            except BaseException:
                self._cancel(running)
                raise
            if not goes_on:
                self._cancel(running)
            return goes_on

        usable = False
        try:
            running.worker.pipe.send(sent)
            outcome = self._outcome(running, watch_alone)
        except (EOFError, OSError) as reason:
            if running.cancelled is not None:
                raise  # by ``watch``; the process is well
            raise self._lost_task_error(running) from reason
        else:
            usable = True
            return outcome
        finally:
            if running.cancelled is None:
                self._give_back(running, usable=usable)

    def _cancel(self, running: _RunningTask) -> None:
        """Let a task run to its end, on a thread of its own, and discard its result."""
        running.cancelled = self._clock()
        threading.Thread(
            target=self._end_cancelled_task, args=(running,), name="run-out", daemon=True
        ).start()

    def _end_cancelled_task(self, running: _RunningTask) -> None:
        usable = False
        try:
            self._outcome(running, lambda: self._may_still_run(running))
            usable = True
        except (EOFError, OSError, DrawingTooLarge, TaskCancelled) as reason:
            _log.info("a cancelled task was ended: %s", reason or type(reason).__name__)
        finally:
            self._give_back(running, usable=usable)

    def _may_still_run(self, running: _RunningTask) -> bool:
        """Return False if a cancelled task has run on for long while other tasks wait."""
        with self._changed:
            cancelled = [one for one in self._busy if one.cancelled is not None]
            oldest = min(cancelled, key=lambda one: one.cancelled or 0.0)
            # One after the other: the first gives its process to the one that waits.
            if running is not oldest or not self._waiting or len(self._busy) < self.size:
                return True
            return self._clock() - (running.cancelled or 0.0) < CANCELLED

    def _outcome(self, running: _RunningTask, goes_on: Callable[[], bool]) -> tuple[str, Any]:
        """Wait for the outcome of a task.

        ``running``: the task; it gets the stage and the fraction that it reports.
        ``goes_on``: called after each report of the task, and at least once per second.
        Returns kind: "result" or "error"; value: the result of the task; after an error, a
        ``KnifetipError`` or the text of a traceback.
        Raises ``DrawingTooLarge``: the time of the task is over.
        Raises ``TaskCancelled``: ``goes_on`` returned False.
        Raises ``EOFError, OSError``: the process died.
        """
        pipe = running.worker.pipe
        while True:
            remaining = running.begun + running.limit - self._clock()
            if remaining <= 0:
                raise DrawingTooLarge("worker.timeout", stage=running.stage, seconds=running.limit)
            if remaining <= running.limit / 2 and not running.is_late:
                with self._changed:
                    running.is_late = True
                    self._start_missing()
            if pipe.poll(min(remaining, _WATCH_INTERVAL)):
                kind, value = pipe.recv()
                if kind != "progress":
                    return kind, value
                running.stage, running.fraction = value
            if not goes_on():
                raise TaskCancelled

    def _lost_task_error(self, running: _RunningTask) -> Exception:
        """Return the error of a task whose process died."""
        if self._closed:
            return TaskCancelled()
        running.worker.process.join(5.0)
        return DrawingTooLarge("worker.died", code=running.worker.process.exitcode)

    def _give_back(self, running: _RunningTask, *, usable: bool) -> None:
        """Make the process of an ended task idle, or kill and replace it if it is not usable."""
        worker = running.worker
        with self._changed:
            self._busy.remove(running)
            usable = usable and not self._closed
            if usable:
                worker.idle_since = time.monotonic()
                self._idle.append(worker)
            self._start_missing()
            self._changed.notify_all()
        if not usable:
            worker.kill()

    def trim(self, idle: float = IDLE) -> None:
        """End the worker processes that have had no task for ``idle`` seconds.

        The process that was used last and the spare ones are never ended.
        """
        with self._changed:
            # The worker that was used last is the first to be used again.
            kept = min(1 + self._spare, self.size)
            before = time.monotonic() - idle
            ended = [one for one in self._idle[:-kept] if one.idle_since < before]
            self._idle = [one for one in self._idle if one not in ended]
        for worker in ended:
            worker.kill()

    def close(self) -> None:
        """Kill all worker processes; running calls of ``run`` raise ``TaskCancelled``."""
        with self._changed:
            self._closed = True
            idle, self._idle = self._idle, []
            others = [*(running.worker for running in self._busy), *self._new]
            self._changed.notify_all()
        for worker in others:
            worker.process.kill()
        for worker in idle:
            worker.kill()


def _serve_tasks(pipe: Connection, memory: int, prepare: Callable[[], object]) -> None:
    """Execute the tasks that arrive on a pipe until the pipe closes; called in a worker process.

    ``pipe``: pipe from which tasks are read, and to which results and progress are written.
    ``memory``: greatest address space of this process (bytes).
    ``prepare``: called before the first task.
    """
    # Ctrl-C is sent to the whole process group; the server decides when its workers end.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    hard = resource.getrlimit(resource.RLIMIT_AS)[1]
    allowed = memory if hard == resource.RLIM_INFINITY else min(memory, hard)
    resource.setrlimit(resource.RLIMIT_AS, (allowed, hard))
    threading.Thread(target=_exit_with_parent, daemon=True).start()
    # Imported objects live until the process ends, so the garbage collector need not scan them.
    gc.disable()
    prepare()
    gc.freeze()
    gc.enable()
    reported = 0.0
    last: Stage | None = None

    def progress(stage: Stage, fraction: float) -> None:
        nonlocal reported, last
        if stage != last or time.monotonic() - reported > _REPORT:
            reported, last = time.monotonic(), stage
            pipe.send(("progress", (stage, float(fraction))))

    with contextlib.suppress(EOFError, OSError):
        pipe.send("ready")
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
