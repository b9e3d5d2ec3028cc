"""queue: passes received jobs to the compile service, which makes their programs.

The database table of the jobs is the queue.  On PostgreSQL, where several processes or computers
compile, each job is compiled in a durable workflow of the library DBOS (``durable_queue``).  Both
kinds of queue take a job with ``CompileStore.begin``, which increases the epoch of the job (a
number that identifies the owner).  The result of a compile is stored only if the job still has the
epoch with which it was taken.
"""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable
from typing import Protocol, TypeAlias

from knifetip.service.database.change_notifier import RECEIVED
from knifetip.service.database.tables import Job
from knifetip.service.store import Store

#: Compiles a job that ``CompileStore.begin`` returned.
Compile: TypeAlias = Callable[[Job], None]

#: Returns the fraction (0 … 1) of the kernels for a machine that are compiled; 1 if all are.
FractionCompiled: TypeAlias = Callable[[str], float]

_READY_POLL = 0.1  # seconds between two checks of the kernels that jobs wait for
_PATIENCE = 2.0  # seconds until a job reports that it waits: after a start nothing is known yet
_PAUSE = 1.0  # seconds before the next attempt after the database could not be used

_log = logging.getLogger("knifetip.jobs")


class CompileQueue(Protocol):
    """Interface of a queue that passes each received job to a function that compiles the job."""

    def start(self, compile: Compile) -> None:
        """Begin to call ``compile`` with each received job, on threads of the queue.

        Parameters
        ----------
        compile
            Function that compiles a job and stores the result.
        """

    def stop(self) -> None:
        """Take no further jobs, and return when all calls of ``compile`` have ended."""


class TableQueue:
    """A queue that takes received jobs from the table of jobs.

    Parameters
    ----------
    store
        Store that contains the jobs.
    worker
        Name of the worker that becomes the owner of each job taken.
    at_once
        Number of jobs that are compiled at the same time.
    poll
        Time between two queries for jobs that another process received (s), if that process
        does not notify this one.
    fraction_compiled
        Function that takes the name of a machine and returns a fraction (0 … 1): the part of the
        numba functions for compiling jobs for this machine that has machine code.  While the
        fraction is below 1, jobs for this machine stay ``received``; jobs for other machines are
        compiled.
    """

    def __init__(
        self,
        store: Store,
        worker: str,
        at_once: int,
        poll: float,
        fraction_compiled: FractionCompiled = lambda _machine: 1.0,
    ) -> None:
        self._store = store
        self._worker = worker
        self._at_once = at_once
        self._poll = poll
        self._fraction_compiled = fraction_compiled
        #: when each machine was first found without its kernels (s, monotonic clock)
        self._unready: dict[str, float] = {}
        self._stopping = threading.Event()
        #: each thread with its own event, so that none clears that of another
        self._threads: list[tuple[threading.Thread, threading.Event]] = []

    def start(self, compile: Compile) -> None:
        """Begin to call ``compile`` with each received job, on ``at_once`` threads.

        Parameters
        ----------
        compile
            Function that compiles a job and stores the result.
        """
        for number in range(self._at_once):
            received = threading.Event()
            thread = threading.Thread(
                target=self._take_jobs,
                args=(compile, received),
                name=f"compile-{number + 1}",
                daemon=True,
            )
            self._threads.append((thread, received))
            thread.start()

    def _take_jobs(self, compile: Compile, received: threading.Event) -> None:
        """Call ``compile`` with one received job after another until the queue is stopped.

        A job stays in the queue until the numba functions that are needed to compile it have
        machine code.
        """
        changes = self._store.changes
        with changes.subscribed(received.set, RECEIVED):
            while not self._stopping.is_set():
                received.clear()
                try:
                    job = self._next_job()
                    if job is not None:
                        compile(job)
                        continue
                except Exception:
                    # A database that cannot be reached for a moment must not end the thread.
                    if not self._stopping.is_set():
                        _log.exception("a compile failed")
                    self._stopping.wait(_PAUSE)
                received.wait(_READY_POLL if self._unready else changes.poll(self._poll))

    def _next_job(self) -> Job | None:
        """Take the oldest received job that can be compiled now; return None if there is none.

        A job can be compiled if all numba functions that its machine needs have machine code.  If
        they do not have it within ``_PATIENCE`` seconds, a message is stored in the received jobs
        for the machine.
        """
        machines = self._store.compiles.received_machines()
        compiled = {machine: self._fraction_compiled(machine) for machine in machines}
        unready = [machine for machine in machines if compiled[machine] < 1.0]
        now = time.monotonic()
        self._unready = {machine: self._unready.get(machine, now) for machine in unready}
        for machine, since in self._unready.items():
            if now - since >= _PATIENCE:
                self._store.compiles.report_waiting(machine, compiled[machine])
        return (
            self._store.compiles.begin(self._worker, excluded_machines=unready)
            if machines
            else None
        )

    def stop(self) -> None:
        """Take no further jobs, and return when all calls of ``compile`` have ended."""
        self._stopping.set()
        for _, received in self._threads:
            received.set()
        for thread, _ in self._threads:
            thread.join()
