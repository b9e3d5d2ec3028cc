"""Changes of a job that a gateway owns, each in a transaction of the caller."""

from __future__ import annotations

from typing import Any

import sqlalchemy as sa
from sqlalchemy.orm import Session

from knifetip.contract.job import Actor, ActorKind, Confirmation, State, action_between
from knifetip.messages import Message
from knifetip.service.database.engine import Database, rows
from knifetip.service.database.tables import Job
from knifetip.service.lifecycle.machine_runs import delete_run
from knifetip.service.lifecycle.transitions import Transitions, stale_epoch_error


class ClaimedJobs:
    """Changes jobs for their gateways.

    Each method runs in the transaction of the caller, which ``session`` has begun.  It raises
    ``StaleEpoch`` if the job has got another epoch since the caller read it.
    """

    def __init__(self, database: Database, transitions: Transitions) -> None:
        self._db = database
        self._transitions = transitions

    def change(self, session: Session, row: Job, changes: dict[str, Any]) -> None:
        """Set columns of a job that the transaction of the caller has locked.

        Parameters
        ----------
        session, row
            Session of the transaction, and the locked job.
        changes
            New values of columns, by name of the column.
        """
        statement = sa.update(Job).where(Job.id == row.id, Job.epoch == row.epoch)
        statement = statement.execution_options(synchronize_session=False)
        if not rows(session, statement.values(**changes)):
            raise stale_epoch_error(row.id, row.state, row.epoch + 1, row.epoch)

    def move(self, session: Session, row: Job, goal: State, event: Message, **changes: Any) -> None:
        """Move a job to the state ``goal`` in the name of its gateway, and write the event.

        Parameters
        ----------
        session, row
            Session of the transaction, and the job.
        goal
            The new state.
        event
            Description of the transition, for the log of events.
        **changes
            New values of further columns, by name of the column.
        """
        self._transitions.move(
            session,
            row.id,
            action_between(State(row.state), goal),
            Actor(ActorKind.GATEWAY, row.owner),
            event,
            epoch=row.epoch,
            **changes,
        )

    def start(self, session: Session, row: Job, **changes: Any) -> Job:
        """Move a claimed job to ``running`` and return it.

        This method is called after the operator's confirmation, or if the gateway reports that it
        has already begun to send the program.  ``changes`` are new values of further columns.
        """
        confirmed = row.confirmation == Confirmation.GIVEN
        event = Message("job.started" if confirmed else "job.started-unconfirmed")
        self.move(session, row, State.RUNNING, event, **changes)
        return self._transitions.lock(session, row.id)

    def put_back(
        self, session: Session, row: Job, actor: Actor, cause: Message, *, refused: bool = False
    ) -> None:
        """Put a job of which no line was executed back into the queue, at its former position.

        The job may be ``interrupted``, if this is known late.  The parameters are those of
        ``give_back``.
        """
        if row.state == State.QUEUED:
            self.give_back(session, row, actor, cause, refused=refused)
            return
        late = row.state == State.INTERRUPTED
        if late:
            delete_run(session, row.id)
        self._transitions.move(
            session,
            row.id,
            action_between(State(row.state), State.QUEUED),
            actor,
            return_event(cause, refused=refused),
            epoch=row.epoch,
            # An interrupted job has no owner that could still report.
            new_epoch=row.epoch if late else row.epoch + 1,
            check_refusal=cause if refused else None,
            owner="",
            lease=0.0,
            line=0,
            position=None,
            stopped_at=None,
            message=None,
            seconds_left=None,
            requested_action="",
            confirmation=Confirmation.NONE.value,
        )

    def give_back(
        self, session: Session, row: Job, actor: Actor, cause: Message, *, refused: bool = False
    ) -> None:
        """Put a claimed job that was never started back into the queue, at its former position.

        Parameters
        ----------
        session, row
            Session of the transaction, and the job.
        actor
            Person or process that returns the job, for the log of events.
        cause
            Reason for the return, for the log of events.
        refused
            Whether the job waits for an operator before it is claimed again.
        """
        self.change(
            session,
            row,
            {
                "epoch": row.epoch + 1,
                "owner": "",
                "lease": 0.0,
                "check_refusal": cause if refused else None,
                "requested_action": "",
                "confirmation": Confirmation.NONE.value,
                "updated": self._db.clock(),
            },
        )
        event = return_event(cause, refused=refused)
        self._transitions.write_job_event(session, row.id, State.QUEUED, actor, event, row.machine)


def return_event(cause: Message, *, refused: bool) -> Message:
    """Return the message for the log of events about a job that returns to the queue.

    Parameters
    ----------
    cause
        Reason for the return.
    refused
        Whether the job waits for an operator before it is claimed again.
    """
    return Message("job.check-refused" if refused else "job.claim-returned", reason=cause)


def silent_gateway_message(gateway: str) -> Message:
    """Return the message which states that a gateway has stopped responding."""
    return Message("job.gateway-lost", gateway=gateway)


def is_claimed(row: Job) -> bool:
    """Return whether a gateway has claimed a job and the job is not started yet."""
    return row.state == State.QUEUED and row.confirmation != Confirmation.NONE
