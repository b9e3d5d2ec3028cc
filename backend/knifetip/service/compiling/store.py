"""Repository operations for compile workers: take a job, report progress, store the result.

Each operation on a job that is being compiled fails if the job has another epoch (a number that
increases with each new owner) than the worker expects, because the worker then lost the job.
"""

from __future__ import annotations

import logging
from collections.abc import Collection, Sequence
from typing import Any, Final

import sqlalchemy as sa
from sqlalchemy.orm import Session, undefer

from knifetip.contract.job import CLOCK, Action, Actor, ActorKind, State
from knifetip.errors import StoreError
from knifetip.messages import Message
from knifetip.model.acceptance import Exceptions
from knifetip.model.stage import Stage
from knifetip.service.content.store import ContentStore
from knifetip.service.database.engine import Database, rows
from knifetip.service.database.tables import Job
from knifetip.service.lifecycle.transitions import LEASE, Transitions
from knifetip.service.processes.compile_result import CompileResult

ATTEMPTS = 5  #: failed attempts after which a job is refused
_WORKER = Actor(ActorKind.WORKER)
#: Columns of a job whose compile has ended with a program.
_ENDED_COMPILE: Final = {"stage": "", "progress": 1.0, "owner": "", "lease": 0.0}
_RESULT_COLUMNS: Final = (
    "program_address",
    "program_sha256",
    "lines",
    "toolpath_address",
    "verdict_address",
    "verdict_summary",
    "tools",
    "seconds",
    "lengths",
    "facts",
)
_log = logging.getLogger("knifetip.jobs")
_NEXT = sa.select(Job.id).where(Job.state == State.RECEIVED).order_by(Job.serial).limit(1)


