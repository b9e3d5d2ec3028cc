"""The actions of operators on jobs, and which of them a job allows in its present state."""

from __future__ import annotations

from enum import StrEnum

from knifetip.contract.job import (
    CONTINUABLE,
    LEASED,
    TRANSITIONS,
    Action,
    ActorKind,
    Confirmation,
    State,
)
from knifetip.service.database.tables import Job


class OperatorAction(StrEnum):
    """Actions that an operator can perform on jobs, in the order of their buttons on the page."""

    ACCEPT = "accept"  #: accept the shortfalls of a refused program
    RELEASE = "release"
    CONFIRM = "confirm"  #: table, board and tools are ready
    HOLD = "hold"
    RESUME = "resume"
    END = "end"  #: the machine has executed the program, but does not report it
    REST = "rest"  #: make the rest of the sheet, or the whole program again, with another job
    REQUEUE = "requeue"
    FINISH = "finish"  #: declare an interrupted job finished
    SCRAP = "scrap"
    RECHECK = "recheck"  #: let the machine check a program again that it has refused
    RECOMPILE = "recompile"  #: compile for the newest versions of machine and board
    CANCEL = "cancel"


#: Actions on a job on a table: the operator requests them, its gateway performs them.
_REQUESTED = frozenset({Action.HOLD, Action.RESUME, Action.CANCEL})


def allowed_actions(row: Job, now: float) -> list[OperatorAction]:
    """Return the actions that an operator may perform or request on a job now.

    An action that is not in the result is refused, unless it is a repetition of the action that was
    accepted last; the repetition has no effect.

    Parameters
    ----------
    row
        The job.
    now
        Present time (seconds since 1970).
    """
    state = State(row.state)
    allowed = {
        OperatorAction(transition.action)
        for transition in TRANSITIONS
        if transition.source is state
        and (
            ActorKind.OPERATOR in transition.actors
            or (state in LEASED and transition.action in _REQUESTED)
        )
    }
    if not has_only_shortfalls(row):
        allowed.discard(OperatorAction.ACCEPT)
    if row.rest is not None:
        allowed.discard(OperatorAction.RECOMPILE)
    if state is State.QUEUED and row.check_refusal is not None:
        allowed.add(OperatorAction.RECHECK)
    if awaits_confirmation(row, now):
        allowed.add(OperatorAction.CONFIRM)
    if state in CONTINUABLE and row.lines > 0:
        allowed.add(OperatorAction.REST)
    if is_fully_executed(row) or row.rest is not None:
        allowed.discard(OperatorAction.REQUEUE)
    if state in LEASED:
        _apply_request(row, state, allowed)
    return [action for action in OperatorAction if action in allowed]


def _apply_request(row: Job, state: State, allowed: set[OperatorAction]) -> None:
    """Change the allowed actions of a job on a table according to the operator's last request.

    If a cancel was requested, hold and resume are removed.  If a hold was requested that the
    machine has not executed, resume is allowed; if a resume was requested, hold is allowed.
    Resume is removed if the operator must first confirm the job or its next sheet, and replaced if
    a person must confirm the end of the program.

    ``state``: state of the job, ``running`` or ``held``.
    ``allowed``: allowed actions; changed in place.
    """
    if row.requested_action == OperatorAction.CANCEL:
        allowed -= {OperatorAction.HOLD, OperatorAction.RESUME}
        return
    # A request that the machine has not executed can be replaced by the opposite one.
    if state is State.HELD and row.requested_action == OperatorAction.RESUME:
        allowed.add(OperatorAction.HOLD)
    if state is State.RUNNING and row.requested_action == OperatorAction.HOLD:
        allowed.add(OperatorAction.RESUME)
    if row.confirmation in (Confirmation.AWAITED, Confirmation.SHEET):
        allowed.discard(OperatorAction.RESUME)
    elif row.awaits_end:
        allowed.discard(OperatorAction.RESUME)
        allowed.add(OperatorAction.END)


def awaits_confirmation(row: Job, now: float) -> bool:
    """Return whether a job waits for the operator's confirmation.

    Returns False if the job is being cancelled, or if the lease of the gateway that claimed the job
    has expired.

    Parameters
    ----------
    row
        The job.
    now
        Present time (seconds since 1970).
    """
    return (
        row.confirmation in (Confirmation.AWAITED, Confirmation.SHEET)
        and row.requested_action != OperatorAction.CANCEL
        and not (row.state == State.QUEUED and row.lease < now)
    )


def has_only_shortfalls(row: Job) -> bool:
    """Return whether a job's program is refused only for shortfalls, which a user may accept."""
    # Verdicts of older versions do not count their findings.
    summary = row.verdict_summary or {}
    return summary.get("faults") == 0 and summary.get("shortfalls", 0) > 0


def is_fully_executed(row: Job) -> bool:
    """Return whether an interrupted job was executed to the last line of its last copy.

    Such a job must not be queued again, because that would waste a board.
    """
    return row.state == State.INTERRUPTED and 0 < row.lines == row.line
