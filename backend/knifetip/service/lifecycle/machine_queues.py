"""State of the queues of machines: which gateways are connected, and which jobs come next."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import sqlalchemy as sa
from sqlalchemy.orm import Session, aliased

from knifetip.contract.job import LEASED, ON_TABLE, Confirmation, State
from knifetip.service.database.acting import acting_limits
from knifetip.service.database.engine import Database
from knifetip.service.database.tables import Gateway, Job, Station
from knifetip.service.library.outdated_jobs import outdated

#: A job that a gateway has claimed and that waits for the operator's confirmation.
CLAIMED = sa.and_(Job.state == State.QUEUED, Job.confirmation != Confirmation.NONE)
#: A job in the queue of its machine that no gateway has claimed.
WAITING = sa.and_(Job.state == State.QUEUED, Job.confirmation == Confirmation.NONE)
#: The order in which the waiting jobs of a machine are listed and claimed.
TURN = (Job.priority.desc(), Job.rank, Job.serial)

_LOCK = 0x6B6E_6971  # class of PostgreSQL's advisory locks of queues
_STEP = 0.001  # distance of ranks, where the clock gives none


@dataclass(frozen=True, slots=True)
class Queue:
    """State of the queue of a machine: the next queued job, and the job that occupies the machine.

    A job occupies the machine if it is on the table, or is claimed and waits for a confirmation.
    """

    first: str  #: next job to be claimed; empty if none
    ahead: str  #: job on the table, or claimed and not confirmed; empty if none
    ahead_state: str
    connected: bool  #: whether a gateway is connected, see ``connected_machines``


class MachineQueues:
    """Repository of the connections of gateways, and of the state of the queues of machines."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def record_contact(self, machine: str, name: str) -> None:
        """Store the present time as the time of the last request of a gateway.

        Parameters
        ----------
        machine
            Name of the machine to which the gateway belongs.
        name
            Name of the gateway.
        """
        with self._db.writing() as session:
            session.merge(Gateway(machine=machine, name=name, seen=self._db.clock()))

    def connected_machines(self, max_age: float) -> set[str]:
        """Return the names of the machines whose gateway is connected.

        A gateway is connected if it requested a job in the last ``max_age`` seconds, or has a valid
        lease of a job, or has reported in this time that its controller is connected: it requests
        no job while the controller is not at rest.
        """
        now = self._db.clock()
        recent_requests = sa.select(Gateway.machine).where(Gateway.seen > now - max_age)
        leased_jobs = sa.select(Job.machine).where(
            sa.or_(Job.state.in_(LEASED), CLAIMED), Job.lease > now
        )
        timer = self._db.timer()
        reporting = sa.select(Station.machine).where(
            Station.connected, Station.reported > timer - max_age, Station.reported <= timer
        )
        with self._db.reading() as session:
            return {
                *session.scalars(recent_requests),
                *session.scalars(leased_jobs),
                *session.scalars(reporting),
            }

    def machines_with_queue(self) -> set[str]:
        """Return the names of the machines for which jobs are queued."""
        with self._db.reading() as session:
            return set(
                session.scalars(sa.select(Job.machine).where(Job.state == State.QUEUED).distinct())
            )

    def jobs_on_tables(self) -> dict[str, str]:
        """Return the ids of the jobs that are on the table of a machine, by name of the machine.

        Machines without a job on their table are omitted.
        """
        query = sa.select(Job.machine, Job.id).where(Job.state.in_(ON_TABLE))
        query = query.where(*acting_limits().job_conditions())
        with self._db.reading() as session:
            return {row.machine: row.id for row in session.execute(query)}

    def queues(self, machines: Collection[str], max_age: float) -> dict[str, Queue]:
        """Return the state of the queue of each machine, by name of the machine.

        The state includes whether the gateway of the machine is connected.

        Parameters
        ----------
        machines
            Names of the machines.
        max_age
            A gateway counts as connected if its last request is at most this old (s), or if it has
            a valid lease of a job.
        """
        connected = self.connected_machines(max_age)
        ahead = sa.select(Job.machine, Job.id, Job.state).where(
            Job.machine.in_(machines), sa.or_(Job.state.in_(ON_TABLE), CLAIMED)
        )
        queues: dict[str, Queue] = {}
        with self._db.reading() as session:
            jobs_ahead = {row.machine: row for row in session.execute(ahead)}
            for machine in machines:
                first = session.scalar(next_queued(machine).with_only_columns(Job.id)) or ""
                job_ahead = jobs_ahead.get(machine)
                queues[machine] = Queue(
                    first,
                    "" if job_ahead is None else job_ahead.id,
                    "" if job_ahead is None else job_ahead.state,
                    machine in connected,
                )
        return queues


def next_queued(machine: str) -> sa.Select[Job]:
    """Return a query for the queued job of a machine that is to be claimed next.

    A job whose machine or board has changed since its compile is left in the queue, because the
    operator must first have it compiled again.  So is one whose program the machine has refused.

    While the measured sheet of a job lies on the table, no other job is claimed: the job is being
    compiled for the sheet, or waits in the queue again.
    """
    free = (Job.on_hold.is_(False), Job.check_refusal.is_(None))
    measured = aliased(Job)
    on_table = (
        sa.exists()
        .where(
            measured.machine == machine,
            measured.state.in_((State.RECEIVED, State.COMPILING, State.QUEUED)),
            measured.on_hold.is_(False),
            measured.check_refusal.is_(None),
            _is_measured(measured),
        )
        .correlate(None)
    )
    own = sa.or_(_is_measured(Job), ~on_table)
    return waiting_jobs(machine).where(*free, ~outdated(), own).limit(1)


def _is_measured(job: type[Job]) -> sa.ColumnElement[bool]:
    """Return the condition that the marks of a job's printed sheet were measured."""
    first = job.stored_options[("registration", "measured", 0, 0)].as_float()
    condition: sa.ColumnElement[bool] = first.is_not(None)
    return condition


def waiting_jobs(machine: str) -> sa.Select[Job]:
    """Return a query for the waiting jobs of a machine, in the order in which they are claimed.

    Jobs that are on hold are included at their places.
    """
    return sa.select(Job).where(Job.machine == machine, WAITING).order_by(*TURN)


def is_waiting(row: Job) -> bool:
    """Return whether a job is in the queue of its machine and no gateway has claimed it."""
    return row.state == State.QUEUED and row.confirmation == Confirmation.NONE


def lock_queue(session: Session, machine: str) -> None:
    """Wait until no other transaction claims or reorders jobs of a machine, and exclude others.

    The lock ends with the transaction.  In SQLite, only one transaction writes at a time.
    """
    if session.get_bind().dialect.name == "postgresql":
        key = sa.func.hashtext(machine)
        session.execute(sa.select(sa.func.pg_advisory_xact_lock(_LOCK, key)))


def last_rank(session: Session, machine: str, now: float) -> float:
    """Return a rank that is greater than the ranks of all queued jobs of a machine.

    Parameters
    ----------
    session
        Session with the transaction of the caller.
    machine
        Name of the machine.
    now
        Present time, the least result (seconds since 1970).
    """
    greatest = sa.select(sa.func.max(Job.rank)).where(
        Job.machine == machine, Job.state == State.QUEUED
    )
    return max(now, (session.scalar(greatest) or 0.0) + _STEP)
