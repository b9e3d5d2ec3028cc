"""durable_queue: compiles jobs in durable workflows, for several processes or computers.

A durable workflow is a function call that the library DBOS records in the database and repeats if
the process dies.  Each received job becomes the workflow "compile-JOB-ATTEMPT" in the queue of
DBOS, from which a worker process takes it.  The arguments of the workflow are the id of the job and
the attempt number.  After a worker has died, the job gets the next attempt number and a new
workflow; the earlier workflow then does nothing.
"""

from __future__ import annotations

import logging
import threading
from importlib.metadata import version

from dbos import DBOS, DBOSConfig, SetWorkflowID

from knifetip.jobs.compile_queue import Compile
from knifetip.jobs.store import Store

QUEUE = "compile"
_POLL = 1.0  # seconds between two queries of DBOS for workflows, and of this module for jobs

_log = logging.getLogger("knifetip.jobs")


class DurableQueue:
    """A queue that compiles received jobs in workflows of the library DBOS.

    A process can have only one such queue.

    Parameters
    ----------
    store
        Store that contains the jobs.
    worker
        Name of the worker that becomes the owner of each job taken; it must be the same after a
        restart.
    at_once
        Number of jobs that are compiled at the same time; 0 in a process that does not compile.
    """

    def __init__(self, store: Store, worker: str, at_once: int) -> None:
        self._store = store
        self._worker = worker
        self._at_once = at_once
        self._stopping = threading.Event()
        self._received = threading.Event()
        self._submitting: threading.Thread | None = None
        self._compile: Compile = lambda _job: None

    def start(self, compile: Compile) -> None:
        """Begin to call ``compile`` with each received job, on threads of DBOS.

        Parameters
        ----------
        compile
            Function that compiles a job and stores the result.
        """
        global _running
        if _running is not None:
            raise RuntimeError("A process can run one DurableQueue. Stop the other one first.")
        _running, self._compile = self, compile
        url = self._store.database.url.replace("postgresql+psycopg://", "postgresql://")
        DBOS(
            config=DBOSConfig(
                name="knifetip",
                system_database_url=url,
                executor_id=self._worker,
                application_version=version("knifetip"),
                log_level="ERROR",
                enable_otlp=False,
            )
        )
        DBOS.listen_queues([QUEUE] if self._at_once else [])
        DBOS.launch()
        DBOS.register_queue(
            QUEUE,
            worker_concurrency=max(self._at_once, 1),
            polling_interval_sec=_POLL,
            # Only a process that compiles sets the number of compiles at the same time.
            on_conflict="always_update" if self._at_once else "never_update",
        )
        self._submitting = threading.Thread(target=self._submit, name="submit", daemon=True)
        self._submitting.start()

    def _submit(self) -> None:
        """Submit received jobs to the queue of the library DBOS, until this object is stopped.

        A job that this process received is submitted at once.  A job that another process received
        is submitted within about ``_POLL`` seconds.
        """
        submitted: set[tuple[str, int]] = set()
        with self._store.changes.subscribed(self._received.set):
            while not self._stopping.is_set():
                self._received.clear()
                try:
                    received = set(self._store.compiles.received_jobs())
                    for job, attempt in sorted(received - submitted):
                        # DBOS ignores a second workflow of the same name.
                        with SetWorkflowID(f"{QUEUE}-{job}-{attempt}"):
                            DBOS.enqueue_workflow(QUEUE, compile_job, job, attempt)
                    submitted = received
                except Exception:
                    # A database that cannot be reached for a moment must not end the thread.
                    if not self._stopping.is_set():
                        _log.exception("received jobs were not queued")
                self._received.wait(_POLL)

    def compile(self, id: str, attempt: int) -> None:
        """Compile a job if it still waits for this compile attempt; otherwise do nothing.

        Parameters
        ----------
        id
            Id of the job; nothing is done if the job is no longer ``received``.
        attempt
            Number of the compile attempt; nothing is done if the job has a newer attempt.
        """
        job = self._store.compiles.begin(self._worker, (id, attempt))
        if job is not None:
            self._compile(job)

    def stop(self) -> None:
        """Take no further jobs, and return when all compiles have ended."""
        global _running
        self._stopping.set()
        self._received.set()
        if self._submitting is not None:
            self._submitting.join()
        # Workflows that end now log errors, because DBOS is being destroyed.
        logging.getLogger("dbos").setLevel(logging.CRITICAL)
        DBOS.destroy()
        _running = None


# DBOS calls functions that are registered when this module is imported.
_running: DurableQueue | None = None


@DBOS.workflow(name="compile")
def compile_job(job: str, attempt: int) -> None:
    """Compile a job as a workflow of DBOS.

    DBOS repeats this workflow if the process that executed it has died.

    Parameters
    ----------
    job
        Id of the job.
    attempt
        Number of the compile attempt.
    """
    _compile(job, attempt)


@DBOS.step(name="compile")
def _compile(job: str, attempt: int) -> None:
    if _running is not None:
        _running.compile(job, attempt)
