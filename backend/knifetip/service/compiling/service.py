"""service: compiles received jobs in worker processes, and takes back abandoned jobs.

An UPDATE takes a job from the queue.  It sets the state ``compiling``, the owner, the epoch (a
number that increases with each new owner) and the lease (the time at which the owner loses the job
unless it has renewed the lease; ADR 28).  One transaction stores the result and moves the job to
its next state, but only if the job still has the epoch of the worker.  A job that is compiled twice
therefore has one result.  A job whose worker process ended unexpectedly is compiled again.
"""

from __future__ import annotations

import contextlib
import logging
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from importlib.metadata import version

import sqlalchemy.exc

from knifetip import logs, tracing
from knifetip.errors import (
    ContentLost,
    JobError,
    KnifetipError,
    LibraryError,
    OpenQuestions,
    StoreError,
)
from knifetip.library.definition import Definition, Shelf, machine_of
from knifetip.model.acceptance import Exceptions
from knifetip.model.machine import Machine
from knifetip.model.stage import Stage
from knifetip.model.tool import Engine, kind_of
from knifetip.service.compiling.grace_period import GracePeriod
from knifetip.service.compiling.key import compile_key
from knifetip.service.compiling.queue import CompileQueue
from knifetip.service.compiling.queue_selection import select_queue
from knifetip.service.database.process_link import ProcessLink, join
from knifetip.service.database.tables import Drawing, Job
from knifetip.service.drawings.interpretations import interpretation_of
from knifetip.service.processes import tasks
from knifetip.service.processes.pool import ProcessPool, TaskCancelled, TaskFailed, Watch
from knifetip.service.processes.readings import StoredDrawing
from knifetip.service.processes.reported_stages import ReportedStages, reported_stages
from knifetip.service.processes.rest_record import RestRecord, StoredRest
from knifetip.service.processes.warm_up import WarmUp
from knifetip.service.store import Store
from knifetip.tracing import SpanKind

LIMIT = 120.0  #: seconds that a reading or a compile may take
_RENEW = 0.2  # seconds between two renewals of a compile's lease
_KEEP = 2.5  # seconds between two renewals while nothing reports progress
_LONGEST = 900.0  # seconds for which a lease is renewed without progress
_SWEEP = 1.0  # seconds between two sweeps while a job has a lease
_IDLE_SWEEP = 3.0  # seconds between two sweeps otherwise: several in the duration of a lease
_SERVER_POLL = 3.0  # seconds between two looks of a server for jobs that another process received
_WORKER_POLL = 0.5  # the same of a worker, all of whose jobs are received by another process

_log = logging.getLogger("knifetip.jobs")


def kernels_for(machine: Machine) -> tuple[str, ...]:
    """Return the names of the groups of kernels that are needed to compile jobs for a machine.

    Kernels are functions that numba compiles to machine code.
    """
    engines = {kind_of(station.tool).engine for station in machine.stations}
    return ("drawings", "jobs", "offsets") if Engine.RADIUS in engines else ("drawings", "jobs")


def compile_arguments(store: Store, job: Job, machine: Definition) -> tuple[object, ...]:
    """Return the arguments of ``tasks.compile`` that compile a job for a machine.

    Parameters
    ----------
    store
        Store with the drawing of the job.
    job
        The job.
    machine
        The machine of the job, or one to which the job is to be moved.
    """
    board = store.library.definition(Shelf.BOARDS, job.board, job.board_version)
    drawing = store.drawings.get_with(job.drawing, "content", "edges", "overrides")
    return (
        StoredDrawing(
            drawing.content,
            drawing.edges,
            interpretation_of(drawing, drawing.overrides),
            drawing.layout is not None,
        ),
        interpretation_of(job, store.jobs.column(job.id, "overrides")),
        machine,
        board,
        _notes(job, drawing, machine, board),
        None if job.exceptions is None else Exceptions.from_json(job.exceptions),
        _stored_rest(store, job),
    )


def _notes(job: Job, drawing: Drawing, *definitions: Definition) -> tuple[str, ...]:
    """Return the comments at the head of the program of a job.

    They name the version of knifetip, the file of the drawing, the versions of the machine and the
    board if a user has made them, and the job that the job continues.
    """
    notes = [f"knifetip {version('knifetip')}", f"drawing {drawing.sha256[:40]}"]
    notes += [
        f"{one.shelf.word} {one.name} version {one.version}" for one in definitions if one.version
    ]
    if job.rest is not None:
        notes.append(f"continues job {job.resumes}")
    return tuple(notes)


