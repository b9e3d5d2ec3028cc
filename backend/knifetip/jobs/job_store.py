"""Repository of jobs: store and find jobs, and the actions of operators on them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any

import sqlalchemy as sa
from sqlalchemy.exc import IntegrityError

from knifetip.errors import WrongState
from knifetip.jobs.compile_result import VerdictColumns
from knifetip.jobs.database import Database, short
from knifetip.jobs.interpretations import job_columns
from knifetip.jobs.job import (
    ADVICE,
    LEASED,
    OPERATOR,
    Action,
    Actor,
    ActorKind,
    Confirmation,
    State,
    new_id,
    sources,
)
from knifetip.jobs.operator_actions import (
    OperatorAction,
    allowed_actions,
    awaits_confirmation,
    has_only_shortfalls,
    is_fully_executed,
)
from knifetip.jobs.tables import Drawing, Job
from knifetip.jobs.transitions import Transitions, advice, same_request, unknown_job_error
from knifetip.messages import Message
from knifetip.model.acceptance import Exceptions
from knifetip.model.interpretation import Interpretation


@dataclass(frozen=True, slots=True)
class JobOrder:
    """Data of a new job, except its drawing: machine, board, interpretation and number of copies.

    The interpretation contains the user's decisions about the drawing, such as unit and profile.
    """

    machine: str
    board: str
    interpretation: Interpretation
    copies: int = 1
    priority: int = 0  #: jobs with a higher one are claimed first
    release: bool = False  #: queue the job when it is ready
    exceptions: Exceptions | None = None  #: shortfalls that the user accepts in advance


class JobStore:
    """Repository of jobs: store and find jobs, and the actions of operators on them."""

    def __init__(self, database: Database, transitions: Transitions) -> None:
        self._db = database
        self._transitions = transitions

    def add(
        self,
        drawing: Drawing,
        order: JobOrder,
        *,
        key: str | None = None,
        fingerprint: str = "",
    ) -> Job:
        """Store a new job in the state ``received`` and return it.

        Parameters
        ----------
        drawing
            Drawing of the job.
        order
            Machine, board, interpretation and number of copies.
        key
            Idempotency-Key of the request: a text that a client sends again if it repeats the
            request.  If a job was stored with this key, that job is returned and nothing is stored.
            None if the request has no key.
        fingerprint
            Hash of the content of the request.

        Raises
        ------
        KeyReused
            The key was used for a request with another fingerprint.
        """
        now = self._db.clock()
        row = Job(
            id=new_id(),
            state=State.RECEIVED.value,
            drawing=drawing.id,
            drawing_name=drawing.name,
            machine=order.machine,
            board=order.board,
            **job_columns(order.interpretation),
            copies=order.copies,
            priority=order.priority,
            release=order.release,
            exceptions=None if order.exceptions is None else order.exceptions.as_json(),
            created=now,
            updated=now,
            queued=0.0,
            message=None,
            source=[],
            questions=[],
            attempt=1,
            epoch=0,
            owner="",
            lease=0.0,
            owner_epoch=0,
            confirmation=Confirmation.NONE.value,
            tools=[],
            requested_action="",
            stage="",
            progress=0.0,
            line=0,
            lines=0,
            copies_done=0,
            copies_before=0,
            position=None,
            seconds=0.0,
            seconds_left=None,
            program_sha256="",
            verdict_summary=None,
            key=key,
            fingerprint=fingerprint,
            program=None,
            toolpath=None,
            verdict=None,
        )
        try:
            with self._db.writing() as session:
                session.add(row)
                self._transitions.write_event(
                    session, "job", row.id, State.RECEIVED, OPERATOR, Message("job.ordered")
                )
        except IntegrityError:
            if key is None or (earlier := self.find(key, fingerprint)) is None:
                raise
            return earlier
        return row

    def find(self, key: str, fingerprint: str) -> Job | None:
        """Return the job that was stored with an Idempotency-Key, None if there is none.

        Parameters
        ----------
        key
            Idempotency-Key of the present request: a text that a client sends again if it repeats a
            request.
        fingerprint
            Hash of the content of the present request.

        Raises
        ------
        KeyReused
            The key was used for a request with another fingerprint.
        """
        with self._db.reading() as session:
            row = session.scalar(sa.select(Job).where(Job.key == key))
        return None if row is None else same_request(row, key, fingerprint)

    def get(self, id: str) -> Job:
        """Return the job with an id, without the program, the tool path and other large columns.

        Raises
        ------
        NoSuchJob
            There is no job with this id.
        """
        with self._db.reading() as session:
            row = session.scalar(sa.select(Job).where(Job.id == id))
        if row is None:
            raise unknown_job_error(id)
        return row

    def column(self, id: str, column: str) -> bytes:
        """Return the content of a large column of a job.

        Parameters
        ----------
        id
            Id of the job.
        column
            ``overrides`` (line types that the user has set), ``program``, ``toolpath`` or
            ``verdict``.

        Raises
        ------
        NoSuchJob
            There is no job with this id.
        WrongState
            The column is empty: the job is not compiled yet, or it was refused.
        """
        return self._db.large_column(Job, id, column, "job")

    def search(
        self,
        states: Sequence[str] = (),
        before: int | None = None,
        limit: int = 100,
        ids: Sequence[str] | None = None,
    ) -> list[Job]:
        """Return the jobs that meet all conditions, newest first.

        Parameters
        ----------
        states
            States that the jobs may have; empty for all states.
        before
            Return only jobs with a smaller serial number; None for all.
        limit
            Greatest number of jobs.
        ids
            Ids of the jobs; None for all.
        """
        query = sa.select(Job).order_by(Job.serial.desc()).limit(limit)
        if states:
            query = query.where(Job.state.in_(states))
        if before is not None:
            query = query.where(Job.serial < before)
        if ids is not None:
            query = query.where(Job.id.in_(ids))
        with self._db.reading() as session:
            return list(session.scalars(query))

    def last_with_exceptions(self, row: Job) -> Job | None:
        """Return the newest earlier job for the same file, unit, machine and board whose verdict
        has accepted shortfalls, None if there is none.
        """
        file = sa.select(Drawing.sha256).where(Drawing.id == row.drawing).scalar_subquery()
        query = (
            sa.select(Job)
            .join(Drawing, Drawing.id == Job.drawing)
            .where(
                Job.serial < row.serial,
                Drawing.sha256 == file,
                Job.unit_given == row.unit_given,
                Job.machine == row.machine,
                Job.board == row.board,
                Job.verdict_summary["exceptions"].as_integer() > 0,
            )
            .order_by(Job.serial.desc())
            .limit(1)
        )
        with self._db.reading() as session:
            return session.scalar(query)

    def accept(
        self,
        id: str,
        accepted: Callable[[bytes, Mapping[str, Any]], VerdictColumns],
        actor: Actor,
        event: Message,
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
            row = self._transitions.lock(session, id)
            if row.state not in sources(Action.ACCEPT, ActorKind.OPERATOR):
                raise self._transitions.refusal(session, id, State.READY)
            if row.verdict is None or not has_only_shortfalls(row):
                raise WrongState("job.no-shortfalls", job=id)
            stored = accepted(row.verdict, row.verdict_summary or {})
            columns: dict[str, Any] = {
                field.name: getattr(stored, field.name) for field in fields(stored)
            }
            if stored.message is None:
                self._transitions.move(session, id, Action.ACCEPT, actor, event, **columns)
                if row.release:
                    self._transitions.release_by_order(session, id)
            else:
                session.execute(
                    sa.update(Job)
                    .where(Job.id == id)
                    .values(updated=self._db.clock(), **columns)
                    .execution_options(synchronize_session=False)
                )
                self._transitions.write_event(session, "job", id, State.REFUSED, actor, event)
        return self.get(id)

    def release(self, id: str) -> Job:
        """Move a ready job to the queue of its machine, and return it.

        Raises
        ------
        WrongState
            The job is not ``ready``.
        """
        with self._db.writing() as session:
            self._transitions.move(
                session,
                id,
                Action.RELEASE,
                OPERATOR,
                Message("job.released"),
                queued=self._db.clock(),
            )
        return self.get(id)

    def requeue(self, id: str) -> Job:
        """Queue an interrupted job again, at its former position in the queue, and return it.

        The operator calls this after clearing the table.

        Raises
        ------
        WrongState
            The job is not ``interrupted``, or its last copy was executed to the last program line.
        """
        with self._db.writing() as session:
            row = self._transitions.lock(session, id)
            if is_fully_executed(row):
                raise WrongState("job.fully-executed", job=id, lines=row.lines)
            self._transitions.move(
                session,
                id,
                Action.REQUEUE,
                OPERATOR,
                Message("job.requeued"),
                lease=0.0,
                line=0,
                position=None,
                message=None,
                requested_action="",
                seconds_left=None,
            )
        return self.get(id)

    def scrap(self, id: str) -> Job:
        """Move an interrupted job to ``scrapped`` and return it.

        The job is not made again, and the table of its machine is free for another job.

        Raises
        ------
        WrongState
            The job is not ``interrupted``.
        """
        with self._db.writing() as session:
            self._transitions.move(
                session, id, Action.SCRAP, OPERATOR, Message("job.scrapped"), requested_action=""
            )
        return self.get(id)

    def declare_finished(self, id: str) -> Job:
        """Move an interrupted job to ``done`` and return it.

        An operator calls this after finding that all sheets of the job are complete.

        Raises
        ------
        WrongState
            The job is not ``interrupted``.
        """
        with self._db.writing() as session:
            row = self._transitions.lock(session, id)
            self._transitions.move(
                session,
                id,
                Action.FINISH,
                OPERATOR,
                Message("job.declared-finished", line=row.line, lines=row.lines),
                line=row.lines,
                copies_done=row.copies,
                message=None,
                requested_action="",
                lease=0.0,
                seconds_left=0.0,
            )
        return self.get(id)

    def confirm(self, id: str, board: str = "", by: str = "") -> Job:
        """Store the operator's confirmation that the machine may begin, and return the job.

        The operator confirms that the table is clear and that the board and the tools of the job
        are in place.  The gateway then starts the claimed job, or the next copy of a job that waits
        for a new sheet.  A job that was started before its confirmation, and was therefore held, is
        resumed.  A repeated confirmation has no effect.

        Parameters
        ----------
        id
            Id of the job.
        board
            Name of the board on the table; "" if the operator does not name it.
        by
            Name of the operator, for the log of events.

        Raises
        ------
        WrongState
            The job does not wait for a confirmation, or needs another board.
        """
        with self._db.writing() as session:
            row = self._transitions.lock(session, id)
            if board and board != row.board:
                raise WrongState("job.other-board", job=id, board=row.board, given=short(board))
            confirmed = row.confirmation == Confirmation.GIVEN and row.requested_action != "cancel"
            starts = row.state in (State.QUEUED, State.RUNNING) or row.requested_action == "resume"
            if confirmed and starts:
                return row
            self._check_waiting(row)
            sheet = row.confirmation == Confirmation.SHEET
            action = "" if row.state == State.QUEUED else "resume"
            session.execute(
                sa.update(Job)
                .where(Job.id == id)
                .values(
                    confirmation=Confirmation.GIVEN.value,
                    requested_action=action,
                    updated=self._db.clock(),
                )
                .execution_options(synchronize_session=False)
            )
            event = Message(
                "job.confirmed-sheet" if sheet else "job.confirmed-table", board=row.board
            )
            self._transitions.write_event(
                session, "job", id, row.state, Actor(ActorKind.OPERATOR, by), event
            )
            return self._transitions.lock(session, id)

    def _check_waiting(self, row: Job) -> None:
        """Raise ``WrongState`` unless the job waits for the operator's confirmation."""
        if awaits_confirmation(row, self._db.clock()):
            return
        if row.requested_action == OperatorAction.CANCEL:
            raise WrongState("job.being-cancelled", job=row.id)
        if row.confirmation in (Confirmation.AWAITED, Confirmation.SHEET):
            raise WrongState("job.gateway-silent", gateway=row.owner, job=row.id)
        match row.state:
            case State.QUEUED:
                raise WrongState("job.not-taken", job=row.id, machine=row.machine)
            case State.HELD:
                raise WrongState("job.no-sheet-awaited", job=row.id)
            case State.RUNNING:
                raise WrongState("job.nothing-to-confirm", job=row.id)
            case _:
                raise WrongState(
                    "job.no-confirmation-awaited",
                    job=row.id,
                    state=row.state,
                    advice=advice(row.state, row.message),
                )

    def hold(self, id: str) -> Job:
        """Store an operator's request to hold a job, and return the job.

        The gateway of the job carries out the request.  The job becomes ``held`` when the machine
        has stopped.

        Raises
        ------
        WrongState
            The job cannot be held now.
        """
        return self._request(id, OperatorAction.HOLD)

    def resume(self, id: str) -> Job:
        """Store an operator's request to resume a job, and return the job.

        The gateway of the job carries out the request.  Between two copies, the request also
        confirms that a new sheet is on the table.

        Raises
        ------
        WrongState
            The job cannot be resumed now.
        """
        return self._request(id, OperatorAction.RESUME)

    def cancel(self, id: str) -> Job:
        """Cancel a job and return it.

        If the job is running or held, only a request is stored: the job becomes ``cancelled`` when
        its gateway has stopped the machine.

        Raises
        ------
        WrongState
            The job is interrupted or has already ended.
        """
        with self._db.writing() as session:
            state = session.scalar(sa.select(Job.state).where(Job.id == id).with_for_update())
            if state not in LEASED:
                self._transitions.move(
                    session,
                    id,
                    Action.CANCEL,
                    OPERATOR,
                    Message("job.cancelled"),
                    message=None,
                    stage="",
                    confirmation=Confirmation.NONE.value,
                )
                return self._transitions.lock(session, id)
        return self._request(id, OperatorAction.CANCEL)

    def _request(self, id: str, action: OperatorAction) -> Job:
        """Store an operator's request for the gateway of a job; return the job.

        A repeated request has no effect.

        Parameters
        ----------
        id
            Id of a job that is on a table.
        action
            Requested action: hold, resume or cancel.

        Raises
        ------
        WrongState
            The job does not allow the action in its present state.
        """
        with self._db.writing() as session:
            row = self._transitions.lock(session, id)
            if action not in allowed_actions(row, self._db.clock()):
                raise _refused_request_error(row, action)
            if row.requested_action == action:
                return row
            changes = {"requested_action": action.value, "updated": self._db.clock()}
            if action is OperatorAction.RESUME and row.confirmation == Confirmation.SHEET:
                changes["confirmation"] = Confirmation.GIVEN.value
            session.execute(
                sa.update(Job)
                .where(Job.id == id)
                .values(**changes)
                .execution_options(synchronize_session=False)
            )
            event = Message("job.action-requested", action=action)
            self._transitions.write_event(session, "job", id, row.state, OPERATOR, event)
            return self._transitions.lock(session, id)


def _refused_request_error(row: Job, action: OperatorAction) -> WrongState:
    """Return the error that a job does not allow the action in its present state.

    Parameters
    ----------
    row
        The job.
    action
        Action that the operator requested.
    """
    if action is OperatorAction.RESUME and row.confirmation == Confirmation.AWAITED:
        return WrongState("job.not-confirmed", job=row.id)
    if row.requested_action == OperatorAction.CANCEL:
        return WrongState("job.cancelled-before-request", job=row.id, request=action)
    return WrongState(
        "job.wrong-state-for-request",
        job=row.id,
        state=row.state,
        request=action,
        states=sources(Action(action), ActorKind.GATEWAY),
        advice=ADVICE[State(row.state)],
    )
