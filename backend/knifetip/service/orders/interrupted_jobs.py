"""Decisions of operators about interrupted jobs: make them again, scrap them, or declare them done.

An interrupted job occupies the table of its machine until an operator has made one of the
decisions.
"""

from __future__ import annotations

from knifetip.contract.job import OPERATOR, Action, State
from knifetip.errors import WrongState
from knifetip.messages import Message
from knifetip.service.database.engine import Database
from knifetip.service.database.request_key import RequestKey
from knifetip.service.database.tables import Job
from knifetip.service.lifecycle.transitions import Transitions
from knifetip.service.orders.command_keys import CommandKeys
from knifetip.service.orders.operator_actions import is_fully_executed


class InterruptedJobs:
    """Decisions about interrupted jobs; each method stores one decision with its event.

    Each method returns the job unchanged if it was called with the same ``RequestKey`` before; it
    raises ``KeyReused`` if the key was used for another command.
    """

    def __init__(self, database: Database, transitions: Transitions, keys: CommandKeys) -> None:
        self._db = database
        self._transitions = transitions
        self._keys = keys

    def requeue(self, id: str, key: RequestKey | None = None) -> Job:
        """Queue an interrupted job again, at its former position in the queue, and return it.

        The operator calls this after clearing the table.

        Raises
        ------
        WrongState
            The job is not ``interrupted``, its last copy was executed to the last program line, or
            it makes the rest of a sheet.
        """
        with self._db.writing() as session:
            if (repeated := self._keys.repeated(session, id, key)) is not None:
                return repeated
            row = self._transitions.lock(session, id)
            if row.rest is not None:
                raise WrongState("rest.not-again", job=id)
            if is_fully_executed(row):
                raise WrongState("job.fully-executed", job=id, lines=row.lines)
            self._transitions.move(
                session,
                id,
                Action.REQUEUE,
                OPERATOR,
                Message("job.requeued"),
                lease=0.0,
                line=0,
                position=None,
                stopped_at=None,
                message=None,
                requested_action="",
                seconds_left=None,
            )
            return self._transitions.lock(session, id)

    def scrap(self, id: str, key: RequestKey | None = None) -> Job:
        """Move an interrupted job to ``scrapped`` and return it.

        The table of its machine is then free for another job.  Copies that are not made can be
        ordered as a job of their own.

        Raises
        ------
        WrongState
            The job is not ``interrupted``.
        """
        with self._db.writing() as session:
            if (repeated := self._keys.repeated(session, id, key)) is not None:
                return repeated
            row = self._transitions.lock(session, id)
            if row.state == State.SCRAPPED:
                return row
            self._transitions.move(
                session, id, Action.SCRAP, OPERATOR, Message("job.scrapped"), requested_action=""
            )
            return self._transitions.lock(session, id)

    def declare_finished(self, id: str, key: RequestKey | None = None) -> Job:
        """Move an interrupted job to ``done`` and return it.

        An operator calls this after finding that all sheets of the job are complete.

        Raises
        ------
        WrongState
            The job is not ``interrupted``.
        """
        with self._db.writing() as session:
            if (repeated := self._keys.repeated(session, id, key)) is not None:
                return repeated
            row = self._transitions.lock(session, id)
            if row.state == State.DONE:
                return row
            self._transitions.move(
                session,
                id,
                Action.FINISH,
                OPERATOR,
                Message("job.declared-finished", line=row.line, lines=row.lines),
                line=row.lines,
                copies_done=row.copies,
                message=None,
                stopped_at=None,
                requested_action="",
                lease=0.0,
                seconds_left=0.0,
            )
            return self._transitions.lock(session, id)
