"""Actions of operators on stored jobs, such as release, confirm, hold and cancel.

Actions on interrupted jobs are in ``interrupted_jobs``.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from typing import Any

import sqlalchemy as sa
from sqlalchemy.orm import Session

from knifetip.contract.job import (
    ADVICE,
    LEASED,
    OPERATOR,
    Action,
    Actor,
    ActorKind,
    Confirmation,
    State,
    sources,
)
from knifetip.errors import WrongState
from knifetip.messages import Message
from knifetip.model.job_options import JobOptions
from knifetip.service.content.store import ContentStore
from knifetip.service.database.engine import Database
from knifetip.service.database.request_key import RequestKey
from knifetip.service.database.tables import Job
from knifetip.service.library.outdated_jobs import changes_since_compile, newest_versions
from knifetip.service.lifecycle.transitions import Transitions, advice
from knifetip.service.machines.station_store import (
    dry_run_on,
    end_hands_clear,
    obstacle_on,
    require_hands_clear,
)
from knifetip.service.orders.command_keys import CommandKeys
from knifetip.service.orders.operator_actions import (
    OperatorAction,
    allowed_actions,
    awaits_confirmation,
    has_only_shortfalls,
)
from knifetip.service.processes.compile_result import VerdictColumns
from knifetip.service.runs.checks import Check, CheckList, events_of_checks
from knifetip.service.tools.check import NOTHING_STATED, ToolCheck, ToolGate

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


class OperatorStore:
    """Actions of operators on stored jobs; each method stores one action with its event.

    Each method returns the job unchanged if it was called with the same ``RequestKey`` before; it
    raises ``KeyReused`` if the key was used for another command.
    """

    def __init__(
        self,
        database: Database,
        contents: ContentStore,
        transitions: Transitions,
        checks: CheckList,
        tools: ToolGate,
        keys: CommandKeys,
    ) -> None:
        self._db = database
        self._contents = contents
        self._transitions = transitions
        self._checks = checks
        self._tools = tools
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
                self._change(session, id, **columns)
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
            _check_current(session, row)
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
            self._change(session, id, check_refusal=None, epoch=row.epoch + 1)
            event = Message("job.rechecked")
            self._transitions.write_job_event(session, id, row.state, OPERATOR, event, row.machine)
            return self._transitions.lock(session, id)

    def checks(self, row: Job) -> list[Check]:
        """Return what a person checks at the machine before the next start of a job."""
        with self._db.reading() as session:
            return self._checks.checks_of(session, row)

    def confirm(
        self,
        id: str,
        checked: Collection[str],
        by: str = "",
        tools: ToolCheck = NOTHING_STATED,
        key: RequestKey | None = None,
    ) -> Job:
        """Store the operator's confirmation that the machine may begin, and return the job.

        The operator has made each check of the job at the machine (see ``checks``).  The gateway
        then starts the claimed job, or the next copy of a job that waits for a new sheet.  A job
        that was started before its confirmation, and was therefore held, is resumed.  A repeated
        confirmation has no effect.

        Parameters
        ----------
        id
            Id of the job.
        checked
            Ids of the checks that the operator has made.
        by
            Name of the operator, for the log of events.
        tools
            What the operator states about the tools.

        Raises
        ------
        NotFound
            There is no such job, or its machine has no station whose tool was changed.
        RequestError
            ``checked`` names a check that the job does not have.
        WrongState
            The job does not wait for a confirmation, a check is missing, it uses a tool at the end
            of its life, its machine or board has changed since its compile, an alarm or an obstacle
            keeps its machine from work, or its machine runs above the board.
        """
        with self._db.writing() as session:
            if (repeated := self._keys.repeated(session, id, key)) is not None:
                return repeated
            row = self._transitions.lock(session, id)
            confirmed = row.confirmation == Confirmation.GIVEN and row.requested_action != "cancel"
            starts = row.state in (State.QUEUED, State.RUNNING) or row.requested_action == "resume"
            if confirmed and starts:
                self._checks.require(session, row, checked)
                return row
            _check_current(session, row)
            self._check_free(session, row)
            self._check_waiting(row)
            if dry_run_on(session, row.machine, self._db.timer()):
                raise WrongState("dry-run.in-progress", job=row.id)
            checks = self._checks.require(session, row, checked)
            actor = Actor(ActorKind.OPERATOR, by)
            events = [
                *events_of_checks(row, checks),
                *self._tools.check(session, row, tools, actor),
            ]
            sheet = row.confirmation == Confirmation.SHEET
            action = "" if row.state == State.QUEUED else "resume"
            self._change(
                session, id, confirmation=Confirmation.GIVEN.value, requested_action=action
            )
            end_hands_clear(session, row.machine)
            events.append(
                Message("job.confirmed-sheet" if sheet else "job.confirmed-table", board=row.board)
            )
            for event in events:
                self._transitions.write_job_event(session, id, row.state, actor, event)
            return self._transitions.lock(session, id)

    def _check_free(self, session: Session, row: Job) -> None:
        """Raise ``WrongState`` if a job could start, and an alarm or an obstacle is in the way.

        A job whose machine is not free may have been returned to the queue already.
        """
        if row.state != State.QUEUED and not awaits_confirmation(row, self._db.clock()):
            return
        reason = obstacle_on(session, row.machine, self._db.timer())
        if reason is not None:
            raise WrongState("job.machine-not-free", job=row.id, reason=reason)

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

    def hold(self, id: str, key: RequestKey | None = None) -> Job:
        """Store an operator's request to hold a job, and return the job.

        The gateway of the job executes the request.  The job becomes ``held`` when the machine
        has stopped.

        Raises
        ------
        WrongState
            The job cannot be held now.
        """
        return self._request(id, OperatorAction.HOLD, key=key)

    def resume(
        self,
        id: str,
        phase: int | None = None,
        key: RequestKey | None = None,
        *,
        hands_clear: bool = False,
    ) -> Job:
        """Store an operator's request to resume a job, and return the job.

        The gateway of the job executes the request.  The next copy is never started by it.

        Parameters
        ----------
        id
            Id of the job.
        phase
            Phase of the run for which the operator decided; None for the present one.
        hands_clear
            Whether the operator states with the request that hands are clear of the machine.

        Raises
        ------
        WrongState
            The job cannot be resumed now, or is in another phase.  It waits for a new sheet or for
            its confirmation, or a person must confirm the end of its program.  Nobody has stated
            within ``HANDS_CLEAR`` seconds that hands are clear.
        """
        return self._request(id, OperatorAction.RESUME, phase, key, hands_clear=hands_clear)

    def confirm_end(self, id: str, phase: int | None = None, key: RequestKey | None = None) -> Job:
        """Store that a person has seen the end of a program whose controller does not report it.

        The job is done then, or waits for the sheet of its next copy.

        Parameters
        ----------
        id
            Id of the job.
        phase
            Phase of the run for which the person decided; None for the present one.

        Raises
        ------
        WrongState
            The job does not wait for the end of its program, or is in another phase.
        """
        return self._request(id, OperatorAction.END, phase, key)

    def cancel(self, id: str, key: RequestKey | None = None) -> Job:
        """Cancel a job and return it; a cancelled job stays as it is.

        If the job is running or held, only a request is stored: the job becomes ``cancelled`` when
        its gateway has stopped the machine.

        Raises
        ------
        WrongState
            The job is interrupted or has already ended.
        """
        with self._db.writing() as session:
            state = self._transitions.lock(session, id).state
            if state not in LEASED:
                if (repeated := self._keys.repeated(session, id, key)) is not None:
                    return repeated
                if state == State.CANCELLED:
                    return self._transitions.lock(session, id)
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
        return self._request(id, OperatorAction.CANCEL, key=key)

    def _request(
        self,
        id: str,
        action: OperatorAction,
        phase: int | None = None,
        key: RequestKey | None = None,
        *,
        hands_clear: bool = False,
    ) -> Job:
        """Store an operator's request for the gateway of a job; return the job.

        A repeated request has no effect.

        ``action``: requested action: hold, resume, end or cancel.
        ``phase``: phase of the run that the job must have; None for any.
        ``hands_clear``: whether the operator states that hands are clear, which ``resume`` needs.
        Raises ``WrongState``: the job does not allow the action in its present state, or is in
        another phase.
        """
        with self._db.writing() as session:
            if (repeated := self._keys.repeated(session, id, key)) is not None:
                return repeated
            row = self._transitions.lock(session, id)
            if action is OperatorAction.HOLD and _is_held(row):
                return row
            if action not in allowed_actions(row, self._db.clock()):
                raise _refused_request_error(row, action)
            if phase not in (None, row.phase):
                raise WrongState("job.other-phase", job=id)
            if row.requested_action == action:
                return row
            if action is OperatorAction.RESUME:
                now = self._db.timer()
                require_hands_clear(session, row.machine, action, now, stated=hands_clear)
                end_hands_clear(session, row.machine)
            self._change(session, id, requested_action=action.value)
            event = Message("job.action-requested", action=action)
            self._transitions.write_job_event(session, id, row.state, OPERATOR, event)
            return self._transitions.lock(session, id)

    def _change(self, session: Session, id: str, **changes: Any) -> None:
        """Set columns of a job that the transaction of the caller has locked.

        ``**changes``: new values of columns, by name of the column.
        """
        statement = sa.update(Job).where(Job.id == id)
        # Rows that this session has loaded keep their values; ``Transitions.lock`` reloads them.
        statement = statement.execution_options(synchronize_session=False)
        session.execute(statement.values(updated=self._db.clock(), **changes))


def _check_current(session: Session, row: Job) -> None:
    """Raise ``WrongState`` if the machine or the board of a job has changed since its compile."""
    changes = changes_since_compile(session, [row])
    if changes:
        raise WrongState("job.outdated", job=row.id, changes=changes[row.id])


def _is_held(row: Job) -> bool:
    """Return whether a job is held and stays so."""
    return row.state == State.HELD and not row.requested_action


def _refused_request_error(row: Job, action: OperatorAction) -> WrongState:
    """Return the error that a job does not allow the action in its present state."""
    if row.requested_action == OperatorAction.CANCEL:
        return WrongState("job.cancelled-before-request", job=row.id, request=action)
    if action is OperatorAction.END:
        return WrongState("job.no-end-awaited", job=row.id, state=row.state)
    if action is OperatorAction.RESUME and row.state in LEASED:
        if row.confirmation == Confirmation.AWAITED:
            return WrongState("job.not-confirmed", job=row.id)
        if row.confirmation == Confirmation.SHEET:
            return WrongState("job.needs-sheet", job=row.id)
        if row.awaits_end:
            return WrongState("job.needs-end", job=row.id)
    return WrongState(
        "job.wrong-state-for-request",
        job=row.id,
        state=row.state,
        request=action,
        states=sources(Action(action), ActorKind.GATEWAY),
        advice=ADVICE[State(row.state)],
    )
