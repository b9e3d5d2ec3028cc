"""Decisions about the compiled program of a stored job: accept, release, compile again.

Actions at the machine are in ``operator_store``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from sqlalchemy.orm import Session

from knifetip.contract.job import OPERATOR, Action, Actor, ActorKind, Confirmation, State, sources
from knifetip.errors import WrongState
from knifetip.messages import Message
from knifetip.model.job_options import JobOptions
from knifetip.service.content.store import ContentStore
from knifetip.service.database.engine import Database
from knifetip.service.database.request_key import RequestKey
from knifetip.service.database.tables import Job
from knifetip.service.library.outdated_jobs import newest_versions, require_current
from knifetip.service.lifecycle.transitions import Transitions
from knifetip.service.machines.station_obstacles import dry_run_on
from knifetip.service.orders.command_keys import CommandKeys
from knifetip.service.orders.operator_actions import awaits_confirmation, has_only_shortfalls
from knifetip.service.processes.compile_result import VerdictColumns

#: Columns of a job that has no program yet.
_WITHOUT_PROGRAM: Mapping[str, Any] = {
    "program_address": None,
    "program_sha256": "",
    "toolpath_address": None,
    "verdict_address": None,
    "verdict_summary": None,
    "lines": 0,
    "seconds": 0.0,
    "tools": [],
    "facts": {},
}
#: States of a job that was released, and that its machine makes or has made.
_RELEASED = (State.QUEUED, State.RUNNING, State.HELD, State.DONE)


class ProgramStore:
    """Decisions of operators about the programs of stored jobs, each stored with its event.

    Each method returns the job unchanged if it was called with the same ``RequestKey`` before; it
    raises ``KeyReused`` if the key was used for another command.
    """

    def __init__(
        self,
        database: Database,
        contents: ContentStore,
        transitions: Transitions,
        keys: CommandKeys,
    ) -> None:
        self._db = database
        self._contents = contents
        self._transitions = transitions
        self._keys = keys

    def accept(
        self,
        id: str,
        accepted: Callable[[bytes, Mapping[str, Any]], VerdictColumns],
        actor: Actor,
        event: Message,
        key: RequestKey | None = None,
    ) -> Job:
        """Accept shortfalls of a refused job, and return the job.

        If nothing else refuses its program, the job becomes ``ready``, or ``queued`` if it was
        ordered with immediate release.

        Parameters
        ----------
        id
            Id of the job.
        accepted
            Returns the new verdict from the stored verdict and its summary.
        actor
            The user who accepts the shortfalls.
        event
            Description of the decision, for the log of events.

        Raises
        ------
        WrongState
            The job is not ``refused``, or not only because of shortfalls.
        """
        with self._db.writing() as session:
            if (repeated := self._keys.repeated(session, id, key)) is not None:
                return repeated
            self._check_acceptable(session, self._transitions.lock(session, id))
        # Outside of transactions, since the verdict may be in an object store.
        before = self._contents.find(Job, Job.id == id, "verdict")
        if before is None or before.verdict_address is None:
            raise WrongState("job.no-shortfalls", job=id)
        stored = accepted(before.verdict, before.verdict_summary or {})
        staged = self._contents.stage(verdict=stored.verdict)
        with self._db.writing() as session:
            if (repeated := self._keys.repeated(session, id, key)) is not None:
                return repeated
            row = self._transitions.lock(session, id)
            self._check_acceptable(session, row)
            if row.verdict_address != before.verdict_address:
                raise WrongState("job.verdict-changed", job=id)
            columns: dict[str, Any] = {
                "verdict_summary": stored.verdict_summary,
                "message": stored.message,
                "source": stored.source,
                "edges": stored.edges,
                **self._contents.keep(session, staged),
            }
            if stored.message is None:
                self._transitions.move(session, id, Action.ACCEPT, actor, event, **columns)
                if row.release:
                    self._transitions.release_by_order(session, id)
            else:
                self._transitions.change(session, id, **columns)
                self._transitions.write_job_event(session, id, State.REFUSED, actor, event)
            return self._transitions.lock(session, id)

    def _check_acceptable(self, session: Session, row: Job) -> None:
        """Raise ``WrongState`` unless a job was refused only because of shortfalls."""
        if row.state not in sources(Action.ACCEPT, ActorKind.OPERATOR):
            raise self._transitions.refusal(session, row.id, State.READY)
        if row.verdict_address is None or not has_only_shortfalls(row):
            raise WrongState("job.no-shortfalls", job=row.id)

    def release(self, id: str, key: RequestKey | None = None) -> Job:
        """Move a ready job to the queue of its machine, and return it.

        A job that is queued, on its machine or done was released before, and stays as it is.

        Raises
        ------
        WrongState
            The job was not released and is not ``ready``, or its machine or board has changed
            since its compile.
        """
        with self._db.writing() as session:
            if (repeated := self._keys.repeated(session, id, key)) is not None:
                return repeated
            row = self._transitions.lock(session, id)
            if row.state in _RELEASED:
                return row
            require_current(session, row)
            self._transitions.release(session, id, OPERATOR, Message("job.released"))
            return self._transitions.lock(session, id)

    def recompile(self, id: str, key: RequestKey | None = None) -> Job:
        """Have a job compiled again for the newest versions of its machine and board; return it.

        A job that was queued is queued again when its new program is accepted.

        Raises
        ------
        WrongState
            The job is neither ``ready`` nor ``queued``, its machine or board was deleted, or it
            continues a sheet, which must lie on the machine with which the sheet was begun.
        """
        with self._db.writing() as session:
            if (repeated := self._keys.repeated(session, id, key)) is not None:
                return repeated
            row = self._transitions.lock(session, id)
            # Offsets of stations may have changed with which the marks were measured.
            self._compile_again(session, row, row.options.with_measured(()), OPERATOR)
            return self._transitions.lock(session, id)

    def register(
        self,
        id: str,
        options: JobOptions,
        event: Message,
        by: str = "",
        key: RequestKey | None = None,
    ) -> Job:
        """Have a job compiled again for a printed sheet as it lies on the table; return the job.

        It is queued again when its new program is accepted, before the jobs that wait.

        Parameters
        ----------
        id
            Id of the job.
        options
            The options of the job with its measured marks.
        event
            Description of the measurement, for the log of events.
        by
            Name of the operator, for the log of events.

        Raises
        ------
        WrongState
            The job does not wait at its machine for its first confirmation, its machine or board
            was deleted, its machine runs above the board, or it continues a sheet.
        """
        with self._db.writing() as session:
            if (repeated := self._keys.repeated(session, id, key)) is not None:
                return repeated
            row = self._transitions.lock(session, id)
            if row.state != State.QUEUED or not awaits_confirmation(row, self._db.clock()):
                raise WrongState("registration.not-waiting", job=id)
            if dry_run_on(session, row.machine, self._db.timer()):
                raise WrongState("dry-run.in-progress", job=row.id)
            actor = Actor(ActorKind.OPERATOR, by)
            self._transitions.write_job_event(session, id, row.state, actor, event, row.machine)
            self._compile_again(session, row, options, actor)
            return self._transitions.lock(session, id)

    def _compile_again(self, session: Session, row: Job, options: JobOptions, actor: Actor) -> None:
        """Have a job compiled again with options; it is queued then if it was queued.

        Raises ``WrongState``: the job is neither ``ready`` nor ``queued``, its machine or board was
        deleted, or it continues a sheet.
        """
        if row.rest is not None:
            raise WrongState("rest.bound-to-sheet", job=row.id, machine=row.machine)
        machine, board = newest_versions(session, row)
        self._transitions.move(
            session,
            row.id,
            Action.RECOMPILE,
            actor,
            Message("job.recompiled"),
            new_epoch=row.epoch + 1,
            machine_version=machine,
            board_version=board,
            stored_options=options.model_dump(mode="json"),
            release=row.release or row.state == State.QUEUED,
            attempt=row.attempt + 1,
            confirmation=Confirmation.NONE.value,
            requested_action="",
            owner="",
            lease=0.0,
            message=None,
            check_refusal=None,
            progress=0.0,
            **_WITHOUT_PROGRAM,
        )

    def recheck(self, id: str, key: RequestKey | None = None) -> Job:
        """Let the machine take a job again whose program it has refused, and return the job.

        Raises
        ------
        WrongState
            The job is not ``queued``, or no machine has refused its program.
        """
        with self._db.writing() as session:
            if (repeated := self._keys.repeated(session, id, key)) is not None:
                return repeated
            row = self._transitions.lock(session, id)
            if row.state != State.QUEUED or row.check_refusal is None:
                raise WrongState("job.nothing-refused", job=id, state=row.state)
            # A late repetition of the refusal is ignored.
            self._transitions.change(session, id, check_refusal=None, epoch=row.epoch + 1)
            event = Message("job.rechecked")
            self._transitions.write_job_event(session, id, row.state, OPERATOR, event, row.machine)
            return self._transitions.lock(session, id)
