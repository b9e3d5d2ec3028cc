"""Actions of operators at the machine on stored jobs: confirm, hold, resume, cancel.

Decisions about their programs are in ``program_store``, and actions on interrupted jobs in
``interrupted_jobs``.
"""

from __future__ import annotations

from collections.abc import Collection

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
from knifetip.service.database.engine import Database
from knifetip.service.database.request_key import RequestKey
from knifetip.service.database.tables import Job
from knifetip.service.library.outdated_jobs import require_current
from knifetip.service.lifecycle.transitions import Transitions, advice
from knifetip.service.machines.station_obstacles import (
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
)
from knifetip.service.runs.checks import Check, CheckList, events_of_checks
from knifetip.service.tools.check import NOTHING_STATED, ToolCheck, ToolGate


class OperatorStore:
    """Actions of operators on stored jobs; each method stores one action with its event.

    Each method returns the job unchanged if it was called with the same ``RequestKey`` before; it
    raises ``KeyReused`` if the key was used for another command.
    """

    def __init__(
        self,
        database: Database,
        transitions: Transitions,
        checks: CheckList,
        tools: ToolGate,
        keys: CommandKeys,
    ) -> None:
        self._db = database
        self._transitions = transitions
        self._checks = checks
        self._tools = tools
        self._keys = keys

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
            require_current(session, row)
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
            self._transitions.change(
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
            self._transitions.change(session, id, requested_action=action.value)
            event = Message("job.action-requested", action=action)
            self._transitions.write_job_event(session, id, row.state, OPERATOR, event)
            return self._transitions.lock(session, id)


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
