"""job: the states of a job, and the table of its transitions.

    received → compiling → ready → queued → running ⇄ held → done
                  ↘ refused                    ↘ interrupted → queued again | scrapped
    cancelled from any state before done

A compile may be repeated; a cut may not, since the board is gone and a blade may be in it.  So
only an operator returns a job from ``interrupted`` to the queue.  The last owner's late report may
correct an interrupted job, up to ``done``, but never starts it again.

On a machine that is fed by hand a gateway claims a queued job and waits: the job stays ``queued``
until an operator has confirmed the sheet (see ``Confirmation``).  Nothing is sent before, so such
a claim is given back when its lease runs out.
"""

from __future__ import annotations

import secrets
from enum import StrEnum
from typing import NamedTuple

from knifetip.messages import Message

_ALPHABET = "abcdefghjkmnpqrstuvwxyz23456789"


class State(StrEnum):
    """State of a job."""

    RECEIVED = "received"
    COMPILING = "compiling"
    READY = "ready"
    QUEUED = "queued"
    RUNNING = "running"
    HELD = "held"
    DONE = "done"
    REFUSED = "refused"
    INTERRUPTED = "interrupted"
    SCRAPPED = "scrapped"
    CANCELLED = "cancelled"


class Who(StrEnum):
    """Who moves a job."""

    OPERATOR = "operator"
    WORKER = "worker"  #: a compile worker
    GATEWAY = "gateway"  #: the process beside the table
    CLOCK = "clock"  #: a lease that ran out


class Confirmation(StrEnum):
    """What the operator has to confirm before the machine may move, under the present claim."""

    NONE = ""  #: nothing: no gateway has claimed the job, or its machine feeds itself
    AWAITED = "awaited"  #: claimed; table clear, board and tools are to be confirmed
    GIVEN = "given"  #: confirmed for this claim
    SHEET = "sheet"  #: a copy is done; the next sheet is to be confirmed


#: States in which a job's board lies on the table: one job to a machine.
ON_TABLE = (State.RUNNING, State.HELD, State.INTERRUPTED)

#: States in which a gateway holds a lease.
LEASED = (State.RUNNING, State.HELD)


class Action(StrEnum):
    """What moves a job to another state; each has one target."""

    COMPILE = "compile"
    ACCEPT = "accept"
    REFUSE = "refuse"
    RETRY = "retry"
    RELEASE = "release"
    START = "start"
    HOLD = "hold"
    RESUME = "resume"
    FINISH = "finish"
    INTERRUPT = "interrupt"
    REQUEUE = "requeue"
    SCRAP = "scrap"
    CANCEL = "cancel"


class Transition(NamedTuple):
    """One row of the table of transitions."""

    source: State
    action: Action
    target: State
    actors: tuple[Who, ...]  #: who may do it


_OPERATOR, _WORKER, _GATEWAY, _CLOCK = Who.OPERATOR, Who.WORKER, Who.GATEWAY, Who.CLOCK
#: All transitions.  An operator's hold, resume and cancel of a job on a table are requests to its
#: gateway, which does them.
TRANSITIONS: tuple[Transition, ...] = (
    Transition(State.RECEIVED, Action.COMPILE, State.COMPILING, (_WORKER,)),
    Transition(State.RECEIVED, Action.CANCEL, State.CANCELLED, (_OPERATOR,)),
    Transition(State.COMPILING, Action.ACCEPT, State.READY, (_WORKER,)),
    Transition(State.COMPILING, Action.REFUSE, State.REFUSED, (_WORKER, _CLOCK)),
    Transition(State.COMPILING, Action.RETRY, State.RECEIVED, (_WORKER, _CLOCK)),
    Transition(State.COMPILING, Action.CANCEL, State.CANCELLED, (_OPERATOR,)),
    # The worker releases a job whose order requests it.
    Transition(State.READY, Action.RELEASE, State.QUEUED, (_OPERATOR, _WORKER)),
    Transition(State.READY, Action.CANCEL, State.CANCELLED, (_OPERATOR,)),
    Transition(State.QUEUED, Action.START, State.RUNNING, (_GATEWAY,)),
    Transition(State.QUEUED, Action.CANCEL, State.CANCELLED, (_OPERATOR,)),
    Transition(State.RUNNING, Action.HOLD, State.HELD, (_GATEWAY,)),
    Transition(State.RUNNING, Action.FINISH, State.DONE, (_GATEWAY,)),
    Transition(State.RUNNING, Action.INTERRUPT, State.INTERRUPTED, (_GATEWAY, _CLOCK)),
    Transition(State.RUNNING, Action.CANCEL, State.CANCELLED, (_GATEWAY,)),
    Transition(State.HELD, Action.RESUME, State.RUNNING, (_GATEWAY,)),
    Transition(State.HELD, Action.FINISH, State.DONE, (_GATEWAY,)),
    Transition(State.HELD, Action.INTERRUPT, State.INTERRUPTED, (_GATEWAY, _CLOCK)),
    Transition(State.HELD, Action.CANCEL, State.CANCELLED, (_GATEWAY,)),
    Transition(State.INTERRUPTED, Action.REQUEUE, State.QUEUED, (_OPERATOR,)),
    Transition(State.INTERRUPTED, Action.SCRAP, State.SCRAPPED, (_OPERATOR,)),
    # The gateway: a late report that the whole program was executed.
    Transition(State.INTERRUPTED, Action.FINISH, State.DONE, (_OPERATOR, _GATEWAY)),
)
#: What an operator can do about a job whose state refuses an action.
ADVICE: dict[State, Message] = {
    State.RECEIVED: Message("advice.compiling"),
    State.COMPILING: Message("advice.compiling"),
    State.READY: Message("advice.ready"),
    State.QUEUED: Message("advice.queued"),
    State.RUNNING: Message("advice.running"),
    State.HELD: Message("advice.running"),
    State.INTERRUPTED: Message("advice.interrupted"),
    State.DONE: Message("advice.ended"),
    State.REFUSED: Message("advice.ended"),
    State.SCRAPPED: Message("advice.ended"),
    State.CANCELLED: Message("advice.ended"),
}


def sources(action: Action, who: Who) -> tuple[State, ...]:
    """Return the states in which ``who`` may do an action."""
    return tuple(row.source for row in TRANSITIONS if row.action is action and who in row.actors)


def target(action: Action) -> State:
    """Return the state to which an action moves a job."""
    return next(row.target for row in TRANSITIONS if row.action is action)


def action_between(source: State, goal: State) -> Action:
    """Return the action that moves a job from one state to another.

    Raises
    ------
    StopIteration
        There is none.
    """
    return next(row.action for row in TRANSITIONS if (row.source, row.target) == (source, goal))


def new_id() -> str:
    """Return ten letters and digits that can be read aloud: nothing that looks like another."""
    return "".join(secrets.choice(_ALPHABET) for _ in range(10))
