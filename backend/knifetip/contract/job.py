"""States of a job and the table of its transitions.

    received → compiling → ready → queued → running ⇄ held → done
                  ↘ refused                    ↘ interrupted → queued again | scrapped | continued
    cancelled from any state before done

A program that is refused only for shortfalls becomes ready when an operator accepts them.

The program repeats a failed compile by itself.  It does not repeat a failed cut, since the board is
used up and a blade may be in it: only an operator returns a job from ``interrupted`` to the queue,
or a late report of its gateway that nothing was executed.
Another job may make the rest of the sheet, or the whole program again: when that job is queued, the
interrupted job becomes ``continued`` and no longer occupies the table.  A late report of the last
owner may move an interrupted job to ``done`` or correct its message, but
it never restarts the job.

A machine may refuse a program in its check run, or fail before it executes anything.  The job is
then ``queued`` again with the reason (``check_refusal``), frees the table, and is not claimed until
an operator lets it be tried again.  A gateway announces that it begins the program, and sends the
first line when the server has stored this (``Job.begun``).  The expiry of a lease can therefore
return a job, too.

On a machine with manual feed, a gateway claims a queued job and waits: the job stays ``queued``
until the operator has confirmed the sheet (see ``Confirmation``).  The gateway sends nothing to the
machine before the confirmation, so the claim can be released safely when its lease expires.
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
    CONTINUED = "continued"  #: another job continues its work
    CANCELLED = "cancelled"


class ActorKind(StrEnum):
    """Kinds of persons and processes that move a job to another state."""

    OPERATOR = "operator"
    WORKER = "worker"  #: a compile worker
    GATEWAY = "gateway"  #: a gateway
    CLOCK = "clock"  #: an expired lease


class Actor(NamedTuple):
    """The person or process that moves a job to another state, with its name if it is known."""

    kind: ActorKind
    name: str = ""

    def __str__(self) -> str:
        return f"{self.kind} {self.name}".strip()


#: An operator whose name is not known, and the expiry of a lease.
OPERATOR, CLOCK = Actor(ActorKind.OPERATOR), Actor(ActorKind.CLOCK)


class Confirmation(StrEnum):
    """Stages of the operator's confirmation that the machine may begin a job or its next copy.

    A confirmation is valid only for the present claim of the job.
    """

    NONE = ""  #: nothing: the job is not claimed, or its machine has automatic feed
    AWAITED = "awaited"  #: claimed; table, board and tools must be confirmed
    GIVEN = "given"  #: confirmed for this claim
    SHEET = "sheet"  #: a copy is done; the next sheet must be confirmed


#: States in which a job's board is on the table; at most one job per machine.
ON_TABLE = (State.RUNNING, State.HELD, State.INTERRUPTED)

#: States in which a job is not worked on; only an operator moves it to another state.
ENDED = (
    State.DONE,
    State.REFUSED,
    State.INTERRUPTED,
    State.SCRAPPED,
    State.CONTINUED,
    State.CANCELLED,
)

#: States in which another job may continue the work of a job: its machine has ended its work.
CONTINUABLE = (
    State.INTERRUPTED,
    State.DONE,
    State.SCRAPPED,
    State.CONTINUED,
    State.CANCELLED,
)

#: States in which a gateway holds a lease.
LEASED = (State.RUNNING, State.HELD)


class Action(StrEnum):
    """Actions that move a job to another state; each action leads to one state."""

    COMPILE = "compile"
    ACCEPT = "accept"
    REFUSE = "refuse"
    RETRY = "retry"
    RECOMPILE = "recompile"
    RELEASE = "release"
    START = "start"
    HOLD = "hold"
    RESUME = "resume"
    FINISH = "finish"
    INTERRUPT = "interrupt"
    RETURN = "return"  #: the program was not begun: no line of it was executed
    REQUEUE = "requeue"
    SCRAP = "scrap"
    REST = "rest"  #: another job continues its work
    CANCEL = "cancel"


class Transition(NamedTuple):
    """A permitted change of a job's state, with its action.

    It contains the state before, the state after, and the kinds of actors that may perform the
    action.
    """

    source: State
    action: Action
    target: State
    actors: tuple[ActorKind, ...]  #: who may perform it


_OPERATOR, _WORKER, _GATEWAY, _CLOCK = (
    ActorKind.OPERATOR,
    ActorKind.WORKER,
    ActorKind.GATEWAY,
    ActorKind.CLOCK,
)
#: All transitions.  For a job on a table, the operator's hold, resume and cancel are requests that
#: its gateway performs.
TRANSITIONS: tuple[Transition, ...] = (
    Transition(State.RECEIVED, Action.COMPILE, State.COMPILING, (_WORKER,)),
    Transition(State.RECEIVED, Action.CANCEL, State.CANCELLED, (_OPERATOR,)),
    Transition(State.COMPILING, Action.ACCEPT, State.READY, (_WORKER,)),
    Transition(State.COMPILING, Action.REFUSE, State.REFUSED, (_WORKER, _CLOCK)),
    Transition(State.COMPILING, Action.RETRY, State.RECEIVED, (_WORKER, _CLOCK)),
    # An operator accepts the shortfalls of a program.
    Transition(State.REFUSED, Action.ACCEPT, State.READY, (_OPERATOR,)),
    Transition(State.COMPILING, Action.CANCEL, State.CANCELLED, (_OPERATOR,)),
    # The worker queues a job that is to be released when ready.
    Transition(State.READY, Action.RELEASE, State.QUEUED, (_OPERATOR, _WORKER)),
    Transition(State.READY, Action.CANCEL, State.CANCELLED, (_OPERATOR,)),
    # The machine or the board has changed since the compile.
    Transition(State.READY, Action.RECOMPILE, State.RECEIVED, (_OPERATOR,)),
    Transition(State.QUEUED, Action.RECOMPILE, State.RECEIVED, (_OPERATOR,)),
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
    # The gateway reports late that no line was executed; an operator lets the job be tried again.
    Transition(State.INTERRUPTED, Action.REQUEUE, State.QUEUED, (_OPERATOR, _GATEWAY)),
    Transition(State.INTERRUPTED, Action.SCRAP, State.SCRAPPED, (_OPERATOR,)),
    # No line of the program was executed.
    Transition(State.RUNNING, Action.RETURN, State.QUEUED, (_GATEWAY, _CLOCK)),
    Transition(State.HELD, Action.RETURN, State.QUEUED, (_GATEWAY, _CLOCK)),
    # When the job that continues it is released, by the operator or as ordered.
    Transition(State.INTERRUPTED, Action.REST, State.CONTINUED, (_OPERATOR, _WORKER)),
    # Late report of the gateway that the whole program was executed.
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
    State.CONTINUED: Message("advice.ended"),
    State.CANCELLED: Message("advice.ended"),
}


def sources(action: Action, actor_kind: ActorKind) -> tuple[State, ...]:
    """Return the states of a job in which an action may be performed; empty if there is none.

    Parameters
    ----------
    action
        Action that moves the job to another state.
    actor_kind
        Kind of the person or process that performs the action.
    """
    return tuple(
        row.source for row in TRANSITIONS if row.action is action and actor_kind in row.actors
    )


def target(action: Action) -> State:
    """Return the state of a job after an action."""
    return next(row.target for row in TRANSITIONS if row.action is action)


def action_between(source: State, goal: State) -> Action:
    """Return the action that moves a job from the state ``source`` to the state ``goal``.

    Raises
    ------
    StopIteration
        There is no such action.
    """
    return next(row.action for row in TRANSITIONS if (row.source, row.target) == (source, goal))


def new_id() -> str:
    """Return a random id of ten letters and digits, without characters that look alike."""
    return "".join(secrets.choice(_ALPHABET) for _ in range(10))