def _stored_rest(store: Store, job: Job) -> StoredRest | None:
    """Return the work that remains on the sheet that a job continues, with the stored data of the
    earlier jobs; None if the job begins a new sheet.
    """
    if job.rest is None or job.resumes is None:
        return None
    record = RestRecord.from_json(job.rest)
    return StoredRest(
        store.jobs.column(job.resumes, "toolpath"),
        record.tracks,
        tuple(
            (store.jobs.column(work.job, "program"), work.lines, work.repeated)
            for work in record.made
        ),
    )


@dataclass(slots=True)
class CompileService:
    """Threads that compile received jobs, and take jobs back from owners whose lease has expired.

    The owner of a job is a worker or a gateway.  An owner that does not renew its lease in time
    loses the job.
    """

    store: Store
    pool: ProcessPool
    #: must not change at a restart, which repeats the compiles under this name; "" for a default
    name: str = ""
    compiles: bool = True  #: False in a server whose workers are other processes
    at_once: int = 1
    limit: float = LIMIT
    gateways: bool = True  #: False in a process that gateways do not report to
    warm_up: WarmUp = field(default_factory=WarmUp)  #: started with the service
    #: called with each stage of a compile that has ended, and its duration (s)
    observe: Callable[[Stage, float], None] = lambda _stage, _seconds: None
    #: called with the duration of each compile (s), whatever its result
    observe_compile: Callable[[float], None] = lambda _seconds: None

    _stopping: threading.Event = field(default_factory=threading.Event)
    _swept: float | None = None  # time.monotonic() of the last sweep
    _queue: CompileQueue | None = None
    _link: ProcessLink | None = None
    _threads: list[threading.Thread] = field(default_factory=list)

    def start(self) -> None:
        """Take the name and start the threads; the database must have the current schema.

        Raises
        ------
        StoreError
            A running process with this database has the same name.
        """
        role = "server" if self.gateways else "worker"
        self._link = join(self.store.database.url, self.store.changes, self.name, role)
        self.name = self._link.name
        if self.compiles:
            self.store.compiles.recover(self.name)
        self._swept = time.monotonic()
        self._start_thread(self._sweep, "sweep")
        self.warm_up.start(self.pool)
        if not self.compiles:
            return
        # Jobs that this process receives notify the queue; a server has no others on SQLite.
        poll = _SERVER_POLL if self.gateways else _WORKER_POLL
        self._queue = select_queue(
            self.store,
            self.name,
            self.at_once,
            poll,
            fraction_compiled=self.fraction_compiled,
        )
        self._queue.start(self.compile)

    def fraction_compiled(self, machine: str) -> float:
        """Return the fraction (0 … 1) of the kernels for a machine that have machine code.

        Kernels are functions that a compile needs.  Returns 1 only if a compile for the machine can
        begin.
        """
        try:
            kernels = kernels_for(self.store.library.machine(machine))
            return self.warm_up.fraction_compiled(*kernels)
        except LibraryError:
            return 1.0  # the compile refuses the job

    @property
    def seconds_since_sweep(self) -> float | None:
        """Seconds since the last sweep, which runs every few seconds; None before the start."""
        return None if self._swept is None else time.monotonic() - self._swept

    def _start_thread(self, target: Callable[[], None], name: str) -> None:
        thread = threading.Thread(target=target, name=name, daemon=True)
        thread.start()
        self._threads.append(thread)

    def stop(self) -> None:
        """Stop compiling immediately; a running compile is repeated after the next start."""
        self._stopping.set()
        self.warm_up.close()
        self.pool.close()
        if self._queue is not None:
            self._queue.stop()
        for thread in self._threads:
            thread.join()
        # The name is released when no compile uses it any more.
        if self._link is not None:
            self._link.close()

    def _sweep(self) -> None:
        grace = GracePeriod()
        while not self._stopping.is_set():
            leased = True
            try:
                listened = grace.is_over(self.store.database.clock())
                leased = self.store.leases.run(gateways=self.gateways and listened)
                self.pool.trim()
            except Exception:
                if not self._stopping.is_set():
                    _log.exception("the sweep failed")
            self._swept = time.monotonic()
            self._stopping.wait(_SWEEP if leased else _IDLE_SWEEP)

    def compile(self, job: Job) -> None:
        """Compile a job and store the result; see ``_compile``."""
        about = tracing.Attributes(
            job=job.id, drawing=job.drawing, machine=job.machine, attempt=job.attempt
        )
        # The order waits in the database: its span was that of another process, perhaps.
        with (
            logs.about(job=job.id),
            tracing.span("compile", SpanKind.CONSUMER, job.traceparent, **about),
            self._kept_lease(job.id, job.epoch),
        ):
            begun = time.monotonic()
            self._compile(job)
            self.observe_compile(time.monotonic() - begun)
            fields = {"duration": round(time.monotonic() - begun, 4)}
            _log.info("compiled", extra={logs.FIELDS: fields})

    @contextlib.contextmanager
    def _kept_lease(self, id: str, epoch: int) -> Iterator[None]:
        """Return a context in which the lease of a compile is renewed by a thread of its own.

        A compile also waits where nothing reports progress: for a worker process while requests
        occupy all of them, and for the folder or the bucket that contains large values.
        """
        ended = threading.Event()

        def renew() -> None:
            until = time.monotonic() + _LONGEST
            while not ended.wait(_KEEP) and time.monotonic() < until:
                try:
                    if not self.store.compiles.renew_lease(id, epoch):
                        return
                except sqlalchemy.exc.SQLAlchemyError as reason:
                    _log.warning("the lease of job %s was not renewed: %s", id, reason)

        thread = threading.Thread(target=renew, name="lease", daemon=True)
        thread.start()
        try:
            yield
        finally:
            ended.set()
            thread.join()

    def _compile(self, job: Job) -> None:
        """Compile a job and store the result.

        If the job cannot be compiled, it is refused with a message about the reason.

        ``job``: a job in the state ``compiling``, which this worker has taken from the queue.
        """
        id, epoch = job.id, job.epoch
        try:
            machine = self.store.library.definition(
                Shelf.MACHINES, job.machine, job.machine_version
            )
            arguments = compile_arguments(self.store, job, machine)
            key = compile_key(arguments)
            if self.store.compiles.answer(id, epoch, key):
                tracing.current().set(outcome="answered")
                return
            with reported_stages(self.observe) as stages:
                watch = self._watch(id, epoch, stages)
                self.warm_up.wait(*kernels_for(machine_of(machine)), watch=watch)
                result = self.pool.run(tasks.compile, *arguments, limit=self.limit, watch=watch)
            with tracing.span("save result"):
                self.store.compiles.save_result(id, epoch, result, key)
            outcome = "accepted" if result.accepted else "refused"
            tracing.current().set(outcome=outcome, lines=result.lines)
            if result.message is not None:
                tracing.current().set(error=result.message.code)
        except TaskCancelled:
            tracing.current().set(outcome="cancelled")
            if self._stopping.is_set():
                with contextlib.suppress(JobError):
                    self.store.compiles.give_back(id, epoch)
        except OpenQuestions as reason:
            self._refuse(id, epoch, reason, reason.questions)
        except ContentLost as reason:
            self._refuse(id, epoch, reason)
        except StoreError as reason:
            # The lease expires, and then the job is tried again.
            tracing.current().fail(reason.message.code)
            _log.warning("job %s is not compiled now: %s", id, reason)
        except JobError:
            # The job was cancelled or taken by another worker before its result was stored.
            tracing.current().set(outcome="late")
            _log.info("the result of job %s came too late", id)
        except KnifetipError as reason:
            self._refuse(id, epoch, reason)
        except TaskFailed as reason:
            crash = KnifetipError("job.compile-crashed", incident=reason.incident)
            self._refuse(id, epoch, crash)

    def _watch(self, id: str, epoch: int, stages: ReportedStages) -> Watch:
        """Return a function that stores the progress of a compile and renews its lease."""
        renewed = 0.0

        def watch(stage: Stage, fraction: float) -> bool:
            nonlocal renewed
            now = time.monotonic()
            if not stages.enter(stage) and now - renewed < _RENEW:
                return True
            renewed = now
            return self.store.compiles.report_progress(id, epoch, stage, fraction)

        return watch

    def _refuse(
        self,
        id: str,
        epoch: int,
        reason: KnifetipError,
        questions: list[dict[str, object]] | None = None,
    ) -> None:
        tracing.current().set(outcome="refused", error=reason.message.code)
        with contextlib.suppress(JobError):
            self.store.compiles.refuse(
                id, epoch, reason.message, reason.source, reason.edges, questions or ()
            )
