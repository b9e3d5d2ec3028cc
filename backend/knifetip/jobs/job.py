"""job: the states of a job and who may move it from one to another.

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

_ALPHABET = "abcdefghjkmnpqrstuvwxyz23456789"


class State(StrEnum):
    """Where a job stands."""

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

TRANSITIONS: dict[tuple[State, State], frozenset[Who]] = {
    (State.RECEIVED, State.COMPILING): frozenset({Who.WORKER}),
    (State.RECEIVED, State.CANCELLED): frozenset({Who.OPERATOR}),
    (State.COMPILING, State.READY): frozenset({Who.WORKER}),
    (State.COMPILING, State.REFUSED): frozenset({Who.WORKER, Who.CLOCK}),
    (State.COMPILING, State.RECEIVED): frozenset({Who.WORKER, Who.CLOCK}),
    (State.COMPILING, State.CANCELLED): frozenset({Who.OPERATOR}),
    # The worker, where the order asked to be queued as soon as it is ready.
    (State.READY, State.QUEUED): frozenset({Who.OPERATOR, Who.WORKER}),
    (State.READY, State.CANCELLED): frozenset({Who.OPERATOR}),
    (State.QUEUED, State.RUNNING): frozenset({Who.GATEWAY}),
    (State.QUEUED, State.CANCELLED): frozenset({Who.OPERATOR}),
    (State.RUNNING, State.HELD): frozenset({Who.GATEWAY}),
    (State.HELD, State.RUNNING): frozenset({Who.GATEWAY}),
    (State.RUNNING, State.DONE): frozenset({Who.GATEWAY}),
    (State.HELD, State.DONE): frozenset({Who.GATEWAY}),
    (State.RUNNING, State.INTERRUPTED): frozenset({Who.GATEWAY, Who.CLOCK}),
    (State.HELD, State.INTERRUPTED): frozenset({Who.GATEWAY, Who.CLOCK}),
    (State.RUNNING, State.CANCELLED): frozenset({Who.GATEWAY}),
    (State.HELD, State.CANCELLED): frozenset({Who.GATEWAY}),
    (State.INTERRUPTED, State.QUEUED): frozenset({Who.OPERATOR}),
    (State.INTERRUPTED, State.SCRAPPED): frozenset({Who.OPERATOR}),
    # The gateway: its late report that the whole program was executed.
    (State.INTERRUPTED, State.DONE): frozenset({Who.OPERATOR, Who.GATEWAY}),
}


def sources(goal: State, who: Who) -> tuple[State, ...]:
    """Return the states from which ``who`` may move a job to ``goal``."""
    return tuple(
        start for (start, end), movers in TRANSITIONS.items() if end is goal and who in movers
    )


def new_id() -> str:
    """Return ten letters and digits that can be read aloud: nothing that looks like another."""
    return "".join(secrets.choice(_ALPHABET) for _ in range(10))
