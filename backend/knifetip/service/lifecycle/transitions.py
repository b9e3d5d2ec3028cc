"""Transitions of jobs, each in one transaction with its event.

A transition is one UPDATE … WHERE state IN … (AND epoch = …), so that only one of two concurrent
transitions succeeds.  The epoch is a number that increases with each new owner of a job.  The
module ``job`` contains the table of permitted transitions.
"""

from __future__ import annotations

from typing import Any

import sqlalchemy as sa
from sqlalchemy.orm import Session

from knifetip.contract.job import ADVICE, ENDED, Action, Actor, ActorKind, State, sources, target
from knifetip.errors import NotFound, StaleEpoch, WrongState
from knifetip.messages import Message, hint
from knifetip.service.database.acting import acting_limits, set_subject, signature
from knifetip.service.database.change_notifier import ALL, RECEIVED, machine_topic
from knifetip.service.database.engine import Database, note_change, short
from knifetip.service.database.tables import Event, Job
from knifetip.service.lifecycle.machine_queues import last_rank
from knifetip.service.lifecycle.machine_runs import record_run
from knifetip.service.webhooks.outbox import enqueue_event

LEASE = 10.0  #: duration of a lease (s)


class Transitions:
    """Moves jobs to other states and writes events, inside a transaction of the caller."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def move(
        self,
        session: Session,
        id: str,
        action: Action,
        actor: Actor,
        event: Message,
        *,
        epoch: int | None = None,
        new_epoch: int | None = None,
        **changes: Any,
    ) -> None:
        """Perform an action on a job, which moves the job to another state, and write the event.

        Parameters
        ----------
        session
            Session with the transaction of the caller.
        id
            Id of the job.
        action
            The action.
        actor
            Person or process that performs the action.
        event
            Description of the transition, for the log of events.
        epoch
            Epoch that the job must have; None for any.
        new_epoch
            New epoch of the job; None to keep its epoch.
        **changes
            New values of further columns, by name of the column.

        Raises
        ------
        NotFound
            There is no job with this id.
        WrongState
            The actor may not perform the action in the present state of the job.
        StaleEpoch
            The job has another epoch.
        """
        goal = target(action)
        statement = sa.update(Job).where(Job.id == id, Job.state.in_(sources(action, actor.kind)))
        statement = statement.where(*acting_limits().job_conditions())
        if epoch is not None:
            statement = statement.where(Job.epoch == epoch)
        # Rows that this session has loaded keep their values; ``lock`` reloads them.
        statement = statement.execution_options(synchronize_session=False)
        now = self._db.clock()
        values: dict[str, Any] = {"state": goal.value, "updated": now, **changes}
        if action is Action.START:
            values["started"] = sa.case((Job.started > 0.0, Job.started), else_=now)
        if action is Action.RETURN:
            # No line of the copy was executed.
            values["started"] = sa.case((Job.copies_done > 0, Job.started), else_=0.0)
        if goal in ENDED:
            values["ended"] = now
        if new_epoch is not None:
            values["epoch"] = new_epoch
        machine = session.scalar(statement.values(**values).returning(Job.machine))
        if machine is None:
            raise self.refusal(session, id, goal, epoch)
        record_run(session, id, action, now)
        self.write_job_event(session, id, goal, actor, event, machine, new_state=True)

    def release(self, session: Session, id: str, actor: Actor, event: Message) -> None:
        """Move a ready job to the end of the queue of its machine.

        If it continues an interrupted job, that job becomes ``continued`` and frees its table.

        Parameters
        ----------
        session
            Session with the transaction of the caller.
        id
            Id of the job.
        actor
            Person or process that releases the job.
        event
            Description of the release, for the log of events.

        Raises
        ------
        WrongState
            The job is not ``ready``.
        """
        now = self._db.clock()
        machine = session.scalar(sa.select(Job.machine).where(Job.id == id)) or ""
        rank = last_rank(session, machine, now)
        self.move(session, id, Action.RELEASE, actor, event, queued=now, rank=rank)
        parent = session.scalar(
            sa.select(Job.id).where(
                Job.id == sa.select(Job.resumes).where(Job.id == id).scalar_subquery(),
                Job.state == State.INTERRUPTED,
            )
        )
        if parent is not None:
            self.move(session, parent, Action.REST, actor, Message("rest.continued-by", job=id))

    def release_by_order(self, session: Session, id: str) -> None:
        """Queue a ready job that was ordered with immediate release."""
        event = Message("job.released-by-order")
        self.release(session, id, Actor(ActorKind.WORKER), event)

    def refusal(
        self, session: Session, id: str, goal: str, epoch: int | None = None
    ) -> NotFound | WrongState | StaleEpoch:
        """Return the error about a job that cannot move to the state ``goal``.

        ``epoch`` is the epoch that the job should have, None for any.
        """
        columns = sa.select(Job.state, Job.epoch, Job.message).where(Job.id == id)
        found = session.execute(columns.where(*acting_limits().job_conditions())).first()
        if found is None:
            return unknown_job_error(id)
        state, current, message = found
        if epoch is not None and epoch != current:
            return stale_epoch_error(id, state, current, epoch)
        return WrongState(
            "job.wrong-state", job=id, state=state, goal=goal, advice=advice(state, message)
        )

    def write_job_event(
        self,
        session: Session,
        id: str,
        state: str,
        actor: Actor,
        message: Message,
        machine: str = "",
        *,
        new_state: bool = False,
    ) -> None:
        """Write an event about a job to the log of events, and its webhooks.

        Parameters
        ----------
        session
            Session with the transaction of the caller.
        id
            Id of the job.
        state
            State of the job after the event.
        actor
            Person or process that caused the event.
        message
            Description of the event.
        machine
            Name of the machine of the job, which limits who is woken; "" to wake all.
        new_state
            Whether the job was created or came to another state with this event.
        """
        topics = [machine_topic(machine) if machine else ALL]
        note_change(session, *topics, *([RECEIVED] if state == State.RECEIVED else []))
        row = self._event("job", id, state, actor, message)
        self._write_event(session, row, new_state=new_state)

    def write_drawing_event(
        self, session: Session, id: str, state: str, actor: Actor, message: Message
    ) -> None:
        """Write an event about a drawing to the log of events, and its webhooks.

        ``state`` is ``read``, ``changed`` or ``deleted``; the other parameters are those of
        ``write_job_event``.
        """
        note_change(session, ALL)
        row = self._event("drawing", id, state, actor, message)
        self._write_event(session, row, new_state=False)

    def _event(self, kind: str, subject: str, state: str, actor: Actor, message: Message) -> Event:
        """Return an event that happens now."""
        return Event(
            kind=kind,
            subject=subject,
            at=self._db.clock(),
            state=str(state),
            who=signature(actor)[:200],
            message=message,
        )

    def _write_event(self, session: Session, event: Event, *, new_state: bool) -> None:
        set_subject(session, event.kind, event.subject)
        session.add(event)
        enqueue_event(session, event, new_state=new_state)

    def change(self, session: Session, id: str, **changes: Any) -> None:
        """Set columns of a job that the transaction of the caller has locked.

        ``**changes``: new values of columns, by name of the column.
        """
        statement = sa.update(Job).where(Job.id == id)
        # Rows that this session has loaded keep their values; ``lock`` reloads them.
        statement = statement.execution_options(synchronize_session=False)
        session.execute(statement.values(updated=self._db.clock(), **changes))

    def lock(self, session: Session, id: str) -> Job:
        """Return the job with an id, locked for other writers until the transaction ends.

        Raises
        ------
        NotFound
            There is no job with this id.
        """
        row = session.scalar(
            sa.select(Job)
            .where(Job.id == id, *acting_limits().job_conditions())
            .with_for_update()
            .execution_options(populate_existing=True)
        )
        if row is None:
            raise unknown_job_error(id)
        return row


def advice(state: str, message: Message | None) -> Message:
    """Return a message about what an operator can do with a job.

    The result is the hint of the message stored in the job.  If there is no such hint, the result
    is a general hint for the state of the job.

    Parameters
    ----------
    state
        State of the job.
    message
        Message stored in the job; None if there is none.
    """
    if message is not None and hint(message):
        return Message("advice.of-reason", reason=message)
    return ADVICE[State(state)]


def unknown_job_error(id: str) -> NotFound:
    """Return the error that there is no job with an id."""
    return NotFound("job.unknown", job=short(id))


def stale_epoch_error(id: str, state: str, current: int, epoch: int) -> StaleEpoch:
    """Return the error for a worker or gateway that no longer owns a job.

    Parameters
    ----------
    id
        Id of the job.
    state
        State of the job.
    current
        Present epoch of the job: a number that increases with each new owner.
    epoch
        Epoch that the worker or gateway has sent.
    """
    return StaleEpoch("job.stale-epoch", job=id, state=state, current=current, epoch=epoch)
