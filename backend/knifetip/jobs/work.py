"""work: compiles jobs, as durable workflows that survive the death of their process.

    received job -> DBOS workflow on the queue "compile" -> a process of the crew -> ready | refused

DBOS knows job ids and nothing else.  What a compile makes is kept by the store in the one
transaction that moves the job, and only while the worker still holds the job's epoch, so that a
compile which runs twice (and after kill -9 it may) leaves one result.  Cuts are never workflows.
"""

from __future__ import annotations

import contextlib
import logging
import socket
import threading
import time
from dataclasses import dataclass, field
from importlib.metadata import version

from dbos import DBOS, DBOSConfig, SetWorkflowID

from knifetip.errors import JobError, KnifetipError, OpenQuestions
from knifetip.jobs import tasks
from knifetip.jobs.crew import Crew, Fault, Withdrawn
from knifetip.jobs.grace import Grace
from knifetip.jobs.interpretations import interpretation_of
from knifetip.jobs.readings import StoredDrawing
from knifetip.jobs.store import Store
from knifetip.model.stage import Stage

QUEUE = "compile"
LIMIT = 120.0  #: seconds that a reading or a compile may take
_POLL = 0.1  # seconds between two looks of DBOS at its queue
_RENEW = 1.0  # seconds between two renewals of a compile's lease

_log = logging.getLogger("knifetip.jobs")


def _version() -> str:
    return version("knifetip")


@dataclass(slots=True)
class Workshop:
    """Hands received jobs to DBOS, compiles them, and takes back what silent owners had.

    There is one to a process, since there is one DBOS to a process.
    """

    store: Store
    crew: Crew
    name: str = ""  #: stable over restarts: DBOS gives a dead worker's compiles to its name
    compiles: bool = True  #: False in a server whose workers are other processes
    at_once: int = 1
    limit: float = LIMIT
    gateways: bool = True  #: False in a process that gateways do not report to

    _stopping: threading.Event = field(default_factory=threading.Event)
    _sweeping: threading.Thread | None = None

    def start(self) -> None:
        """Begin; the store must be migrated.  Not to be called on an event loop's thread."""
        global _workshop
        if _workshop is not None:
            raise RuntimeError("a process has one workshop, and this one has one already")
        self.name = self.name or socket.gethostname()
        settings = DBOSConfig(
            name="knifetip",
            system_database_url=self.store.url.replace("postgresql+psycopg://", "postgresql://"),
            executor_id=self.name,
            application_version=_version(),
            log_level="ERROR",
            enable_otlp=False,
        )
        _workshop = self
        DBOS(config=settings)
        DBOS.listen_queues([QUEUE] if self.compiles else [])
        DBOS.launch()
        DBOS.register_queue(
            QUEUE,
            worker_concurrency=self.at_once,
            polling_interval_sec=_POLL,
            # How many at once is for those to say who compile.
            on_conflict="always_update" if self.compiles else "never_update",
        )
        self._sweeping = threading.Thread(target=self._sweep, name="sweep", daemon=True)
        self._sweeping.start()
        threading.Thread(target=self._rehearse, name="rehearsal", daemon=True).start()

    def stop(self) -> None:
        """End at once: a compile under way is broken off, and tried again at the next start."""
        global _workshop
        self._stopping.set()
        self.crew.close()
        if self._sweeping is not None:
            self._sweeping.join()
        # Compiles that are broken off report to a DBOS that is going away: no error to anybody.
        logging.getLogger("dbos").setLevel(logging.CRITICAL)
        DBOS.destroy()
        _workshop = None

    def submit(self, job: str, attempt: int = 1) -> None:
        """Have a received job compiled; to say it twice does no harm."""
        with SetWorkflowID(f"{QUEUE}-{job}-{attempt}"):
            DBOS.enqueue_workflow(QUEUE, compile_job, job, attempt)

    def _sweep(self) -> None:
        # What waits since before this process was born is taken up without delay.
        patience = 0.0
        grace = Grace()
        while not self._stopping.is_set():
            listened = grace.over(self.store.clock())
            try:
                for job, attempt in self.store.sweep(patience, gateways=self.gateways and listened):
                    self.submit(job, attempt)
                patience = 2.0
            except Exception:
                # A database that is away for a moment must not end the sweeping.
                if not self._stopping.is_set():
                    _log.exception("the sweep failed")
            self._stopping.wait(1.0)

    def _rehearse(self) -> None:
        with contextlib.suppress(Withdrawn):
            try:
                self.crew.run(tasks.rehearse, limit=self.limit)
            except (KnifetipError, Fault):
                _log.exception("the rehearsal failed")

    def compile(self, id: str, attempt: int) -> None:
        """Compile a job, if it is still this attempt's to compile."""
        job = self.store.begin_compile(id, attempt, self.name)
        if job is None:
            return
        epoch = job.epoch
        renewed = time.monotonic()
        said: Stage | None = None

        def watch(stage: Stage, fraction: float) -> bool:
            nonlocal renewed, said
            now = time.monotonic()
            if stage == said and now - renewed < _RENEW / 5:
                return True
            renewed, said = now, stage
            return self.store.compile_progress(id, epoch, stage, fraction)

        drawing = self.store.drawing_with(job.drawing, "content", "edges", "overrides")
        stored = StoredDrawing(
            drawing.content, drawing.edges, interpretation_of(drawing, drawing.overrides)
        )
        try:
            result = self.crew.run(
                tasks.compile,
                stored,
                interpretation_of(job, self.store.job_column(id, "overrides")),
                job.machine,
                job.board,
                (f"knifetip {_version()}", f"drawing {drawing.sha256[:40]}"),
                limit=self.limit,
                watch=watch,
            )
            self.store.compiled(id, epoch, result)
        except Withdrawn:
            if self._stopping.is_set():
                with contextlib.suppress(JobError):
                    self.store.give_back(id, epoch)
        except OpenQuestions as reason:
            self._refuse(id, epoch, reason, reason.questions)
        except JobError:
            # Cancelled, or taken by another, while the result was on its way.
            _log.info("the result of job %s came too late", id)
        except KnifetipError as reason:
            self._refuse(id, epoch, reason)
        except Fault as reason:
            self._refuse(
                id,
                epoch,
                KnifetipError(
                    f"The compile failed in a way that nobody foresaw: {reason}.",
                    "The server's log has the details; nothing was cut.",
                ),
            )

    def _refuse(
        self,
        id: str,
        epoch: int,
        reason: KnifetipError,
        questions: list[dict[str, object]] | None = None,
    ) -> None:
        with contextlib.suppress(JobError):
            self.store.refuse(
                id, epoch, reason.message, reason.hint, reason.source, questions or ()
            )


# DBOS calls functions, registered when this module is imported; this is whose they are.
_workshop: Workshop | None = None


@DBOS.workflow(name="compile")
def compile_job(job: str, attempt: int) -> None:
    """Compile a job: the workflow that DBOS keeps alive."""
    _compile(job, attempt)


@DBOS.step(name="compile")
def _compile(job: str, attempt: int) -> None:
    if _workshop is not None:
        _workshop.compile(job, attempt)
