"""Repository operations on the queues of machines: list and reorder jobs, and change waiting jobs.

The order of a queue is ``machine_queues.TURN``: priority, then rank.  A change of the order locks
the queue (``machine_queues.lock_queue``), as a claim does, so that a gateway claims the job that is
listed first.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import sqlalchemy as sa
from sqlalchemy.orm import Session

from knifetip.contract.job import ON_TABLE, Actor, Confirmation, State
from knifetip.errors import StaleVersion, WrongState
from knifetip.library.definition import Definition
from knifetip.messages import Message
from knifetip.service.compiling.store import result_columns, result_contents
from knifetip.service.content.store import ContentStore
from knifetip.service.database.acting import acting_limits
from knifetip.service.database.engine import Database, short
from knifetip.service.database.tables import Job
from knifetip.service.lifecycle.machine_queues import (
    CLAIMED,
    is_waiting,
    last_rank,
    lock_queue,
    waiting_jobs,
)
from knifetip.service.lifecycle.transitions import Transitions, advice
from knifetip.service.order_details.details import Details, replace_metadata
from knifetip.service.processes.compile_result import CompileResult
from knifetip.service.runs.claimed_jobs import ClaimedJobs, is_claimed

#: States of a job that no machine works on yet.
_BEFORE_START = (State.RECEIVED, State.COMPILING, State.READY, State.QUEUED)
_STEP = 1.0  # distance of ranks that are assigned anew


@dataclass(frozen=True, slots=True)
class Place:
    """A place in a queue, given by its neighbours.

    A neighbour is the id of a job, "" for the beginning or the end of the queue, or None if it may
    be any job.  At least one neighbour is not None.
    """

    previous: str | None = None  #: job that is claimed before
    next: str | None = None  #: job that is claimed after


@dataclass(frozen=True, slots=True)
class WaitingChange:
    """New values of a waiting job; None to keep a value."""

    priority: int | None = None
    copies: int | None = None
    on_hold: bool | None = None

    @property
    def is_empty(self) -> bool:
        """Whether the change sets no value."""
        return self.priority is None and self.copies is None and self.on_hold is None


class QueueStore:
    """Repository operations on the queues of machines."""

    def __init__(
        self,
        database: Database,
        contents: ContentStore,
        transitions: Transitions,
        claimed: ClaimedJobs,
    ) -> None:
        self._db = database
        self._contents = contents
        self._transitions = transitions
        self._claimed = claimed

    def jobs(self, machine: str) -> list[Job]:
        """Return the jobs of a machine in the order in which they run.

        The first is the job that occupies the machine, if there is one: it is on the table, or
        claimed and not started.
        """
        occupying = sa.select(Job).where(
            Job.machine == machine, sa.or_(Job.state.in_(ON_TABLE), CLAIMED)
        )
        with self._db.reading() as session:
            return [*session.scalars(occupying), *session.scalars(waiting_jobs(machine))]

    def move(self, id: str, place: Place, actor: Actor, version: str | None = None) -> Job:
        """Move a waiting job to a place in the queue of its machine, and return the job.

        If the priority of the job does not permit the place, the job gets the priority of the
        nearest neighbour.  A repeated move has no effect.

        Parameters
        ----------
        id
            Id of the job.
        place
            The neighbours between which the job is to be.
        actor
            The operator.
        version
            ``order_version`` of the jobs for which the place was chosen; None for no check.

        Raises
        ------
        WrongState
            The job does not wait in a queue, or a neighbour does not.
        StaleVersion
            The order has another version, or the neighbours are not next to each other.
        """
        with self._db.writing() as session:
            row = self._lock(session, id)
            if not is_waiting(row):
                raise _not_waiting_error(row)
            queue = list(session.scalars(waiting_jobs(row.machine)))
            if version is not None and version != order_version(queue):
                raise StaleVersion("queue.changed", machine=row.machine)
            others = [job for job in queue if job.id != id]
            index = _index_of(others, row, place)
            if queue.index(row) != index:
                self._insert(session, row, others, index, actor)
            return self._transitions.lock(session, id)

    def _insert(
        self, session: Session, row: Job, others: Sequence[Job], index: int, actor: Actor
    ) -> None:
        """Store the priority and the rank with which a job is at a place among other jobs.

        ``others``: the other waiting jobs of the machine, in their order.
        ``index``: number of the other jobs before the place.
        """
        before = others[index - 1] if index else None
        after = others[index] if index < len(others) else None
        priority = row.priority
        if before is not None:
            priority = min(priority, before.priority)
        if after is not None:
            priority = max(priority, after.priority)
        if priority != row.priority:
            self._write(session, row, actor, _priority_event(row, priority))
        peers = [job for job in others if job.priority == priority]
        count = sum(job.priority == priority for job in others[:index])
        rank = self._rank_among(session, row.machine, peers, count)
        self._set(session, row.id, priority=priority, rank=rank)
        self._write(session, row, actor, _move_event(before, after))

    def _rank_among(
        self, session: Session, machine: str, peers: Sequence[Job], count: int
    ) -> float:
        """Return a rank that is greater than that of exactly ``count`` jobs of equal priority.

        If no number lies between the ranks of two neighbours, all jobs get new ranks.

        ``session``, ``machine``: session of the transaction, and name of the machine.
        ``peers``: waiting jobs of the machine with equal priority, in their order.
        ``count``: number of jobs that are to have a smaller rank.
        """
        if count == len(peers):
            return last_rank(session, machine, self._db.clock())
        if count == 0:
            return peers[0].rank - _STEP
        low, high = peers[count - 1].rank, peers[count].rank
        if low < (rank := (low + high) / 2.0) < high:
            return rank
        first = peers[0].rank
        for index, job in enumerate(peers):
            self._set(session, job.id, rank=first + _STEP * (index + (index >= count)))
        return first + _STEP * count

    def change(
        self,
        id: str,
        change: WaitingChange,
        actor: Actor,
        details: Details | None = None,
        check: Callable[[Job], None] | None = None,
    ) -> Job:
        """Change a job that no machine works on yet, or the details of any job; return the job.

        Each changed value is an event; a repeated change has no effect.  A job with a new priority
        comes after the other jobs of that priority.  A claimed job that is put on hold returns to
        the queue, if the operator has not confirmed it.

        Parameters
        ----------
        id
            Id of the job.
        change
            The new values.
        actor
            The operator.
        details
            New details of the order, by name of the column; None for none.  They can be changed in
            every state of the job.
        check
            Called with the job, locked; an error of it prevents the change.  None for no check.

        Raises
        ------
        WrongState
            The job is on a machine, confirmed or ended, or has more completed copies, or it makes
            the rest of one sheet and other copies are wanted.
        """
        with self._db.writing() as session:
            row = self._lock(session, id)
            acting_limits().check_change(details or {})
            if check is not None:
                check(row)
            if details and any(getattr(row, name) != value for name, value in details.items()):
                self._set(session, id, **details)
                if "extra" in details:
                    replace_metadata(session, Job, row.serial, details["extra"])
                self._write(session, row, actor, Message("job.details-changed"))
            if change.is_empty:
                return self._transitions.lock(session, id)
            if is_claimed(row):
                row = self._return_to_queue(session, row, change, actor)
            if row.state not in _BEFORE_START:
                raise _not_waiting_error(row)
            if change.priority is not None and change.priority != row.priority:
                rank = last_rank(session, row.machine, self._db.clock())
                self._set(session, id, priority=change.priority, rank=rank)
                self._write(session, row, actor, _priority_event(row, change.priority))
            if change.copies is not None and change.copies != row.copies:
                if row.rest is not None:
                    raise WrongState("rest.bound-to-sheet", job=id, machine=row.machine)
                if change.copies <= row.copies_done:
                    raise WrongState("queue.copies-done", job=id, done=row.copies_done)
                self._set(session, id, copies=change.copies)
                event = Message("queue.copies-changed", former=row.copies, copies=change.copies)
                self._write(session, row, actor, event)
            if change.on_hold is not None and change.on_hold != row.on_hold:
                self._set(session, id, on_hold=change.on_hold)
                code = "queue.put-on-hold" if change.on_hold else "queue.let-go"
                self._write(session, row, actor, Message(code))
            return self._transitions.lock(session, id)

    def _return_to_queue(
        self, session: Session, row: Job, change: WaitingChange, actor: Actor
    ) -> Job:
        """Take a claimed job back from its gateway, so that it can be put on hold."""
        if not change.on_hold or row.confirmation != Confirmation.AWAITED:
            raise _not_waiting_error(row)
        self._claimed.give_back(session, row, actor, Message("queue.put-on-hold"))
        return self._transitions.lock(session, row.id)

    def transfer(self, row: Job, machine: Definition, result: CompileResult, actor: Actor) -> Job:
        """Move a ready or waiting job to another machine, and return the job.

        A waiting job comes after the jobs of its priority that wait for the other machine.

        Parameters
        ----------
        row
            The job for which the program was compiled.
        machine
            The other machine.
        result
            The program for the other machine; the verifier has accepted it.
        actor
            The operator.

        Raises
        ------
        WrongState
            The job has been claimed, moved or cancelled meanwhile.
        """
        staged = self._contents.stage(**result_contents(result))
        with self._db.writing() as session:
            lock_queue(session, machine.name)
            present = self._transitions.lock(session, row.id)
            if (present.state, present.epoch, present.machine) != (
                row.state,
                row.epoch,
                row.machine,
            ):
                raise _not_waiting_error(present)
            check_transferable(present)
            self._set(
                session,
                row.id,
                machine=machine.name,
                machine_version=machine.version,
                rank=last_rank(session, machine.name, self._db.clock()),
                **result_columns(result),
                **self._contents.keep(session, staged),
            )
            event = Message("queue.transferred", former=row.machine, machine=machine.name)
            self._write(session, present, actor, event)
            return self._transitions.lock(session, row.id)

    def _lock(self, session: Session, id: str) -> Job:
        """Return the job with an id, locked with the queue of its machine."""
        row = session.scalar(sa.select(Job).where(Job.id == id))
        if row is not None:
            lock_queue(session, row.machine)
        return self._transitions.lock(session, id)

    def _set(self, session: Session, id: str, **changes: Any) -> None:
        """Set columns of a job that the transaction of the caller has locked."""
        statement = sa.update(Job).where(Job.id == id).values(**changes)
        session.execute(statement.execution_options(synchronize_session=False))

    def _write(self, session: Session, row: Job, actor: Actor, event: Message) -> None:
        self._set(session, row.id, updated=self._db.clock())
        self._transitions.write_job_event(session, row.id, row.state, actor, event)


def order_version(waiting: Sequence[Job]) -> str:
    """Return a text that changes when the order of waiting jobs or one of their priorities does."""
    order = ",".join(f"{job.id}:{job.priority}" for job in waiting)
    return hashlib.sha256(order.encode()).hexdigest()[:16]


def check_transferable(row: Job) -> None:
    """Raise ``WrongState`` unless a job is ready, or waits and is not claimed, on any sheet."""
    if row.rest is not None:
        raise WrongState("rest.bound-to-sheet", job=row.id, machine=row.machine)
    registration = row.options.registration
    if registration is not None and registration.measured:
        raise WrongState("registration.bound-to-machine", job=row.id, machine=row.machine)
    if row.state != State.READY and not is_waiting(row):
        raise _not_waiting_error(row)


def _index_of(others: Sequence[Job], row: Job, place: Place) -> int:
    """Return the number of other waiting jobs before a place.

    Raises ``WrongState``: a neighbour of the place does not wait for the same machine.
    Raises ``StaleVersion``: the neighbours are not next to each other.
    """
    ids = ["", *(job.id for job in others), ""]
    for neighbour in (place.previous, place.next):
        if neighbour is not None and neighbour not in ids:
            raise WrongState(
                "queue.no-neighbour", job=row.id, neighbour=short(neighbour), machine=row.machine
            )
    if place.previous is None:
        return len(others) if not place.next else ids.index(place.next) - 1
    index = ids.index(place.previous)
    if place.next is not None and ids[index + 1] != place.next:
        raise StaleVersion("queue.changed", machine=row.machine)
    return index


def _move_event(before: Job | None, after: Job | None) -> Message:
    """Return the event about a job that was moved between its new neighbours in the queue."""
    if before is None:
        return Message("queue.moved-before", before="" if after is None else after.id)
    if after is None:
        return Message("queue.moved-after", after=before.id)
    return Message("queue.moved-between", after=before.id, before=after.id)


def _priority_event(row: Job, priority: int) -> Message:
    return Message("queue.priority-changed", former=row.priority, priority=priority)


def _not_waiting_error(row: Job) -> WrongState:
    """Return the error that a job cannot be changed, because it does not wait."""
    if is_claimed(row):
        return WrongState("queue.claimed", job=row.id, machine=row.machine)
    return WrongState(
        "queue.not-waiting", job=row.id, state=row.state, advice=advice(row.state, row.message)
    )
