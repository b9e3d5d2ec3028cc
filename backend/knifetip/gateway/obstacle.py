"""obstacle: why a connected machine takes no job, and what the person at it does.

A controller that is held, asleep or in check mode is not locked by an alarm.  The operation
``release`` leads out of these states: it discards what the controller holds and moves no axis.
"""

from __future__ import annotations

from knifetip.gateway.controller import State, Status
from knifetip.messages import Message

#: States without an alarm from which ``release`` brings a controller to rest.
RELEASABLE = frozenset(
    {State.HOLD, State.DOOR, State.CHECK, State.SLEEP, State.TOOL, State.RUN, State.BUSY}
)
_CODES = {
    State.HOLD: "obstacle.held",
    State.CHECK: "obstacle.check-mode",
    State.SLEEP: "obstacle.asleep",
    State.TOOL: "obstacle.tool-change",
    State.RUN: "obstacle.moves",
    State.BUSY: "obstacle.busy",
}


def obstacle_of(status: Status, name: str) -> Message | None:
    """Return why a machine takes no job, with what to do; None if it is at rest or locked.

    A pressed limit switch is in the way only if it stops the machine (``notice_of``).

    An alarm is reported by itself (``Operable.alarm``), and a move by hand ends by itself.

    Parameters
    ----------
    status
        Last report of the controller, which runs no job of this gateway.
    name
        Address of the controller.
    """
    if status.state is State.DOOR:
        door = "obstacle.door-open" if status.door_open else "obstacle.door-closed"
        return Message(door, name=name)
    if status.state is State.IDLE and status.pressed and status.hard_limits:
        return Message("obstacle.limit-pressed", name=name, axes=list(status.pressed))
    code = _CODES.get(status.state)
    return None if code is None else Message(code, name=name)


def obstacle_in_job(status: Status, name: str) -> Message | None:
    """Return why a job on a machine does not move, with what to do; None if it moves or is held.

    A job that is held has its own commands (resume and cancel).

    Parameters
    ----------
    status
        Last report of the controller, which runs a job of this gateway.
    name
        Address of the controller.
    """
    if status.state is not State.DOOR:
        return None
    opened = status.door_open
    return Message("obstacle.job-door-open" if opened else "obstacle.job-door-closed", name=name)


def notice_of(status: Status, name: str) -> Message | None:
    """Return a notice about a machine that can take jobs all the same; None if there is none.

    Parameters
    ----------
    status
        Last report of the controller.
    name
        Address of the controller.
    """
    if status.hard_limits or not status.pressed:
        return None
    return Message("obstacle.limit-unused", name=name, axes=list(status.pressed))