class CompileStore:
    """Repository operations for compile workers on jobs that are received or being compiled."""

    def __init__(
        self, database: Database, contents: ContentStore, transitions: Transitions
    ) -> None:
        self._db = database
        self._contents = contents
        self._transitions = transitions

    def find_owned(self, id: str, epoch: int) -> Job | None:
        """Return the job that a worker is compiling in an epoch; None if that worker has lost it.

        Parameters
        ----------
        id
            Id of the job.
        epoch
            Epoch of the job when the worker took the job.
        """
        query = sa.select(Job).where(Job.id == id, Job.epoch == epoch, Job.state == State.COMPILING)
        with self._db.reading() as session:
            return session.scalar(query)

    def received_machines(self) -> list[str]:
        """Return the names of the machines for which jobs wait to be compiled, each name once."""
        query = sa.select(Job.machine).where(Job.state == State.RECEIVED).distinct()
        with self._db.reading() as session:
            return list(session.scalars(query))

    def report_waiting(self, machine: str, progress: float) -> None:
        """Store a message and the progress in the received jobs for a machine.

        The message says that the job waits until numba functions are compiled to machine code.
        When the message is first stored in a job, an event about the job is written.

        Parameters
        ----------
        machine
            Name of the machine.
        progress
            Fraction (0 … 1) of the numba functions for the machine that have machine code.
        """
        message = Message("job.awaits-kernels", machine=machine)
        waiting = sa.and_(Job.state == State.RECEIVED, Job.machine == machine)
        outdated = sa.or_(Job.stage != Stage.PREPARE, Job.progress != progress)
        with self._db.reading() as session:
            if session.scalar(sa.select(Job.id).where(waiting, outdated).limit(1)) is None:
                return
        with self._db.writing() as session:
            unreported = sa.select(Job.id).where(waiting, Job.message.is_(None))
            for id in session.scalars(unreported.with_for_update()).all():
                session.execute(sa.update(Job).where(Job.id == id).values(message=message))
                self._transitions.write_job_event(session, id, State.RECEIVED, _WORKER, message)
            session.execute(
                sa.update(Job)
                .where(waiting, outdated)
                .values(stage=Stage.PREPARE.value, progress=progress)
            )

    def begin(
        self,
        worker: str,
        excluded_machines: Collection[str] = (),
    ) -> Job | None:
        """Move the oldest received job to ``compiling`` and return it; None if there is none.

        Parameters
        ----------
        worker
            Name of the worker that becomes the owner of the job.
        excluded_machines
            Names of the machines whose jobs are not taken.
        """
        query = _NEXT.where(Job.machine.not_in(excluded_machines))
        with self._db.reading() as session:
            if session.scalar(query) is None:
                return None
        with self._db.writing() as session:
            id = session.scalar(query.with_for_update(skip_locked=True))
            if id is None:
                return None
            row = self._transitions.lock(session, id)
            self._transitions.move(
                session,
                id,
                Action.COMPILE,
                Actor(ActorKind.WORKER, worker),
                Message("job.compile-started", attempt=row.attempt),
                epoch=row.epoch,
                new_epoch=row.epoch + 1,
                owner=worker,
                lease=self._db.clock() + LEASE,
                message=None,
                stage=Stage.READ.value,
                progress=0.0,
            )
            return self._transitions.lock(session, id)

    def recover(self, worker: str) -> None:
        """Put the jobs that an earlier process of this worker was compiling back into the queue.

        A job is refused instead after ``ATTEMPTS`` (5) attempts to compile it.

        Parameters
        ----------
        worker
            Name of the worker, which is the same after a restart.
        """
        with self._db.writing() as session:
            dead = sa.select(Job).where(Job.state == State.COMPILING, Job.owner == worker)
            for row in session.scalars(dead.with_for_update()).all():
                self.take_back(session, row)

    def take_back(self, session: Session, row: Job) -> None:
        """Put a job whose worker is lost back into the queue.

        The job is refused instead after ``ATTEMPTS`` (5) attempts to compile it.

        Parameters
        ----------
        session
            Session with the transaction of the caller.
        row
            The job, in the state ``compiling``.
        """
        if row.attempt < ATTEMPTS:
            self._transitions.move(
                session,
                row.id,
                Action.RETRY,
                CLOCK,
                Message("job.worker-silent", worker=row.owner, stage=row.stage),
                epoch=row.epoch,
                attempt=row.attempt + 1,
                stage="",
                progress=0.0,
            )
            return
        died = Message("job.compiles-died", attempts=ATTEMPTS, stage=row.stage)
        self._transitions.move(
            session,
            row.id,
            Action.REFUSE,
            CLOCK,
            died,
            epoch=row.epoch,
            message=died,
            stage="",
        )

    def report_progress(self, id: str, epoch: int, stage: Stage, progress: float) -> bool:
        """Store the progress of a compile, and renew the lease of its job.

        Parameters
        ----------
        id
            Id of the job.
        epoch
            Epoch of the job when the worker took the job: a number that increases with each new
            owner.
        stage
            Present stage of the compile.
        progress
            Completed fraction of the compile (0 … 1).

        Returns
        -------
        bool
            False if the compile must end, because its job has another state or epoch; else True.
        """
        with self._db.writing() as session:
            return bool(
                rows(
                    session,
                    sa.update(Job)
                    .where(Job.id == id, Job.state == State.COMPILING, Job.epoch == epoch)
                    .values(stage=stage.value, progress=progress, lease=self._db.clock() + LEASE),
                )
            )

    def renew_lease(self, id: str, epoch: int) -> bool:
        """Renew the lease of a job that is being compiled; return False if the worker has lost it.

        Parameters
        ----------
        id
            Id of the job.
        epoch
            Epoch of the job when the worker took the job.
        """
        find_owned = sa.and_(Job.id == id, Job.state == State.COMPILING, Job.epoch == epoch)
        with self._db.writing() as session:
            renewed = sa.update(Job).where(find_owned).values(lease=self._db.clock() + LEASE)
            return bool(rows(session, renewed))

    def answer(self, id: str, epoch: int, key: str) -> bool:
        """Give a job the stored program of an earlier job with the same input, if there is one.

        The job moves to the next state, as with ``save_result``.

        Parameters
        ----------
        id
            Id of the job.
        epoch
            Epoch of the job when the worker took the job.
        key
            Key of the compile (see ``compiling.key``).

        Returns
        -------
        bool
            Whether there is such a program, and its bytes agree with its hash.

        Raises
        ------
        WrongState
            The job has another state.
        StaleEpoch
            The job has another epoch, because the worker has lost the job.
        """
        newest = sa.select(Job).where(Job.compile_key == key).order_by(Job.serial.desc()).limit(1)
        newest = newest.options(undefer(Job.lengths))
        with self._db.reading() as session:
            found = session.scalar(newest)
        if found is None or not self._is_sound(found):
            return False
        with self._db.writing() as session:
            earlier = session.scalar(newest)
            if earlier is None or earlier.program_address != found.program_address:
                return False
            copied = {name: getattr(earlier, name) for name in _RESULT_COLUMNS}
            columns = {
                **copied,
                "compile_key": key,
                "program_of": earlier.program_of or earlier.id,
                **_ENDED_COMPILE,
            }
            event = Message("job.answered", job=columns["program_of"])
            self._transitions.move(
                session, id, Action.ACCEPT, _WORKER, event, epoch=epoch, **columns
            )
            if session.scalar(sa.select(Job.release).where(Job.id == id)):
                self._transitions.release_by_order(session, id)
            return True

    def _is_sound(self, row: Job) -> bool:
        """Return whether the large values of a compiled job can be read and are those of it."""
        names = ("program", "toolpath", "verdict")
        try:
            self._contents.find(Job, Job.id == row.id, *names)
        except StoreError as reason:
            _log.error("job %s answers no other job: %s", row.id, reason)
            return False
        return row.program_address == row.program_sha256

    def save_result(self, id: str, epoch: int, result: CompileResult, key: str = "") -> None:
        """Store the result of a compile, and move its job to the next state.

        The state is ``refused`` if the verifier rejected the program.  If the program was accepted,
        the state is ``queued`` for a job that was ordered with immediate release, else ``ready``.

        Parameters
        ----------
        id
            Id of the job.
        epoch
            Epoch of the job when the worker took the job: a number that increases with each new
            owner.
        result
            Program, tool path, verdict and tools.
        key
            Key of the compile (see ``compiling.key``), under which later jobs find an accepted
            program; "" if they may not.

        Raises
        ------
        WrongState
            The job has another state.
        StaleEpoch
            The job has another epoch, because the worker has lost the job.
        """
        columns = {
            **result_columns(result),
            "compile_key": key if result.message is None else "",
            **_ENDED_COMPILE,
        }
        staged = self._contents.stage(**result_contents(result))
        with self._db.writing() as session:
            columns |= self._contents.keep(session, staged)
            self._record_exceptions(session, id, result.verdict_summary.get("exceptions", 0))
            if result.message is not None:
                self._transitions.move(
                    session,
                    id,
                    Action.REFUSE,
                    _WORKER,
                    result.message,
                    epoch=epoch,
                    message=result.message,
                    source=result.source,
                    edges=result.edges,
                    **columns,
                )
                return
            self._transitions.move(
                session, id, Action.ACCEPT, _WORKER, Message("job.verified"), epoch=epoch, **columns
            )
            if session.scalar(sa.select(Job.release).where(Job.id == id)):
                self._transitions.release_by_order(session, id)

    def _record_exceptions(self, session: Session, id: str, count: int) -> None:
        """Write an event if the verdict on a job has shortfalls that its order accepts.

        ``count`` is the number of accepted shortfalls.
        """
        ordered = session.scalar(sa.select(Job.exceptions).where(Job.id == id))
        if ordered is not None and count > 0:
            given = Exceptions.from_json(ordered).acceptance
            message = Message(
                "job.exceptions-accepted", by=given.by, count=count, reason=given.reason
            )
            actor = Actor(ActorKind.OPERATOR, given.by)
            self._transitions.write_job_event(session, id, State.COMPILING, actor, message)

    def refuse(
        self,
        id: str,
        epoch: int,
        message: Message,
        source: Sequence[str] = (),
        edges: Sequence[int] = (),
        questions: Sequence[dict[str, Any]] = (),
    ) -> None:
        """Move a job that could not be compiled to ``refused``.

        Parameters
        ----------
        id
            Id of the job.
        epoch
            Epoch of the job when the worker took the job: a number that increases with each new
            owner.
        message
            Reason for which the job is refused.
        source
            Handles of the entities of the drawing that the message concerns.
        edges
            Rows of the edges of the drawing that the message concerns.
        questions
            Questions that the user must answer before the job can be compiled, as JSON data.

        Raises
        ------
        WrongState
            The job has another state.
        StaleEpoch
            The job has another epoch, because the worker has lost the job.
        """
        with self._db.writing() as session:
            self._transitions.move(
                session,
                id,
                Action.REFUSE,
                _WORKER,
                message,
                epoch=epoch,
                message=message,
                source=list(source),
                edges=list(edges),
                questions=list(questions),
                stage="",
                owner="",
                lease=0.0,
            )

    def give_back(self, id: str, epoch: int) -> None:
        """Put a job back into the queue after its compile was cancelled.

        Parameters
        ----------
        id
            Id of the job.
        epoch
            Epoch of the job when the worker took the job: a number that increases with each new
            owner.

        Raises
        ------
        WrongState
            The job has another state.
        StaleEpoch
            The job has another epoch, because the worker has lost the job.
        """
        with self._db.writing() as session:
            attempt = self._transitions.lock(session, id).attempt
            self._transitions.move(
                session,
                id,
                Action.RETRY,
                _WORKER,
                Message("job.compile-cancelled"),
                epoch=epoch,
                attempt=attempt + 1,
                stage="",
                progress=0.0,
                owner="",
                lease=0.0,
            )


def result_columns(result: CompileResult) -> dict[str, Any]:
    """Return the columns of a job that store the result of a compile, by name of the column.

    Its large values are ``result_contents``.
    """
    return {
        "program_sha256": result.sha256,
        "lines": result.lines,
        "verdict_summary": result.verdict_summary,
        "tools": result.tools,
        "seconds": result.verdict_summary["seconds"],
        "lengths": result.lengths,
        "facts": result.facts,
        # Programs that are made in another way are not found by later jobs.
        "compile_key": "",
        "program_of": "",
    }


def result_contents(result: CompileResult) -> dict[str, bytes]:
    """Return the large values of a job that store the result of a compile, by name."""
    return {
        "program": result.program,
        "toolpath": result.toolpath,
        "verdict": result.verdict,
    }
