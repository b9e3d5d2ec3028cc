"""What keeps a machine from work: a run above the board, an obstacle, or hands that are not clear.

The functions read and change the row of the station in the transaction of the caller.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from typing import Any

import sqlalchemy as sa
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session

from knifetip.contract.operations import HANDS_CLEAR, RUNS
from knifetip.errors import WrongState
from knifetip.messages import Message
from knifetip.service.database.tables import NEVER_STATED, Operation, Station

#: Seconds after its last report from which a gateway counts as disconnected.
SILENCE = 6.0


def locked_station(session: Session, machine: str) -> Station:
    """Return the row of a station, locked by the transaction; it is added if there is none."""
    row = session.get(Station, machine, with_for_update=True)
    if row is not None:
        return row
    # Another process may add the row at the same time.
    with suppress(IntegrityError), session.begin_nested():
        added = Station(machine=machine, gateway="", reported=0.0, watched=0.0, connected=False)
        added.state, added.outputs, added.operations, added.notices = "", [], [], []
        session.add(added)
    return session.get_one(Station, machine, with_for_update=True)


def dry_run_on(session: Session, machine: str, now: float) -> bool:
    """Return whether a machine runs above the board, or will do so at once.

    Parameters
    ----------
    session
        Session with the transaction of the caller.
    machine
        Name of the machine.
    now
        Present time, see ``Database.timer``.
    """
    row = session.get(Station, machine)
    if row is not None and 0.0 <= now - row.reported <= SILENCE and _is_busy(row.activity):
        return True
    waiting = sa.select(Operation.request).where(
        Operation.machine == machine,
        Operation.state == "waiting",
        Operation.asked > now - SILENCE,
        Operation.asked <= now,
    )
    return any(request.get("operation") in RUNS for request in session.scalars(waiting))


def require_hands_clear(
    session: Session, machine: str, request: str, now: float, *, stated: bool
) -> None:
    """Raise ``WrongState`` unless hands are clear of a machine that is about to move.

    Parameters
    ----------
    session
        Session with the transaction of the caller.
    machine
        Name of the machine.
    request
        What moves it, for the message.
    now
        Present time, see ``Database.timer``.
    stated
        Whether the request itself states it; that counts for this request only.
    """
    row = locked_station(session, machine)
    if not stated and not 0.0 <= now - row.hands_clear < HANDS_CLEAR:
        raise WrongState(
            "operation.hands-not-clear", request=request, machine=machine, seconds=HANDS_CLEAR
        )


def end_hands_clear(session: Session, machine: str) -> None:
    """End the statement that hands are clear of a machine.

    It ends when a person withdraws it, and as a job starts or goes on: when the job has ended, a
    person takes the sheet from the table.
    """
    locked_station(session, machine).hands_clear = NEVER_STATED


def obstacle_on(session: Session, machine: str, now: float) -> Message | None:
    """Return the alarm or the obstacle that keeps a machine from work; None if it reports none.

    Parameters
    ----------
    session
        Session with the transaction of the caller.
    machine
        Name of the machine.
    now
        Present time, see ``Database.timer``.
    """
    row = session.get(Station, machine)
    if row is None or not row.connected or not 0.0 <= now - row.reported <= SILENCE:
        return None
    return row.alarm or row.obstacle


def _is_busy(activity: Mapping[str, Any] | None) -> bool:
    return activity is not None and activity["state"] in ("running", "held")
