"""Takes jobs back from workers and gateways that did not renew their lease in time."""

from __future__ import annotations

import sqlalchemy as sa
from sqlalchemy.orm import Session

from knifetip import tracing
from knifetip.contract.job import CLOCK, LEASED, Action, Confirmation, State
from knifetip.messages import Message
from knifetip.service.compiling.store import CompileStore
from knifetip.service.database.engine import Database
from knifetip.service.database.tables import Job
from knifetip.service.lifecycle.machine_queues import CLAIMED
from knifetip.service.lifecycle.transitions import Transitions
from knifetip.service.runs.claimed_jobs import ClaimedJobs, is_claimed, silent_gateway_message
from knifetip.service.runs.interruption import interruption
from knifetip.service.runs.stop_place import StopPlace, stopped


class LeaseSweep:
    """Takes jobs back from workers and gateways whose lease has expired.

    A worker or gateway that owns a job must renew its lease in time; otherwise it loses the job.
    """

    def __init__(
        self,
        database: Database,
        transitions: Transitions,
        compiles: CompileStore,
        claimed: ClaimedJobs,
    ) -> None:
        self._db = database
        self._transitions = transitions
        self._compiles = compiles
        self._claimed = claimed
        self.taken_back = 0  #: jobs that this process has taken back

    def run(self, *, gateways: bool = True) -> bool:
        """Take back each job whose lease has expired; return whether any job has a lease.

        A job on a table becomes ``interrupted``, unless its gateway has not begun the program: it
        then returns to the queue, as a claimed job does that has not been started.  A job that was
        being compiled is compiled again.

        Parameters
        ----------
        gateways
            Whether jobs are also taken back from gateways; False if this process could not receive
            their heartbeats.

        Returns
        -------
        bool
            Whether any job had a lease when the method was called, expired or not.  Leases of
            gateways count only if ``gateways`` is True.
        """
        now = self._db.clock()
        leased = Job.state == State.COMPILING
        if gateways:
            leased = sa.or_(leased, Job.state.in_(LEASED), CLAIMED)
        with self._db.reading() as session:
            leases = session.execute(sa.select(Job.id, Job.lease).where(leased)).all()
        for id, lease in leases:
            if lease < now:
                self._take_back(id, now)
        return bool(leases)

    def _take_back(self, id: str, now: float) -> None:
        with self._db.writing() as session:
            row = session.scalar(sa.select(Job).where(Job.id == id).with_for_update())
            # It may have been renewed, finished or taken back meanwhile.
            if row is None or row.lease >= now or not _is_leased(row):
                return
            self.taken_back += 1
            with tracing.span("lease expired", parent=row.traceparent, job=id, machine=row.machine):
                self._move(session, row)

    def _move(self, session: Session, row: Job) -> None:
        """Move a job whose lease has expired to the state that follows."""
        if row.state in LEASED and not row.begun:
            silent = silent_gateway_message(row.owner)
            self._claimed.put_back(session, row, CLOCK, silent)
        elif row.state in LEASED:
            stop = interruption(row, Message("job.gateway-lost", gateway=row.owner))
            self._transitions.move(
                session,
                row.id,
                Action.INTERRUPT,
                CLOCK,
                stop.message,
                epoch=row.epoch,
                new_epoch=row.epoch + 1,
                line=stop.line,
                **stopped(stop.line, stop.at_most, StopPlace(row.position)),
                copies_done=stop.copies_done,
                message=stop.message,
                seconds_left=None,
                requested_action="",
                confirmation=Confirmation.NONE.value,
            )
        elif is_claimed(row):
            self._claimed.give_back(session, row, CLOCK, silent_gateway_message(row.owner))
        elif row.state == State.COMPILING:
            self._compiles.take_back(session, row)


def _is_leased(row: Job) -> bool:
    """Return whether a worker or a gateway owns a job."""
    return row.state == State.COMPILING or row.state in LEASED or is_claimed(row)
