"""moves: how a job goes from state to state, in one transaction with the event that records it.

A move is one UPDATE … WHERE state = … (and epoch = …): of two who want the same job one comes late.
"""

from __future__ import annotations

from typing import Any, cast

import sqlalchemy as sa
from sqlalchemy.orm import Session

from knifetip.errors import KeyReused, NoSuchJob, StaleEpoch, WrongState
from knifetip.jobs.database import Database
from knifetip.jobs.job import State, Who, sources
from knifetip.jobs.tables import Drawing, Event, Job
from knifetip.messages import Message, from_json

LEASE = 10.0  #: seconds that a gateway or a worker may be silent


class Moves(Database):
    """A database whose jobs move, each move with its event."""

    def _move(
        self,
        session: Session,
        id: str,
        goal: State,
        who: Who,
        why: str,
        *,
        name: str = "",
        epoch: int | None = None,
        only: tuple[State, ...] = (),
        changes_epoch: int | None = None,
        **changes: Any,
    ) -> None:
        """Move a job, if it is where such a move begins, and write the event beside it.

        Raises
        ------
        NoSuchJob, WrongState, StaleEpoch
            It was not moved.
        """
        statement = sa.update(Job).where(Job.id == id, Job.state.in_(only or sources(goal, who)))
        if epoch is not None:
            statement = statement.where(Job.epoch == epoch)
        if changes_epoch is not None:
            changes["epoch"] = changes_epoch
        # Rows that were read in this session keep what they said: the caller reads afresh.
        statement = statement.execution_options(synchronize_session=False)
        values = {"state": goal.value, "updated": self.clock(), **changes}
        if not rows(session, statement.values(**values)):
            raise self._refusal(session, id, goal, epoch)
        self._note(session, "job", id, goal, f"{who} {name}".strip(), why)

    def _refusal(
        self, session: Session, id: str, goal: str, epoch: int | None
    ) -> NoSuchJob | WrongState | StaleEpoch:
        columns = sa.select(Job.state, Job.epoch, Job.hint).where(Job.id == id)
        found = session.execute(columns).first()
        if found is None:
            return NoSuchJob("job.unknown", job=short(id))
        state, current, hint = found
        if epoch is not None and epoch != current:
            return stale(id, state, current, epoch)
        advice = from_json(hint) if hint else advice_for(state)
        return WrongState("job.wrong-state", job=id, state=state, goal=goal, advice=advice)

    def _note(
        self, session: Session, kind: str, subject: str, state: str, who: str, why: str
    ) -> None:
        session.info["changed"] = True
        session.add(
            Event(
                kind=kind,
                subject=subject,
                at=self.clock(),
                state=str(state),
                who=who[:200],
                why=why,
            )
        )

    def _fresh(self, session: Session, id: str) -> Job:
        row = session.scalar(
            sa.select(Job)
            .where(Job.id == id)
            .with_for_update()
            .execution_options(populate_existing=True)
        )
        if row is None:
            raise NoSuchJob("job.unknown", job=short(id))
        return row

    def _column(self, table: type[Drawing] | type[Job], id: str, column: str, word: str) -> bytes:
        query = sa.select(getattr(table, column), table.id).where(table.id == id)
        with self._reading() as session:
            found = session.execute(query).first()
        if found is None:
            raise NoSuchJob("store.unknown", kind=word, id=short(id))
        if found[0] is None:
            raise WrongState("store.no-column", kind=word, id=id, column=column)
        return bytes(found[0])


def stale(id: str, state: str, current: int, epoch: int) -> StaleEpoch:
    """Return the refusal of somebody whose epoch is over."""
    return StaleEpoch("job.stale-epoch", job=id, state=state, current=current, epoch=epoch)


def rows(session: Session, statement: sa.Update | sa.Delete) -> int:
    """Return how many rows a statement changed."""
    return cast("sa.CursorResult[Any]", session.execute(statement)).rowcount


def short(id: str) -> str:
    """Return an id as it may stand in an error, however long it came."""
    return repr(id if len(id) <= 40 else id[:40] + "…")


def advice_for(state: str) -> Message:
    """Return what can be done about a job in this state."""
    match state:
        case State.INTERRUPTED:
            return Message("advice.interrupted")
        case State.RECEIVED | State.COMPILING:
            return Message("advice.compiling")
        case State.READY:
            return Message("advice.ready")
        case State.QUEUED:
            return Message("advice.queued")
        case State.RUNNING | State.HELD:
            return Message("advice.running")
        case _:
            return Message("advice.ended")


def same_request(row: Any, key: str, fingerprint: str) -> Any:
    """Return the row that an Idempotency-Key stands for.

    Raises
    ------
    KeyReused
        It was used for another request.
    """
    if row.fingerprint != fingerprint:
        raise KeyReused("request.key-reused", key=short(key))
    return row
