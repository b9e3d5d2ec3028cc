"""durable_queue: compiles jobs in durable workflows, for several processes or computers.

A durable workflow is a function call that the library DBOS records in the database and repeats if
its process, the executor, has ended unexpectedly and is restarted.  A worker takes a job from the
table of jobs, as on one computer, and compiles it in the workflow "compile-JOB-EPOCH".  The name of
the worker is the id of the executor.  A compile whose worker has ended gets another epoch when the
job is taken again, by any worker: the repeated workflow then does nothing.
"""

from __future__ import annotations

import logging
import threading
from datetime import UTC, datetime, timedelta
from importlib.metadata import version
from typing import Final

from dbos import DBOS, DBOSConfig, SetWorkflowID, WorkflowStatus

from knifetip.service.compiling.queue import Compile, TableQueue
from knifetip.service.database.tables import Job
from knifetip.service.database.url import add_options
from knifetip.service.store import Store

_PREFIX: Final = "compile"
_TIDY: Final = 60.0  # seconds between two searches for records of workflows that have no use
_KEPT: Final = timedelta(hours=1)  # age up to which the records of ended workflows are kept
_ORPHANED: Final = timedelta(minutes=1)  # age at which a workflow without its compile is orphaned
_BATCH: Final = 500  # records of one state that one search finds
_BATCHES: Final = 40  # searches in a row: more records than all workers can make in a minute
_ENDED: Final = ["SUCCESS", "ERROR", "CANCELLED", "MAX_RECOVERY_ATTEMPTS_EXCEEDED"]
_UNENDED: Final = ["PENDING", "ENQUEUED"]

_log = logging.getLogger("knifetip.jobs")


class DurableQueue:
    """A queue that compiles received jobs in workflows of the library DBOS.

    A process can have only one such queue.

    Parameters
    ----------
    store
        Store that contains the jobs.
    worker
        Name of this process, which is the owner of each job taken and the id of the executor; it
        must be the same after a restart, and no other running process may have it.
    taken
        Queue that takes the received jobs from the table of jobs.
    """

    def __init__(self, store: Store, worker: str, taken: TableQueue) -> None:
        self._store = store
        self._worker = worker
        self._taken = taken
        self._stopping = threading.Event()
        self._tidying = threading.Thread(target=self._tidy, name="tidy", daemon=True)
        self._compile: Compile = lambda _job: None

    def start(self, compile: Compile) -> None:
        """Begin to call ``compile`` with each received job, in workflows.

        Parameters
        ----------
        compile
            Function that compiles a job and stores the result.
        """
        global _running
        if _running is not None:
            raise RuntimeError("A process can run one DurableQueue. Stop the other one first.")
        _running, self._compile = self, compile
        url = add_options(self._store.database.url).render_as_string(hide_password=False)
        url = url.replace("postgresql+psycopg://", "postgresql://")
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
        # Workers take jobs from the table of jobs, which wakes them; queues of DBOS are polled.
        DBOS.listen_queues([])
        DBOS.launch()
        self._taken.start(_start_workflow)
        self._tidying.start()

    def compile(self, id: str, epoch: int) -> None:
        """Compile a job if this process still owns it in this epoch; otherwise do nothing.

        Parameters
        ----------
        id
            Id of the job.
        epoch
            Epoch of the job when this process took it.
        """
        job = self._store.compiles.find_owned(id, epoch)
        if job is not None:
            self._compile(job)

    def _tidy(self) -> None:
        """Delete records of workflows at intervals, until this object is stopped."""
        while not self._stopping.wait(_TIDY):
            try:
                for _ in range(_BATCHES):
                    if self.delete_old_workflows(datetime.now(UTC)) < _BATCH:
                        break
            except Exception:
                if not self._stopping.is_set():
                    _log.exception("the records of workflows were not deleted")

    def delete_old_workflows(self, now: datetime) -> int:
        """Delete records of workflows that have no use any more, and return their number.

        These are old ones that have ended, and those whose compile was lost with its worker.

        Parameters
        ----------
        now
            Present time.
        """
        ended = _workflows(_ENDED, now - _KEPT)
        unended = _workflows(_UNENDED, now - _ORPHANED)
        lost = [one for one in unended if not self._is_compiling(one.workflow_id)]
        old = [one.workflow_id for one in [*ended, *lost]]
        if old:
            DBOS.delete_workflows(old)
        return len(old)

    def _is_compiling(self, workflow: str) -> bool:
        """Return whether a job is being compiled in a workflow, by this or another worker."""
        _, id, epoch = workflow.rsplit("-", 2)
        return self._store.compiles.find_owned(id, int(epoch)) is not None

    def stop(self) -> None:
        """Take no further jobs, and return when all compiles have ended."""
        global _running
        self._stopping.set()
        self._taken.stop()
        self._tidying.join()
        # Workflows that end now log errors, because DBOS is being destroyed.
        logging.getLogger("dbos").setLevel(logging.CRITICAL)
        DBOS.destroy()
        _running = None


def _workflows(states: list[str], until: datetime) -> list[WorkflowStatus]:
    """Return some workflows of compiles in some states that began before a time, oldest first."""
    return DBOS.list_workflows(
        status=states,
        workflow_id_prefix=f"{_PREFIX}-",
        end_time=until.isoformat(),
        limit=_BATCH,
        load_input=False,
        load_output=False,
    )


def _start_workflow(job: Job) -> None:
    with SetWorkflowID(f"{_PREFIX}-{job.id}-{job.epoch}"):
        compile_job(job.id, job.epoch)


# DBOS calls functions that are registered when this module is imported.
_running: DurableQueue | None = None


@DBOS.workflow(name="compile")
def compile_job(job: str, epoch: int) -> None:
    """Compile a job as a workflow of DBOS.

    DBOS repeats this workflow when the process that executed it ended unexpectedly and restarts.

    Parameters
    ----------
    job
        Id of the job.
    epoch
        Epoch of the job when this process took it.
    """
    _compile(job, epoch)


@DBOS.step(name="compile")
def _compile(job: str, epoch: int) -> None:
    if _running is not None:
        _running.compile(job, epoch)
